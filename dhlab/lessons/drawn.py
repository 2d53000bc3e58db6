"""What a step draws beside its motion: a ghost where it began, the arc of a turn, an arrow."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

import dhlab.shapes as shapes
from dhlab.arrays import as_color, read_only
from dhlab.lessons.moves import Move, Slide, State, Turn, frame_of
from dhlab.lessons.step import Step
from dhlab.lessons.timeline import Timeline
from dhlab.scene.csys import Csys
from dhlab.scene.frame_look import frame_nodes
from dhlab.scene.node import Node, Span, Style
from dhlab.scene.placed import Placed
from dhlab.shapes import Label, Lines, Mesh
from dhlab.shapes.between import pose_along

GHOST_OPACITY = 0.22
ARC_RADIUS = 0.62
"""Radius of an arc, in lengths of the axes."""
HEAD = 0.09
"""Length of an arrow head, in lengths of the axes."""
WIDTH = 3.5
LABEL_SIZE = 19.0
TURN_COLOR = as_color("#b5179e", "palette")
SLIDE_COLOR = as_color("#c05600", "palette")


def marks_of_step(
    step: Step, k: int, timeline: Timeline, last: float
) -> dict[Placed, dict[str, Node]]:
    """Return what step number `k`, from 1, draws, by the handle that it moves.

    Parameters
    ----------
    step : Step
    k : int
    timeline : Timeline
    last : float [s]
        Until when it stays.

    Returns
    -------
    marks : dict of Placed to dict of str to Node
        In the world.
    """
    stops, clock = timeline.clock.stops, timeline.clock
    span = Span(clock, stops[k - 1], last, stops[k])
    state = timeline.states[k - 1]
    drawn: dict[Placed, dict[str, Node]] = {}
    for move in step.moves:
        if isinstance(move.what, Placed):
            nodes = _ghost(move.what, state, span._replace(grown=-np.inf), f"{k}.ghost")
            if isinstance(move, Turn | Slide) and not _is_small(move):
                nodes |= _way(move, state, span, f"{k}.way")
            drawn[move.what] = nodes
    return drawn


def axis_length(what: Placed) -> float:
    """Length of the axes of a csys; what suits the size of a block [m]."""
    if isinstance(what, Csys):
        return what.size
    shapes_of = [node.shape for node in what.describe().values()]
    bounds = [shape.bounds for shape in shapes_of if isinstance(shape, Mesh | Lines)]
    return float(max((np.ptp(b, axis=0).max() for b in bounds), default=1.0))


def _is_small(move: Turn | Slide) -> bool:
    size = abs(move.angle) if isinstance(move, Turn) else np.linalg.norm(move.vector)
    return bool(size < 1e-9)


def _ghost(what: Placed, state: State, span: Span, path: str) -> dict[str, Node]:
    """Return a pale copy of a csys as it stood before the step; none of a block."""
    if not isinstance(what, Csys):
        return {}
    nodes = {path: Node(pose=state[what], span=span)}
    return nodes | frame_nodes(path, what.size, labelled="", opacity=GHOST_OPACITY)


def _way(move: Turn | Slide, state: State, span: Span, path: str) -> dict[str, Node]:
    """Return the line that a move follows, its arrow head and its label."""
    size = axis_length(move.what)
    color = TURN_COLOR if isinstance(move, Turn) else SLIDE_COLOR
    points = _arc(move, state, size) if isinstance(move, Turn) else _line(move, state)
    way = points[-1] - points[-2]
    length = float(np.linalg.norm(points[1:] - points[:-1], axis=1).sum())
    head = min(HEAD * size, 0.45 * length)
    shaft = _shortened(points, head)
    headed = span._replace(begin=span.begin + 0.97 * (span.grown - span.begin), grown=-np.inf)
    middle = points[len(points) // 2] if isinstance(move, Turn) else points.mean(axis=0)
    return {
        path: Node(
            shape=shapes.polyline(shaft), style=Style(color=color, line_width=WIDTH), span=span
        ),
        f"{path}.head": Node(
            pose=read_only(pose_along(points[-1] - head * way / np.linalg.norm(way), way)),
            shape=shapes.cone(0.42 * head, head),
            style=Style(color=color, edges=False),
            span=headed,
        ),
        f"{path}.label": Node(
            pose=_origin(middle + 0.1 * size * _aside(move, state, middle)),
            shape=Label(move.label or " · ", size=LABEL_SIZE),
            style=Style(color=color),
            span=span._replace(grown=-np.inf),
        ),
    }


def _arc(move: Turn, state: State, size: float) -> NDArray[np.float64]:
    """Return points of the way of a point that the turn carries, in the world."""
    axis, centre = _line_of(move, state)
    start = state[move.what]
    arm = _arm(start, axis, centre, ARC_RADIUS * size)
    if not move.fixed and move.about is None:
        centre = start[:3, 3]
    count = max(8, int(np.ceil(abs(move.angle) / 0.05)))
    angles = np.linspace(0, move.angle, count + 1)[:, None]
    return np.asarray(
        centre
        + (arm @ axis) * axis
        + np.cos(angles) * (arm - (arm @ axis) * axis)
        + np.sin(angles) * np.cross(axis, arm)
    )


def _arm(
    start: NDArray[np.float64], axis: NDArray[np.float64], centre: NDArray[np.float64], reach: float
) -> NDArray[np.float64]:
    """Return from the centre to the point that draws the arc: the origin, or a point of an axis."""
    away = start[:3, 3] - centre
    across = away - (away @ axis) * axis
    if np.linalg.norm(across) > 0.3 * reach:
        return away
    sideways = np.abs(start[:3, :3].T @ axis)
    letter = next(k for k in (0, 1, 2) if sideways[k] < 0.9)
    arm = start[:3, letter] - (start[:3, letter] @ axis) * axis
    return (away @ axis) * axis + reach * arm / np.linalg.norm(arm)


def _line(move: Slide, state: State) -> NDArray[np.float64]:
    return np.array([state[move.what][:3, 3], move.at(state, 1)[:3, 3]])


def _line_of(move: Turn, state: State) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return direction and a point of the axis that a turn goes about, in the world."""
    frame = frame_of(move, state)
    frame = state[move.what] if frame is None else frame
    return frame[:3, :3] @ move.axis, frame[:3, 3]


def _aside(move: Move, state: State, middle: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the direction in which a label stands off its line."""
    if isinstance(move, Turn):
        axis, centre = _line_of(move, state)
        out = middle - centre
        out = out - (out @ axis) * axis
    else:
        out = np.array([0.0, 0.0, 1.0])
    return np.asarray(out / max(float(np.linalg.norm(out)), 1e-12))


def _shortened(points: NDArray[np.float64], by: float) -> NDArray[np.float64]:
    """Return a line without the last part of it, where the arrow head is."""
    rest = np.linalg.norm(points - points[-1], axis=1)
    kept = points[rest > by]
    way = points[-1] - points[-2]
    tip = points[-1] - by * way / np.linalg.norm(way)
    return np.vstack([kept, tip]) if len(kept) else np.vstack([points[0], tip])


def _origin(at: NDArray[np.float64]) -> NDArray[np.float64]:
    pose = np.eye(4)
    pose[:3, 3] = at
    return read_only(pose)
