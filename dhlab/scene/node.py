"""What a handle says of itself: plain, immutable data that a view can compare and send.

A handle describes itself as ``{path: Node}``. Paths nest (``arm/1/2/body``), parents come before
their children, and every pose is the pose in the parent node, so the tree of nodes *is* the
kinematic tree: one joint moved is one number.
"""

from __future__ import annotations

from typing import Literal, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from dhlab.arrays import read_only
from dhlab.kinematics.dh import joint_motion
from dhlab.shapes import Label, Lines, Mesh

Shape: TypeAlias = Mesh | Lines | Label
Color: TypeAlias = tuple[float, float, float]

IDENTITY: NDArray[np.float64] = read_only(np.eye(4))


class Style(NamedTuple):
    """How the shape of a node is painted.

    Attributes
    ----------
    color : tuple of 3 floats in [0, 1]
        Red, green, blue of faces; of the line for `Lines`; of the text for `Label`.
    opacity : float in [0, 1]
    edges : bool
        Whether a mesh shows its feature edges.
    edge_color : tuple of 3 floats or None
        None: a darker shade of `color`.
    line_width : float [pixel]
        Width on the screen of edges and lines.
    """

    color: Color = (0.62, 0.65, 0.69)
    opacity: float = 1.0
    edges: bool = True
    edge_color: Color | None = None
    line_width: float = 1.5


class Joint(NamedTuple):
    """A node that moves: its pose is ``pose @ motion(value) @ after``.

    Attributes
    ----------
    kind : {'r', 'p'}
        `value` turns about z [rad] or slides along z [m].
    after : ndarray, shape (4, 4)
        The constant behind the motion (identity in the modified convention).
    key : str
        Names this joint for as long as its robot lives; sliders find the joint by it.
    """

    kind: Literal["r", "p"]
    after: NDArray[np.float64]
    key: str


class Clock(NamedTuple):
    """The common time of one planned motion: a key of its own and its instants.

    Attributes
    ----------
    key : str
    times : ndarray, shape (steps,) [s]
        Increasing.
    stops : tuple of floats [s]
        Where a motion that is walked through step by step rests, the first instant and the last
        among them; empty for a motion that plays from end to end.
    """

    key: str
    times: NDArray[np.float64]
    stops: tuple[float, ...] = ()


class Rest(NamedTuple):
    """Where a motion with stops stands.

    Attributes
    ----------
    time : float [s]
    turn : int
        Counts how often the kernel has sent it somewhere: a page that went there by itself, or
        has gone further, is not called back.
    """

    time: float
    turn: int


class Curve(NamedTuple):
    """Where a node is at each instant of a planned motion.

    Attributes
    ----------
    clock : Clock
    samples : ndarray
        For a joint its values, shape (steps,) [rad or m]; for any other node its poses in its
        parent, shape (steps, 4, 4); for a node with `Lines` the number of segments to show,
        shape (steps,): a trace that grows.
    rest : Rest or None
        Where a motion with stops stands; None for one that ends at its last instant.
    """

    clock: Clock
    samples: NDArray[np.float64]
    rest: Rest | None = None

    def moves_like(self, other: Curve | None) -> bool:
        """Whether two curves are one motion, wherever it stands."""
        return other is not None and (self.clock is other.clock and self.samples is other.samples)


class Span(NamedTuple):
    """The part of a planned motion in which a node is drawn.

    Attributes
    ----------
    clock : Clock
    begin, end : float [s]
        Drawn later than `begin` and up to `end`; infinite for ever after.
    grown : float [s]
        `Lines` grow from `begin` until `grown`.
    """

    clock: Clock
    begin: float
    end: float = float("inf")
    grown: float = -float("inf")


class Gauge(NamedTuple):
    """What a node shows of a joint's variable: a page draws it anew where a slider moves that.

    The node is the arc about z from x of an angle, or the segment along z of a slide (`Lines`), the
    head at its end (`Mesh`), or its text (`Label`).

    Attributes
    ----------
    key : str
        Of the joint.
    kind : {'r', 'p'}
        Of the joint.
    value : float [rad or m]
        For which the node is drawn.
    size : float [m]
        Radius of an arc.
    text : str
        What stands before the value.
    """

    key: str
    kind: Literal["r", "p"]
    value: float
    size: float
    text: str


class Node(NamedTuple):
    """One node of the scene.

    Attributes
    ----------
    pose : ndarray, shape (4, 4)
        Pose in the parent node; for a joint the constant before its motion.
    joint : Joint or None
    value : float [rad or m]
        The joint's variable, offset included; 0 for a node that is no joint.
    shape : Mesh, Lines, Label or None
        What is drawn in this node; None for a node that only carries others.
    style : Style
    visible : bool
        Of the node and of everything under it.
    curve : Curve or None
        The planned motion of this node; `pose` and `value` are the state it rests in.
    span : Span or None
        When the node is drawn, with all that it carries; None for always.
    gauge : Gauge or None
        The variable that its shape shows.
    """

    pose: NDArray[np.float64] = IDENTITY
    joint: Joint | None = None
    value: float = 0.0
    shape: Shape | None = None
    style: Style = Style()
    visible: bool = True
    curve: Curve | None = None
    span: Span | None = None
    gauge: Gauge | None = None

    @property
    def matrix(self) -> NDArray[np.float64]:
        """Pose of this node in its parent, the joint's motion included, shape (4, 4)."""
        if self.joint is None:
            return self.pose
        return self.pose @ joint_motion(self.joint.kind, self.value) @ self.joint.after


def same_place(a: Node, b: Node) -> bool:
    """Whether two nodes stand at the same place, now and in their planned motion."""
    return a.value == b.value and a.curve is b.curve and same_pose(a, b)


def same_but_for_place(a: Node, b: Node) -> bool:
    """Whether two nodes surely differ in their place at most: a quick look, by identity."""
    return (
        a.joint is b.joint
        and a.shape is b.shape
        and a.style is b.style
        and a.visible == b.visible
        and a.span is b.span
        and a.gauge is b.gauge
    )


def same_pose(a: Node, b: Node) -> bool:
    """Whether two nodes have the same pose, whatever their joints do."""
    return a.pose is b.pose or bool(np.array_equal(a.pose, b.pose))


def same_body(a: Node, b: Node) -> bool:
    """Whether two nodes draw the same shape, at the same times, and move in the same way."""
    return (
        same_shape(a.shape, b.shape)
        and same_joint(a.joint, b.joint)
        and same_span(a.span, b.span)
        and a.gauge == b.gauge
    )


def same_paint(a: Node, b: Node) -> bool:
    """Whether two nodes are painted alike."""
    return a.visible == b.visible and a.style == b.style


def same_shape(a: Shape | None, b: Shape | None) -> bool:
    """Whether two shapes are one, by content."""
    return a is b or (a is not None and b is not None and a.digest == b.digest)


def same_joint(a: Joint | None, b: Joint | None) -> bool:
    """Whether two joints are one."""
    if a is b or a is None or b is None:
        return a is b
    return a.kind == b.kind and a.key == b.key and np.array_equal(a.after, b.after)


def same_span(a: Span | None, b: Span | None) -> bool:
    """Whether two spans are one: of the same clock, from and until the same instants."""
    if a is b or a is None or b is None:
        return a is b
    return a.clock.key == b.clock.key and a[1:] == b[1:]
