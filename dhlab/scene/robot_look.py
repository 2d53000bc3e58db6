"""The two default looks of a robot, as functions of its table: the stick and the solid one.

Every function gives the nodes that hang on the frames of one robot, `{frame: {name: Node}}`:
frame 0 is the base, 1 to n are the joints, n + 1 is the grasper.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

import dhlab.shapes as shapes
from dhlab.kinematics.chain import Chain
from dhlab.kinematics.transforms import inverse, rotx, rp2t, transl
from dhlab.scene.frame_look import frame_nodes
from dhlab.scene.node import Color, Node, Style
from dhlab.scene.palette import INK, METAL
from dhlab.shapes import Lines, Mesh

STICK_WIDTH = 5.0
"""Width of the lines of a stick robot [pixel]."""


class Appearance(NamedTuple):
    """All that the default looks of one robot depend on.

    Attributes
    ----------
    chain : Chain
    color : tuple of 3 floats
    opacity : float
    edges : bool
    radius : float [m]
        Of the cylinder of a revolute joint.
    grasper_size : float [m]
        Opening of the gripper; 0 for a fingertip.
    frame_size : float [m]
        Length of the axes of local coordinate systems.
    standing : bool
        Whether it stands on a base of its own: nothing carries it.
    configex : bool
        Whether spheres mark where components are joined.
    carried : tuple of (int, Chain)
        What is attached: frame and chain of each attached robot.
    """

    chain: Chain
    color: Color
    opacity: float
    edges: bool
    radius: float
    grasper_size: float
    frame_size: float
    standing: bool
    configex: bool
    carried: tuple[tuple[int, Chain], ...]

    def style(self, color: Color | None = None) -> Style:
        """Paint in a colour, the robot's own unless given."""
        return Style(color=color or self.color, opacity=self.opacity, edges=self.edges)

    @property
    def has_grasper(self) -> bool:
        """Whether the last frame carries a gripper or fingertip, not another robot."""
        n = self.chain.n
        return n > 0 and all(at != n for at, _ in self.carried)


def default_radius(chain: Chain) -> float:
    """Radius of joints that suits a chain's reach [m]: a 25th of it, 0.02 where it has none."""
    reach = sum(float(np.linalg.norm(np.diff(path, axis=0), axis=1).sum()) for path in spine(chain))
    reach += float(np.linalg.norm(chain.grasper[:3, 3]))
    reach += sum(high - low for low, high in map(slide, (chain,) * chain.n, range(1, chain.n + 1)))
    return 0.04 * reach or 0.02


def slide(chain: Chain, joint: int) -> tuple[float, float]:
    """Range of a prismatic joint's variable that its rail covers [m]; (0, 0) for a revolute."""
    if chain.joints[joint - 1] == "r":
        return 0.0, 0.0
    home = float(chain.home[joint - 1] + chain.offset[joint - 1])
    low, high = chain.limits[joint - 1] + chain.offset[joint - 1]
    low = low if np.isfinite(low) else min(0.0, home)
    high = high if np.isfinite(high) else max(low, home, 0.0)
    return float(min(low, 0.0)), float(max(high, 0.0))


def spine(chain: Chain) -> list[NDArray[np.float64]]:
    """Centre line of each link, in the frame of the link: links 0 (the base) to n (the tip).

    From the axis of the joint that moves the link, along the common normal (a) and the next
    axis (d), to the point where the next joint sits.

    Returns
    -------
    paths : list of n + 1 ndarrays, shape (points, 3) [m]
    """
    befores, afters = [b for b, _ in chain.constants], [a for _, a in chain.constants]
    paths = []
    for i in range(chain.n + 1):
        points = [np.zeros(3)]
        if i > 0:
            start = inverse(afters[i - 1])[:3, 3]
            row = chain.rows[i - 1]
            behind = chain.convention == "standard" and chain.joints[i - 1] == "r"
            along_d = row.d if behind else 0.0
            points = [start, start + along_d * inverse(afters[i - 1])[:3, 2], np.zeros(3)]
        if i < chain.n:
            if chain.convention == "modified":
                points.append(np.array([chain.rows[i].a, 0.0, 0.0]))
            points.append(befores[i][:3, 3])
        else:
            points.append(chain.grasper[:3, 3])
        paths.append(_without_repeats(points))
    return paths


def _without_repeats(points: Iterable[NDArray[np.float64]]) -> NDArray[np.float64]:
    kept: list[NDArray[np.float64]] = []
    for p in points:
        if not kept or np.linalg.norm(p - kept[-1]) > 1e-9:
            kept.append(p)
    return np.array(kept)


