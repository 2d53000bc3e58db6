"""From which zeros the joints of a robot may count so that its tips move alike.

Most zeros are settled by how a tip moves. Of joints that do the same, such as two slides along one
direction, only the sum is: so what is allowed is a point and the directions in which it may go.
"""

from dataclasses import dataclass

import numpy as np

from dhlab.diagnosis.gauge import screws
from dhlab.diagnosis.paths import Path
from dhlab.diagnosis.values import Floats

SMALL = 1e-4
"""A motion of a tip below this, for a joint's own of 1, is none: numbers such as 1.5708 come."""


@dataclass(frozen=True, eq=False)
class Zeros:
    """Offsets of all joints, and in which directions they may change together.

    Attributes
    ----------
    offsets : ndarray, shape (n,) [rad or m]
    free : ndarray, shape (n, k)
        A direction each column, orthonormal.
    """

    offsets: Floats
    free: Floats

    @classmethod
    def of(cls, n: int, settled: bool = False) -> "Zeros":
        """Offsets of n joints of which nothing is known; or, settled, all 0."""
        return cls(np.zeros(n), np.zeros((n, 0)) if settled else np.eye(n))

    def met(self, row: Floats, value: float) -> "Zeros":
        """Offsets whose sum, weighted by a row of shape (n,), has a value; where that is open."""
        lever = row @ self.free
        size = np.linalg.norm(lever)
        if size <= SMALL:
            return self
        offsets = self.offsets + self.free @ lever * (value - row @ self.offsets) / size**2
        kept = np.linalg.svd(lever[None])[2][1:]
        return Zeros(offsets, self.free @ kept.T)

    def on(self, way: Path, offsets: Floats, base_free: bool, tool_free: bool) -> "Zeros":
        """Offsets with which the ends of a path move as they do with these, of its own joints."""
        zeros = self
        for row in _settling(way, base_free, tool_free):
            whole = np.zeros(len(self.offsets))
            whole[list(way.numbers)] = row
            zeros = zeros.met(whole, row @ offsets)
        return zeros

    def at(self, joint: int, value: float, turning: bool) -> "Zeros":
        """Offsets with this one for a joint, where that is open; if it turns, up to full turns."""
        near = self.turned(joint, value) if turning else self
        return near.met(np.eye(len(self.offsets))[joint], value)

    def turned(self, joint: int, value: float) -> "Zeros":
        """Offsets with full turns added to that of a joint, so that it comes near to a value."""
        offsets = self.offsets.copy()
        offsets[joint] += 2 * np.pi * np.round((value - offsets[joint]) / (2 * np.pi))
        return Zeros(offsets, self.free)


def _settling(way: Path, base_free: bool, tool_free: bool) -> Floats:
    """What the ends of a path settle: sums of offsets, a row each, shape (m, n)."""
    rng = np.random.default_rng(7)
    moved, given = [], []
    for q in rng.uniform(-2, 2, (6, way.n)):
        there = screws(way, q)
        turns = np.array([k == "r" for k in way.kinds])[:, None]
        linear = np.where(turns, np.cross(there.p, there.u), there.u)
        moved.append(np.hstack([linear, turns * there.u]).T)
        ends = [np.eye(6)] * base_free + [_carried(there.tip)] * tool_free
        given.append(np.hstack([np.zeros((6, 0)), *ends]))
    J, F = np.vstack(moved), np.vstack(given)
    if F.size:
        U, size, _ = np.linalg.svd(F, full_matrices=False)
        Q = U[:, size > SMALL]
        J = J - Q @ (Q.T @ J)
    return _reduced(J)


def _carried(T: Floats) -> Floats:
    """Velocities of a pose told in its own frame, told in the world: shape (6, 6)."""
    R, p = T[:3, :3], T[:3, 3]
    return np.block([[R, np.cross(p, R.T).T], [np.zeros((3, 3)), R]])


def _reduced(rows: Floats) -> Floats:
    """Rows that span the same, as few as can be, each with a 1 where all others have 0.

    Sums of angles come out with factors 1 and -1: so a full turn more or less in one of them
    stays one.
    """
    _, size, vh = np.linalg.svd(rows, full_matrices=False)
    left = vh[size > SMALL * np.sqrt(len(rows))]
    for k in range(len(left)):
        i, j = divmod(int(np.abs(left[k:]).argmax()), left.shape[1])
        left[[k, k + i]] = left[[k + i, k]]
        left[k] /= left[k, j]
        others = np.arange(len(left)) != k
        left[others] -= np.outer(left[others, j], left[k])
    out: Floats = left
    return out
