"""Where the frames of a robot are: from handles to the mechanism that computes them."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dhlab.arrays import as_config, as_configs
from dhlab.kinematics.mechanism import Branch
from dhlab.scene.marks import Trail
from dhlab.scene.node import Clock
from dhlab.scene.way import Link

if TYPE_CHECKING:
    from dhlab.scene.component import Component
    from dhlab.scene.robot import Robot


def branches_of(robot: Robot) -> tuple[Branch, ...]:
    """Return the chains of a mechanism, parents first, named by their paths."""
    branches: list[Branch] = []

    def add(robot: Robot, path: str, parent: int, at: int) -> None:
        index = len(branches)
        branches.append(Branch(path, robot.chain, parent, at))
        for frame, child in robot.joints_at:
            add(child, f"{path}/{child.name}", index, frame)

    add(robot, robot.name, -1, 0)
    return tuple(branches)


def path_of(robot: Robot) -> str:
    """Return the names from the mechanism's root to a robot, as one path."""
    names = [r.name for r in robot.ancestors() if r.kind == robot.kind]
    return "/".join(reversed(names))


def frames_of(robot: Robot, q: ArrayLike | None) -> dict[str, NDArray[np.float64]]:
    """Return the frames of a robot in the world, by names from the mechanism's root."""
    top = robot.top
    if robot is top:
        return top.mechanism.frames(top.q if q is None else q)
    if q is not None:
        what = f"q of '{robot.name}'"
        single = np.asarray(q).ndim != 2
        q = as_config(q, robot.n, what) if single else as_configs(q, robot.n, what)
    whole = top.q
    if q is not None:
        whole = np.array(np.broadcast_to(top.q, (*q.shape[:-1], top.n)))
        whole[..., slice_of(robot)] = q
    return _below(robot, top.mechanism.frames(whole))


def slice_of(robot: Robot) -> slice:
    """Return the place of a robot's variables in the configuration of its mechanism."""
    start = 0
    for other in robot.top.robots():
        if other is robot:
            break
        start += other.own.n
    return slice(start, start + robot.n)


def link_to(component: Component, frame: int) -> Link:
    """Return a frame in what carries the robot: 0 base, 1 to n joints, n + 1 grasper."""
    chain, curves = component.chain, component.curves
    if frame == 0:
        return Link(chain.base)

    def poses(q: NDArray[np.float64]) -> NDArray[np.float64]:
        found: NDArray[np.float64]
        found = chain.tip(q) if frame > chain.n else chain.frames(q)[..., frame - 1, :, :]
        return found

    if not curves:
        return Link(poses(component.q))
    motion = curves[0]
    return Link(poses(component.q), motion, lambda: poses(component.samples(motion.clock)))


def trails_of(robot: Robot, clock: Clock) -> list[Trail]:
    """Return the paths of a robot's graspers in the world during a motion."""
    top = robot.top
    q = np.hstack([component.samples(clock) for component in top.components])
    frames = top.mechanism.frames(q)
    return [
        Trail(path.replace("/", " "), frames[f"{path}/grasper"][:, :3, 3], r.own.color)
        for r, path in ((r, path_of(r)) for r in robot.robots())
        if f"{path}/grasper" in frames
    ]


def _below(robot: Robot, frames: dict[str, NDArray[np.float64]]) -> dict[str, NDArray[np.float64]]:
    path = path_of(robot) + "/"
    return {name: pose for name, pose in frames.items() if name.startswith(path)}
