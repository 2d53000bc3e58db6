"""When two tables are the same mechanism: up to signs and zeros of joints, and free ends.

Joint i moves all that follows by a screw: a turn about a line, or a shift along a direction. Two
chains move their tips alike, up to ``q -> s q + o``, when the motions that `o` makes bring all
screws of one onto those of the other, up to their senses `s`. `match` finds such motions joint by
joint. A motion that leaves the next screw where it is waits (it commutes with that screw), until a
later screw or the tip settles it.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import product
from typing import Protocol

import numpy as np

from dhlab.diagnosis.values import Floats, inverted
from dhlab.diagnosis.waiting import State, reach, settle
from dhlab.kinematics.dh import JointKind, joint_motion
from dhlab.kinematics.transforms import pose_of

TOLERANCE = 1e-5
"""Room for numbers such as 1.5708: lengths in m, angles in rad."""


class Moving(Protocol):
    """Joints one after the other, with constant poses between them: such as a `Chain`."""

    @property
    def n(self) -> int:
        """Number of joints."""

    @property
    def joints(self) -> str:
        """A letter each."""

    @property
    def kinds(self) -> tuple[JointKind, ...]:
        """The letters one by one."""

    @property
    def offset(self) -> Floats:
        """What is added to the variables."""

    @property
    def base(self) -> Floats:
        """Pose before the first joint."""

    @property
    def grasper(self) -> Floats:
        """Pose behind the last joint."""

    @property
    def constants(self) -> tuple[tuple[Floats, Floats], ...]:
        """Poses before and behind each joint."""

    def tip(self, q: Floats) -> Floats:
        """Pose of the tip, shape (..., 4, 4)."""


@dataclass(frozen=True, eq=False)
class Screws:
    """At one configuration: directions and points of the axes, shape (n, 3), and the tip."""

    kinds: str
    u: Floats
    p: Floats
    tip: Floats


@dataclass(frozen=True, eq=False)
class Match:
    """The renaming under which two chains agree: ``base @ came.tip(renamed(q)) @ tool``.

    `q` counts from the first of the `zeros`: that of the chain wanted.
    """

    signs: Floats
    offsets: Floats
    base: Floats
    tool: Floats
    zeros: tuple[Floats, Floats]

    def renamed(self, q: Floats) -> Floats:
        """Configuration of the chain that came, shape (..., n)."""
        return self.signs * q + self.offsets + self.zeros[1]


def match(
    wanted: Moving,
    came: Moving,
    base_free: bool = False,
    tool_free: bool = False,
    zero_free: bool = True,
    tolerance: float = TOLERANCE,
) -> Match | None:
    """Find how the joints of `came` must be renamed to move its tip as `wanted` does.

    Parameters
    ----------
    wanted, came : Chain, or another that is `Moving`
    base_free, tool_free : bool
        Whether a constant pose may stand before, or behind.
    zero_free : bool
        Whether joints may have other zeros.
    tolerance : float [rad or m]

    Returns
    -------
    match : Match or None
        None: there is no such renaming.
    """
    return next(matches(wanted, came, base_free, tool_free, zero_free, tolerance), None)


def matches(
    wanted: Moving,
    came: Moving,
    base_free: bool = False,
    tool_free: bool = False,
    zero_free: bool = True,
    tolerance: float = TOLERANCE,
    senses: Mapping[int, float] | None = None,
) -> Iterator[Match]:
    """Find all such renamings, one for each choice of senses.

    Parameters
    ----------
    wanted, came, base_free, tool_free, zero_free, tolerance
        As `match` takes them.
    senses : mapping from int to float, optional
        Joints, from 0, whose sense is known: 1 or -1.
    """
    if wanted.joints != came.joints:
        return
    zeros = (-wanted.offset, -came.offset) if zero_free else (0 * wanted.offset, 0 * came.offset)
    A, B = screws(wanted, zeros[0]), screws(came, zeros[1])
    if base_free and not tool_free:
        A, B, tool_known = _backwards(A), _backwards(B), False
        starts = iter([_start(A)])
        flip = True
    else:
        starts = _free_starts(A, B, tolerance) if base_free else iter([_start(A)])
        tool_known, flip = not tool_free, False
    known = {wanted.n - 1 - i if flip else i: sense for i, sense in (senses or {}).items()}
    told: set[bytes] = set()
    for start in starts:
        for end in _walk(A, B, start, tool_known, zero_free, tolerance, known):
            signs, offsets = np.array(end.signs), end.offsets
            if flip:
                signs, offsets = signs[::-1], offsets[::-1]
            begin = Match(signs, offsets, np.eye(4), np.eye(4), zeros)
            found = _ends(wanted, came, begin, base_free, tool_free, end.G @ B.tip)
            if signs.tobytes() not in told and _agrees(wanted, came, found, tolerance):
                told.add(signs.tobytes())
                yield found


def screws(chain: Moving, q: Floats) -> Screws:
    """Screws of a chain at a configuration."""
    previous, u, p = chain.base, [], []
    variables = q + chain.offset
    for (before, after), kind, variable in zip(
        chain.constants, chain.kinds, variables, strict=True
    ):
        previous = previous @ before
        u.append(previous[:3, 2])
        p.append(previous[:3, 3])
        previous = previous @ joint_motion(kind, variable) @ after
    shape = (chain.n, 3)
    return Screws(
        chain.joints, np.reshape(u, shape), np.reshape(p, shape), previous @ chain.grasper
    )


def _start(A: Screws) -> State:
    return State(np.eye(4), np.zeros(len(A.kinds)))


def _backwards(A: Screws) -> Screws:
    """Screws of the inverse motion: the base seen from the tip."""
    T = inverted(A.tip)
    R, t = T[:3, :3], T[:3, 3]
    return Screws(A.kinds[::-1], -(A.u @ R.T)[::-1], (A.p @ R.T + t)[::-1], T)


def _free_starts(A: Screws, B: Screws, tol: float) -> Iterator[State]:
    """Ways to put a free base so that the first axes agree; what then is free waits."""
    n = len(A.kinds)
    if n == 0:
        yield _start(A)
        return
    first = A.kinds.find("r")
    head = range(n if first < 0 else first + 1)
    j = next((k for k in head if np.linalg.norm(np.cross(A.u[0], A.u[k])) > tol), None)
    for s, t in product((1.0, -1.0), repeat=2):
        if j is None:
            if t < 0:
                continue
            R = _carry(B.u[0], s * A.u[0])
        elif np.linalg.norm(np.cross(B.u[0], B.u[j])) <= tol:
            return
        else:
            R = _axes(s * A.u[0], t * A.u[j]) @ _axes(B.u[0], B.u[j]).T
        at = max(first, 0)
        G = pose_of(R, A.p[at] - R @ B.p[at])
        state = replace(_start(A), G=G)
        if j is not None:
            yield replace(state, shifts=tuple((np.zeros(n), e) for e in np.eye(3)))
        else:
            yield replace(state, turn=(-1, A.u[at], A.p[at]), shifts=((np.zeros(n), A.u[at]),))


def _carry(u: Floats, v: Floats) -> Floats:
    """Some rotation that carries one direction onto another."""
    return _axes(v, _across(v)) @ _axes(u, _across(u)).T


def _across(u: Floats) -> Floats:
    return np.cross(u, np.eye(3)[int(np.abs(u).argmin())])


def _axes(u: Floats, v: Floats) -> Floats:
    z = np.cross(u, v)
    z = z / np.linalg.norm(z)
    return np.stack([u, np.cross(z, u), z], axis=1)


def _walk(
    A: Screws,
    B: Screws,
    state: State,
    tool_known: bool,
    zero_free: bool,
    tol: float,
    known: Mapping[int, float],
) -> Iterator[State]:
    """All ways to bring the screws of B onto those of A, from this state on."""
    i = len(state.signs)
    if i == len(A.kinds):
        if not tool_known:
            yield state
        else:
            yield from reach(A.tip, B.tip, state, tol)
        return
    v, w = A.u[i], A.p[i]
    for sign, settled in settle(A.kinds[i], v, w, B.u[i], B.p[i], state, tol):
        if sign != known.get(i, sign):
            continue
        u = settled.G[:3, :3] @ B.u[i]
        turn, shifts = settled.turn, settled.shifts
        if not zero_free:
            pass
        elif A.kinds[i] == "r":
            turn = (i, u, w)
        else:
            shifts = (*shifts, (np.eye(len(A.kinds))[i], u))
        after = replace(settled, signs=(*state.signs, sign), turn=turn, shifts=shifts)
        yield from _walk(A, B, after, tool_known, zero_free, tol, known)


def _ends(
    wanted: Moving, came: Moving, found: Match, base_free: bool, tool_free: bool, tip: Floats
) -> Match:
    """What stands before and behind, once the joints are named; `tip` is where the walk ends."""
    there = came.tip(found.renamed(np.zeros(wanted.n)))
    goal = wanted.tip(found.zeros[0])
    before, behind = np.eye(4), np.eye(4)
    if base_free and not tool_free:
        before = goal @ inverted(there)
    elif base_free:
        before = tip @ inverted(there)
    if tool_free:
        behind = inverted(before @ there) @ goal
    return replace(found, base=before, tool=behind)


def _agrees(wanted: Moving, came: Moving, found: Match, tol: float) -> bool:
    """Whether the tips agree for all of a set of configurations."""
    q = np.random.default_rng(7).uniform(-2, 2, (8, wanted.n))
    T = found.base @ came.tip(found.renamed(q)) @ found.tool
    goal = wanted.tip(found.zeros[0] + q)
    return bool(np.abs(T - goal).max() <= 100 * tol * (1 + float(np.abs(goal).max())))
