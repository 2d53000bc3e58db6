"""What a motion leaves behind: the paths of what moved, and pale copies on the way."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from dhlab.arrays import read_only
from dhlab.scene.node import Clock, Color, Curve, Node, Style
from dhlab.shapes import Lines, Mesh, polyline

GHOSTS = 5
"""How many poses ghosts show: the first, and others evenly on the way to the last."""

GHOST_OPACITY = 0.2

TRACE_WIDTH = 3.0
"""Width of a trace [pixel]."""


class Trail(NamedTuple):
    """The path of a point during a motion.

    Attributes
    ----------
    name : str
    points : ndarray, shape (steps, 3) [m]
        In the world, one for each instant.
    color : tuple of 3 floats
    """

    name: str
    points: NDArray[np.float64]
    color: Color


def traces_of(trails: list[Trail], clock: Clock) -> dict[str, Node]:
    """Return a line for every path that is more than a point; it grows as the motion plays."""
    marks: dict[str, Node] = {}
    for name, points, color in trails:
        kept = np.linalg.norm(np.diff(points, axis=0, prepend=points[:1] - 1), axis=1) > 1e-9
        if kept.sum() > 1:
            curve = Curve(clock, read_only(np.cumsum(kept) - 1.0))
            style = Style(color=color, line_width=TRACE_WIDTH)
            marks[f"traces/{name}"] = Node(shape=polyline(points[kept]), style=style, curve=curve)
    return {"traces": Node()} | marks if marks else {}


def ghosts_of(nodes: dict[str, Node], clock: Clock) -> dict[str, Node]:
    """Return pale copies of what moves as it stands at a few instants before the last.

    Parameters
    ----------
    nodes : dict of str to Node
        What the handle draws, its planned motion included.
    clock : Clock

    Returns
    -------
    marks : dict of str to Node
        Everything of one colour at one instant is one node.
    """
    steps = np.unique(np.linspace(0, len(clock.times) - 1, GHOSTS + 1).round().astype(int))[:-1]
    marks: dict[str, Node] = {"ghosts": Node()} if len(steps) else {}
    for k in steps:
        for number, (style, shape) in enumerate(_still(nodes, clock, int(k))):
            pale = style._replace(opacity=GHOST_OPACITY * style.opacity, edges=False)
            marks[f"ghosts/{k}.{number}"] = Node(shape=shape, style=pale)
    return marks


def _still(nodes: dict[str, Node], clock: Clock, k: int) -> list[tuple[Style, Mesh | Lines]]:
    """Gather what is drawn at instant `k` by how it is painted, in world coordinates."""
    worlds: dict[str, NDArray[np.float64] | None] = {"": np.eye(4)}
    drawn: dict[tuple[Style, type], list[Mesh | Lines]] = {}
    for path, node in nodes.items():
        above = worlds[path.rpartition("/")[0]]
        if above is None or not node.visible:
            worlds[path] = None
            continue
        T = worlds[path] = above @ _at_instant(node, clock, k).matrix
        if isinstance(node.shape, Mesh | Lines):
            key = (node.style, type(node.shape))
            drawn.setdefault(key, []).append(node.shape.transformed(T))
    return [(style, _merged(parts)) for (style, _), parts in drawn.items()]


def _merged(parts: list[Mesh | Lines]) -> Mesh | Lines:
    first, *others = parts
    return first.merged(*others)  # type: ignore[arg-type]


def _at_instant(node: Node, clock: Clock, k: int) -> Node:
    if node.curve is None or node.curve.clock is not clock or isinstance(node.shape, Lines):
        return node
    sample = node.curve.samples[k]
    if node.joint is not None:
        return node._replace(value=float(sample))
    return node._replace(pose=sample)
