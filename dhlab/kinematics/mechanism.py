"""A tree of chains, and where all its frames are.

A frame hangs on another one by what stands still between them and by the motion of one joint. All
frames of one depth in the tree follow from those of the depth above in one product.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dhlab.arrays import as_array
from dhlab.errors import InputError
from dhlab.kinematics.chain import Chain
from dhlab.kinematics.dh import JointKind, joint_motion

Index: TypeAlias = int | slice | list[int]

WORLD = 0
CHUNK = 1024  # configurations at a time: their frames stay in the processor's cache


class Branch(NamedTuple):
    """A chain in a tree of chains.

    Attributes
    ----------
    name : str
        The whole path: ``"arm/hand/thumb"``.
    chain : Chain
        Its base is given in the frame that it is attached to.
    parent : int
        Number of the branch that it is attached to, from 0; -1: the world.
    at : int
        Frame of the parent that it is attached to: 0 the base, 1 to n the joint frames.
    """

    name: str
    chain: Chain
    parent: int = -1
    at: int = 0


class Frame(NamedTuple):
    """A frame of the tree: ``T = T_parent @ before @ joint_motion(kind, q[variable]) @ after``.

    Without a kind it stands still: ``T = T_parent @ before``.
    """

    name: str
    parent: int
    before: NDArray[np.float64]
    after: NDArray[np.float64]
    kind: JointKind | None = None
    variable: int = 0


class Level(NamedTuple):
    """All frames of one depth in the tree."""

    frames: Index
    parents: Index
    slide: bool  # some joints here are prismatic
    go_on: bool  # something stands behind some joints here: the standard convention


@dataclass(frozen=True, eq=False)
class Mechanism:
    """A tree of chains that never changes; its configuration joins theirs, in their order.

    Parameters
    ----------
    branches : sequence of Branch
        A parent comes before what is attached to it.

    Examples
    --------
    >>> slide = Chain([(0, 0, 0, 0)], "p", base=(0, 0, 1))
    >>> finger = Chain([(0, 0, 0, 0), (0, 0.3, 0, 0)], "rr", grasper=(0.2, 0, 0))
    >>> robot = Mechanism([Branch("slide", slide), Branch("slide/finger", finger, 0, at=1)])
    >>> robot.names
    ('slide/1', 'slide/finger/1', 'slide/finger/2', 'slide/finger/grasper')
    >>> robot.frames([0.5, 0, np.pi / 2])["slide/finger/grasper"][:3, 3].round(6)
    array([0.3, 0.2, 1.5])
    """

    branches: Sequence[Branch]

    def __post_init__(self) -> None:
        branches = tuple(self.branches)
        object.__setattr__(self, "branches", branches)
        if not branches:
            raise InputError("a mechanism needs at least one branch")
        if len({branch.name for branch in branches}) < len(branches):
            raise InputError(f"names of branches must differ, got {[b.name for b in branches]}")
        for i, branch in enumerate(branches):
            if branch.parent not in range(-1, i):
                raise InputError(f"parent of '{branch.name}' must come before it in the branches")
            n = branches[branch.parent].chain.n if branch.parent >= 0 else 0
            if branch.at not in range(n + 1):
                raise InputError(f"'{branch.name}' is attached at frame {branch.at} of 0 to {n}")

    @cached_property
    def n(self) -> int:
        """Number of variables."""
        return sum(branch.chain.n for branch in self.branches)

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Names of all frames: of each branch its joints from 1 and, where it ends, its grasper."""
        return tuple(frame.name for frame in self._plan.tree[1:])

    @cached_property
    def slices(self) -> tuple[slice, ...]:
        """Where the variables of each branch are in the configuration."""
        ends = np.cumsum([0, *(branch.chain.n for branch in self.branches)]).tolist()
        return tuple(map(slice, ends[:-1], ends[1:]))

    def frames(self, q: ArrayLike) -> dict[str, NDArray[np.float64]]:
        """Poses of all frames in the world; limits are not looked at.

        Parameters
        ----------
        q : array_like, shape (n,) or (steps, n) [rad or m]
            One configuration, or one per step.

        Returns
        -------
        frames : dict of str to ndarray, shape (4, 4) or (steps, 4, 4)
            Read-only poses by the names of `names`.
        """
        q = as_array(q, (..., self.n), f"q of '{self.branches[0].name}'")
        if not self.names:
            return {}
        T = self._one(q) if q.ndim == 1 else self._many(q)
        T.flags.writeable = False
        return dict(zip(self.names, T[1:], strict=True))

    @cached_property
    def _plan(self) -> "Plan":
        return Plan(_tree(self.branches))

    def _one(self, q: NDArray[np.float64]) -> NDArray[np.float64]:
        """Poses of the tree for one configuration, shape (frames, 4, 4).

        The pose of a frame on its parent is a sum of constants times 1, cos q, sin q and q.
        """
        plan = self._plan
        q = q[plan.variables]
        factors = np.ones((len(q), 1, 4))
        factors[:, 0, 1] = np.cos(q)
        factors[:, 0, 2] = np.sin(q)
        factors[:, 0, 3] = q
        T: NDArray[np.float64] = (factors @ plan.terms).reshape(-1, 4, 4)
        for level in plan.levels[1:]:
            product = np.dot if isinstance(level.frames, int) else np.matmul
            T[level.frames] = product(T[level.parents], T[level.frames])
        return T

    def _many(self, q: NDArray[np.float64]) -> NDArray[np.float64]:
        """Poses of the tree for many configurations, shape (frames, ..., 4, 4).

        In memory the configurations lie side by side: what is done to one number of a pose is
        done to that of all configurations in one go.
        """
        steps = q.reshape(-1, self.n).T[self._plan.variables]
        T = np.zeros((len(steps), 4, 4, steps.shape[1]))
        T[:, 3, 3] = 1
        T[WORLD, range(3), range(3)] = 1
        for start in range(0, steps.shape[1], CHUNK):
            chunk = slice(start, start + CHUNK)
            self._fill(T[:, :3, :, chunk], steps[:, None, chunk])
        return np.moveaxis(T.reshape(len(T), 4, 4, *q.shape[:-1]), (1, 2), (-2, -1))

    def _fill(self, T: NDArray[np.float64], q: NDArray[np.float64]) -> None:
        """Work out the upper rows of all poses, shape (frames, 3, 4, steps)."""
        plan = self._plan
        angle, slide = q * plan.turns, q * plan.slides
        c, s = np.cos(angle), np.sin(angle)
        for level in plan.levels:
            i = level.frames
            A = plan.before_T[i] @ T[level.parents]
            x, y, z, p = (A[..., column, :] for column in range(4))
            A[..., 0, :], A[..., 1, :] = c[i] * x + s[i] * y, c[i] * y - s[i] * x
            if level.slide:
                p += slide[i] * z
            T[i] = plan.after_T[i] @ A if level.go_on else A


