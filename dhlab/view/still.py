"""A still picture of a scene without any browser: numpy projects it, matplotlib paints it.

What is farther away is painted first. That is right for what a class draws, and wrong only where
large faces run through each other; the picture in the browser has no such limit.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from io import BytesIO
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dhlab.arrays import as_number, as_vector
from dhlab.errors import InputError
from dhlab.scene.node import Node, Style
from dhlab.shapes import Label, Lines, Mesh

if TYPE_CHECKING:
    from matplotlib.figure import Figure

FROM = {
    "first": (0.42, -1.0, 0.42),
    "front": (0.0, -1.0, 0.0),
    "top": (0.0, -1e-4, 1.0),
    "side": (1.0, 0.0, 0.0),
    "isometric": (1.0, -1.0, 1.0),
}
"""From where one looks, z up: the same names as in the browser."""

FIELD = np.radians(34)
MARGIN = 1.12
DOTS = 100
LIGHT = np.array([0.35, -0.55, 0.75]) / np.linalg.norm([0.35, -0.55, 0.75])
BACKGROUNDS = {"light": "#f2f5f9", "dark": "#20242b"}


@dataclass(frozen=True, eq=False)
class Drawn:
    """Primitives in the world, ready to be painted: all of one length.

    Attributes
    ----------
    points : ndarray, shape (k, 3, 3) [m]
        Corners of triangles; of a segment the last corner repeats the second.
    face, line : ndarray, shape (k, 4)
        Red, green, blue, opacity of the face and of its outline.
    width : ndarray, shape (k,) [pixel]
        Of the outline.
    """

    points: NDArray[np.float64]
    face: NDArray[np.float64]
    line: NDArray[np.float64]
    width: NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Eye:
    """A camera that sees all of some points.

    Attributes
    ----------
    axes : ndarray, shape (3, 3)
        Right, up and towards the camera, as rows.
    target : ndarray, shape (3,) [m]
    distance : float [m]
    """

    axes: NDArray[np.float64]
    target: NDArray[np.float64]
    distance: float

    def project(self, points: NDArray[np.float64]) -> tuple[NDArray[np.float64], Any]:
        """Return picture coordinates, 1 at half the height, and how near points are."""
        seen = (points - self.target) @ self.axes.T
        depth = self.distance - seen[..., 2]
        return seen[..., :2] / (depth * np.tan(FIELD / 2))[..., None], seen[..., 2]


def still(
    nodes: Mapping[str, Node],
    *,
    width: int = 900,
    height: int = 600,
    seen_from: str | ArrayLike = "first",
    background: str = "light",
) -> bytes:
    """Paint a scene.

    Parameters
    ----------
    nodes : mapping of str to Node
        The scene: what a handle's `describe` or a view's `nodes` gives.
    width, height : int [pixel]
    seen_from : {'first', 'front', 'top', 'side', 'isometric'} or array_like, shape (3,)
        From where one looks: a direction from the scene to the camera.
    background : {'light', 'dark'}

    Returns
    -------
    png : bytes

    Raises
    ------
    InputError
        A name or a size that cannot be.

    Examples
    --------
    >>> from dhlab.scene.blocks import cube
    >>> still(cube(1).describe(), width=60, height=40)[1:4]
    b'PNG'
    """
    if background not in BACKGROUNDS:
        raise InputError(f"no background {background!r}; use 'light' or 'dark'")
    size = (
        int(as_number(width, "width", minimum=16)),
        int(as_number(height, "height", minimum=16)),
    )
    drawn, labels = gather(nodes)
    eye = look(drawn.points.reshape(-1, 3), _direction(seen_from), size[0] / size[1])
    figure = _paint(drawn, labels, eye, size, BACKGROUNDS[background])
    png = BytesIO()
    figure.savefig(png, format="png", dpi=DOTS)
    return png.getvalue()


def _direction(seen_from: str | ArrayLike) -> NDArray[np.float64]:
    if isinstance(seen_from, str):
        if seen_from not in FROM:
            names = ", ".join(FROM)
            raise InputError(f"seen_from must be a 3-vector or one of {names}, got {seen_from!r}")
        return np.array(FROM[seen_from])
    way = as_vector(seen_from, "seen_from")
    if np.linalg.norm(way) == 0:
        raise InputError("seen_from must have a length, got (0, 0, 0)")
    return way


def look(points: NDArray[np.float64], way: NDArray[np.float64], aspect: float) -> Eye:
    """Stand where all points are in the picture."""
    toward = way / np.linalg.norm(way)
    right = np.cross((0, 0, 1), toward)
    right = right / np.linalg.norm(right) if np.linalg.norm(right) > 1e-9 else np.eye(3)[0]
    axes = np.array([right, np.cross(toward, right), toward])
    if len(points) == 0:
        return Eye(axes, np.zeros(3), 3.0)
    target = (points.min(axis=0) + points.max(axis=0)) / 2
    x, y, z = ((points - target) @ axes.T).T
    across = np.maximum(np.abs(x) / aspect, np.abs(y)) * MARGIN / np.tan(FIELD / 2)
    return Eye(axes, target, max(float((across + z).max()), 1e-6))


def gather(nodes: Mapping[str, Node]) -> tuple[Drawn, list[tuple[Label, Style, Any]]]:
    """Put everything visible into world coordinates."""
    worlds: dict[str, NDArray[np.float64] | None] = {"": np.eye(4)}
    parts: list[Drawn] = []
    labels: list[tuple[Label, Style, Any]] = []
    for path, node in nodes.items():
        above = worlds[path.rpartition("/")[0]]
        T = worlds[path] = None if above is None or not node.visible else above @ node.matrix
        if T is None:
            continue
        if isinstance(node.shape, Label):
            labels.append((node.shape, node.style, T[:3, 3]))
        elif isinstance(node.shape, Lines):
            ends = node.shape.transformed(T)
            parts.append(_segments(ends.points[ends.segments], node.style.color, node.style))
        elif isinstance(node.shape, Mesh):
            parts += _mesh(node.shape.transformed(T), node.style)
    none = Drawn(np.empty((0, 3, 3)), np.empty((0, 4)), np.empty((0, 4)), np.empty(0))
    fields = zip(*((p.points, p.face, p.line, p.width) for p in [none, *parts]), strict=True)
    return Drawn(*map(np.concatenate, fields)), labels


def _mesh(mesh: Mesh, style: Style) -> list[Drawn]:
    corners = mesh.vertices[mesh.triangles]
    brightness = 0.62 + 0.38 * (mesh.triangle_normals @ LIGHT)
    color = np.clip(brightness[:, None] * style.color, 0, 1)
    face = np.column_stack([color, np.full(len(color), style.opacity)])
    seam = face * [1, 1, 1, 0 if style.opacity < 1 else 1]
    faces = Drawn(corners, face, seam, np.full(len(face), 0.4))
    if not style.edges or len(mesh.edges) == 0:
        return [faces]
    dark = style.edge_color or tuple(0.45 * c for c in style.color)
    return [faces, _segments(mesh.vertices[mesh.edges], dark, style)]


def _segments(ends: NDArray[np.float64], color: Any, style: Style) -> Drawn:
    line = np.tile([*color, style.opacity], (len(ends), 1))
    points = ends[:, [0, 1, 1]]
    return Drawn(points, np.zeros_like(line), line, np.full(len(ends), style.line_width))


def _paint(
    drawn: Drawn,
    labels: list[tuple[Label, Style, Any]],
    eye: Eye,
    size: tuple[int, int],
    background: str,
) -> Figure:
    """Paint from back to front; outlines a little nearer than the faces they bound."""
    from matplotlib.collections import PolyCollection
    from matplotlib.figure import Figure

    figure = Figure(figsize=(size[0] / DOTS, size[1] / DOTS), dpi=DOTS, facecolor=background)
    axes = figure.add_axes((0, 0, 1, 1))
    axes.set_axis_off()
    axes.set_xlim(-size[0] / size[1], size[0] / size[1])
    axes.set_ylim(-1, 1)
    flat, near = eye.project(drawn.points)
    is_line = drawn.face[:, 3] == 0
    order = np.argsort(near.mean(axis=1) + 0.004 * eye.distance * is_line, kind="stable")
    axes.add_collection(
        PolyCollection(
            list(flat[order]),
            facecolors=drawn.face[order],
            edgecolors=drawn.line[order],
            linewidths=drawn.width[order] * 72 / DOTS,
            closed=False,
        )
    )
    for label, style, at in labels:
        (x, y), _ = eye.project(at)
        text = label.text if "_" not in label.text else f"${label.text}$"
        points = label.size * 72 / DOTS
        axes.text(x, y, text, color=style.color, fontsize=points, ha="center", va="center")
    return figure
