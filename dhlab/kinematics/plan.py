"""How all frames of a tree are computed at once, for one configuration and for many.

A frame hangs on another one by what stands still between them and by the motion of one joint. All
frames of one depth in the tree follow from those of the depth above in one product.
"""

from collections.abc import Callable, Sequence
from itertools import groupby
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from dhlab.kinematics.dh import JointKind

Index: TypeAlias = int | slice | NDArray[np.intp]

WORLD = -1
CHUNK = 1024  # configurations at a time: their frames stay in the processor's cache


class Frame(NamedTuple):
    """A frame of the tree: ``T = T_parent @ before @ joint_motion(kind, q[variable]) @ after``.

    The last joint of a chain moves two frames, its own and the grasper's.
    """

    name: str
    parent: int
    before: NDArray[np.float64]
    after: NDArray[np.float64]
    kind: JointKind
    variable: int


class Level(NamedTuple):
    """Frames of one depth in the tree, computed at once.

    Attributes
    ----------
    frames, parents : int, slice or ndarray of int
        Where they and the frames that they hang on are in the plan.
    multiply : function
        The faster product of two poses, or of two arrays of poses.
    slide : bool
        Some of their joints are prismatic.
    go_on : bool
        Something stands behind their joints.
    """

    frames: int | slice
    parents: Index
    multiply: Callable[..., NDArray[np.float64]]
    slide: bool
    go_on: bool


class Plan:
    """The frames of a tree, ordered by levels, and their constants.

    Parameters
    ----------
    tree : sequence of Frame
        Each frame behind its parent.
    """

    def __init__(self, tree: Sequence[Frame]) -> None:
        rank: list[tuple[int, bool]] = []  # depth in the tree; whether something stands behind
        for frame in tree:
            depth = rank[frame.parent][0] + 1 if frame.parent != WORLD else 0
            rank.append((depth, not np.array_equal(frame.after, np.eye(4))))
        by_level = sorted(range(len(tree)), key=rank.__getitem__)
        frames = [tree[i] for i in by_level]
        kinds = {frame.variable: frame.kind for frame in frames}
        self.place = np.argsort(by_level)
        self.variables = np.array([frame.variable for frame in frames])
        self.turns = np.array([[[kinds[i] == "r"]] for i in range(len(kinds))])
        self.terms = np.array([_terms(frame) for frame in frames]).reshape(-1, 4, 16)
        self.before_T = np.array([[frame.before.T] for frame in frames])
        self.after_T = np.array([[frame.after.T] for frame in frames])
        levels = groupby(enumerate(frames), lambda numbered: rank[by_level[numbered[0]]])
        self.levels = [self._level(dict(level), go_on) for (_, go_on), level in levels]
        grounded = len({r for r in rank if r[0] == 0})  # so many levels hang on the world
        self.products = [level[:3] for level in self.levels[grounded:]]

    def _level(self, frames: dict[int, Frame], go_on: bool) -> Level:
        numbers, parents = list(frames), [frame.parent for frame in frames.values()]
        return Level(
            slice(numbers[0], numbers[-1] + 1) if len(numbers) > 1 else numbers[0],
            WORLD if parents[0] == WORLD else _index(self.place[parents].tolist()),
            np.matmul if len(numbers) > 1 else np.dot,
            any(frame.kind == "p" for frame in frames.values()),
            go_on,
        )

    def one(self, q: NDArray[np.float64]) -> NDArray[np.float64]:
        """Poses for one configuration, shape (frames, 4, 4).

        The pose of a frame on its parent is a sum of constants times 1, cos q, sin q and q.
        """
        q = q[self.variables]
        factors = np.empty((len(q), 1, 4))
        factors[:, 0, 0] = 1
        np.cos(q, factors[:, 0, 1])
        np.sin(q, factors[:, 0, 2])
        factors[:, 0, 3] = q
        links: NDArray[np.float64] = (factors @ self.terms).reshape(-1, 4, 4)
        T = links.copy()
        for i, parents, multiply in self.products:
            multiply(T[parents], links[i], T[i])
        T = T.take(self.place, axis=0)
        T.flags.writeable = False
        return T

    def many(self, q: NDArray[np.float64]) -> list[NDArray[np.float64]]:
        """Poses for many configurations, for each frame an array of shape (..., 4, 4).

        In memory the configurations lie side by side: what is done to one number of a pose is
        done to that of all configurations in one go.
        """
        steps = q.reshape(-1, q.shape[-1]).T
        T = np.zeros((len(self.place) + 1, 4, 4, steps.shape[1]))
        T[:, 3, 3] = 1
        T[WORLD, range(3), range(3)] = 1
        for start in range(0, steps.shape[1], CHUNK):
            chunk = slice(start, start + CHUNK)
            self._fill(T[:, :3, :, chunk], steps[:, None, chunk])
        T.flags.writeable = False
        T = np.moveaxis(T.reshape(len(T), 4, 4, *q.shape[:-1]), (1, 2), (-2, -1))
        return [T[i] for i in self.place]

    def _fill(self, T: NDArray[np.float64], q: NDArray[np.float64]) -> None:
        """Work out the upper three rows of all poses.

        A frame's columns x, y, z, p are its parent's, moved by what stands before the joint; then
        x and y turn by the joint's angle, or p slides along z. Cosine and sine come from the
        tangent of the half angle, at half the cost.

        Parameters
        ----------
        T : ndarray, shape (frames + 1, 3, 4, steps)
            Filled in here, but for the world, which is its last.
        q : ndarray, shape (n, 1, steps)

        References
        ----------
        Craig, Introduction to Robotics, eq. 4.35.
        """
        angle = np.where(self.turns, q, 0)
        u = np.tan(angle / 2)
        c = ((1 - u**2) / (1 + u**2))[self.variables]
        s = (2 * u / (1 + u**2))[self.variables]
        for i, parents, _, slide, go_on in self.levels:
            A = np.matmul(self.before_T[i], T[parents], out=T[i])
            x, y, z, p = (A[..., column, :] for column in range(4))
            A[..., 0, :], A[..., 1, :] = c[i] * x + s[i] * y, c[i] * y - s[i] * x
            if slide:
                p += (q - angle)[self.variables[i]] * z
            if go_on:
                A[:] = self.after_T[i] @ A


def _terms(frame: Frame) -> NDArray[np.float64]:
    """Matrices of 1, cos q, sin q and q in the pose of a frame on its parent, shape (4, 4, 4)."""
    motion = np.zeros((4, 4, 4))
    if frame.kind == "r":
        motion[0] = np.diag([0, 0, 1, 1])
        motion[1] = np.diag([1, 1, 0, 0])
        motion[2, :2, :2] = [[0, -1], [1, 0]]
    else:
        motion[0] = np.eye(4)
        motion[3, 2, 3] = 1
    terms: NDArray[np.float64] = frame.before @ motion @ frame.after
    return terms


def _index(numbers: list[int]) -> Index:
    """Numbers in the form that numpy takes fastest: a number, a slice, or else an array."""
    if len(set(numbers)) == 1:
        return numbers[0]
    if numbers == list(range(numbers[0], numbers[-1] + 1)):
        return slice(numbers[0], numbers[-1] + 1)
    return np.array(numbers)
