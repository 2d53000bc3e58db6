"""How a robot shows itself: the nodes of its joints, looks, parts and attached robots."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import accumulate
from typing import TYPE_CHECKING

from dhlab.scene.dimensions import dimension_nodes
from dhlab.scene.node import Node

if TYPE_CHECKING:
    from dhlab.scene.component import Component
    from dhlab.scene.robot import Robot


class Description:
    """The nodes of a robot and of all that is attached to it, until more than a joint changes.

    Parameters
    ----------
    robot : Robot
    path : str
        Of the robot's first node.
    """

    def __init__(self, robot: Robot, path: str) -> None:
        self.path = path
        joints = list(joint_paths(robot, path))
        self._joints = [(c, c.chain.offset, c.n * (None,), paths[1:]) for c, paths in joints]
        self._measured = [(c, paths) for c, paths in joints if c.dimensions is not None]
        self._nodes = robot_nodes(robot, path)

    def nodes(self) -> dict[str, Node]:
        """Return the nodes as the joints are now; those of joints that rest stay the same."""
        nodes = self._nodes
        for component, offset, still, paths in self._joints:
            values = (component.q + offset).tolist()
            curves = component.curves or still
            for path, value, curve in zip(paths, values, curves, strict=True):
                node = nodes[path]
                if node.value != value or node.curve is not curve:
                    nodes[path] = Node(node.pose, node.joint, value, curve=curve)
        nodes = nodes.copy()
        for component, paths in self._measured:
            selection, size = component.dimensions, component.frame_size
            if selection is not None:
                chain, q = component.chain, component.q
                nodes |= dimension_nodes(selection, chain, q, size, paths, component.keys)
        return nodes


def joint_paths(robot: Robot, path: str) -> Iterator[tuple[Component, list[str]]]:
    """Go through all components that have joints, and the paths of their base and joints."""
    frames = list(accumulate(range(1, robot.own.n + 1), "{}/{}".format, initial=path))
    if robot.own.n:
        yield robot.own, frames
    for at, child in robot.joints_at:
        yield from joint_paths(child, f"{frames[at]}/{child.name}")


def robot_nodes(robot: Robot, path: str) -> dict[str, Node]:
    """Return the nodes of a robot and of all that is attached to it.

    The joints nest (``arm/1/2/3``), each with its bodies below it, so that a node moves all that
    the joint moves.
    """
    component, chain = robot.own, robot.chain
    carried = tuple((at, child.chain) for at, child in robot.joints_at)
    looks = component.look_nodes(carried)
    befores = [before for before, _ in chain.constants]
    values = component.q + chain.offset
    curves = component.curves
    nodes = {path: Node(pose=chain.base, visible=robot.visible)}
    _add_bodies(nodes, robot, 0, path, looks)
    for i in range(1, chain.n + 1):
        path = f"{path}/{i}"
        nodes[path] = Node(
            pose=befores[i - 1],
            joint=component.joints[i - 1],
            value=float(values[i - 1]),
            curve=curves[i - 1] if curves else None,
        )
        _add_bodies(nodes, robot, i, path, looks)
    if chain.n:
        path = f"{path}/grasper"
        nodes[path] = Node(pose=chain.grasper)
        _add_bodies(nodes, robot, chain.n + 1, path, looks)
    return nodes


def _add_bodies(
    nodes: dict[str, Node],
    robot: Robot,
    frame: int,
    path: str,
    looks: dict[int, dict[str, Node]],
) -> None:
    """Add what hangs on one frame: bodies of the default look, the user's part, other robots."""
    for name, node in looks.get(frame, {}).items():
        nodes[f"{path}/{name.lstrip('/')}"] = node
    part = robot.own.parts.get(frame)
    if part is not None and robot.own.look == "user":
        nodes |= part._nodes(f"{path}/part", robot.own.color)
    for at, child in robot.joints_at:
        if at == frame:
            nodes |= robot_nodes(child, f"{path}/{child.name}")
