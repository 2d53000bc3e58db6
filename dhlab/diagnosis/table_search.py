"""The search for what went wrong in a table, up to every choice that a right table may make."""

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from itertools import combinations, product
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from dhlab.diagnosis.chain_slips import convention_mistake
from dhlab.diagnosis.slips import ALTERNATIVES, Explanation, Slip, unique
from dhlab.diagnosis.table_model import Table, chain_of, table_of
from dhlab.diagnosis.values import Floats
from dhlab.kinematics.chain import Chain

Matches: TypeAlias = Callable[[Chain, Chain], bool]
NEAR = 1e-3
"""Links as near as this are looked at closely; this is no bound on what is right."""
SAME = 1e-4
"""Numbers of a table as near as this are the same: room for four digits, not for a thousandth."""
MATCHES = 400
"""So many pairs are looked at closely, at most: an answer at once is worth more than the last."""


def explain_table(
    wanted: Chain, came: Chain, slips: Sequence[Slip[Table]], matches: Matches
) -> list[Explanation]:
    """Find the fewest slips that make the table that came, or one that moves as it does.

    Parameters
    ----------
    wanted, came : Chain
        With the same joints.
    slips : sequence of Slip
    matches : callable
        Whether the second chain moves as the first, up to the choices that are free.

    Returns
    -------
    explanations : list of tuples of Mistake
    """
    model = table_of(wanted, wanted.home)
    singles = [((slip.mistake,), slip.change(model)) for slip in slips]
    other = came.replace(convention="standard" if came.convention == "modified" else "modified")
    convention = convention_mistake(came.convention)
    found = [*_fitting(singles, wanted, came, matches)]
    if matches(wanted, other):
        found.append((convention,))
    if found or _is_one_number(wanted, came):
        return unique(found)
    together = [single for single, slip in zip(singles, slips, strict=True) if not slip.alone]
    with_convention = [
        ((convention, *e), wrong) for e, wrong in together if not _moves_columns(e[0].key)
    ]
    pairs = [
        pair
        for pair in combinations([slip for slip in slips if not slip.alone], 2)
        if not all(slip.mistake.key.startswith(("shifted-", "columns-")) for slip in pair)
    ]
    found = [
        *_fitting(with_convention, wanted, other, matches),
        *_fitting(_made(model, pairs), wanted, came, matches),
    ]
    named = {m.key for explanation in found for m in explanation}
    beside = [pair for pair in combinations(slips, 2) if _does_the_same(pair, named)]
    return unique([*found, *_fitting(_made(model, beside), wanted, came, matches)])


def _made(
    model: Table, pairs: Iterable[tuple[Slip[Table], Slip[Table]]]
) -> list[tuple[Explanation, Table]]:
    """Tables that pairs of slips make."""
    once: dict[int, Table] = {}
    made: list[tuple[Explanation, Table]] = []
    for first, second in pairs:
        if id(first) not in once:
            once[id(first)] = first.change(model)
        made.append(((first.mistake, second.mistake), second.change(once[id(first)])))
    return made


def _does_the_same(pair: tuple[Slip[Table], Slip[Table]], named: Collection[str]) -> bool:
    """Whether a slip of the pen may do, beside one that is named, what another one does."""
    one, other = pair
    return (one.alone and other.mistake.key in named) or (other.alone and one.mistake.key in named)


def _is_one_number(wanted: Chain, came: Chain) -> bool:
    """Whether one number alone of the table is another: too little to tell two slips by."""
    ends = (came.base, wanted.base), (came.grasper, wanted.grasper), (came.offset, wanted.offset)
    alike = all(np.allclose(one, other, atol=NEAR) for one, other in ends)
    if came.convention != wanted.convention or not alike:
        return False
    return int((np.abs(_rows(came) - _rows(wanted)) > NEAR).sum()) == 1


def _moves_columns(key: str) -> bool:
    """Whether a slip moves numbers about, as reading in the other convention does."""
    return key == "convention" or key.startswith(("shifted-", "columns-"))


def joint_counts(wanted: Chain, came: Chain, matches: Matches) -> Iterator[tuple[str, str]]:
    """Say which joint has no row in a table that has one less; or which row is one too many."""
    step = came.n - wanted.n
    if abs(step) != 1:
        return
    for i in range(wanted.n):
        rows, letters = list(wanted.rows), list(wanted.joints)
        if step < 0:
            del rows[i], letters[i]
        else:
            rows.insert(i, rows[i])
            letters.insert(i, letters[i])
        changed = wanted.replace(rows=rows, joints=letters, offset=None, limits=None)
        if matches(changed, came.replace(joints=letters)):
            key, how = ("skipped", "no row") if step < 0 else ("doubled", "two rows")
            yield f"{key}-{i + 1}", f"joint {i + 1} has {how}"
    if step > 0:
        for key, part, kept in (
            ("tool-row", "what stands behind the last joint", slice(0, -1)),
            ("base-row", "what stands before the first joint", slice(1, None)),
        ):
            left = came.replace(
                rows=came.rows[kept], joints=wanted.joints, offset=came.offset[kept], limits=None
            )
            if matches(wanted, left):
                yield key, f"{part} has a row of its own"


