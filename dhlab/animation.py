"""Planned motions: many handles over one vector of times, played by every view that shows them."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dhlab.arrays import as_array, as_number, read_only
from dhlab.errors import InputError
from dhlab.scene.block import Block, BlockComplex
from dhlab.scene.component import Component
from dhlab.scene.csys import Csys
from dhlab.scene.handle import CHANGES
from dhlab.scene.marks import ghosts_of, traces_of
from dhlab.scene.node import Clock
from dhlab.scene.robot import Robot

Movable: TypeAlias = Csys | Block | BlockComplex | Robot | Component

TRACES = (False, True, "ghosts")

PAUSE = 0.05
"""Seconds between the steps of a motion that has no times of its own."""


@dataclass(frozen=True, eq=False)
class PlannedMotion:
    """A motion as it was planned: its instants and who moves.

    Attributes
    ----------
    clock : Clock
        The instants as they are played [s].
    handles : tuple of handles
        Who moves; each is left in its last state.
    """

    clock: Clock
    handles: tuple[Movable, ...]

    @property
    def duration(self) -> float:
        """Time from the first instant to the last [s]."""
        return float(self.clock.times[-1] - self.clock.times[0])

    def __repr__(self) -> str:
        names = ", ".join(handle.name for handle in self.handles)
        return f"Motion of {names}: {len(self.clock.times)} steps in {self.duration:.2f} s"


def animate(
    t: ArrayLike,
    motions: Mapping[Any, Callable[[float], ArrayLike]],
    *,
    delay: float | None = None,
    trace: bool | str = False,
) -> PlannedMotion:
    """Move handles over one vector of times.

    Every function is asked for every instant first, and everything is checked; then the handles
    take their last state, and the views that show them play the motion. The call returns at
    once. Assigning to a handle that plays stops it.

    Parameters
    ----------
    t : array_like, shape (steps,) [s]
        Instants, increasing.
    motions : mapping of handles to functions
        ``f(t)`` gives the pose of a csys or block (or whatever its `move` takes), and the
        configuration of a robot. A `Trajectory` is such a function. A function with a method
        ``start(handle)`` gets that call first.
    delay : float [s], optional
        Pause between steps, in place of the times in `t`.
    trace : bool or 'ghosts'
        True leaves the path of every origin and grasper, 'ghosts' poses on the way as well.

    Returns
    -------
    motion : PlannedMotion

    Raises
    ------
    InputError
        Times that do not increase, a value of the wrong shape (the message says whose and
        when), a handle that is moved twice.
    LimitError
        A configuration outside the limits; nothing has moved.

    Examples
    --------
    >>> from dhlab import cube
    >>> c = cube(1)
    >>> animate([0, 1, 2], {c: lambda t: (t, 0, 0)})
    Motion of block: 3 steps in 2.00 s
    >>> c.pose[:3, 3]
    array([2., 0., 0.])

    References
    ----------
    Pajak, section 3.3.
    """
    times = _check_times(t)
    _check_handles(motions)
    samples = {}
    for handle, f in motions.items():
        if not callable(f):
            raise InputError(f"motion of '{handle.name}' must be a function of t, got {f!r}")
        samples[handle] = _sampled(handle, f, times)
    if delay is not None:
        times = _steps(len(times), delay)
    return _play(times, samples, trace)


def robot_motion(
    motions: Mapping[Any, ArrayLike], *, delay: float = PAUSE, trace: bool | str = False
) -> PlannedMotion:
    """Show robots in planned configurations, one after the other.

    Parameters
    ----------
    motions : mapping of Robot or Component to array_like, shape (steps, n) [rad or m]
        A configuration a row. A shorter motion holds its last one.
    delay : float [s]
        Pause between steps.
    trace : bool or 'ghosts'
        As in `animate`.

    Returns
    -------
    motion : PlannedMotion

    Raises
    ------
    InputError, LimitError
        As `animate`.

    Examples
    --------
    >>> from dhlab import dh, robot
    >>> r = robot([dh(0, 0, 0, 0)], "r")
    >>> robot_motion({r: [[0.0], [0.1], [0.2]]}, delay=0.5)
    Motion of robot: 3 steps in 1.00 s

    References
    ----------
    Pajak, section 3.3.
    """
    return _step_motion(motions, delay, trace, (Robot, Component), "a robot")


def block_motion(
    motions: Mapping[Any, ArrayLike], *, delay: float = PAUSE, trace: bool | str = False
) -> PlannedMotion:
    """Show blocks or coordinate systems in planned poses, one after the other.

    Parameters
    ----------
    motions : mapping of Block, BlockComplex or Csys to array_like, shape (steps, 4, 4)
        A pose a step. A shorter motion holds its last one.
    delay : float [s]
        Pause between steps.
    trace : bool or 'ghosts'
        As in `animate`.

    Returns
    -------
    motion : PlannedMotion

    Raises
    ------
    InputError
        As `animate`.

    Examples
    --------
    >>> from dhlab import cube, transl
    >>> block_motion({cube(1): [transl((x, 0, 0)) for x in (0, 1, 2)]}, delay=0.5)
    Motion of block: 3 steps in 1.00 s

    References
    ----------
    Pajak, section 3.3.
    """
    return _step_motion(motions, delay, trace, (Block, BlockComplex, Csys), "a block or csys")


def _step_motion(
    motions: Mapping[Any, ArrayLike],
    delay: float,
    trace: bool | str,
    kinds: tuple[type, ...],
    wanted: str,
) -> PlannedMotion:
    _check_handles(motions)
    samples: dict[Any, NDArray[np.float64]] = {}
    for handle in motions:
        if not isinstance(handle, kinds):
            raise TypeError(f"'{handle.name}' is a {type(handle).__name__}, not {wanted}")
    for handle, rows in motions.items():
        samples[handle] = handle.check_samples(rows, f"motion of '{handle.name}'")
        if len(samples[handle]) == 0:
            raise InputError(f"motion of '{handle.name}' has no steps")
    steps = max(len(rows) for rows in samples.values())
    held = {
        handle: rows[np.minimum(np.arange(steps), len(rows) - 1)]
        for handle, rows in samples.items()
    }
    return _play(_steps(steps, delay), held, trace)


def _play(
    times: NDArray[np.float64], samples: Mapping[Movable, NDArray[np.float64]], trace: bool | str
) -> PlannedMotion:
    """Give checked motions to their handles, all at once, then tell."""
    if trace not in TRACES:
        raise InputError(f"trace must be True, False or 'ghosts', got {trace!r}")
    clock = Clock(os.urandom(8).hex(), times)
    with CHANGES:
        for handle, rows in samples.items():
            handle.take_motion(clock, read_only(rows))
        for handle in samples:
            seen = handle.robot if isinstance(handle, Component) else handle
            seen.leave_marks({})
            marks = traces_of(handle.trails(clock), clock) if trace else {}
            if trace == "ghosts":
                marks |= ghosts_of(seen.describe(), clock)
            seen.leave_marks(marks)
        for handle in samples:
            handle.tell()
    return PlannedMotion(clock, tuple(samples))


def _sampled(
    handle: Movable, f: Callable[[float], ArrayLike], times: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Ask a function for every instant and check what it gives."""
    start = getattr(f, "start", None)
    if callable(start):
        start(handle)
    rows = []
    for instant in times:
        what = f"motion of '{handle.name}' at t = {instant:g} s"
        rows.append(handle.check_sample(f(float(instant)), what))
    return handle.check_samples(np.array(rows), f"motion of '{handle.name}'")


def _check_times(t: ArrayLike) -> NDArray[np.float64]:
    times = as_array(t, (None,), "t")
    if len(times) == 0 or (np.diff(times) <= 0).any():
        raise InputError("t must be one or more instants that increase")
    return times


def _check_handles(motions: Mapping[Any, Any]) -> None:
    if not motions:
        raise InputError("a motion needs at least one handle, got none")
    for handle in motions:
        if not isinstance(handle, Movable):
            raise TypeError(
                f"a motion moves robots, components, blocks and csys, not a {type(handle).__name__}"
            )
    moved: dict[Any, str] = {}
    for handle in motions:
        parts: Sequence[Any] = handle.components if isinstance(handle, Robot) else (handle,)
        for part in parts:
            if part in moved:
                raise InputError(f"'{part.name}' is moved twice: by '{moved[part]}' too")
            moved[part] = handle.name


def _steps(count: int, delay: float) -> NDArray[np.float64]:
    return read_only(np.arange(count) * as_number(delay, "delay", above=0.0))
