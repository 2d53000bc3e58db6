"""What may go wrong in a Denavit-Hartenberg table and in what is computed from it."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import combinations, permutations
from math import degrees, pi, radians

import numpy as np

from dhlab.diagnosis.after import after_slips, hand_of
from dhlab.diagnosis.end_slips import end_slips, no_offset, offset_slips, parts_of_ends
from dhlab.diagnosis.product import After
from dhlab.diagnosis.slips import Slip
from dhlab.diagnosis.table_model import Table
from dhlab.diagnosis.values import Floats
from dhlab.diagnosis.verdict import Mistake, mistake
from dhlab.kinematics.chain import Chain

NAMES = ("alpha", "a", "d", "theta")
ANGLE_UNIT = "In which unit do angles count here, in degrees or in radians?"
LENGTH_UNIT = "In which unit are the lengths asked for?"


def chain_slips(chain: Chain) -> list[Slip[Table]]:
    """All slips in what is computed from a chain's table."""
    slips = [
        *_numbers(chain),
        *_pen(chain),
        *_links(),
        _convention(chain),
        *_columns(),
        *_joints(chain),
    ]
    slips += end_slips(chain)
    return slips + [_after(m, change) for m, change in after_slips(rotation=False)]


def table_slips(chain: Chain) -> list[Slip[Table]]:
    """All slips in a table, but for its being read in the other convention."""
    return [
        *_numbers(chain),
        *_pen(chain),
        *_table_units(),
        *_links(),
        _convention(chain),
        *_columns(),
        *no_offset(chain),
        *offset_slips(chain),
        *end_slips(chain),
        *parts_of_ends(chain),
    ]


def _after(m: Mistake, change: After) -> Slip[Table]:
    return Slip(m, lambda t: replace(t, after=(*t.after, change)), about=hand_of(m))


def _edit(change: Callable[[Floats], None]) -> Callable[[Table], Table]:
    def edited(t: Table) -> Table:
        rows = t.rows.copy()
        change(rows)
        return replace(t, rows=rows)

    return edited


def _exchange(i: int) -> Callable[[Table], Table]:
    def change(rows: Floats) -> None:
        rows[i, [1, 2]] = rows[i, [2, 1]]

    return _edit(change)


def _numbers(chain: Chain) -> Iterator[Slip[Table]]:
    for i, (row, kind) in enumerate(zip(chain.rows, chain.kinds, strict=True)):
        for k, name in enumerate(NAMES):
            variable = k == (3 if kind == "r" else 2)
            if row[k] and not variable:
                when = f"{name} in row {i + 1} has the wrong sign"
                about = "x" if k < 2 else "z"
                question = f"Which way along or about {about} does it go from one to the next?"
                yield Slip(
                    mistake(f"sign-{name}-{i + 1}", when, question), _changed(i, k, lambda x: -x)
                )
        if kind == "r" and row.a != row.d:
            when = f"a and d are exchanged in row {i + 1}"
            question = "Which of the two lengths lies along x, which along z?"
            yield Slip(mistake(f"a-d-{i + 1}", when, question), _exchange(i))


def _pen(chain: Chain) -> Iterator[Slip[Table]]:
    """Slips of the pen: a number left out, a quarter turn too much, two lengths exchanged."""
    between = "How do the two axes lie: parallel, crossing, how far apart?"
    for i, (row, kind) in enumerate(zip(chain.rows, chain.kinds, strict=True)):
        for k, name in enumerate(NAMES):
            if row[k] and k != (3 if kind == "r" else 2):
                m = mistake(f"left-out-{name}-{i + 1}", f"{name} in row {i + 1} is 0", between)
                yield Slip(m, _changed(i, k, lambda x: 0.0), alone=True)
        when = f"alpha in row {i + 1} is a quarter turn off"
        m = mistake(f"quarter-alpha-{i + 1}", when, between)
        for quarter in (pi / 2, -pi / 2):
            by = _changed(i, 0, lambda x, quarter=quarter: x + quarter)  # type: ignore[misc]
            yield Slip(m, by, alone=True)
    yield from _exchanged(chain)


def _exchanged(chain: Chain) -> Iterator[Slip[Table]]:
    """Two lengths, or two rows, in each other's places."""
    for i, j in combinations(range(chain.n), 2):
        one, other = chain.rows[i], chain.rows[j]
        if (one.alpha, one.d) != (other.alpha, other.d):

            def rows_exchanged(rows: Floats, i: int = i, j: int = j) -> None:
                rows[[i, j]] = rows[[j, i]]

            when = f"rows {i + 1} and {j + 1} are exchanged"
            m = mistake(
                f"rows-exchanged-{i + 1}-{j + 1}", when, "Which joint does each row lead to?"
            )
            yield Slip(m, _edit(rows_exchanged), alone=True)
        if one.a != other.a:
            when = f"a of rows {i + 1} and {j + 1} are exchanged"
            question = "Which length lies between which two axes?"
            m = mistake(f"a-exchanged-{i + 1}-{j + 1}", when, question)

            def exchanged(rows: Floats, i: int = i, j: int = j) -> None:
                rows[[i, j], 1] = rows[[j, i], 1]

            yield Slip(m, _edit(exchanged), alone=True)


def _changed(i: int, k: int, change: Callable[[float], float]) -> Callable[[Table], Table]:
    def changed(rows: Floats) -> None:
        rows[i, k] = change(rows[i, k])

    return _edit(changed)