def invariants(chain: Chain) -> Floats:
    """What no choice changes between neighbouring axes, shape (3, n - 1).

    The cosine between two axes regardless of their senses; their distance, where both turn; and
    the way along an axis between the common normals on both sides of it, where there is one.
    """
    alpha, a = _links(chain)
    d = np.array([row.d for row in chain.rows[:-1]])
    return _invariant(alpha, a, d, chain.joints)


def _links(chain: Chain) -> tuple[Floats, Floats]:
    rows = np.array(chain.rows).reshape(-1, 4)
    links = rows[1:] if chain.convention == "modified" else rows[:-1]
    return links[:, 0], links[:, 1]


def _invariant(alpha: Floats, a: Floats, d: Floats, joints: str) -> Floats:
    turns = np.array([letter == "r" for letter in joints])
    both = turns[1:] & turns[:-1]
    slanted = (np.abs(np.sin(alpha)) > NEAR) & both
    between = np.zeros(alpha.shape)
    between[..., 1:] = np.where(slanted[..., 1:] & slanted[..., :-1], np.abs(d[..., 1:]), 0)
    return np.stack([np.abs(np.cos(alpha)), np.where(both, np.abs(a), 0), between], axis=-2)


def _fitting(
    candidates: Sequence[tuple[Explanation, Table]], wanted: Chain, came: Chain, matches: Matches
) -> list[Explanation]:
    """Explanations whose tables move as the one that came; links are compared first."""
    whole = [(e, t) for e, t in candidates if t.is_chain(wanted.n)]
    if not whole:
        return []
    rows = np.array([t.rows[:, list(t.columns)] for _, t in whole])
    shift = [0 if t.standard else 1 for _, t in whole]
    links = np.array([r[k : k + wanted.n - 1, :2] for r, k in zip(rows, shift, strict=True)])
    same_kinds = np.array(["".join(t.kinds) == came.joints for _, t in whole])
    there = _invariant(links[..., 0], links[..., 1], rows[:, :-1, 2], came.joints)
    off = np.abs(there - invariants(came)) > NEAR * (1 + np.abs(there))
    near = np.flatnonzero(~off.any(axis=(1, 2)) & same_kinds)[:MATCHES]
    ours = _told_in(came.convention, wanted)
    found: list[Explanation] = []
    for k in near.tolist():
        explanation, table = whole[k]
        wrong = _told_in(came.convention, chain_of(table))
        if (
            _holds_displaced(table, came)
            and matches(wrong, came)
            and (_stands_there(wrong, ours, came) or _mends(wrong, ours, came, matches))
        ):
            found.append(explanation)
            if len(found) > ALTERNATIVES:
                break
    return found


def _stands_there(wrong: Chain, wanted: Chain, came: Chain) -> bool:
    """Whether all that a slip has changed stands so in what came.

    Other slips may move the tip alike, in other places: of them nothing is known to be made.
    """
    there, before, after = (_told(chain) for chain in (came, wanted, wrong))
    changed = ~_same(before, after)
    return bool(_same(there, after)[changed].all())


def _mends(wrong: Chain, wanted: Chain, came: Chain, matches: Matches) -> bool:
    """Whether the numbers that a slip has changed, put right in what came, make it right.

    It may choose other axes than our table does: then their signs are others too.
    """
    before, after, there = (_rows(chain) for chain in (wanted, wrong, came))
    cells = tuple(np.argwhere(~_same(before, after)).T)
    if not 0 < len(cells[0]) <= 2 or _same(before, there).all():
        return False
    if not _same(np.abs(there[cells]), np.abs(after[cells])).all():
        return False
    for signs in product((1, -1), repeat=len(cells[0])):
        mended = np.array(came.rows)
        mended[cells] = signs * before[cells]
        if matches(wanted, came.replace(rows=mended)):
            return True
    return False


def _told_in(convention: str, chain: Chain) -> Chain:
    return chain.to_standard() if convention == "standard" else chain.to_modified()


def _rows(chain: Chain) -> Floats:
    """Rows with the variables at 0."""
    rows = np.array(chain.rows).reshape(-1, 4)
    for i, kind in enumerate(chain.kinds):
        rows[i, 3 if kind == "r" else 2] = 0
    return rows


def _told(chain: Chain) -> Floats:
    """All numbers of a table but its variables; angles by cosine and sine."""
    rows = _rows(chain)
    angles = np.array([np.cos(rows[:, ::3]), np.sin(rows[:, ::3])])
    ends = np.concatenate([chain.base.ravel(), chain.grasper.ravel()])
    return np.concatenate([angles.ravel(), rows[:, 1:3].ravel(), chain.offset, ends])


def _same(a: Floats, b: Floats) -> NDArray[np.bool_]:
    out: NDArray[np.bool_] = np.abs(a - b) <= SAME * (1 + np.abs(b))
    return out


def _holds_displaced(table: Table, came: Chain) -> bool:
    """Whether the numbers that stand in other columns are there: no free choice hides them."""
    for row, there, kind in zip(table.rows, came.rows, came.joints, strict=True):
        variable = 3 if kind == "r" else 2
        for place, column in enumerate(table.columns):
            moved = column not in (place, variable)
            if moved and abs(abs(there[place]) - abs(row[column])) > SAME:
                return False
    return True
