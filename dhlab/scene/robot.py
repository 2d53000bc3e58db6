"""Robots: chains with a configuration, joined to trees."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dhlab.arrays import as_config, as_configs, read_only
from dhlab.errors import InputError
from dhlab.kinematics.chain import Chain
from dhlab.kinematics.mechanism import Mechanism
from dhlab.kinematics.transforms import inverse
from dhlab.scene import setting
from dhlab.scene.block import Block, BlockComplex
from dhlab.scene.component import Component
from dhlab.scene.handle import CHANGES, Handle, Names
from dhlab.scene.marks import Trail
from dhlab.scene.node import Clock, Node
from dhlab.scene.robot_frames import branches_of, frames_of, link_to, trails_of
from dhlab.scene.robot_nodes import Description
from dhlab.scene.robot_settings import Common, Handed, Joined, Own
from dhlab.scene.robot_text import robot_html, robot_text
from dhlab.scene.setting import Setting, check_settings, settings_of
from dhlab.scene.way import Link


def check_robots(robots: Sequence[Any], what: str) -> None:
    """Refuse no robots at all, and what is no robot."""
    if not robots:
        raise InputError(f"{what} needs at least one robot, got none")
    for k, candidate in enumerate(robots, start=1):
        if not isinstance(candidate, Robot):
            raise TypeError(f"{what}: argument {k} is a {type(candidate).__name__}, not a robot")


class Robot(Handle):
    """A mechanism: joints of its own and robots attached to them.

    Made by `robot` (a chain) and `robot_complex` (several robots on one base). Whatever is set
    on a robot holds for the whole mechanism from it down; `components` lists the simple robots
    in it, each to be set alone.
    """

    __slots__ = ("_attached", "_description", "_mechanism", "_model", "_own")

    kind = "robot"

    q = Joined("q")
    limits = Joined("limits")
    base = Own("base")
    dimensions = Own("dimensions")
    chain = Own("chain")
    grasper = Own("grasper")
    color = Common("color")
    opacity = Common("opacity")
    edges = Common("edges")
    look = Common("look")
    radius = Common("radius")
    grasper_size = Common("grasper_size")
    frame_size = Common("frame_size")
    show_csys = Common("show_csys")
    model: Setting[str] = Setting(
        setting.one_of("plain", "configex"),
        "'plain', or 'configex': spheres mark where components are joined.",
    )

    def __init__(self, chain: Chain, name: str | None = None) -> None:
        super().__init__(name)
        self._own = Component(self, chain)
        self._attached: list[tuple[int, Robot]] = []
        self._mechanism: Mechanism | None = None
        self._description: Description | None = None
        self._model = "plain"

    @property
    def own(self) -> Component:
        """The own joints alone, whatever is attached to them; none in a complex."""
        return self._own

    @property
    def joints_at(self) -> tuple[tuple[int, Robot], ...]:
        """The attached robots with the frame each hangs on: 0 the base, 1 to n a joint."""
        return tuple(self._attached)

    @property
    def attached(self) -> tuple[Robot, ...]:
        """The robots attached to this one, in order."""
        return tuple(robot for _, robot in self._attached)

    @property
    def components(self) -> tuple[Component, ...]:
        """The simple robots from this one down, in the order of `q`."""
        below = tuple(c for _, robot in self._attached for c in robot.components)
        return (self._own, *below) if self._own.n else below

    @property
    def n(self) -> int:
        """Number of variables of the whole mechanism."""
        return sum(component.n for component in self.components)

    @property
    def home(self) -> NDArray[np.float64]:
        """Configuration that the tables give, shape (n,) [rad or m]."""
        return read_only(np.concatenate([np.empty(0), *(c.chain.home for c in self.components)]))

    def set(self, **values: Any) -> Self:
        """Set several properties at once; all are checked before the first is changed.

        Parameters
        ----------
        **values
            Properties by name. `q` and `limits` are those of the whole mechanism; `base`,
            `chain` and `grasper` belong to the own joints; looks go to all components.

        Returns
        -------
        robot : the robot itself

        Raises
        ------
        LimitError
            A configuration outside the limits, or limits that shut out the present one.
        InputError, TypeError
            A value that cannot be, or a property that does not exist.
        """
        with CHANGES:
            if values.keys() == {"q"}:
                return self._go(values["q"])
            shares, own = self._shares(values)
            checked = check_settings(self, self.name, own)
            plan = [(component, component.check(part)) for component, part in shares.items()]
            for component, part in plan:
                component.store(part)
            self._store(checked)
            self._changed()
        return self

    def _go(self, q: ArrayLike) -> Self:
        """Take a configuration and nothing else: all its limits are looked at in one go."""
        q = self.mechanism.check(as_config(q, self.n, f"q of '{self.name}'"))
        for robot, part in zip(self.robots(), self.mechanism.slices, strict=True):
            robot.own.store({"q": q[part]})
        self._moved()
        return self

    def _shares(
        self, values: Mapping[str, Any]
    ) -> tuple[dict[Component, dict[str, Any]], dict[str, Any]]:
        """Cut values up among the components; what the robot keeps itself comes second."""
        settings = settings_of(Robot)
        shares: dict[Component, dict[str, Any]] = {}
        own: dict[str, Any] = {}
        for key, value in values.items():
            handed = settings.get(key)
            if isinstance(handed, Handed):
                for component, part in handed.share(self, value):
                    shares.setdefault(component, {})[key] = part
            else:
                own[key] = value
        return shares, own

    def robots(self) -> tuple[Robot, ...]:
        """Return this robot and all that hang on it, in the order of `q`."""
        return (self, *(r for _, robot in self._attached for r in robot.robots()))

    @property
    def top(self) -> Robot:
        """The robot at the root of the mechanism."""
        return self._parent.top if isinstance(self._parent, Robot) else self

    def connect(self, *robots: Robot, at: int | None = None) -> Self:
        """Attach robots to the last joint's frame, or to any frame.

        Several are made one complex first; from then on their bases are poses in the frame they
        are attached to. A gripper at that frame is drawn no more.

        Parameters
        ----------
        *robots : Robot
        at : int, optional
            Frame: 0 for the base, 1 to n for a joint; the last joint unless given.

        Returns
        -------
        robot : the robot itself, now the whole mechanism

        Raises
        ------
        AttachError
            A robot is attached already, or carries this one; nothing is changed.
        InputError
            There is no such frame, there are no robots, or two have one name.

        References
        ----------
        Pajak, section 3.2.
        """
        check_robots(robots, f"connect of '{self.name}'")
        frame = self._connect_frame(at)
        with CHANGES:
            self._check_free(*robots)
            child = robots[0]
            if len(robots) > 1:
                child = Robot(Chain(rows=(), joints=""))
                child._name = Names(c.name for c in self.children()).take("complex")
                child._attach(0, *robots)
            self._attach(frame, child)
            self._changed()
        return self

    def carry(self, robots: Sequence[Robot]) -> None:
        """Take robots onto the base; they stay where they are in the world."""
        with CHANGES:
            self._attach(0, *robots)
            to_base = inverse(self.world_pose)
            for robot in robots:
                robot._own.store({"chain": robot.chain.replace(base=to_base @ robot.base)})
            self._changed()

    def _connect_frame(self, at: int | None) -> int:
        n = self._own.n
        if at is None and n == 0:
            names = ", ".join(repr(robot.name) for robot in self.attached)
            raise InputError(
                f"'{self.name}' has no last joint to connect to: connect to one of its components "
                f"({names}), or to its base with at=0"
            )
        frame = n if at is None else at
        if isinstance(frame, bool) or not isinstance(frame, int) or not 0 <= frame <= n:
            raise InputError(f"at: '{self.name}' has frames 0 (its base) to {n}, got {at!r}")
        return frame

    def _attach(self, frame: int, *robots: Robot) -> None:
        self._adopt(*robots)
        self._attached += [(frame, robot) for robot in robots]

    def _set_part(
        self, component: Component, part: Block | BlockComplex | None, frame: int
    ) -> Block | BlockComplex | None:
        if part is not None and not isinstance(part, Block | BlockComplex):
            raise TypeError(f"part of '{self.name}' must be a block, got a {type(part).__name__}")
        with CHANGES:
            old = component._parts.get(frame)
            if part is not None and part is not old:
                self._adopt(part)
            if old is not None and old is not part:
                old._parent = None
            component._parts = {k: b for k, b in component._parts.items() if k != frame}
            if part is not None:
                component._parts[frame] = part
            self._changed()
        return part

    def set_part(
        self, part: Block | BlockComplex | None, *, joint: int | str = 0
    ) -> Block | BlockComplex | None:
        """Give the user look a block at one of the robot's own frames; None takes it away.

        Parameters
        ----------
        part : Block, BlockComplex or None
            Drawn in coordinates of the frame; its handle stays live.
        joint : int or 'grasper'
            1 to n: a joint's frame; 0: the base; 'grasper': the grasper's frame.

        Returns
        -------
        part : the block

        Raises
        ------
        InputError
            There is no such joint.
        AttachError
            The block belongs to something already.

        References
        ----------
        Pajak, section 4.3.
        """
        return self._own.set_part(part, joint=joint)

    def clip(self, q: ArrayLike) -> NDArray[np.float64]:
        """Return the configuration nearest to `q` that is within the limits, shape (n,)."""
        q = as_config(q, self.n, f"q of '{self.name}'")
        return read_only(np.clip(q, self.limits[:, 0], self.limits[:, 1]))

    def frames(self, q: ArrayLike | None = None) -> dict[str, NDArray[np.float64]]:
        """Poses of all joints and graspers in the world frame.

        Parameters
        ----------
        q : array_like, shape (n,) or (steps, n) [rad or m], optional
            Configuration of this robot's mechanism; the present one unless given. Shape and
            finiteness are checked, limits are not.

        Returns
        -------
        frames : dict of str to ndarray, shape (4, 4) or (steps, 4, 4)
            By names from the mechanism's root: ``arm/7``, ``arm/hand/thumb/1``,
            ``arm/hand/thumb/grasper``.

        Examples
        --------
        >>> from dhlab import dh, robot
        >>> r = robot([dh(0, 0, 0, 0), dh(0, 2, 0, 0)], "rr", grasper=(1, 0, 0))
        >>> r.frames([np.pi / 2, 0])["robot/grasper"][:3, 3].round(6)
        array([0., 3., 0.])
        """
        return frames_of(self, q)

    @property
    def mechanism(self) -> Mechanism:
        """The mechanism from this robot down as immutable maths, its base in the world."""
        if self._mechanism is None:
            self._mechanism = Mechanism(branches_of(self))
        return self._mechanism

    def children(self) -> tuple[Handle, ...]:
        """Return the attached robots and the user's parts."""
        return (*self.attached, *self._own._parts.values())

    def way(self) -> tuple[Link, ...]:
        """Return the frames from the world to the base, each in the one before."""
        return (*self._carrier(), Link(self.base))

    def way_to(self, child: Handle) -> tuple[Link, ...]:
        """Return the frames from the world to the one that a child of this robot stands in."""
        places: dict[Handle, int] = {robot: at for at, robot in self._attached}
        places |= {part: at for at, part in self._own.parts.items()}
        return (*self._carrier(), link_to(self._own, places[child]))

    def _forget(self) -> None:
        super()._forget()
        self._mechanism = self._description = None

    def _nodes(self, path: str) -> dict[str, Node]:
        if self._description is None or self._description.path != path:
            self._description = Description(self, path)
        return self._description.nodes()

    def check_samples(self, samples: ArrayLike, what: str) -> NDArray[np.float64]:
        """Check the configurations of a motion, shape (steps, n), and put them on the limits."""
        q = as_configs(samples, self.n, what)
        cuts = np.cumsum([component.n for component in self.components])[:-1]
        columns = np.split(q, cuts, axis=1)
        pairs = zip(self.components, columns, strict=True)
        return np.hstack([component.check_samples(part, what) for component, part in pairs])

    def check_sample(self, sample: ArrayLike, what: str) -> NDArray[np.float64]:
        """Check the shape of one configuration of a motion."""
        return as_config(sample, self.n, what)

    def take_motion(self, clock: Clock, samples: NDArray[np.float64]) -> None:
        """Move along `samples` and end in the last; the lock is held, nobody is told."""
        cuts = np.cumsum([component.n for component in self.components])[:-1]
        for component, part in zip(self.components, np.split(samples, cuts, axis=1), strict=True):
            component.take_motion(clock, part)

    def trails(self, clock: Clock) -> list[Trail]:
        """Return the paths of the graspers in the world during a motion."""
        return trails_of(self, clock)

    def __repr__(self) -> str:
        return robot_text(self)

    def _repr_html_(self) -> str:
        return robot_html(self)
