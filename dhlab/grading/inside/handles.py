"""From handles of dhlab to plain data: what of a robot, a frame or a scene is judged.

Handles are read by their properties, so that this needs no dhlab of its own.
"""

from collections.abc import Callable, Iterable, Mapping
from typing import Any

import numpy as np

from dhlab.grading.inside.plain import NotPlain

CHAIN = ("rows", "joints", "convention", "base", "grasper", "offset", "home", "limits")


def robot_fields(robot: Any) -> Mapping[str, Any]:
    """Return a robot as a mapping: its table, and those of the robots attached to it.

    Parameters
    ----------
    robot : Robot or Chain

    Returns
    -------
    fields : mapping
        `name`, `rows`, `joints`, `convention`, `base`, `grasper`, `offset`, `home`, `limits` of
        the robot's own joints and its `q`; `components`, the same of each simple robot in the
        order of `q`, where there are several, each with what it hangs on: `on`, the number of a
        component, -1 for none, `at`, the frame there, and `stand`, the pose of its base in that
        frame; `frames`, by name and in the world, at `q`.
    """
    if not hasattr(robot, "frames"):
        raise _is_no("robot", robot)
    if not hasattr(robot, "components"):
        return _chain_fields(robot)
    own = {"name": robot.name, **_chain_fields(robot.own.chain)}
    whole: dict[str, Any] = {"q": robot.q, "frames": robot.frames()}
    components = [_component_fields(c) | hung for c, hung in _components(robot)]
    if len(components) == 1:
        return components[0] | whole | {"base": components[0]["stand"]}
    return own | whole | {"components": components}


def csys_pose(csys: Any) -> Any:
    """Return the pose of a coordinate system in the world; an array stays as it is."""
    return getattr(csys, "world_pose", csys)


def scene_poses(scene: Any) -> Mapping[str, Any]:
    """Return the poses of everything in a view, or in a list of handles, in the world, by name.

    A robot gives its frames too, such as ``arm/1`` and ``arm/grasper``.
    """
    handles = getattr(scene, "handles", [scene] if hasattr(scene, "world_pose") else scene)
    if isinstance(handles, Mapping):
        return handles
    if isinstance(handles, str) or not isinstance(handles, Iterable):
        raise _is_no("view and no list of handles", scene)
    poses: dict[str, Any] = {}
    for top in handles:
        if not hasattr(top, "walk"):
            raise _is_no("handle", top)
        for handle in top.walk():
            name = handle.name
            while name in poses:
                name += "'"
            poses[name] = handle.world_pose
            if handle is top and hasattr(handle, "frames"):
                poses |= handle.frames()
    return poses


READERS: Mapping[str, Callable[[Any], Any]] = {
    "values": lambda value: value,
    "robot": robot_fields,
    "csys": csys_pose,
    "scene": scene_poses,
}


def _component_fields(component: Any) -> dict[str, Any]:
    return {"name": component.name, **_chain_fields(component.chain), "q": component.q}


def _components(robot: Any) -> list[tuple[Any, dict[str, Any]]]:
    """Each component with what it hangs on; robots without joints go into the poses between."""
    found: list[tuple[Any, dict[str, Any]]] = []

    def add(robot: Any, on: int, at: int, stand: Any) -> None:
        stand, own = stand @ robot.own.base, len(found)
        if robot.own.n:
            found.append((robot.own, {"on": on, "at": at, "stand": stand}))
        for frame, child in robot.joints_at:
            if robot.own.n:
                add(child, own, frame, np.eye(4))
            else:
                add(child, on, at, stand)

    add(robot, -1, 0, np.eye(4))
    return found


def _chain_fields(chain: Any) -> dict[str, Any]:
    fields = {name: getattr(chain, name) for name in CHAIN}
    return fields | {"rows": np.array(fields["rows"], dtype=np.float64).reshape(-1, 4)}


def _is_no(wanted: str, came: Any) -> NotPlain:
    return NotPlain("not numbers", f"a {type(came).__name__} is no {wanted}")
