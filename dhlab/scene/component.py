"""One simple robot of a mechanism: its table, its own joints, how it looks."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dhlab.arrays import as_config, as_configs, as_limits, as_placement
from dhlab.errors import InputError, LimitError
from dhlab.kinematics.chain import Chain
from dhlab.scene import dimensions, robot_look, setting
from dhlab.scene.handle import CHANGES
from dhlab.scene.marks import Trail
from dhlab.scene.node import Clock, Color, Curve, Joint, Node
from dhlab.scene.palette import component_color
from dhlab.scene.robot_look import Appearance
from dhlab.scene.setting import Setting, check_settings

if TYPE_CHECKING:
    from dhlab.scene.block import Block, BlockComplex
    from dhlab.scene.robot import Robot

LOOKS = ("stick", "solid", "user")


def own_limits(value: Any, what: str, current: NDArray[np.float64]) -> NDArray[np.float64]:
    """Check limits: one row a joint, None for none."""
    return as_limits(value, len(current), what)


def own_config(value: Any, what: str, current: NDArray[np.float64]) -> NDArray[np.float64]:
    """Check the shape of a configuration."""
    return as_config(value, len(current), what)


def own_chain(value: Any, what: str, current: Chain) -> Chain:
    """Check that a new table has as many joints as the old one."""
    if not isinstance(value, Chain):
        raise InputError(f"{what} must be a Chain, got a {type(value).__name__}")
    if value.n != current.n:
        raise InputError(f"{what} must have {current.n} joints, got {value.n}")
    return value


def of_chain(field: str) -> Callable[[Component], Any]:
    """Read a field of a component's chain."""
    return lambda component: getattr(component.chain, field)


def palette_color(component: Component) -> Color:
    """Read the colour: the one given, or the palette's for its place in the mechanism."""
    if component._color is not None:
        return component._color
    mechanism = [robot.own for robot in component.robot.top.robots()]
    mechanism.sort(key=lambda other: other.n == 0)
    return component_color(mechanism.index(component))