class Plan:
    """What the frames of a tree have in common with those of any configuration.

    Parameters
    ----------
    tree : list of Frame
        The world first, and each frame behind its parent.
    """

    def __init__(self, tree: list[Frame]) -> None:
        self.tree = tree
        self.variables = np.array([frame.variable for frame in tree])
        self.turns = np.array([[[frame.kind == "r"]] for frame in tree], dtype=np.float64)
        self.slides = np.array([[[frame.kind == "p"]] for frame in tree], dtype=np.float64)
        self.terms = np.array([_terms(frame) for frame in tree]).reshape(-1, 4, 16)
        self.before_T = np.array([[frame.before.T] for frame in tree])
        self.after_T = np.array([[frame.after.T] for frame in tree])
        depth = [0]
        for frame in tree[1:]:
            depth.append(depth[frame.parent] + 1)
        self.levels = [
            self._level([i for i, d in enumerate(depth) if d == k])
            for k in range(1, max(depth) + 1)
        ]

    def _level(self, frames: list[int]) -> Level:
        members = [self.tree[i] for i in frames]
        return Level(
            _index(frames),
            _index([frame.parent for frame in members]),
            any(frame.kind == "p" for frame in members),
            any(not np.array_equal(frame.after, np.eye(4)) for frame in members),
        )


def _tree(branches: Sequence[Branch]) -> list[Frame]:
    """All frames, the world first, and each frame behind its parent."""
    still = np.eye(4)
    tree = [Frame("", WORLD, still, still)]
    taken = {(branch.parent, branch.at) for branch in branches}
    places: list[list[tuple[int, NDArray[np.float64]]]] = []  # of each branch: frame k stands ...
    variable = 0
    for number, (name, chain, parent, at) in enumerate(branches):
        carrier, stand = places[parent][at] if parent >= 0 else (WORLD, still)
        place = [(carrier, stand @ chain.base)]  # ... on this frame of the tree, in this pose
        for i, (before, after) in enumerate(chain.constants):
            carrier, stand = place[i]
            before = stand @ before @ joint_motion(chain.kinds[i], chain.offset[i])
            tree.append(Frame(f"{name}/{i + 1}", carrier, before, after, chain.kinds[i], variable))
            place.append((len(tree) - 1, still))
            variable += 1
        places.append(place)
        if chain.n and (number, chain.n) not in taken:
            tree.append(Frame(f"{name}/grasper", len(tree) - 1, chain.grasper, still))
    return tree


def _terms(frame: Frame) -> NDArray[np.float64]:
    """Matrices of 1, cos q, sin q and q in the pose of a frame on its parent, shape (4, 4, 4)."""
    motion = np.zeros((4, 4, 4))
    if frame.kind == "r":
        motion[0] = np.diag([0, 0, 1, 1])
        motion[1] = np.diag([1, 1, 0, 0])
        motion[2, :2, :2] = [[0, -1], [1, 0]]
    else:
        motion[0] = np.eye(4)
        motion[3, 2, 3] = frame.kind == "p"
    terms: NDArray[np.float64] = frame.before @ motion @ frame.after
    return terms


def _index(numbers: list[int]) -> Index:
    """Numbers in the form that numpy takes fastest: a number, a slice, or the list itself."""
    if len(set(numbers)) == 1:
        return numbers[0]
    stretch = slice(numbers[0], numbers[-1] + 1, numbers[1] - numbers[0])
    if stretch.step > 0 and list(range(numbers[-1] + 1))[stretch] == numbers:
        return stretch
    return numbers
