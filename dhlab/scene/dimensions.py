"""The four numbers of a table's row, drawn as dimensions in the frames that they belong to."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

import dhlab.shapes as shapes
from dhlab.arrays import as_color, read_only
from dhlab.errors import InputError
from dhlab.kinematics.chain import Chain
from dhlab.scene.node import Color, Gauge, Node, Style
from dhlab.shapes import Label, Lines, Mesh
from dhlab.shapes.between import pose_along

PARAMETERS = ("alpha", "a", "d", "theta")
COLORS: dict[str, Color] = {
    name: as_color(text, "palette")
    for name, text in {
        "alpha": "#b5179e",
        "a": "#c05600",
        "d": "#00708c",
        "theta": "#5b3fc4",
    }.items()
}
"""One for each column of a table; an editor of the table uses the same."""

LETTERS = {"alpha": "α", "a": "a", "d": "d", "theta": "θ"}
PALE = 0.35
ARC = 0.85
"""Radius of an arc, in lengths of the robot's axes."""

STEP = 0.08
"""Between the points of an arc, about [rad]; the page's `gauge.js` draws the same."""

MOST = 400
"""Points of an arc."""

Selection = tuple[int, str | None]


def as_selection(value: Any, what: str, current: Any) -> Selection | None:
    """Check what is drawn: None, the number of a row, or a row and one of its parameters."""
    if value is None:
        return None
    row, parameter = value if isinstance(value, tuple) and len(value) == 2 else (value, None)
    if isinstance(row, bool) or not isinstance(row, int | np.integer):
        raise InputError(
            f"{what} must be None, a row such as 2, or a row and a parameter such as "
            f"(2, 'alpha'), got {value!r}"
        )
    if parameter is not None and parameter not in PARAMETERS:
        raise InputError(f"{what}: no parameter {parameter!r}; use {', '.join(PARAMETERS)}")
    return int(row), parameter


def check_row(selection: Selection | None, chain: Chain, what: str) -> None:
    """Refuse a row that the table has not."""
    if selection is not None and not 1 <= selection[0] <= chain.n:
        raise InputError(f"{what}: the table has rows 1 to {chain.n}, got {selection[0]}")


def dimension_nodes(
    selection: Selection,
    chain: Chain,
    q: NDArray[np.float64],
    size: float,
    paths: list[str],
    keys: Sequence[str],
) -> dict[str, Node]:
    """Return the nodes of the dimensions of one row.

    Twist and length lie in the frame before the joint in the modified convention, and in the
    joint's own frame in the standard one; so they go with the joints by themselves. Angle and
    offset lie where the joint's axis is.

    Parameters
    ----------
    selection : (int, str or None)
        The row, from 1, and the parameter that is lit up.
    chain : Chain
    q : ndarray, shape (n,)
    size : float [m]
        Length of the axes of the robot's frames.
    paths : list of str
        Nodes of the chain's frames: the base, then the joints.
    keys : sequence of str
        Of the joints: the number of the row that is a joint's variable goes with it in the page.

    Returns
    -------
    nodes : dict of str to Node
    """
    i, lit = selection
    alpha, a, d, theta = chain.rows[i - 1]
    variable = float(q[i - 1] + chain.offset[i - 1])
    d, theta = (d, variable) if chain.kinds[i - 1] == "r" else (variable, theta)
    modified = chain.convention == "modified"
    before, own = paths[i - 1], paths[i]
    link = i - 1 if modified else i
    if modified:
        foot = _pose(_turned_x(alpha), (a, 0.0, 0.0))
        places = {"a": (before, np.eye(4)), "alpha": (before, _pose(np.eye(3), (a, 0.0, 0.0)))}
        places |= {"theta": (before, foot), "d": (before, foot)}
    else:
        back = _turned_x(-alpha)
        places = {"a": (own, _pose(np.eye(3), (-a, 0.0, 0.0))), "alpha": (own, _pose(back))}
        places |= {"theta": (before, np.eye(4)), "d": (before, np.eye(4))}
    values = {"alpha": alpha, "a": a, "d": d, "theta": theta}
    numbers = {"alpha": link, "a": link, "d": i, "theta": i}
    kind = chain.kinds[i - 1]
    nodes: dict[str, Node] = {}
    for parameter, (path, pose) in places.items():
        text = f"{LETTERS[parameter]}_{{{numbers[parameter]}}} = "
        gauge = None
        if parameter == ("theta" if kind == "r" else "d"):
            gauge = Gauge(keys[i - 1], kind, variable, ARC * size, text)
        text += _amount(parameter, values)
        style = Style(
            color=COLORS[parameter],
            opacity=PALE if lit not in (None, parameter) else 1.0,
            edges=False,
            line_width=5.0 if lit == parameter else 3.0,
        )
        drawn = _drawing(parameter, values[parameter], size)
        nodes |= _placed(f"{path}/{parameter}", read_only(pose), drawn, text, style, gauge)
    return nodes


