"""Handles with a pose of their own: what coordinate systems and blocks have in common."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dhlab.arrays import as_placement, as_poses
from dhlab.scene.handle import Handle
from dhlab.scene.marks import Trail
from dhlab.scene.node import IDENTITY, Clock, Color, Curve, Node
from dhlab.scene.palette import INK
from dhlab.scene.setting import Setting
from dhlab.scene.way import Link, motion_along


class Placed(Handle):
    """A handle that stands at a pose in its parent; assign the pose and it moves.

    Parameters
    ----------
    name : str, optional
    """

    __slots__ = ("_curve", "_pose")

    pose: Setting[NDArray[np.float64]] = Setting(
        as_placement,
        "ndarray, shape (4, 4): pose in the parent (the world, where there is none), read-only. "
        "Takes a pose, a 3-vector (the orientation stays) or a rotation (the origin stays).",
    )

    def __init__(self, name: str | None = None) -> None:
        super().__init__(name)
        self._pose = IDENTITY
        self._curve: Curve | None = None

    def move(self, T: ArrayLike) -> Self:
        """Set the pose; relative motion is written out.

        ``b.move(b.pose @ T)`` moves relative to the block's own axes, ``b.move(T @ b.pose)``
        relative to the parent's.

        Parameters
        ----------
        T : array_like, shape (4, 4), (3,) or (3, 3)
            A pose, an origin [m] (the orientation stays) or a rotation (the origin stays).

        Returns
        -------
        handle : the handle itself

        Raises
        ------
        InputError
            `T` is none of these, or not a rotation.
        """
        return self.set(pose=T)

    def way(self) -> tuple[Link, ...]:
        """Return the frames from the world to this handle's own, each in the one before."""
        curve = self._curve
        if curve is None:
            return (*self._carrier(), Link(self._pose))
        return (*self._carrier(), Link(self._pose, curve, lambda: curve.samples))

    def check_samples(self, samples: ArrayLike, what: str) -> NDArray[np.float64]:
        """Check the poses of a motion, shape (steps, 4, 4)."""
        return as_poses(samples, what)

    def check_sample(self, sample: ArrayLike, what: str) -> NDArray[np.float64]:
        """Check one pose of a motion: whatever `move` takes."""
        return as_placement(sample, what, self._pose)

    def take_motion(self, clock: Clock, samples: NDArray[np.float64]) -> None:
        """Move along `samples` and end in the last; the lock is held, nobody is told."""
        self._pose = samples[-1]
        self._curve = Curve(clock, samples)

    def rest_in_motion(self, curves: tuple[Curve, ...], state: NDArray[np.float64]) -> None:
        """Stand in `state`, on the way of a motion with stops; the lock is held, nobody is told."""
        self._pose = state
        (self._curve,) = curves

    def trails(self, clock: Clock) -> list[Trail]:
        """Return the path of the origin in the world during a motion."""
        curve = motion_along(self.way())
        moves = curve is not None and curve.clock is clock
        poses = curve.samples if curve is not None and moves else self.world_pose[None]
        return [Trail("origin", poses[:, :3, 3], self._trail_color())]

    def _trail_color(self) -> Color:
        return INK

    def _store(self, checked: Any) -> None:
        super()._store(checked)
        if "pose" in checked:
            self._curve = None

    def _own_node(self) -> Node:
        """Return the node that all other nodes of this handle hang on."""
        return Node(pose=self._pose, visible=self._visible, curve=self._curve)
