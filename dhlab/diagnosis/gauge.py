"""When two tables are the same mechanism: up to signs and zeros of joints, and free ends.

Joint i moves all that follows by a screw: a turn about a line, or a shift along a direction. Two
chains move their tips alike, up to ``q -> s q + o``, when the motions that `o` makes bring all
screws of one onto those of the other, up to their senses `s`. `match` finds such motions joint by
joint. A motion that leaves the next screw where it is waits (it commutes with that screw), until a
later screw or the tip settles it.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from dhlab.diagnosis.values import Floats, inverted
from dhlab.kinematics.angles import angvec2r
from dhlab.kinematics.chain import Chain
from dhlab.kinematics.transforms import pose_of

TOLERANCE = 1e-5
"""Room for numbers such as 1.5708: lengths in m, angles in rad."""


@dataclass(frozen=True, eq=False)
class Screws:
    """Directions and points of the joints' axes, shape (n, 3), and the tip, at q + offset = 0."""

    kinds: str
    u: Floats
    p: Floats
    tip: Floats


@dataclass(frozen=True, eq=False)
class Match:
    """The renaming under which two chains agree: ``B @ other.tip(s * q + o) @ E``."""

    signs: Floats
    offsets: Floats
    base: Floats
    tool: Floats


@dataclass(frozen=True, eq=False)
class _State:
    """What is settled so far: the motion G of the rest, and motions that wait."""

    G: Floats
    offsets: Floats
    signs: tuple[float, ...] = ()
    turn: tuple[int, Floats, Floats] | None = None
    shifts: tuple[tuple[Floats, Floats], ...] = ()


