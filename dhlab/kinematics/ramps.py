"""Motions of constant acceleration, constant velocity and constant acceleration again.

They tell when a trajectory's acceleration changes, and from what to what. All joints of a motion
change together: the joint with the hardest task goes to its limit, the others stay below theirs.

References
----------
Craig, Introduction to Robotics, section 7.3, linear function with parabolic blends.
"""

import numpy as np
from numpy.typing import NDArray

from dhlab.errors import InputError

Floats = NDArray[np.float64]


def trapezoid(way: Floats, velocity: Floats, acceleration: Floats) -> tuple[Floats, Floats]:
    """Fastest motion along a straight way, from rest to rest, within limits for every joint.

    A short way is a triangle: the velocity limit is not reached.

    Parameters
    ----------
    way, velocity, acceleration : ndarray, shape (n,) [rad or m], per s, per s^2
        How far each joint goes, and how fast and how hard at most.

    Returns
    -------
    h : ndarray, shape (3,) [s]
        Durations of speeding up, of constant velocity, of slowing down.
    a : ndarray, shape (3, n)
        Accelerations meanwhile.
    """
    moving = way != 0
    if not moving.any():
        return np.zeros(3), np.zeros((3, len(way)))
    distance = np.abs(way[moving])
    speed = (velocity[moving] / distance).min()
    rise = (acceleration[moving] / distance).min()
    speed = min(speed, np.sqrt(rise))
    ramp = speed / rise
    h = np.array([ramp, max(1 / speed - ramp, 0), ramp])
    return h, np.multiply.outer([rise, 0, -rise], way)


def shortest_blends(t: Floats, points: Floats, acceleration: Floats) -> Floats:
    """Durations, shape (m,), of the blends at m points that keep within the accelerations (n,).

    The first and the last blend lie inside their segments, so that the motion begins and ends in
    time; the others lie half before and half after their instant.
    """
    h = np.diff(t)[:, None]
    way = np.abs(np.diff(points, axis=0))
    both = 2 if len(t) == 2 else 1  # the only segment has the first and the last blend
    square = h**2 - 2 * both * way / acceleration
    for segment in (0, -1):
        if (square[segment] < 0).any():
            joint = int(square[segment].argmin())
            least = 2 * both * way[segment, joint] / h[segment, 0] ** 2
            raise InputError(
                f"acceleration is too low: from {t[:-1][segment]:g} s to {t[1:][segment]:g} s "
                f"joint {joint + 1} needs at least {least:g}, got {acceleration[joint]:g}"
            )
    ends = 2 * way / acceleration / (h + np.sqrt(np.maximum(square, 0)))
    blends = np.zeros(len(t))
    blends[0], blends[-1] = ends[0].max(), ends[-1].max()
    change = np.abs(np.diff(line_velocities(t, points, blends), axis=0))
    blends[1:-1] = (change / acceleration).max(axis=1, initial=0)
    return blends


def line_velocities(t: Floats, points: Floats, blends: Floats) -> Floats:
    """Velocities on the straight lines between m points with blends, shape (m - 1, n)."""
    h = np.diff(t)
    h[0] -= blends[0] / 2
    h[-1] -= blends[-1] / 2
    return np.diff(points, axis=0) / h[:, None]


def lines_with_blends(t: Floats, points: Floats, blends: Floats) -> tuple[Floats, Floats]:
    """Instants, shape (2 m,), and accelerations between them: blend, line, blend ..., blend."""
    before, after = blends / 2, blends / 2
    before[0], after[0] = 0, blends[0]
    before[-1], after[-1] = blends[-1], 0
    needed = after[:-1] + before[1:]
    for k in np.flatnonzero(needed > np.diff(t) * (1 + 1e-12)):
        raise InputError(
            f"the blends need {needed[k]:g} s between the points at {t[k]:g} s and {t[k + 1]:g} s; "
            "more acceleration or shorter blends would fit"
        )
    instants = np.maximum.accumulate(np.stack([t - before, t + after], axis=1).ravel())
    n = points.shape[1]
    v = np.vstack([np.zeros(n), line_velocities(t, points, blends), np.zeros(n)])
    a = np.zeros((2 * len(t) - 1, n))
    a[::2] = np.diff(v, axis=0) / np.where(blends > 0, blends, np.inf)[:, None]
    return instants, a
