"""A lesson laid out in time: where everything stands at every instant of every step."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from dhlab.arrays import read_only
from dhlab.lessons.moves import Move, State
from dhlab.lessons.step import Step
from dhlab.scene.component import Component
from dhlab.scene.handle import Handle
from dhlab.scene.node import Clock, Curve
from dhlab.scene.placed import Placed
from dhlab.scene.robot import Robot


@dataclass(frozen=True, eq=False)
class Track:
    """The motion of one csys, one block or the own joints of one robot, over the whole lesson.

    Attributes
    ----------
    what : Placed or Component
    samples : ndarray, shape (instants, 4, 4) or (instants, n)
    curves : tuple of Curve
        As the nodes have them.
    """

    what: Placed | Component
    samples: NDArray[np.float64]
    curves: tuple[Curve, ...]


@dataclass(frozen=True, eq=False)
class Timeline:
    """A lesson in time.

    Attributes
    ----------
    clock : Clock
        Its `stops` are the ends of the steps, the beginning first.
    states : tuple of dict
        Where everything stands at each stop.
    tracks : tuple of Track
    instants : tuple of int
        Sample of each stop.
    """

    clock: Clock
    states: tuple[State, ...]
    tracks: tuple[Track, ...]
    instants: tuple[int, ...]


def lay_out(steps: Sequence[Step], handles: Iterable[Handle]) -> Timeline:
    """Lay steps out in time, each from where the one before has ended.

    Parameters
    ----------
    steps : sequence of Step
    handles : iterable of Csys, Block, BlockComplex, Robot
        What is shown; what moves is among them.

    Returns
    -------
    timeline : Timeline
    """
    start: State = {
        handle: _present(handle) for handle in handles if isinstance(handle, Placed | Robot)
    }
    states: list[State] = [start]
    times, rows = [np.zeros(1)], {handle: [pose[None]] for handle, pose in start.items()}
    stops, instants = [0.0], [0]
    for step in steps:
        before = states[-1]
        count = max((move.samples for move in step.moves), default=1)
        ways = _eased(count)
        after = dict(before)
        moves: dict[Handle, Move] = {move.what: move for move in step.moves}
        for handle, row in rows.items():
            move = moves.get(handle)
            if move is None:
                row.append(np.broadcast_to(before[handle], (count, *before[handle].shape)))
            else:
                row.append(np.stack([move.at(before, s) for s in ways]))
                after[handle] = read_only(row[-1][-1])
        times.append(stops[-1] + step.seconds * np.linspace(0, 1, count + 1)[1:])
        stops.append(float(times[-1][-1]))
        instants.append(instants[-1] + count)
        states.append(after)
    clock = Clock(os.urandom(8).hex(), read_only(np.concatenate(times)), tuple(stops))
    moving = {move.what for step in steps for move in step.moves}
    tracks = tuple(
        track
        for handle, row in rows.items()
        if handle in moving
        for track in _tracks(handle, np.concatenate(row), clock)
    )
    return Timeline(clock, tuple(states), tracks, tuple(instants))


def _present(handle: Placed | Robot) -> NDArray[np.float64]:
    return handle.q if isinstance(handle, Robot) else handle.pose


def _eased(count: int) -> NDArray[np.float64]:
    """Ways from 0 to 1 that begin and end gently, shape (count,), without the 0."""
    s = np.linspace(0, 1, count + 1)[1:]
    return s * s * (3 - 2 * s)


def _tracks(handle: Handle, samples: NDArray[np.float64], clock: Clock) -> Iterable[Track]:
    if isinstance(handle, Placed):
        fixed = read_only(samples)
        yield Track(handle, fixed, (Curve(clock, fixed),))
    elif isinstance(handle, Robot):
        samples = handle.check_samples(samples, f"lesson motion of '{handle.name}'")
        first = 0
        for component in handle.components:
            own = samples[:, first : first + component.n]
            first += component.n
            columns = (own + component.chain.offset).T
            curves = tuple(Curve(clock, read_only(column)) for column in columns)
            yield Track(component, read_only(own), curves)