def match(
    wanted: Chain,
    came: Chain,
    base_free: bool = False,
    tool_free: bool = False,
    zero_free: bool = True,
    tolerance: float = TOLERANCE,
) -> Match | None:
    """Find how the joints of `came` must be renamed to move its tip as `wanted` does.

    Parameters
    ----------
    wanted, came : Chain
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
    if wanted.joints != came.joints:
        return None
    A, B = screws(wanted), screws(came)
    if base_free and not tool_free:
        A, B, tool_known = _backwards(A), _backwards(B), False
        starts = iter([_start(A)])
        flip = True
    else:
        starts = _free_starts(A, B, tolerance) if base_free else iter([_start(A)])
        tool_known, flip = not tool_free, False
    for start in starts:
        for end in _walk(A, B, start, tool_known, zero_free, tolerance):
            signs, offsets = np.array(end.signs), end.offsets
            if flip:
                signs, offsets = signs[::-1], offsets[::-1]
            found = _ends(wanted, came, signs, offsets, base_free, tool_free, end, B)
            if _agrees(wanted, came, found, tolerance):
                return found
    return None


def screws(chain: Chain) -> Screws:
    """Screws of a chain."""
    previous, u, p = chain.base, [], []
    for before, after in chain.constants:
        previous = previous @ before
        u.append(previous[:3, 2])
        p.append(previous[:3, 3])
        previous = previous @ after
    shape = (chain.n, 3)
    return Screws(
        chain.joints, np.reshape(u, shape), np.reshape(p, shape), previous @ chain.grasper
    )


def _start(A: Screws) -> _State:
    return _State(np.eye(4), np.zeros(len(A.kinds)))


def _backwards(A: Screws) -> Screws:
    """Screws of the inverse motion: the base seen from the tip."""
    T = inverted(A.tip)
    R, t = T[:3, :3], T[:3, 3]
    return Screws(A.kinds[::-1], -(A.u @ R.T)[::-1], (A.p @ R.T + t)[::-1], T)


def _free_starts(A: Screws, B: Screws, tol: float) -> Iterator[_State]:
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
    A: Screws, B: Screws, state: _State, tool_known: bool, zero_free: bool, tol: float
) -> Iterator[_State]:
    """All ways to bring the screws of B onto those of A, from this state on."""
    i = len(state.signs)
    if i == len(A.kinds):
        if not tool_known:
            yield state
        else:
            yield from _reach(A.tip, B.tip, state, tol)
        return
    v, w = A.u[i], A.p[i]
    for sign, settled in _settle(A.kinds[i], v, w, B.u[i], B.p[i], state, tol):
        u = settled.G[:3, :3] @ B.u[i]
        turn, shifts = settled.turn, settled.shifts
        if zero_free and A.kinds[i] == "r":
            turn = (i, u, w)
        elif zero_free:
            shifts = (*shifts, (np.eye(len(A.kinds))[i], u))
        after = replace(settled, signs=(*state.signs, sign), turn=turn, shifts=shifts)
        yield from _walk(A, B, after, tool_known, zero_free, tol)


def _settle(
    kind: str, v: Floats, w: Floats, u0: Floats, p0: Floats, state: _State, tol: float
) -> Iterator[tuple[float, _State]]:
    """Use the waiting motions to bring one screw into its place, in either sense."""
    for sign in (1.0, -1.0):
        for turned in _turnings(kind, sign * v, w, u0, p0, state, tol):
            u = turned.G[:3, :3] @ u0
            if np.linalg.norm(u - sign * v) > 3 * tol:
                continue
            if kind == "p":
                yield sign, turned
                continue
            off = w - (turned.G[:3, :3] @ p0 + turned.G[:3, 3])
            shifted = _shift(off, v, turned, tol)
            if shifted is not None:
                yield sign, shifted


def _turnings(
    kind: str, v: Floats, w: Floats, u0: Floats, p0: Floats, state: _State, tol: float
) -> list[_State]:
    """States after the waiting turn: as it must be, or still waiting where it does not matter."""
    if state.turn is None:
        return [state]
    _, z, c = state.turn
    u, p = state.G[:3, :3] @ u0, state.G[:3, :3] @ p0 + state.G[:3, 3]
    if np.linalg.norm(np.cross(u, z)) > tol:
        a, b = _perp(u, z), _perp(v, z)
        return [_turned(state, a, b)] if np.linalg.norm(b) > tol else []
    if kind == "p":
        return [state]
    a, b = _perp(p - c, z), _perp(w - c, z)
    if max(np.linalg.norm(a), np.linalg.norm(b)) <= tol:
        return [state]
    if abs(np.linalg.norm(a) - np.linalg.norm(b)) > 3 * tol:
        return []
    return [_turned(state, a, b)]


def _turned(state: _State, a: Floats, b: Floats) -> _State:
    """State after the waiting turn by the angle from a to b."""
    joint, z, c = state.turn or (-1, np.zeros(3), np.zeros(3))
    angle = float(np.arctan2(z @ np.cross(a, b), a @ b))
    R = angvec2r(angle, z)
    offsets = state.offsets.copy()
    if joint >= 0:
        offsets[joint] += angle
    return replace(state, G=pose_of(R, c - R @ c) @ state.G, offsets=offsets, turn=None)


def _shift(off: Floats, v: Floats | None, state: _State, tol: float) -> _State | None:
    """State after waiting shifts that make up for `off`, but for what lies along v."""
    P = np.eye(3) if v is None else np.eye(3) - np.outer(v, v)
    if not state.shifts:
        return state if np.linalg.norm(P @ off) <= 3 * tol else None
    C = np.array([c for c, _ in state.shifts])
    D = np.array([d for _, d in state.shifts]).T
    U, size, vh = np.linalg.svd(P @ D)
    rank = int((size > 1e-6).sum())  # an absolute bound: shifts along v come out as rounding errors
    x = vh[:rank].T @ ((U[:, :rank].T @ P @ off) / size[:rank])
    if np.linalg.norm(P @ (D @ x - off)) > 3 * tol:
        return None
    rest = vh[rank:]
    lengths = np.linalg.norm(rest @ D.T, axis=1)
    left: tuple[tuple[Floats, Floats], ...] = ()
    if v is not None and len(rest) and lengths.max() > 1e-6:
        y = rest[int(lengths.argmax())] / lengths.max()
        left = ((y @ C, D @ y),)
    G = pose_of(np.eye(3), D @ x) @ state.G
    return replace(state, G=G, offsets=state.offsets + x @ C, shifts=left)


def _reach(wanted: Floats, tip: Floats, state: _State, tol: float) -> Iterator[_State]:
    """Use what still waits to bring the tip into its place."""
    came = state.G @ tip
    if state.turn is not None:
        z = state.turn[1]
        k = int(np.linalg.norm(np.cross(z, came[:3, :3].T), axis=1).argmax())
        state = _turned(state, _perp(came[:3, k], z), _perp(wanted[:3, k], z))
        came = state.G @ tip
    shifted = _shift(wanted[:3, 3] - came[:3, 3], None, state, tol)
    if shifted is not None and np.abs(came[:3, :3] - wanted[:3, :3]).max() <= 10 * tol:
        yield shifted


def _perp(a: Floats, z: Floats) -> Floats:
    return a - z * (a @ z)


def _ends(
    wanted: Chain,
    came: Chain,
    signs: Floats,
    offsets: Floats,
    base_free: bool,
    tool_free: bool,
    end: _State,
    B: Screws,
) -> Match:
    """What stands before and behind, once the joints are named."""
    zero = -wanted.offset
    there = came.tip(offsets - came.offset)
    goal = wanted.tip(zero)
    before, behind = np.eye(4), np.eye(4)
    if base_free and not tool_free:
        before = goal @ inverted(there)
    elif base_free:
        before = end.G @ B.tip @ inverted(there)
    if tool_free:
        behind = inverted(before @ there) @ goal
    return Match(signs, offsets, before, behind)


def _agrees(wanted: Chain, came: Chain, found: Match, tol: float) -> bool:
    """Whether the tips agree for all of a set of configurations."""
    q = np.random.default_rng(7).uniform(-2, 2, (8, wanted.n))
    T = found.base @ came.tip(found.signs * q + found.offsets - came.offset) @ found.tool
    room = 100 * tol * (1 + float(np.abs(wanted.tip(q - wanted.offset)).max()))
    return bool(np.abs(T - wanted.tip(q - wanted.offset)).max() <= room)