def _columns() -> Iterator[Slip[Table]]:
    question = "In which order does a row hold alpha, a, d and theta?"
    for order in permutations(range(4)):
        if order != (0, 1, 2, 3):
            names = ", ".join(NAMES[k] for k in order)
            yield Slip(
                mistake(
                    "columns-" + "".join(map(str, order)),
                    f"the columns of the table hold {names}, in this order",
                    question,
                ),
                lambda t, order=order: replace(t, columns=order),  # type: ignore[misc]
            )


def convention_mistake(convention: str) -> Mistake:
    """Mistake of reading a table in this convention that is meant in the other one."""
    other = "modified" if convention == "standard" else "standard"
    return mistake(
        "convention",
        f"the table of the {other} convention is read in the {convention} one",
        "Which comes first in a row of your convention: the link or the joint?",
    )


def _convention(chain: Chain) -> Slip[Table]:
    other = "modified" if chain.convention == "standard" else "standard"
    m = convention_mistake(other)
    return Slip(m, lambda t: replace(t, standard=not t.standard))


def _links() -> Iterator[Slip[Table]]:
    question = "Between which two axes do alpha and a of row i lie?"
    for step, way in ((-1, "next"), (1, "previous")):

        def shifted(rows: Floats, step: int = step) -> None:
            rows[:, :2] = np.roll(rows[:, :2], step, axis=0)
            rows[-1 if step < 0 else 0, :2] = 0

        when = f"alpha and a are shifted by one: each row has those of the {way} one"
        yield Slip(mistake(f"shifted-{way}", when, question), _edit(shifted))


def _table_units() -> Iterator[Slip[Table]]:
    for key, when, question, columns, factor in (
        ("radians", "the angles are given in degrees", ANGLE_UNIT, (0, 3), degrees(1)),
        ("degrees", "angles in radians are taken for degrees", ANGLE_UNIT, (0, 3), radians(1)),
        ("millimetres", "lengths are in millimetres", LENGTH_UNIT, (1, 2), 1e3),
        ("thousandth", "lengths are divided by 1000", LENGTH_UNIT, (1, 2), 1e-3),
    ):

        def scaled(
            rows: Floats, columns: tuple[int, ...] = columns, factor: float = factor
        ) -> None:
            rows[:, columns] *= factor

        m = mistake(key, when, question)
        yield Slip(m, _edit(scaled))
        if columns == (1, 2):
            yield Slip(m, lambda t, factor=factor: _all_lengths(t, factor))  # type: ignore[misc]


def _all_lengths(t: Table, factor: float) -> Table:
    """Scale the lengths of the rows, and those of what stands before and behind them."""
    rows, base, tool = t.rows.copy(), t.base.copy(), t.tool.copy()
    for lengths in (rows[:, 1:3], base[:3, 3], tool[:3, 3]):
        lengths *= factor
    return replace(t, rows=rows, base=base, tool=tool)


def _joints(chain: Chain) -> Iterator[Slip[Table]]:
    n = chain.n
    yield from no_offset(chain)
    if chain.home.any():
        when = "the home value of the table is added to the joint variable"
        question = "Does a joint variable stand in place of the table's value, or is it added?"
        home = chain.home
        m = mistake("home-added", when, question)
        yield Slip(m, lambda t: replace(t, q=t.q + home))
    for i, kind in enumerate(chain.kinds):
        yield from _joint(i, kind)
    yield from _units(chain)
    if n > 1:
        when = "the links are multiplied in the reverse order"
        question = "Which frame's pose stands leftmost in the product?"
        m = mistake("reversed-order", when, question)
        yield Slip(m, lambda t: replace(t, use=t.use[::-1]))


def _joint(i: int, kind: str) -> Iterator[Slip[Table]]:
    def negated(t: Table) -> Table:
        q = t.q.copy()
        q[i] *= -1
        return replace(t, q=q)

    way = "turns" if kind == "r" else "slides"
    question = "Point your right thumb along z: which way is positive?"
    yield Slip(mistake(f"sign-q-{i + 1}", f"joint {i + 1} {way} the wrong way", question), negated)
    count = "How many rows does the table have, and how many factors your product?"
    skipped = mistake(f"skipped-{i + 1}", f"joint {i + 1} is left out of the product", count)
    yield Slip(skipped, lambda t: replace(t, use=tuple(k for k in t.use if k != i)))
    doubled = mistake(f"doubled-{i + 1}", f"joint {i + 1} is in the product twice", count)
    yield Slip(
        doubled, lambda t: replace(t, use=tuple(k for k in t.use for _ in range(1 + (k == i))))
    )
    if kind == "p":
        when = f"the variable of prismatic joint {i + 1} is put in for theta instead of d"
        m = mistake(f"d-theta-{i + 1}", when, "Which of the four numbers changes when it slides?")
        yield Slip(m, lambda t: replace(t, kinds=(*t.kinds[:i], "r", *t.kinds[i + 1 :])))


def _units(chain: Chain) -> Iterator[Slip[Table]]:
    turning = np.array([k == "r" for k in chain.kinds])
    for key, factor, when in (
        ("degrees", radians(1), "joint angles in radians are taken for degrees"),
        ("radians", degrees(1), "joint angles are put in as degrees"),
    ):
        yield Slip(
            mistake(key, when, ANGLE_UNIT),
            lambda t, factor=factor: replace(  # type: ignore[misc]
                t, q=np.where(turning, t.q * factor, t.q)
            ),
        )
