"""Arrows with a text: dimensions, axes and vectors of a drawing."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

import dhlab.shapes as shapes
from dhlab.arrays import as_vector, read_only
from dhlab.errors import InputError
from dhlab.kinematics.transforms import transl
from dhlab.scene import setting
from dhlab.scene.node import Color, Node, Style
from dhlab.scene.palette import INK
from dhlab.scene.placed import Placed
from dhlab.scene.setting import Setting
from dhlab.shapes import Label
from dhlab.shapes.between import pose_along

HEADS = ("end", "both", "none")
SLIMNESS = 0.3
LABEL_SIZE = 19.0


def _text(value: Any, what: str, current: Any) -> str:
    """Check the text of an arrow; an empty one writes nothing."""
    if not isinstance(value, str):
        raise InputError(f"{what} must be text, got {value!r}")
    return value


def _two_points(value: Any, what: str, current: Any) -> NDArray[np.float64]:
    """Check that an arrow leads from one point to another."""
    if not isinstance(value, list | tuple | np.ndarray) or len(value) != 2:
        raise InputError(f"{what} must be the points where it begins and ends, got {value!r}")
    p, q = as_vector(value[0], f"{what}: begin"), as_vector(value[1], f"{what}: end")
    if np.linalg.norm(q - p) < 1e-9:
        raise InputError(f"{what} begins and ends at one point, {p.tolist()}")
    return read_only([p, q])


class Arrow(Placed):
    """A line with heads and a text; made by `arrow`."""

    __slots__ = ("_color", "_head", "_heads", "_label", "_label_at", "_line_width", "_points")

    kind = "arrow"

    points: Setting[NDArray[np.float64]] = Setting(
        _two_points, "ndarray, shape (2, 3) [m]: where it begins and where it ends."
    )
    label: Setting[str] = Setting(_text, "str: written beside it; ``l_1`` has a subscript.")
    label_at: Setting[float] = Setting(
        setting.number, "float: where the label stands, 0 at the beginning, 1 at the end."
    )
    heads: Setting[str] = Setting(
        setting.one_of(*HEADS), "'end', 'both' (a dimension) or 'none' (an axis)."
    )
    head: Setting[float] = Setting(
        setting.positive_or_default, "float [m]: length of a head; None: what suits its length.",
        read=lambda arrow: arrow._head or 0.09 * arrow.length,
    )  # fmt: skip
    color: Setting[Color | None] = Setting(
        setting.color, "colour as 3 floats in [0, 1] or '#rrggbb'; None: ink."
    )
    line_width: Setting[float] = Setting(
        setting.positive, "float [pixel]: width of its line on the screen."
    )

    def __init__(self, p: ArrayLike, q: ArrayLike, name: str | None = None) -> None:
        super().__init__(name)
        self._points = _two_points((p, q), f"an arrow {name!r}" if name else "an arrow", None)
        self._label = ""
        self._label_at = 0.5
        self._heads = "end"
        self._head: float | None = None
        self._color: Color | None = None
        self._line_width = 3.0

    @property
    def length(self) -> float:
        """Distance from its beginning to its end [m]."""
        return float(np.linalg.norm(self._points[1] - self._points[0]))

    def _trail_color(self) -> Color:
        return self._color or INK

    def _nodes(self, path: str) -> dict[str, Node]:
        p, q = self._points
        style = Style(color=self._color or INK, edges=False, line_width=self._line_width)
        along = (q - p) / self.length
        head = min(self.head, 0.45 * self.length)
        begin = p + head * along if self._heads == "both" else p
        end = q if self._heads == "none" else q - head * along
        nodes = {path: self._own_node()}
        nodes[f"{path}/line"] = Node(shape=shapes.polyline(np.array([begin, end])), style=style)
        cone = shapes.cone(SLIMNESS * head, head)
        heads = {"none": {}, "end": {"head": (end, along)}}
        heads["both"] = heads["end"] | {"tail": (begin, -along)}
        for part, (at, way) in heads[self._heads].items():
            pose = read_only(pose_along(at, way))
            nodes[f"{path}/{part}"] = Node(pose=pose, shape=cone, style=style)
        if self._label.strip():
            place = transl(p + self._label_at * (q - p))
            label = Label(self._label, size=LABEL_SIZE)
            nodes[f"{path}/label"] = Node(pose=read_only(place), shape=label, style=style)
        return nodes

    def __repr__(self) -> str:
        p, q = (", ".join(f"{x:z.4g}" for x in point) for point in self._points)
        text = f" {self._label!r}" if self._label else ""
        return f"Arrow {self.name!r}{text} from ({p}) to ({q})"


def arrow(
    p: ArrayLike,
    q: ArrayLike,
    label: str = "",
    *,
    heads: str = "end",
    head: float | None = None,
    label_at: float = 0.5,
    name: str | None = None,
    color: str | ArrayLike | None = None,
    line_width: float = 3.0,
    pose: ArrayLike | None = None,
    visible: bool = True,
) -> Arrow:
    """Make an arrow with a text: a vector, a dimension of a drawing, an axis.

    Parameters
    ----------
    p, q : array_like, shape (3,) [m]
        Where it begins and where it ends.
    label : str
        Written beside it; ``l_1`` and ``l_{12}`` have a subscript.
    heads : {'end', 'both', 'none'}
        'both' for a dimension, 'none' for an axis.
    head : float [m], optional
        Length of a head; what suits the arrow's length unless given.
    label_at : float
        Where the label stands: 0 at the beginning, 1 at the end, 1.1 a little beyond.
    name : str, optional
    color : str or 3 floats, optional
        ``"#rrggbb"`` or red, green, blue in [0, 1].
    line_width : float [pixel]
    pose : array_like, shape (4, 4) or (3,), optional
        Of the frame that `p` and `q` are told in; the parent's own unless given.
    visible : bool

    Returns
    -------
    arrow : Arrow

    Raises
    ------
    InputError
        The two points are one, or a value cannot be.

    Examples
    --------
    >>> arrow((0, 0, 0), (0, 0, 0.4), "0.4 m", heads="both", name="height")
    Arrow 'height' '0.4 m' from (0, 0, 0) to (0, 0, 0.4)
    >>> arrow((1, 0, 0), (1, 0, 0))
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: an arrow begins and ends at one point, [1.0, 0.0, 0.0]
    """
    made = Arrow(p, q, name)
    place = {} if pose is None else {"pose": pose}
    return made.set(
        label=label, heads=heads, head=head, label_at=label_at, color=color,
        line_width=line_width, visible=visible, **place,
    )  # fmt: skip