def _amount(parameter: str, values: dict[str, float]) -> str:
    value = values[parameter]
    if parameter in ("alpha", "theta"):
        return f"{np.degrees(value):z.4g}°"
    return f"{value:z.4g} m"


def _placed(
    path: str,
    pose: NDArray[np.float64],
    drawn: tuple[Lines, Mesh, NDArray[np.float64]] | tuple[None, None, NDArray[np.float64]],
    text: str,
    style: Style,
    gauge: Gauge | None,
) -> dict[str, Node]:
    line, head, at = drawn
    nodes = {path: Node(pose=pose, shape=line, style=style, gauge=gauge)}
    if head is not None:
        nodes[f"{path}/head"] = Node(shape=head, style=style, gauge=gauge)
    label = _pose(np.eye(3), at)
    big = Label(text, size=21.0 if style.line_width > 4 else 17.0)
    nodes[f"{path}/label"] = Node(pose=read_only(label), shape=big, style=style, gauge=gauge)
    return nodes


@lru_cache(maxsize=512)
def _drawing(
    parameter: str, value: float, size: float
) -> tuple[Lines, Mesh, NDArray[np.float64]] | tuple[None, None, NDArray[np.float64]]:
    """Return line, arrow head and the label's place, in the frame where the dimension begins.

    Lengths go along x (a) or z (d); angles about x from z (alpha) or about z from x (theta).
    """
    along = np.eye(3)[0 if parameter in ("alpha", "a") else 2]
    if parameter in ("a", "d"):
        points = np.array([np.zeros(3), value * along])
        middle = points.mean(axis=0)
        aside = 0.18 * size * np.eye(3)[2 if parameter == "a" else 0]
    else:
        first = np.eye(3)[2 if parameter == "alpha" else 0]
        angles = np.linspace(0, value, min(int(abs(value) / STEP) + 2, MOST))[:, None]
        radius = ARC * size
        points = radius * (np.cos(angles) * first + np.sin(angles) * np.cross(along, first))
        outwards = np.cos(value / 2) * first + np.sin(value / 2) * np.cross(along, first)
        middle, aside = radius * outwards, 0.25 * size * outwards
        points = np.asarray(points)
    length = float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
    if length < 1e-9 * max(size, 1.0):
        return None, None, read_only(points[0] + aside)
    tip = min(0.22 * size, 0.5 * length)
    way = points[-1] - points[-2]
    way = way / np.linalg.norm(way)
    head = shapes.cone(0.35 * tip, tip).transformed(pose_along(points[-1] - tip * way, way))
    return shapes.polyline(points), head, read_only(middle + aside)


def _turned_x(angle: float) -> NDArray[np.float64]:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[1, 0, 0], [0, c, -s], [0, s, c]])


def _pose(R: NDArray[np.float64], p: Any = (0.0, 0.0, 0.0)) -> NDArray[np.float64]:
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, p
    return T
