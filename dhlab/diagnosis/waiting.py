"""Motions that wait until a later axis settles them: how `gauge` brings screw onto screw.

The zero of a joint may be chosen freely; what that turns or shifts is not settled by the joint's
own axis, but by the next one that it does not leave in its place.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from dhlab.diagnosis.values import Floats
from dhlab.kinematics.angles import angvec2r
from dhlab.kinematics.transforms import pose_of


@dataclass(frozen=True, eq=False)
class State:
    """What is settled so far: the motion G of the rest, and motions that wait."""

    G: Floats
    offsets: Floats
    signs: tuple[float, ...] = ()
    turn: tuple[int, Floats, Floats] | None = None
    shifts: tuple[tuple[Floats, Floats], ...] = ()


def settle(
    kind: str, v: Floats, w: Floats, u0: Floats, p0: Floats, state: State, tol: float
) -> Iterator[tuple[float, State]]:
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
    kind: str, v: Floats, w: Floats, u0: Floats, p0: Floats, state: State, tol: float
) -> list[State]:
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


def _turned(state: State, a: Floats, b: Floats) -> State:
    """State after the waiting turn by the angle from a to b."""
    joint, z, c = state.turn or (-1, np.zeros(3), np.zeros(3))
    angle = float(np.arctan2(z @ np.cross(a, b), a @ b))
    R = angvec2r(angle, z)
    offsets = state.offsets.copy()
    if joint >= 0:
        offsets[joint] += angle
    return replace(state, G=pose_of(R, c - R @ c) @ state.G, offsets=offsets, turn=None)


def _shift(off: Floats, v: Floats | None, state: State, tol: float) -> State | None:
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


def reach(wanted: Floats, tip: Floats, state: State, tol: float) -> Iterator[State]:
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
