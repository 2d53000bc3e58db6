"""A csys to be put by hand where something will be: six joints in a row, so that sliders move it.

Its nodes are joints as those of a robot are. So a page moves it by itself, kernel or not.
"""

from __future__ import annotations

import os
from typing import Any

import numpy as np
from numpy.typing import NDArray

from dhlab.arrays import as_config, read_only
from dhlab.kinematics.angles import r2rpy, rpy2r
from dhlab.kinematics.transforms import inverse, rp2t
from dhlab.scene.frame_look import frame_nodes
from dhlab.scene.handle import Handle
from dhlab.scene.node import Joint, Node, Span
from dhlab.scene.setting import Setting

LETTERS = ("x", "y", "z", "yaw", "pitch", "roll")
KINDS = "ppprrr"
TURNED = {  # poses whose z axis is x, y or z
    "x": rp2t(np.array([[0.0, 0, 1], [1, 0, 0], [0, 1, 0]]), np.zeros(3)),
    "y": rp2t(np.array([[0.0, 1, 0], [0, 0, 1], [1, 0, 0]]), np.zeros(3)),
    "z": np.eye(4),
}
ALONG = ("x", "y", "z", "z", "y", "x")
ROOM = 3.0
"""How far the sliders go, in sizes of the csys."""


def guess_config(value: Any, what: str, current: NDArray[np.float64]) -> NDArray[np.float64]:
    """Check the six numbers of a guess."""
    return as_config(value, 6, what)


class Guess(Handle):
    """The csys that a student puts where a step will end.

    Parameters
    ----------
    name : str
    size : float [m]
        Length of its axes.
    start : ndarray, shape (4, 4)
        Where it stands at first, in the world.
    span : Span
        When it is seen.
    """

    __slots__ = ("_joints", "_label", "_q", "_size", "_span", "limits")

    kind = "guess"

    q: Setting[NDArray[np.float64]] = Setting(
        guess_config, "ndarray, shape (6,): x, y, z [m], yaw, pitch, roll [rad]."
    )

    def __init__(self, name: str, size: float, start: NDArray[np.float64], span: Span) -> None:
        super().__init__(name)
        self._label = self.name.partition("?")[0] + "?"
        roll, pitch, yaw = r2rpy(start[:3, :3])
        self._q = read_only([*start[:3, 3], yaw, pitch, roll])
        self._size = size
        self._span = span
        self._joints = tuple(
            Joint(kind, inverse(TURNED[axis]), os.urandom(6).hex())  # type: ignore[arg-type]
            for kind, axis in zip(KINDS, ALONG, strict=True)
        )
        reach = ROOM * size
        middle = np.round(start[:3, 3] / size) * size
        turns = 3 * [[-np.pi, np.pi]]
        self.limits = read_only([*([x - reach, x + reach] for x in middle), *turns])

    @property
    def keys(self) -> tuple[str, ...]:
        """Names of the six joints, by which sliders find them."""
        return tuple(joint.key for joint in self._joints)

    @property
    def pose(self) -> NDArray[np.float64]:
        """Where it stands in the world, shape (4, 4)."""
        return pose_of_guess(self._q)

    @property
    def world_pose(self) -> NDArray[np.float64]:
        """Pose in the world frame, shape (4, 4)."""
        return self.pose

    def _nodes(self, path: str) -> dict[str, Node]:
        nodes = {path: Node(span=self._span, visible=self._visible)}
        for letter, joint, axis, value in zip(LETTERS, self._joints, ALONG, self._q, strict=True):
            path = f"{path}/{letter}"
            nodes[path] = Node(pose=TURNED[axis], joint=joint, value=float(value))
        return nodes | frame_nodes(
            path, self._size, name=self._label, labelled="xyz", subscript="?", opacity=0.6
        )

    def __repr__(self) -> str:
        return f"Guess {self.name!r} at ({', '.join(f'{x:z.4f}' for x in self._q[:3])})"


def pose_of_guess(q: NDArray[np.float64]) -> NDArray[np.float64]:
    """Pose that the six numbers of a guess mean, shape (4, 4).

    Examples
    --------
    >>> pose_of_guess(np.array([1, 2, 3, 0, 0, 0.0]))[:3, 3]
    array([1., 2., 3.])
    """
    yaw, pitch, roll = q[3:]
    return rp2t(rpy2r(roll, pitch, yaw), q[:3])
