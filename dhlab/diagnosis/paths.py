"""Several chains that hang on each other, as paths between the world and the tips.

Where the inner frames of a robot stand is a choice, as long as what hangs on them is placed to
match. So two robots are compared by how the ends of their paths move.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from dhlab.diagnosis.values import Floats, inverted
from dhlab.kinematics.chain import Chain
from dhlab.kinematics.dh import JointKind, joint_motion
from dhlab.kinematics.mechanism import Branch

WORLD = -1
"""The end at which all paths to the tips begin."""

OVER = np.diag([1.0, -1.0, -1.0, 1.0])
"""Half a turn about x: a joint's axis turned over."""


class Part(NamedTuple):
    """A chain with joints, and on which other it hangs.

    Attributes
    ----------
    chain : Chain
    on : int
        Which part carries it; -1: none.
    at : int
        Frame of that part: 0 the base, 1 to n the joint frames.
    base : ndarray, shape (4, 4)
        Pose of its base in that frame.
    """

    chain: Chain
    on: int
    at: int
    base: Floats


@dataclass(frozen=True, eq=False)
class Path:
    """The joints from one end to another, and the constant poses between them; it is `Moving`.

    Attributes
    ----------
    numbers : tuple of int
        Which joints of the whole robot they are.
    kinds : tuple of str
        A letter each.
    poses : tuple of ndarray, each (4, 4)
        What stands before each joint, and behind the last: one more than joints.
    backwards : int
        So many joints, the first ones, are passed from behind.
    """

    numbers: tuple[int, ...]
    kinds: tuple[JointKind, ...]
    poses: tuple[Floats, ...]
    backwards: int = 0

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.kinds)

    @property
    def joints(self) -> str:
        """A letter each."""
        return "".join(self.kinds)

    @property
    def offset(self) -> Floats:
        """Zeros, shape (n,): offsets are part of the poses."""
        return np.zeros(self.n)

    @property
    def base(self) -> Floats:
        """Nothing: what stands first is one of the poses."""
        return np.eye(4)

    @property
    def grasper(self) -> Floats:
        """Pose behind the last joint."""
        return self.poses[-1]

    @property
    def constants(self) -> tuple[tuple[Floats, Floats], ...]:
        """Poses before and behind each joint; one that is passed from behind is turned over."""
        return tuple(
            (pose @ OVER, OVER) if i < self.backwards else (pose, np.eye(4))
            for i, pose in enumerate(self.poses[:-1])
        )

    def tip(self, q: Floats) -> Floats:
        """Pose of the far end in the near one, shape (..., 4, 4)."""
        T = np.broadcast_to(np.eye(4), (*q.shape[:-1], 4, 4))
        for i, (before, after) in enumerate(self.constants):
            T = T @ before @ joint_motion(self.kinds[i], q[..., i]) @ after
        out: Floats = T @ self.grasper
        return out


def parts_of(branches: Sequence[Branch]) -> list[Part]:
    """Parts of a mechanism: chains without joints go into the bases of what hangs on them."""
    parts: list[Part] = []
    places: list[tuple[int, int, Floats]] = []  # of each branch: where a child at frame 0 stands
    for _, chain, parent, at in branches:
        on, frame, base = places[parent] if parent >= 0 else (-1, 0, np.eye(4))
        if parent >= 0 and branches[parent].chain.n:
            frame = at
        base = base @ chain.base
        places.append((len(parts), 0, np.eye(4)) if chain.n else (on, frame, base))
        if chain.n:
            parts.append(Part(chain, on, frame, base))
    return parts


def joints_of(parts: Sequence[Part]) -> list[slice]:
    """Of each part, which joints of the whole robot are its own."""
    ends = np.cumsum([0, *(part.chain.n for part in parts)]).tolist()
    return [slice(a, b) for a, b in pairwise(ends)]


def tips(parts: Sequence[Part]) -> list[int]:
    """Parts at whose last frame nothing hangs."""
    carrying = {(part.on, part.at) for part in parts}
    return [i for i, part in enumerate(parts) if (i, part.chain.n) not in carrying]


def path(parts: Sequence[Part], tip: int, start: int = WORLD) -> Path:
    """Join what is on the way to the tip of a part, from the world or from another tip.

    Joints that both tips hang on do not move one against the other, and are left out.
    """
    there = _outwards(parts, tip)
    if start == WORLD:
        return there
    back = _outwards(parts, start)
    shared = 0
    for a, b in zip(there.numbers, back.numbers, strict=False):
        if a != b:
            break
        shared += 1
    first, *others = there.poses[shared:]
    return Path(
        back.numbers[shared:][::-1] + there.numbers[shared:],
        back.kinds[shared:][::-1] + there.kinds[shared:],
        (
            *(inverted(pose) for pose in back.poses[shared + 1 :][::-1]),
            inverted(back.poses[shared]) @ first,
            *others,
        ),
        backwards=back.n - shared,
    )


def _outwards(parts: Sequence[Part], tip: int) -> Path:
    """Path from the world."""
    own = joints_of(parts)
    numbers: list[int] = []
    kinds: list[JointKind] = []
    poses: list[Floats] = []
    stand = np.eye(4)
    for i, count in _way(parts, tip):
        chain = parts[i].chain
        stand = stand @ parts[i].base
        for k in range(count):
            before, after = chain.constants[k]
            numbers.append(own[i].start + k)
            kinds.append(chain.kinds[k])
            poses.append(stand @ before)
            stand = joint_motion(chain.kinds[k], chain.offset[k]) @ after
    poses.append(stand @ parts[tip].chain.grasper)
    return Path(tuple(numbers), tuple(kinds), tuple(poses))


def _way(parts: Sequence[Part], tip: int) -> list[tuple[int, int]]:
    """Parts from the world to one, each with how many of its joints count."""
    way, i, count = [(tip, parts[tip].chain.n)], tip, 0
    while parts[i].on >= 0 and len(way) <= len(parts):
        i, count = parts[i].on, parts[i].at
        way.append((i, count))
    return way[::-1]
