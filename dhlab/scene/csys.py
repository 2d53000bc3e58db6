"""Coordinate systems: three labelled axes at a pose."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from dhlab.scene.frame_look import frame_nodes
from dhlab.scene.node import Node
from dhlab.scene.placed import Placed
from dhlab.scene.setting import Setting, flag, fraction, positive


class Csys(Placed):
    """A coordinate system to look at and to move; made by `csys`."""

    __slots__ = ("_labels", "_opacity", "_size")

    kind = "csys"

    size: Setting[float] = Setting(positive, "float [m]: length of the axes.")
    labels: Setting[bool] = Setting(flag, "bool: whether name and axes are labelled.")
    opacity: Setting[float] = Setting(fraction, "float in [0, 1]: 1 hides what is behind.")

    def __init__(self, name: str | None = None) -> None:
        super().__init__(name)
        self._size = 1.0
        self._labels = True
        self._opacity = 1.0

    def _nodes(self, path: str) -> dict[str, Node]:
        label = self._name if self._labels else None
        labelled = "xyz" if self._labels else ""
        return {path: self._own_node()} | frame_nodes(
            path,
            self._size,
            name=label,
            subscript=label or "",
            labelled=labelled,
            opacity=self._opacity,
        )

    def __repr__(self) -> str:
        return f"Csys {self.name!r} at {placement_text(self.pose)}"


def csys(
    T: ArrayLike | None = None,
    *,
    name: str | None = None,
    size: float = 1.0,
    labels: bool = True,
    opacity: float = 1.0,
    visible: bool = True,
) -> Csys:
    """Make a coordinate system at a pose.

    Parameters
    ----------
    T : array_like, shape (4, 4) or (3,), optional
        Pose in the world, or its origin alone [m]; at the origin unless given.
    name : str, optional
        Written at the origin as {name}, and behind the axes' letters.
    size : float [m]
        Length of the axes.
    labels : bool
        Whether name and axes are labelled.
    opacity : float in [0, 1]
    visible : bool

    Returns
    -------
    cs : Csys

    Raises
    ------
    InputError
        `T` is not a pose; `size` is not above 0.

    Examples
    --------
    >>> A = csys(name="A")
    >>> A.move((1, 2, 3))
    Csys 'A' at (1.0000, 2.0000, 3.0000), axes of its parent
    >>> A.pose[0, 3] = 5
    Traceback (most recent call last):
    ...
    ValueError: assignment destination is read-only

    References
    ----------
    Pajak, section 2.2.
    """
    handle = Csys(name)
    pose = np.eye(4) if T is None else T
    return handle.set(pose=pose, size=size, labels=labels, opacity=opacity, visible=visible)


def placement_text(pose: np.ndarray) -> str:
    """Return origin and orientation of a pose in a line: four decimals, no minus zero.

    Examples
    --------
    >>> placement_text(np.eye(4))
    '(0.0000, 0.0000, 0.0000), axes of its parent'
    """
    origin = ", ".join(f"{x:z.4f}" for x in pose[:3, 3])
    if np.allclose(pose[:3, :3], np.eye(3), rtol=0, atol=5e-5):
        return f"({origin}), axes of its parent"
    axes = "; ".join(
        f"{letter} = ({', '.join(f'{x:z.4f}' for x in pose[:3, k])})"
        for k, letter in enumerate("xyz")
    )
    return f"({origin}), {axes}"