def solid(look: Appearance) -> dict[int, dict[str, Node]]:
    """Draw the solid look: cylinders, sleeves, link bodies, base and gripper."""
    nodes: dict[int, dict[str, Node]] = {i: {} for i in range(look.chain.n + 2)}
    for i, path in enumerate(spine(look.chain)):
        if mesh := _rod(path, 0.62 * look.radius):
            nodes[i]["link"] = Node(shape=mesh, style=look.style())
    for i in range(1, look.chain.n + 1):
        _add_joint(nodes, look, i)
    for k, (at, chain) in enumerate(look.carried):
        ends = _without_repeats([np.zeros(3), chain.base[:3, 3]])
        if mesh := _rod(ends, look.radius):
            nodes[at][f"body {k + 1}"] = Node(shape=mesh, style=look.style())
        if look.configex:
            ball = _at(shapes.sphere(1.35 * look.radius), chain.base[:3, 3])
            nodes[at][f"ball {k + 1}"] = Node(shape=ball, style=look.style())
    if look.configex and look.carried:
        nodes[0]["ball"] = Node(shape=shapes.sphere(1.35 * look.radius), style=look.style())
    if look.standing and look.chain.n:
        nodes[0]["base"] = Node(shape=_pedestal(look), style=look.style(METAL))
    if look.has_grasper:
        nodes[look.chain.n + 1] |= _grasper(look)
    return nodes


def _add_joint(nodes: dict[int, dict[str, Node]], look: Appearance, i: int) -> None:
    """Add the cylinder of a revolute joint, or the sleeve and the rail of a prismatic one."""
    before, after = look.chain.constants[i - 1]
    on_axis = inverse(after)
    r = look.radius
    if look.chain.joints[i - 1] == "r":
        mesh = shapes.cylinder(r, 2.3 * r)
        mesh = mesh.transformed(on_axis @ transl((0, 0, -1.15 * r)))
        nodes[i]["joint"] = Node(shape=mesh, style=look.style(_darker(look.color)))
        return
    low, high = slide(look.chain, i)
    rail = shapes.cuboid(1.0 * r, 1.0 * r, high - low + 3.4 * r)
    rail = rail.transformed(transl((0, 0, low - 1.7 * r)))
    nodes[i - 1][f"rail {i}"] = Node(pose=before, shape=rail, style=look.style(METAL))
    sleeve = shapes.cuboid(2 * r, 2 * r, 2.8 * r).transformed(on_axis @ transl((0, 0, -1.4 * r)))
    nodes[i]["joint"] = Node(shape=sleeve, style=look.style(_darker(look.color)))


def _rod(path: NDArray[np.float64], radius: float) -> Mesh | None:
    """Return round rods along a centre line with balls at its bends; None for a point."""
    parts = [shapes.tube(p, q, radius) for p, q in pairwise(path)]
    parts += [_at(shapes.sphere(radius), p) for p in path[1:-1]]
    return parts[0].merged(*parts[1:]) if parts else None


def _pedestal(look: Appearance) -> Mesh:
    """Return a round foot under the first joint, or on the floor where that stands higher."""
    r = look.radius
    foot = shapes.cylinder(1.9 * r, 0.5 * r)
    if np.linalg.norm(look.chain.constants[0][0][:3, 3]) > 1e-9 or look.chain.joints[0] != "r":
        return foot
    neck = shapes.cylinder(0.9 * r, 0.6 * r)
    below = _at(foot, (0, 0, -1.9 * r)).merged(_at(neck, (0, 0, -1.45 * r)))
    return below.transformed(rp2t(rotx(np.pi), (0, 0, 0))) if _hangs(look) else below


def _hangs(look: Appearance) -> bool:
    """Whether the robot at home goes down where a foot below its first joint would stand."""
    home = look.chain.frames(look.chain.home)
    origins = (inverse(look.chain.base) @ home)[:, :3, 3]
    way = np.linspace(origins[:-1], origins[1:], 9).reshape(-1, 3)
    beside = np.hypot(way[:, 0], way[:, 1]) > 2 * look.radius
    return bool((~beside & (way[:, 2] < -look.radius)).any())


