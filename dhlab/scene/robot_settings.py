"""How a property of a robot is shared out: to its own joints, to all components, or cut up."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from dhlab.arrays import as_config, as_limits, read_only
from dhlab.scene.component import Component
from dhlab.scene.setting import Setting, settings_of

if TYPE_CHECKING:
    from dhlab.scene.robot import Robot


class Handed(Setting[Any]):
    """A property that a robot hands on to components, which keep it.

    Parameters
    ----------
    name : str
        The property of a `Component` that keeps it.
    """

    def __init__(self, name: str) -> None:
        kept = settings_of(Component)[name]
        super().__init__(kept.check, kept.__doc__ or "")

    def share(self, robot: Robot, value: Any) -> Iterable[tuple[Component, Any]]:
        """Give each component that is concerned its part of a value."""
        raise NotImplementedError


class Own(Handed):
    """A property of the robot's own joints, whatever is attached to them."""

    def value(self, handle: Any) -> Any:
        """Return the own value."""
        return getattr(handle.own, self.slot[1:])

    def share(self, robot: Robot, value: Any) -> Iterable[tuple[Component, Any]]:
        """Give the value to the own joints."""
        return [(robot.own, value)]


class Common(Handed):
    """A property that goes to all components.

    Reading gives the robot's own value, and for a complex what its components agree on: None
    where they differ.
    """

    def value(self, handle: Any) -> Any:
        """Return the own value, or the common one."""
        name = self.slot[1:]
        if handle.own.n:
            return getattr(handle.own, name)
        values = {getattr(component, name) for component in handle.components}
        return values.pop() if len(values) == 1 else None

    def share(self, robot: Robot, value: Any) -> Iterable[tuple[Component, Any]]:
        """Give the value to everybody from the robot down."""
        return [(other.own, value) for other in robot.robots()]


class Joined(Handed):
    """A property of the whole mechanism: those of its components, one after the other."""

    def value(self, handle: Any) -> NDArray[np.float64]:
        """Return the components' values as one array."""
        return read_only(np.concatenate([getattr(r.own, self.slot[1:]) for r in handle.robots()]))

    def share(self, robot: Robot, value: Any) -> Iterable[tuple[Component, Any]]:
        """Cut the value up; its shape is checked here, its parts where they are kept."""
        check = as_limits if self.slot == "_limits" else as_config
        whole = check(value, robot.n, f"{self.slot[1:]} of '{robot.name}'")
        start, parts = 0, []
        for other in robot.robots():
            parts.append((other.own, whole[start : start + other.own.n]))
            start += other.own.n
        return parts
