"""How a coordinate system is drawn: three arrows and their labels."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

import dhlab.shapes as shapes
from dhlab.scene.node import Node, Style
from dhlab.scene.palette import AXES, INK
from dhlab.shapes import Label, Mesh

THICKNESS = 0.022
LABEL_AT = 1.14
LABEL_SIZE = 20.0


@lru_cache(maxsize=256)
def axis_arrow(axis: int, length: float) -> Mesh:
    """Arrow of one axis: 0, 1, 2 for x, y, z."""
    return shapes.arrow(length, THICKNESS * length, axis=np.eye(3)[axis])


def frame_nodes(
    path: str,
    length: float,
    *,
    name: str | None = None,
    subscript: str = "",
    labelled: str = "xyz",
    opacity: float = 1.0,
) -> dict[str, Node]:
    """Nodes of the arrows and labels of a frame that stands at `path`.

    Parameters
    ----------
    path : str
        The node that carries the frame.
    length : float [m]
        Length of the axes.
    name : str, optional
        Written at the origin, in braces.
    subscript : str
        Follows the axes' letters: ``"A"`` writes x_A, y_A, z_A.
    labelled : str
        The letters of the axes that are labelled.
    opacity : float in [0, 1]

    Returns
    -------
    nodes : dict of str to Node
    """
    nodes = {}
    for k, letter in enumerate("xyz"):
        style = Style(color=AXES[k], opacity=opacity, edges=False)
        nodes[f"{path}/{letter}"] = Node(shape=axis_arrow(k, length), style=style)
        if letter in labelled:
            text = f"{letter}_{{{subscript}}}" if subscript else letter
            nodes[f"{path}/{letter}/label"] = _label(text, LABEL_AT * length * np.eye(3)[k], style)
    if name:
        corner = -0.12 * length * np.ones(3)
        nodes[f"{path}/name"] = _label(f"{{{name}}}", corner, Style(color=INK, opacity=opacity))
    return nodes


def _label(text: str, at: np.ndarray, style: Style) -> Node:
    pose = np.eye(4)
    pose[:3, 3] = at
    pose.flags.writeable = False
    return Node(pose=pose, shape=Label(text, size=LABEL_SIZE), style=style)
