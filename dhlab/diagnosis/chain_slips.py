"""What may go wrong in a Denavit-Hartenberg table and in what is computed from it."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import permutations
from math import degrees, radians

import numpy as np

from dhlab.diagnosis.after import after_slips
from dhlab.diagnosis.product import After
from dhlab.diagnosis.slips import Slip
from dhlab.diagnosis.values import Floats
from dhlab.diagnosis.verdict import Mistake, mistake
from dhlab.kinematics.chain import Chain
from dhlab.kinematics.dh import link_transform

NAMES = ("alpha", "a", "d", "theta")


@dataclass(frozen=True, eq=False)
class Table:
    """A table with its joint values in numbers, and what was done to it."""

    rows: Floats
    kinds: tuple[str, ...]
    q: Floats
    offset: Floats
    standard: bool
    base: Floats
    tool: Floats
    columns: tuple[int, ...] = (0, 1, 2, 3)
    use: tuple[int, ...] = ()
    ends: str = "bct"
    after: tuple[After, ...] = ()

    def filled(self) -> Floats:
        """Rows with the joint values in their places, shape (used, 4)."""
        rows = self.rows.copy()
        for i, kind in enumerate(self.kinds):
            rows[i, 3 if kind == "r" else 2] = self.q[i] + self.offset[i]
        out: Floats = rows[list(self.use)][:, list(self.columns)]
        return out

    def chain(self, like: Chain) -> Chain | None:
        """Chain of this table; None where it has other joints, or factors in another order."""
        if self.use != tuple(range(like.n)) or self.ends != "bct" or self.after:
            return None
        rows = self.rows[:, list(self.columns)].tolist()
        convention = "standard" if self.standard else "modified"
        return Chain(
            [tuple(r) for r in rows],
            self.kinds,
            "standard" if convention == "standard" else "modified",
            self.base,
            self.tool,
            offset=self.offset,
        )


def table_of(chain: Chain, q: Floats) -> Table:
    """Table of a chain at a configuration."""
    return Table(
        np.array(chain.rows, dtype=np.float64).reshape(-1, 4),
        chain.kinds,
        np.asarray(q, dtype=np.float64).reshape(chain.n),
        chain.offset,
        chain.convention == "standard",
        chain.base,
        chain.grasper,
        use=tuple(range(chain.n)),
    )


def evaluate_tables(tables: Sequence[Table]) -> list[Floats]:
    """Poses of the tips of many tables at once, each (4, 4)."""
    out: list[Floats] = [np.eye(4)] * len(tables)
    groups: dict[tuple[int, bool], list[int]] = {}
    for k, t in enumerate(tables):
        groups.setdefault((len(t.use), t.standard), []).append(k)
    for (n, standard), members in groups.items():
        rows = np.array([tables[k].filled() for k in members]).reshape(len(members), n, 4)
        links = link_transform(rows, "standard" if standard else "modified")
        T = np.broadcast_to(np.eye(4), (len(members), 4, 4))
        for i in range(n):
            T = T @ links[:, i]
        for k, chain in zip(members, T, strict=True):
            out[k] = _finished(tables[k], chain)
    return out


def _finished(t: Table, chain: Floats) -> Floats:
    parts = {"b": t.base, "c": chain, "t": t.tool}
    T = np.eye(4)
    for letter in t.ends:
        T = T @ parts[letter]
    for change in t.after:
        T = change(T)
    return T


def chain_slips(chain: Chain, table: bool = False) -> list[Slip[Table]]:
    """All slips for a chain; with `table` those that a table itself can show."""
    slips = [*_numbers(chain), *_links(chain), *_columns(chain), *_joints(chain, table)]
    slips += _ends(chain)
    if not table:
        slips += [_after(m, change) for m, change in after_slips(rotation=False)]
    return slips


def _after(m: Mistake, change: After) -> Slip[Table]:
    return Slip(m, lambda t: replace(t, after=(*t.after, change)))


def _edit(change: Callable[[Floats], None]) -> Callable[[Table], Table]:
    def edited(t: Table) -> Table:
        rows = t.rows.copy()
        change(rows)
        return replace(t, rows=rows)

    return edited


def _negate(i: int, k: int) -> Callable[[Table], Table]:
    def change(rows: Floats) -> None:
        rows[i, k] *= -1

    return _edit(change)


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
                yield Slip(mistake(f"sign-{name}-{i + 1}", when, question), _negate(i, k))
        if kind == "r" and row.a != row.d:
            when = f"a and d are exchanged in row {i + 1}"
            question = "Which of the two lengths lies along x, which along z?"
            yield Slip(mistake(f"a-d-{i + 1}", when, question), _exchange(i))


def _columns(chain: Chain) -> Iterator[Slip[Table]]:
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


def _links(chain: Chain) -> Iterator[Slip[Table]]:
    other = "modified" if chain.convention == "standard" else "standard"
    yield Slip(
        mistake(
            "convention",
            f"the table is read in the {other} convention",
            "Which comes first in a row of your convention: the link or the joint?",
        ),
        lambda t: replace(t, standard=not t.standard),
    )
    question = "Between which two axes do alpha and a of row i lie?"
    for step, way in ((-1, "next"), (1, "previous")):

        def shifted(rows: Floats, step: int = step) -> None:
            rows[:, :2] = np.roll(rows[:, :2], step, axis=0)
            rows[-1 if step < 0 else 0, :2] = 0

        when = f"alpha and a are shifted by one: each row has those of the {way} one"
        yield Slip(mistake(f"shifted-{way}", when, question), _edit(shifted))


def _joints(chain: Chain, table: bool) -> Iterator[Slip[Table]]:
    n = chain.n
    if chain.offset.any():
        yield Slip(
            mistake("no-offset", "the offset is forgotten", "Where does each joint count from?"),
            lambda t: replace(t, offset=np.zeros(n)),
        )
    if table:
        return
    if chain.home.any():
        when = "the home value of the table is added to the joint variable"
        question = "Does a joint variable stand in place of the table's value, or is it added?"
        home = chain.home
        m = mistake("home-added", when, question)
        yield Slip(m, lambda t: replace(t, q=t.q + home))
    for i, kind in enumerate(chain.kinds):
        yield from _joint(i, kind, n)
    yield from _units(chain)
    if n > 1:
        when = "the links are multiplied in the reverse order"
        question = "Which frame's pose stands leftmost in the product?"
        m = mistake("reversed-order", when, question)
        yield Slip(m, lambda t: replace(t, use=t.use[::-1]))


def _joint(i: int, kind: str, n: int) -> Iterator[Slip[Table]]:
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
    question = "Do the sine and cosine of numpy take degrees or radians?"
    for key, factor, when in (
        ("degrees", radians(1), "joint angles in radians are taken for degrees"),
        ("radians", degrees(1), "joint angles are put in as degrees"),
    ):
        yield Slip(
            mistake(key, when, question),
            lambda t, factor=factor: replace(  # type: ignore[misc]
                t, q=np.where(turning, t.q * factor, t.q)
            ),
        )


def _ends(chain: Chain) -> Iterator[Slip[Table]]:
    if not np.array_equal(chain.base, np.eye(4)):
        m = mistake("no-base", "the base is left out", "In which frame is the tip asked for?")
        yield Slip(m, lambda t: replace(t, base=np.eye(4)))
        side = "On which side of the product does the pose of the base stand?"
        m = mistake("base-side", "the base is multiplied on the right instead of the left", side)
        for ends in ("ctb", "cbt"):
            yield Slip(m, lambda t, ends=ends: replace(t, ends=ends))  # type: ignore[misc]
    if not np.array_equal(chain.grasper, np.eye(4)):
        m = mistake("no-tool", "the tool is left out", "Which point of the hand is asked for?")
        yield Slip(m, lambda t: replace(t, tool=np.eye(4)))
        side = "On which side of the product does the pose of the tool stand?"
        m = mistake("tool-side", "the tool is multiplied on the left instead of the right", side)
        for ends in ("tbc", "btc"):
            yield Slip(m, lambda t, ends=ends: replace(t, ends=ends))  # type: ignore[misc]