def _grasper(look: Appearance) -> dict[str, Node]:
    """Return a fingertip where the grasper's size is 0, else a gripper that opens so far."""
    r, size = look.radius, look.grasper_size
    if size == 0:
        return {"tip": Node(shape=shapes.sphere(0.62 * r), style=look.style())}
    thick = 0.22 * size
    jaw = shapes.cuboid(1.6 * thick, thick, 0.9 * size)
    parts = [
        _at(shapes.cuboid(1.8 * thick, 1.9 * size, 1.2 * thick), (0, 0, 0)),
        _at(jaw, (0, 0.5 * (size + thick), thick)),
        _at(jaw, (0, -0.5 * (size + thick), thick)),
    ]
    mesh = parts[0].merged(*parts[1:]).transformed(_approach(look.chain))
    return {"gripper": Node(shape=mesh, style=look.style(METAL))}


def _approach(chain: Chain) -> NDArray[np.float64]:
    """Turn that lays z, along which a gripper reaches out, to where the tool points.

    A tool that is only moved away from the last joint points the way it is moved; any other
    points along its own z axis.
    """
    way = chain.grasper[:3, 3]
    turned = not np.allclose(chain.grasper[:3, :3], np.eye(3))
    if turned or np.linalg.norm(way) < 1e-9:
        return np.eye(4)
    z = way / np.linalg.norm(way)
    y = np.cross(z, np.eye(3)[int(np.argmin(np.abs(z)))])
    y /= np.linalg.norm(y)
    T = np.eye(4)
    T[:3, :3] = np.column_stack([np.cross(y, z), y, z])
    return T


def stick(look: Appearance) -> dict[int, dict[str, Node]]:
    """Draw the stick look: lines along the links, small joints, small frames."""
    nodes: dict[int, dict[str, Node]] = {i: {} for i in range(look.chain.n + 2)}
    paint = look.style()._replace(line_width=STICK_WIDTH)
    for i, path in enumerate(spine(look.chain)):
        if len(path) > 1:
            nodes[i]["link"] = Node(shape=_line(path), style=paint)
    for i in range(1, look.chain.n + 1):
        _add_stick_joint(nodes, look, i)
    for k, (at, chain) in enumerate(look.carried):
        ends = _without_repeats([np.zeros(3), chain.base[:3, 3]])
        if len(ends) > 1:
            nodes[at][f"body {k + 1}"] = Node(shape=_line(ends), style=paint)
    if look.has_grasper:
        nodes[look.chain.n + 1] |= frame_nodes("", 0.5 * look.frame_size, labelled="")
    return nodes


def _add_stick_joint(nodes: dict[int, dict[str, Node]], look: Appearance, i: int) -> None:
    """Add a small cylinder or sleeve, and for a prismatic joint the line it slides along."""
    before, after = look.chain.constants[i - 1]
    r = 0.4 * look.radius
    small = shapes.cylinder(r, 4 * r)
    if look.chain.joints[i - 1] == "p":
        small = shapes.cuboid(2 * r, 2 * r, 4 * r)
        low, high = slide(look.chain, i)
        if high > low:
            rail = _line(np.array([[0, 0, low], [0, 0, high]]))
            paint = look.style(INK)._replace(line_width=0.5 * STICK_WIDTH)
            nodes[i - 1][f"rail {i}"] = Node(pose=before, shape=rail, style=paint)
    mesh = small.transformed(inverse(after) @ transl((0, 0, -2 * r)))
    nodes[i]["joint"] = Node(shape=mesh, style=look.style())


def local_frames(look: Appearance) -> dict[int, dict[str, Node]]:
    """Draw the labelled frame of every joint.

    Frames with a common origin get axes of different lengths, so that all can be read.
    """
    nodes: dict[int, dict[str, Node]] = {}
    longer = 0
    for i in range(1, look.chain.n + 1):
        before, after = look.chain.constants[i - 1]
        apart = np.linalg.norm(before[:3, 3]) > 1e-9 or np.linalg.norm(after[:3, 3]) > 1e-9
        longer = 0 if apart or look.chain.joints[i - 1] == "p" else longer + 1
        length = look.frame_size * (1 + 0.3 * longer)
        nodes[i] = frame_nodes("frame", length, subscript=str(i), labelled="xz")
        nodes[i] = {"frame": Node()} | nodes[i]
    return nodes


def _line(points: NDArray[np.float64]) -> Lines:
    return shapes.polyline(points)


def _at(mesh: Mesh, p: NDArray[np.float64] | tuple[float, float, float]) -> Mesh:
    return mesh.transformed(transl(p))


def _darker(color: Color) -> Color:
    red, green, blue = (0.62 * c for c in color)
    return red, green, blue
