"""A tree of chains, and where all its frames are."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dhlab.arrays import as_array, read_only
from dhlab.errors import InputError
from dhlab.kinematics.chain import Chain
from dhlab.kinematics.dh import joint_motion
from dhlab.kinematics.plan import WORLD, Frame, Plan


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
                raise InputError(
                    f"'{branch.name}' is attached at frame {branch.at}; "
                    f"its parent has frames 0 to {n}"
                )

    @cached_property
    def n(self) -> int:
        """Number of variables."""
        return sum(branch.chain.n for branch in self.branches)

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Names of all frames: of each branch its joints from 1 and, where it ends, its grasper."""
        return tuple(frame.name for frame in self._tree)

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
        T = self._plan.one(q) if q.ndim == 1 else self._plan.many(q)
        return dict(zip(self.names, T, strict=True))

    def check(self, q: ArrayLike) -> NDArray[np.float64]:
        """Configurations within the limits; a value just outside is put on its limit.

        Parameters
        ----------
        q : array_like, shape (..., n) [rad or m]

        Raises
        ------
        LimitError
            For the first variable of the first chain that is further outside.
        """
        q = as_array(q, (..., self.n), f"q of '{self.branches[0].name}'")
        lower, upper = self._limits
        if np.count_nonzero((lower <= q) & (q <= upper)) == q.size:
            return q
        names = (branch.name.rpartition("/")[2] for branch in self.branches)
        parts = zip(self.branches, self.slices, names, strict=True)
        return read_only(np.concatenate([b.chain.check(q[..., s], n) for b, s, n in parts], -1))

    @cached_property
    def _limits(self) -> NDArray[np.float64]:
        return np.concatenate([branch.chain.limits for branch in self.branches]).T.copy()

    @cached_property
    def _tree(self) -> tuple[Frame, ...]:
        return tuple(_frames(self.branches))

    @cached_property
    def _plan(self) -> Plan:
        return Plan(self._tree)


def _frames(branches: Sequence[Branch]) -> list[Frame]:
    """All frames in the order of their names, each behind its parent."""
    still = np.eye(4)
    tree: list[Frame] = []
    taken = {(branch.parent, branch.at) for branch in branches}
    places: list[list[tuple[int, NDArray[np.float64]]]] = []  # of each branch: frame k stands ...
    variable = 0
    for number, (name, chain, parent, at) in enumerate(branches):
        carrier, stand = places[parent][at] if parent >= 0 else (WORLD, still)
        place = [(carrier, stand @ chain.base)]  # ... on this frame of the tree, in this pose
        for i, (before, after) in enumerate(chain.constants):
            carrier, stand = place[i]
            before = stand @ before @ joint_motion(chain.kinds[i], chain.offset[i])
            frame = Frame(f"{name}/{i + 1}", carrier, before, after, chain.kinds[i], variable)
            tree.append(frame)
            place.append((len(tree) - 1, still))
            variable += 1
        places.append(place)
        if chain.n and (number, chain.n) not in taken:
            tree.append(frame._replace(name=f"{name}/grasper", after=after @ chain.grasper))
    return tree
