"""What a step of a lesson moves, and how: turns, slides, robots to a configuration."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dhlab.arrays import as_config, as_number, as_placement, as_vector, read_only
from dhlab.errors import InputError
from dhlab.kinematics.angles import angvec2r, interpolate
from dhlab.kinematics.transforms import inverse, rp2t, transl
from dhlab.scene.handle import Handle
from dhlab.scene.placed import Placed
from dhlab.scene.robot import Robot

State: TypeAlias = Mapping[Handle, NDArray[np.float64]]
"""Where everything stands: a pose for a csys or block, a configuration for a robot."""

AXES = {letter: read_only(np.eye(3)[k]) for k, letter in enumerate("xyz")}
SLIDE_SAMPLES = 9
TURN_PER_SAMPLE = np.pi / 30


@dataclass(frozen=True, eq=False)
class Turn:
    """A turn of a csys or block about an axis; made by `turn`.

    Attributes
    ----------
    what : Csys, Block or BlockComplex
    axis : ndarray, shape (3,)
        Unit vector in the frame it turns about.
    angle : float [rad]
    about : Csys or other placed handle, or None
        The frame whose axis it is; None for the axes of `what` itself, as they are before.
    letter : str
        Name of the axis in formulas.
    label : str
        Written at the arc.
    fixed : bool
        Whether it is an axis of the world.
    """

    what: Placed
    axis: NDArray[np.float64]
    angle: float
    about: Placed | None = None
    letter: str = "u"
    label: str = ""
    fixed: bool = False

    @property
    def samples(self) -> int:
        """Into how many parts the way is cut."""
        return max(SLIDE_SAMPLES, int(np.ceil(abs(self.angle) / TURN_PER_SAMPLE)))

    @property
    def motion(self) -> NDArray[np.float64]:
        """The move as a pose in its own frame, shape (4, 4)."""
        return self.partial(1.0)

    def partial(self, s: float) -> NDArray[np.float64]:
        """Return the part `s` of the move, from 0 to 1, shape (4, 4)."""
        return rp2t(angvec2r(s * self.angle, self.axis), np.zeros(3))

    def at(self, state: State, s: float) -> NDArray[np.float64]:
        """Pose after the part `s` of the move, which begins in `state`, shape (4, 4)."""
        return moved(self, state, self.partial(s))

    @property
    def latex(self) -> str:
        """The move as a factor of a product."""
        return rf"R_{{{self._axis}}}({np.degrees(self.angle):.4g}^\circ)"

    @property
    def words(self) -> str:
        """The move in a sentence."""
        amount = f"{np.degrees(self.angle):.4g}°"
        axis = f"{self.letter}-axis" if self.letter in AXES else f"axis {vector_text(self.axis)}"
        return f"'{self.what.name}' turns by {amount} about {whose(self, axis)}"

    @property
    def _axis(self) -> str:
        return self.letter if self.about is None else f"{self.letter}_{{{self.about.name}}}"


@dataclass(frozen=True, eq=False)
class Slide:
    """A slide of a csys or block along a vector; made by `slide`.

    Attributes
    ----------
    what : Csys, Block or BlockComplex
    vector : ndarray, shape (3,) [m]
        In the frame it slides along.
    along : Csys or other placed handle, or None
        The frame of the vector; None for the axes of `what` itself.
    label : str
        Written at the arrow.
    fixed : bool
        Whether it is a vector of the world.
    """

    what: Placed
    vector: NDArray[np.float64]
    along: Placed | None = None
    label: str = ""
    fixed: bool = False

    @property
    def about(self) -> Placed | None:
        """The frame of the vector."""
        return self.along

    @property
    def samples(self) -> int:
        """Into how many parts the way is cut."""
        return SLIDE_SAMPLES

    @property
    def motion(self) -> NDArray[np.float64]:
        """The move as a pose in its own frame, shape (4, 4)."""
        return self.partial(1.0)

    def partial(self, s: float) -> NDArray[np.float64]:
        """Return the part `s` of the move, from 0 to 1, shape (4, 4)."""
        return transl(s * self.vector)

    def at(self, state: State, s: float) -> NDArray[np.float64]:
        """Pose after the part `s` of the move, which begins in `state`, shape (4, 4)."""
        return moved(self, state, self.partial(s))

    @property
    def latex(self) -> str:
        """The move as a factor of a product."""
        along = np.flatnonzero(np.abs(self.vector) > 1e-12)
        if len(along) == 1:
            return rf"D_{'xyz'[along[0]]}({self.vector[along[0]]:.4g})"
        return rf"D({', '.join(f'{x:.4g}' for x in self.vector)})"

    @property
    def words(self) -> str:
        """The move in a sentence."""
        along = np.flatnonzero(np.abs(self.vector) > 1e-12)
        if len(along) == 1:
            amount, axis = self.vector[along[0]], f"{'xyz'[along[0]]}-axis"
            return f"'{self.what.name}' slides by {amount:.4g} m along {whose(self, axis)}"
        if len(along) == 0:
            return f"'{self.what.name}' stays where it is"
        axes = whose(self, "axes")
        return f"'{self.what.name}' slides by {vector_text(self.vector)} m, told in {axes}"


@dataclass(frozen=True, eq=False)
class MoveTo:
    """A csys or block goes to a pose by the shortest turn and a straight way; made by `move_to`."""

    what: Placed
    pose: NDArray[np.float64]

    samples = 16

    def at(self, state: State, s: float) -> NDArray[np.float64]:
        """Pose after the part `s` of the move, which begins in `state`, shape (4, 4)."""
        return self.pose if s == 1 else interpolate(state[self.what], self.pose, s)

    @property
    def words(self) -> str:
        """The move in a sentence."""
        return f"'{self.what.name}' moves to a pose of its own"


@dataclass(frozen=True, eq=False)
class Configure:
    """A robot goes to a configuration, every joint evenly; made by `configure`."""

    what: Robot
    q: NDArray[np.float64]

    samples = 16

    def at(self, state: State, s: float) -> NDArray[np.float64]:
        """Configuration after the part `s` of the move, which begins in `state`, shape (n,)."""
        return self.q if s == 1 else state[self.what] + s * (self.q - state[self.what])

    @property
    def words(self) -> str:
        """The move in a sentence."""
        return f"'{self.what.name}' goes to another configuration"


Move: TypeAlias = Turn | Slide | MoveTo | Configure


def turn(
    what: Placed,
    axis: str | ArrayLike,
    angle: float,
    *,
    about: Placed | str | None = None,
    label: str | None = None,
) -> Turn:
    """Turn a csys or block about an axis.

    Parameters
    ----------
    what : Csys, Block or BlockComplex
    axis : {'x', 'y', 'z'} or array_like, shape (3,)
        Of the frame `about`; a vector need not have length 1.
    angle : float [rad]
    about : Csys, Block, 'world' or None
        The frame whose axis it is, where that frame stands before the step. None: the moving
        axes of `what` itself.
    label : str, optional
        Written at the arc; the angle in degrees unless given.

    Returns
    -------
    move : Turn

    Raises
    ------
    InputError, TypeError
        An axis or a frame that is none.

    Examples
    --------
    >>> from dhlab import csys, deg
    >>> turn(csys(name="B"), "z", 90 * deg).words
    "'B' turns by 90° about its own z-axis"
    """
    check_placed(what, "turn")
    frame, fixed = _frame(about, "about")
    letter = axis if isinstance(axis, str) else "u"
    text = f"{np.degrees(angle):.4g}°" if label is None else label
    return Turn(what, _axis(axis), as_number(angle, "angle"), frame, letter, text, fixed)


def slide(
    what: Placed,
    vector: ArrayLike,
    *,
    along: Placed | str | None = None,
    label: str | None = None,
) -> Slide:
    """Slide a csys or block along a vector.

    Parameters
    ----------
    what : Csys, Block or BlockComplex
    vector : array_like, shape (3,) [m]
    along : Csys, Block, 'world' or None
        The frame of the vector, where it stands before the step. None: the moving axes of
        `what` itself.
    label : str, optional
        Written at the arrow; the length unless given.

    Returns
    -------
    move : Slide

    Examples
    --------
    >>> from dhlab import csys
    >>> slide(csys(name="B"), (0, 0, 0.5), along="world").words
    "'B' slides by 0.5 m along the z-axis of the world"
    """
    check_placed(what, "slide")
    frame, fixed = _frame(along, "along")
    way = as_vector(vector, "vector")
    text = f"{np.linalg.norm(way):.4g} m" if label is None else label
    return Slide(what, way, frame, text, fixed)


def move_to(what: Placed, pose: ArrayLike) -> MoveTo:
    """Move a csys or block to a pose: an even turn and a straight way.

    Parameters
    ----------
    what : Csys, Block or BlockComplex
    pose : array_like, shape (4, 4) or (3,)
        In the world; an origin alone keeps the orientation the handle has now.

    Returns
    -------
    move : MoveTo

    Examples
    --------
    >>> from dhlab import csys
    >>> move_to(csys(name="B"), (1, 0, 0)).pose[:3, 3]
    array([1., 0., 0.])
    """
    check_placed(what, "move_to")
    return MoveTo(what, as_placement(pose, f"pose of '{what.name}'", what.pose))


def configure(what: Robot, q: ArrayLike) -> Configure:
    """Move a robot to a configuration.

    Parameters
    ----------
    what : Robot
        The top of its mechanism.
    q : array_like, shape (n,) [rad or m]

    Returns
    -------
    move : Configure

    Raises
    ------
    LimitError
        The configuration is outside the limits.

    Examples
    --------
    >>> from dhlab import dh, robot
    >>> configure(robot([dh(0, 0, 0, 0)], "r"), [0.5]).q
    array([0.5])
    """
    if not isinstance(what, Robot):
        raise TypeError(f"configure moves a robot, not a {type(what).__name__}")
    q = as_config(q, what.n, f"q of '{what.name}'")
    return Configure(what, what.check_samples(q[None], f"q of '{what.name}'")[0])


def moved(move: Turn | Slide, state: State, motion: NDArray[np.float64]) -> NDArray[np.float64]:
    """Pose of what a move moves, after `motion` in the frame of the move, shape (4, 4)."""
    start = state[move.what]
    frame = frame_of(move, state)
    if frame is None:
        return start @ motion
    return frame @ motion @ inverse(frame) @ start


def frame_of(move: Turn | Slide, state: State) -> NDArray[np.float64] | None:
    """Pose in the world of the frame that a move goes by; None for what moves itself."""
    if move.fixed:
        return np.eye(4)
    if move.about is None:
        return None
    return state.get(move.about, move.about.world_pose)


def whose(move: Turn | Slide, axis: str) -> str:
    """Say whose axis a move goes by."""
    if move.fixed:
        return f"the {axis} of the world"
    return f"its own {axis}" if move.about is None else f"the {axis} of '{move.about.name}'"


def vector_text(vector: NDArray[np.float64]) -> str:
    """Return a vector in a few digits."""
    return f"({', '.join(f'{x:.4g}' for x in vector)})"


def check_placed(what: Any, verb: str) -> None:
    """Refuse what has no pose of its own in the world."""
    if not isinstance(what, Placed):
        hint = "; use configure for a robot" if isinstance(what, Robot) else ""
        raise TypeError(f"{verb} moves a csys or a block, not a {type(what).__name__}{hint}")
    if what.parent is not None:
        raise InputError(f"{verb}: '{what.name}' belongs to '{what.parent.name}'; move that")


def _frame(frame: Placed | str | None, what: str) -> tuple[Placed | None, bool]:
    if frame == "world":
        return None, True
    if frame is not None and not isinstance(frame, Placed):
        raise TypeError(f"{what} must be a csys, a block, 'world' or None, got {frame!r}")
    return frame, False


def _axis(axis: str | ArrayLike) -> NDArray[np.float64]:
    if isinstance(axis, str):
        if axis not in AXES:
            raise InputError(f"no axis {axis!r}; use 'x', 'y', 'z' or a vector")
        return AXES[axis]
    vector = as_vector(axis, "axis")
    length = np.linalg.norm(vector)
    if length < 1e-12:
        raise InputError("axis must not be the zero vector")
    return read_only(vector / length)