class Component:
    """The own joints of one robot, live both ways; `Robot.components` lists them.

    Its configuration, limits and colours are those of this robot alone, whatever is attached to
    it. Changes made here and changes made through any robot that carries it are the same.
    """

    __slots__ = (
        "__weakref__",
        "_chain",
        "_color",
        "_curves",
        "_dimensions",
        "_drawn",
        "_edges",
        "_frame_size",
        "_grasper_size",
        "_joints",
        "_look",
        "_opacity",
        "_parts",
        "_q",
        "_radius",
        "_robot",
        "_show_csys",
    )

    q: Setting[NDArray[np.float64]] = Setting(
        own_config, "ndarray, shape (n,) [rad or m]: configuration, within the limits."
    )
    chain: Setting[Chain] = Setting(
        own_chain, "Chain: the table; assign ``chain.replace(2, a=0.3)`` to change a number."
    )
    limits: Setting[NDArray[np.float64]] = Setting(
        own_limits,
        "ndarray, shape (n, 2) [rad or m]: lower and upper limit of each variable.",
        read=of_chain("limits"),
    )
    base: Setting[NDArray[np.float64]] = Setting(
        as_placement,
        "ndarray, shape (4, 4): pose in what carries the robot (the world, where nothing does).",
        read=of_chain("base"),
    )
    grasper: Setting[NDArray[np.float64]] = Setting(
        as_placement,
        "ndarray, shape (4, 4): pose of the grasper (tool) in the last joint's frame.",
        read=of_chain("grasper"),
    )
    grasper_size: Setting[float] = Setting(
        setting.length_or_default,
        "float [m]: opening of the drawn gripper; 0 draws a fingertip; None: the default.",
        read=lambda c: 1.8 * c.radius if c._grasper_size is None else c._grasper_size,
    )
    radius: Setting[float] = Setting(
        setting.positive_or_default,
        "float [m]: radius of the drawn joints and joining bodies; None: what suits the reach.",
        read=lambda c: robot_look.default_radius(c.chain) if c._radius is None else c._radius,
    )
    frame_size: Setting[float] = Setting(
        setting.positive_or_default,
        "float [m]: length of the axes of local coordinate systems; None: what suits the links.",
        read=lambda c: 3.2 * c.radius if c._frame_size is None else c._frame_size,
    )
    color: Setting[Color] = Setting(
        setting.color,
        "colour as 3 floats in [0, 1] or '#rrggbb'; None: the palette's.",
        read=palette_color,
    )
    opacity: Setting[float] = Setting(setting.fraction, "float in [0, 1]: 1 hides what is behind.")
    edges: Setting[bool] = Setting(setting.flag, "bool: whether bodies show their edges.")
    look: Setting[str] = Setting(
        setting.one_of(*LOOKS), "'stick', 'solid' or 'user': what is drawn."
    )
    show_csys: Setting[bool] = Setting(
        setting.flag, "bool: whether the joints' coordinate systems are drawn."
    )
    dimensions: Setting[dimensions.Selection | None] = Setting(
        dimensions.as_selection,
        "None, a row of the table whose four numbers are drawn as dimensions, from 1, or the row "
        "and one of 'alpha', 'a', 'd', 'theta' that is lit up: ``(2, 'alpha')``.",
    )

    def __init__(self, robot: Robot, chain: Chain) -> None:
        self._robot = robot
        self._chain = chain
        self._q = chain.home
        self._curves: tuple[Curve, ...] | None = None
        self._color: Color | None = None
        self._opacity = 1.0
        self._edges = False
        self._look = "solid"
        self._radius: float | None = None
        self._grasper_size: float | None = None
        self._frame_size: float | None = None
        self._show_csys = False
        self._dimensions: dimensions.Selection | None = None
        self._parts: dict[int, Block | BlockComplex] = {}
        self._joints = joints_of(chain, tuple(os.urandom(6).hex() for _ in range(chain.n)))
        self._drawn: tuple[object, dict[int, dict[str, Node]]] | None = None

    @property
    def robot(self) -> Robot:
        """The handle of the robot that these joints belong to."""
        return self._robot

    @property
    def name(self) -> str:
        """Name of the robot."""
        return self._robot.name

    @property
    def n(self) -> int:
        """Number of own joints."""
        return self._chain.n

    @property
    def keys(self) -> tuple[str, ...]:
        """Names that the joints keep as long as the robot lives."""
        return tuple(joint.key for joint in self._joints)

    @property
    def joints(self) -> tuple[Joint, ...]:
        """How each joint's node moves."""
        return self._joints

    @property
    def curves(self) -> tuple[Curve, ...] | None:
        """The planned motion of each joint, None when it stands."""
        return self._curves

    @property
    def parts(self) -> Mapping[int, Block | BlockComplex]:
        """The user's parts by frame: 0 the base, 1 to n the joints, n + 1 the grasper."""
        return dict(self._parts)

    def set(self, **values: Any) -> Self:
        """Set several properties at once; all are checked before the first is changed.

        Raises
        ------
        LimitError
            A configuration outside the limits, or limits that shut out the present one.
        """
        with CHANGES:
            self.store(self.check(values))
            if values.keys() == {"q"}:
                self._robot._moved()
            else:
                self._robot._changed()
        return self

    def set_part(
        self, part: Block | BlockComplex | None, *, joint: int | str
    ) -> Block | BlockComplex | None:
        """Give the user look a block at a frame; None takes it away.

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
        """
        frame = self._frame_index(joint)
        return self._robot._set_part(self, part, frame)

    def clip(self, q: ArrayLike) -> NDArray[np.float64]:
        """Return the configuration nearest to `q` that is within the limits, shape (n,)."""
        return self._chain.clip(as_config(q, self.n, f"q of '{self.name}'"))

    def check(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """Check values of properties, alone and together; return what is to be stored."""
        checked = check_settings(self, self.name, values)
        fields = {k: checked.pop(k) for k in ("limits", "base", "grasper") if k in checked}
        chain: Chain = checked.get("chain", self._chain)
        if fields:
            chain = checked["chain"] = chain.replace(**fields)
        dimensions.check_row(
            checked.get("dimensions", self._dimensions), chain, f"dimensions of '{self.name}'"
        )
        if "q" in checked:
            checked["q"] = chain.check(checked["q"], self.name)
        elif chain is not self._chain:
            self._check_present(chain)
        return checked

    def _check_present(self, chain: Chain) -> None:
        """Refuse a chain whose limits shut out the present configuration."""
        try:
            chain.check(self._q, self.name)
        except LimitError as error:
            hint = "the present configuration would be outside: set(limits=..., q=...) sets both"
            args = (error.component, error.joint, error.value, error.interval, error.kind)
            raise LimitError(*args, hint=hint) from None

    def store(self, checked: Mapping[str, Any]) -> None:
        """Keep checked values; the lock is held, nobody is told."""
        for key, value in checked.items():
            setattr(self, f"_{key}", value)
        if "chain" in checked:
            self._joints = joints_of(self._chain, self.keys)
        if "chain" in checked or "q" in checked:
            self._curves = None

    def check_samples(self, samples: ArrayLike, what: str) -> NDArray[np.float64]:
        """Check the configurations of a motion, shape (steps, n), and put them on the limits."""
        return self._chain.check(as_configs(samples, self.n, what), self.name)

    def take_motion(self, clock: Clock, samples: NDArray[np.float64]) -> None:
        """Move along `samples` and end in the last; the lock is held, nobody is told."""
        self.store({"q": samples[-1]})
        moved = samples + self._chain.offset
        self._curves = tuple(Curve(clock, column) for column in moved.T)

    def rest_in_motion(self, curves: tuple[Curve, ...], state: NDArray[np.float64]) -> None:
        """Stand in `state`, on the way of a motion with stops; the lock is held, nobody is told."""
        self.store({"q": state})
        self._curves = curves

    def samples(self, clock: Clock) -> NDArray[np.float64]:
        """Return the own configurations during a motion, shape (steps, n)."""
        if self._curves and self._curves[0].clock is clock:
            return np.column_stack([curve.samples for curve in self._curves]) - self._chain.offset
        return np.tile(self._q, (len(clock.times), 1))

    def trails(self, clock: Clock) -> list[Trail]:
        """Return the paths of the graspers that these joints carry, during a motion."""
        return self._robot.trails(clock)

    def tell(self) -> None:
        """Tell everybody who watches the robot that something has changed."""
        self._robot.tell()

    def check_sample(self, sample: ArrayLike, what: str) -> NDArray[np.float64]:
        """Check the shape of one configuration of a motion."""
        return as_config(sample, self.n, what)

    def look_nodes(self, carried: tuple[tuple[int, Chain], ...]) -> dict[int, dict[str, Node]]:
        """Return the nodes of the default look on each frame, made anew only when they differ."""
        look = Appearance(
            chain=self._chain,
            color=self.color,
            opacity=self._opacity,
            edges=self._edges,
            radius=self.radius,
            grasper_size=self.grasper_size,
            frame_size=self.frame_size,
            standing=self._robot.parent is None,
            configex=self._robot.model == "configex",
            carried=carried,
        )
        key = (self._look, self._show_csys, look)
        if self._drawn is None or self._drawn[0] != key:
            self._drawn = (key, _draw(self._look, self._show_csys, look))
        return self._drawn[1]

    def _frame_index(self, joint: int | str) -> int:
        if joint == "grasper":
            return self.n + 1
        if isinstance(joint, int) and not isinstance(joint, bool) and 0 <= joint <= self.n:
            return joint
        known = "0 (the base)" + (f", 1 to {self.n}, 'grasper'" if self.n else "")
        raise InputError(f"'{self.name}' has no joint {joint!r}; choose from {known}")

    def __repr__(self) -> str:
        return f"Component {self.name!r}: {self.n} joints, q = {config_text(self._q)}"


def joints_of(chain: Chain, keys: tuple[str, ...]) -> tuple[Joint, ...]:
    """Return the moving part of each joint's node."""
    return tuple(
        Joint(kind, after, key)
        for kind, (_, after), key in zip(chain.kinds, chain.constants, keys, strict=True)
    )


def config_text(q: NDArray[np.float64]) -> str:
    """Return a configuration in a line: four decimals, no minus zero."""
    return f"[{', '.join(f'{x:z.4f}' for x in q)}]"


def _draw(name: str, frames: bool, look: Appearance) -> dict[int, dict[str, Node]]:
    nodes: dict[int, dict[str, Node]] = {}
    if name != "user":
        nodes = robot_look.solid(look) if name == "solid" else robot_look.stick(look)
    if frames:
        for i, frame in robot_look.local_frames(look).items():
            nodes[i] = nodes.get(i, {}) | frame
    return nodes
