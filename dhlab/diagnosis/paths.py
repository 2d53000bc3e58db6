"""Several chains that hang on each other, as paths from the world to each tip.

Where the inner frames of a robot stand is a choice, as long as what hangs on them is placed to
match. So two robots are compared by where their paths end, under one renaming of all joints.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from dhlab.diagnosis.gauge import Match, match
from dhlab.diagnosis.values import Floats
from dhlab.kinematics.chain import Chain
from dhlab.kinematics.dh import JointKind, joint_motion
from dhlab.kinematics.mechanism import Branch

NEAR = 1e-3
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
    """The joints from the world to a tip; as `Chain`, but anything may stand between them.

    Attributes
    ----------
    joints : str
        A letter each.
    numbers : tuple of int
        Which joints of the whole robot they are.
    base, grasper : ndarray, shape (4, 4)
    constants : tuple of pairs of ndarray, each (4, 4)
        What stands before and behind each joint.
    """

    joints: str
    kinds: tuple[JointKind, ...]
    numbers: tuple[int, ...]
    base: Floats
    grasper: Floats
    constants: tuple[tuple[Floats, Floats], ...]

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.kinds)

    @property
    def offset(self) -> Floats:
        """Zeros, shape (n,): offsets are part of the constants."""
        return np.zeros(self.n)

    def tip(self, q: Floats) -> Floats:
        """Pose of the tip, shape (..., 4, 4)."""
        T = np.broadcast_to(self.base, (*q.shape[:-1], 4, 4))
        for i, (before, after) in enumerate(self.constants):
            T = T @ before @ joint_motion(self.kinds[i], q[..., i]) @ after
        out: Floats = T @ self.grasper
        return out


@dataclass(frozen=True, eq=False)
class Naming:
    """How all joints of a robot are renamed, ``q -> signs q + offsets``, and a base before it."""

    signs: Floats
    offsets: Floats
    base: Floats

    def back(self, q: Floats) -> Floats:
        """Configuration before the renaming, shape (n,)."""
        return self.signs * (q - self.offsets)

    def of(self, joints: slice) -> Match:
        """Return the renaming of some of the joints."""
        zero = np.zeros_like(self.signs[joints])
        return Match(self.signs[joints], self.offsets[joints], self.base, np.eye(4), (zero, zero))


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


def renaming(
    wanted: Sequence[Part],
    came: Sequence[Part],
    base_free: bool = False,
    tool_free: bool = False,
    zero_free: bool = True,
) -> Naming | None:
    """Find one renaming of the joints under which all tips move alike.

    Parameters
    ----------
    wanted, came : sequence of Part
        As many, with as many joints each.
    base_free, tool_free, zero_free : bool
        As `match` takes them.

    Returns
    -------
    naming : Naming or None
        None: there is none.
    """
    if [part.chain.joints for part in wanted] != [part.chain.joints for part in came]:
        return None
    tips = ends(wanted)
    for first in tips:  # one path may leave open what another settles
        order = [first, *(i for i in tips if i != first)]
        found = _along(wanted, came, order, (base_free, tool_free, zero_free))
        if found is not None:
            return found
    return None


def ends(parts: Sequence[Part]) -> list[int]:
    """Parts at whose last frame nothing hangs."""
    carrying = {(part.on, part.at) for part in parts}
    return [i for i, part in enumerate(parts) if (i, part.chain.n) not in carrying]


def plain_naming(n: int) -> Naming:
    """Return the renaming of n joints that changes nothing."""
    return Naming(np.ones(n), np.zeros(n), np.eye(4))


def apart(
    wanted: Sequence[Part], came: Sequence[Part], named: Naming, q: Floats
) -> tuple[int, Floats, Floats] | None:
    """Find a tip that is elsewhere, if any, at a configuration or at some of all others.

    Parameters
    ----------
    wanted, came : sequence of Part
    named : Naming
        Of the joints that came.
    q : ndarray, shape (n,) [rad or m]
        In the variables of `wanted`.

    Returns
    -------
    found : (int, ndarray, ndarray) or None
        The part, where its tip came to be, and where it should be, each (4, 4).
    """
    others = np.random.default_rng(7).uniform(-2, 2, (8, len(q)))
    for one in (q, *others):
        for i in ends(wanted):
            A, B = path(wanted, i, plain_naming(len(q))), path(came, i, named)
            goal, T = A.tip(one[list(A.numbers)]), B.tip(one[list(B.numbers)])
            if np.abs(T - goal).max() > NEAR * (1 + np.abs(goal).max()):
                return i, T, goal
    return None


def _along(
    wanted: Sequence[Part],
    came: Sequence[Part],
    order: Sequence[int],
    free: tuple[bool, bool, bool],
) -> Naming | None:
    """Match path after path; what one settles holds for the next."""
    n = sum(part.chain.n for part in wanted)
    named, known = plain_naming(n), np.zeros(n, dtype=bool)
    base_free, tool_free, zero_free = free
    for i in order:
        A, B = path(wanted, i, plain_naming(n)), path(came, i, named)
        if A.numbers != B.numbers:
            return None
        numbers = list(A.numbers)
        fixed = np.flatnonzero(known[numbers]).tolist()
        found = match(A, B, base_free, tool_free, zero_free, fixed=fixed)
        if found is None:
            return None
        new = [k for k in range(A.n) if k not in fixed]
        joints = [numbers[k] for k in new]
        named.signs[joints], named.offsets[joints] = found.signs[new], found.offsets[new]
        known[joints] = True
        if base_free:
            named, base_free = Naming(named.signs, named.offsets, found.base), False
    return named


def path(parts: Sequence[Part], tip: int, named: Naming) -> Path:
    """Join what is on the way from the world to the tip of a part, with its joints renamed."""
    starts = np.cumsum([0, *(part.chain.n for part in parts)]).tolist()
    base, stand = named.base, np.eye(4)
    kinds: list[JointKind] = []
    numbers: list[int] = []
    constants: list[tuple[Floats, Floats]] = []
    for i, count in _way(parts, tip):
        chain = parts[i].chain
        stand = stand @ parts[i].base
        for k in range(count):
            before, after = chain.constants[k]
            j = starts[i] + k
            over = np.eye(4) if named.signs[j] > 0 else OVER
            still = joint_motion(chain.kinds[k], named.offsets[j] + chain.offset[k])
            constants.append((stand @ before @ over, over @ still @ after))
            kinds.append(chain.kinds[k])
            numbers.append(j)
            stand = np.eye(4)
    return Path(
        "".join(kinds),
        tuple(kinds),
        tuple(numbers),
        base,
        stand @ parts[tip].chain.grasper,
        tuple(constants),
    )


def _way(parts: Sequence[Part], tip: int) -> list[tuple[int, int]]:
    """Parts from the world to one, each with how many of its joints count."""
    way, i, count = [(tip, parts[tip].chain.n)], tip, 0
    while parts[i].on >= 0 and len(way) <= len(parts):
        i, count = parts[i].on, parts[i].at
        way.append((i, count))
    return way[::-1]
