"""The way from the world to a handle, through all that carries it: where it ends, how it moves."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import reduce
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from dhlab.arrays import read_only
from dhlab.scene.node import IDENTITY, Clock, Curve


class Link(NamedTuple):
    """One link of a way: a frame in the frame before.

    Attributes
    ----------
    pose : ndarray, shape (4, 4)
        Where it stands.
    motion : Curve or None
        The planned motion that moves it, of a robot that of one joint; None where it stands still.
    poses : callable or None
        Gives where it stands at each instant of the motion, shape (steps, 4, 4).
    """

    pose: NDArray[np.float64]
    motion: Curve | None = None
    poses: Callable[[], NDArray[np.float64]] | None = None

    def along(self, clock: Clock) -> NDArray[np.float64]:
        """Return where it stands at each instant of a clock, or for all of them."""
        if self.motion is None or self.poses is None or self.motion.clock is not clock:
            return self.pose
        return self.poses()


def end_of(way: Sequence[Link]) -> NDArray[np.float64]:
    """Pose in the world of the end of a way, shape (4, 4)."""
    return read_only(reduce(np.matmul, (link.pose for link in way), IDENTITY))


def motion_along(way: Sequence[Link]) -> Curve | None:
    """Return how the end of a way moves in the world; None where all of it stands.

    A node has one clock. Where several motions with clocks of their own move a way, the last of
    them is played, and what moves by another clock stands where that other motion ends.

    Examples
    --------
    >>> from dhlab.scene.node import Clock
    >>> slide = np.tile(np.eye(4), (2, 1, 1))
    >>> slide[1, 0, 3] = 1
    >>> curve = Curve(Clock("a", np.array([0.0, 1.0])), slide)
    >>> link = Link(slide[1], curve, lambda: slide)
    >>> motion_along([link, link]).samples[:, 0, 3]
    array([0., 2.])
    """
    motions = [link.motion for link in way if link.motion is not None]
    if not motions:
        return None
    clock, _, rest = motions[-1]
    poses = reduce(np.matmul, (link.along(clock) for link in way))
    return Curve(clock, read_only(poses), rest)


class MotionAlong:
    """The motion along a way, worked out anew only where the way has changed: it is sent once."""

    __slots__ = ("_curve", "_way")

    def __init__(self) -> None:
        self._way: tuple[tuple[NDArray[np.float64], Curve | None], ...] = ()
        self._curve: Curve | None = None

    def __call__(self, way: Sequence[Link]) -> Curve | None:
        """Return the motion, the same object for as long as it is the same."""
        if not self._fits(way):
            self._way = tuple((link.pose, link.motion) for link in way)
            self._curve = motion_along(way)
        return self._curve

    def _fits(self, way: Sequence[Link]) -> bool:
        return len(way) == len(self._way) and all(
            link.motion is motion and np.array_equal(link.pose, pose)
            for link, (pose, motion) in zip(way, self._way, strict=True)
        )
