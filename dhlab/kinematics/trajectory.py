"""Trajectories: a configuration as a function of time, piece by piece a polynomial.

Each constructor of `Trajectory` is one classical method of planning in the joint space; what they
make is of one kind: it can be called, sampled, plotted and given to `animate`.

References
----------
Craig, Introduction to Robotics, chapter 7.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dhlab.arrays import as_array, as_number, as_vector
from dhlab.errors import InputError
from dhlab.kinematics import polynomials, ramps
from dhlab.kinematics.plot import plot_motion
from dhlab.kinematics.task import as_each_joint, as_ends, as_instants, as_via_points

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Sample(NamedTuple):
    """What a trajectory is at some instants: arrays of shape (..., n).

    Attributes
    ----------
    q, v, a : ndarray, shape (..., n) [rad or m], per second, per second squared
        Configuration, velocity, acceleration.
    """

    q: NDArray[np.float64]
    v: NDArray[np.float64]
    a: NDArray[np.float64]


@dataclass(frozen=True, eq=False, init=False, repr=False)
class Trajectory:
    """A configuration as a function of time; before its first and after its last instant it rests.

    Parameters
    ----------
    times : array_like, shape (pieces + 1,) [s]
        Where the pieces begin, and where the last one ends.
    coefficients : array_like, shape (pieces, powers, n)
        Of each piece, in the time since it began, the highest power first.
    last : array_like, shape (n,) [rad or m], or None
        Configuration at the end, met to the last bit; None: what the last polynomial gives.

    Examples
    --------
    >>> wave = Trajectory.poly3([0, 2], q0=[0, 1], qt=[1, 1])
    >>> wave(1.0)
    array([0.5, 1. ])
    >>> wave.sample([0, 1, 2]).v[:, 0]
    array([0.  , 0.75, 0.  ])
    """

    times: NDArray[np.float64]
    coefficients: NDArray[np.float64]
    last: NDArray[np.float64]

    def __init__(
        self, times: ArrayLike, coefficients: ArrayLike, last: ArrayLike | None = None
    ) -> None:
        c = as_array(coefficients, (None, None, None), "coefficients")
        t = as_vector(times, "times", len(c) + 1)
        if len(c) == 0 or (np.diff(t) < 0).any():
            raise InputError("times of a trajectory must go up, from at least one piece to its end")
        if last is None:
            last = polynomials.evaluate(c[-1], t[-1] - t[-2])[0]
        object.__setattr__(self, "times", t)
        object.__setattr__(self, "coefficients", c)
        object.__setattr__(self, "last", as_vector(last, "last", c.shape[2]))

    @classmethod
    def poly3(cls, t: ArrayLike, q0: ArrayLike, qt: ArrayLike) -> Self:
        """One cubic per joint, at rest at both ends.

        Parameters
        ----------
        t : array_like, shape (m,) [s]
            Increasing instants; only the first and the last count.
        q0, qt : array_like, shape (n,) [rad or m]
            Configurations at the first and the last instant.

        Examples
        --------
        >>> Trajectory.poly3([0, 2], q0=[0], qt=[8]).coefficients[0].ravel()
        array([-2.,  6.,  0.,  0.])

        References
        ----------
        Craig, Introduction to Robotics, eq. 7.6; Pajak, section 4.4.
        """
        t = as_instants(t)
        q0, qt = as_ends(q0, qt)
        return cls.via(t[[0, -1]], np.stack([q0, qt]))

    @classmethod
    def via(cls, t: ArrayLike, points: ArrayLike, velocities: ArrayLike | None = None) -> Self:
        """Cubics through via points.

        Parameters
        ----------
        t : array_like, shape (m,) [s]
            Increasing instants.
        points : array_like, shape (m, n) [rad or m]
            Configuration at each instant.
        velocities : array_like, shape (m, n) [rad/s or m/s], or None
            Velocity at each instant; None: at rest at both ends, and between them such that
            the acceleration is continuous.

        Examples
        --------
        >>> up_and_down = Trajectory.via([0, 1, 2], [[0], [1], [0]])
        >>> up_and_down([0.5, 1, 1.5]).ravel()
        array([0.5, 1. , 0.5])
        """
        t, points = as_via_points(t, points)
        h = np.diff(t)[:, None]
        if velocities is None:
            v = polynomials.smooth_velocities(h, points)
        else:
            v = as_array(velocities, points.shape, "velocities")
        c = polynomials.cubics(h, points[:-1], points[1:], v[:-1], v[1:])
        return cls(t, c, points[-1])

    @classmethod
    def quintic(
        cls,
        t: ArrayLike,
        q0: ArrayLike,
        qt: ArrayLike,
        *,
        v0: ArrayLike = 0.0,
        vt: ArrayLike = 0.0,
        a0: ArrayLike = 0.0,
        at: ArrayLike = 0.0,
    ) -> Self:
        """One quintic per joint, with given velocities and accelerations at both ends.

        Parameters
        ----------
        t : array_like, shape (m,) [s]
            Increasing instants; only the first and the last count.
        q0, qt : array_like, shape (n,) [rad or m]
            Configurations at the first and the last instant.
        v0, vt, a0, at : float or array_like, shape (n,) [per s, per s^2]
            Velocities and accelerations there, for all joints or one per joint.

        Examples
        --------
        >>> Trajectory.quintic([0, 1], [0], [1]).coefficients[0].ravel()
        array([  6., -15.,  10.,   0.,   0.,   0.])

        References
        ----------
        Craig, Introduction to Robotics, eq. 7.18.
        """
        t = as_instants(t)
        q0, qt = as_ends(q0, qt)
        slopes = {"v0": v0, "vt": vt, "a0": a0, "at": at}
        v0, vt, a0, at = (as_each_joint(value, len(q0), name) for name, value in slopes.items())
        h = t[-1:] - t[0]
        return cls(t[[0, -1]], polynomials.quintics(h, q0, qt, v0, vt, a0, at)[None], qt)

    @classmethod
    def blends(
        cls,
        t: ArrayLike,
        points: ArrayLike,
        *,
        acceleration: ArrayLike | None = None,
        blend_time: float | None = None,
    ) -> Self:
        """Straight lines from point to point, with parabolic blends: near the via points.

        It begins at the first point and ends at the last, at rest; a point between them it only
        comes near, the blend lies half before and half after its instant.

        Parameters
        ----------
        t : array_like, shape (m,) [s]
            Increasing instants.
        points : array_like, shape (m, n) [rad or m]
            Configuration aimed at for each instant.
        acceleration : float or array_like, shape (n,) [rad/s^2 or m/s^2]
            Most that each joint may accelerate; the blends are as short as it allows.
        blend_time : float [s]
            Duration of every blend, in place of `acceleration`.

        References
        ----------
        Craig, Introduction to Robotics, section 7.3, linear function with parabolic blends.
        """
        t, points = as_via_points(t, points)
        if acceleration is not None and blend_time is None:
            most = as_each_joint(acceleration, points.shape[1], "acceleration", positive=True)
            blend = ramps.shortest_blends(t, points, most)
        elif blend_time is not None and acceleration is None:
            blend = np.full(len(t), as_number(blend_time, "blend_time", above=0))
        else:
            raise InputError("blends need either acceleration or blend_time")
        instants, a = ramps.lines_with_blends(t, points, blend)
        h = np.diff(instants)[:, None]
        return cls(instants, polynomials.parabolas(h, points[0], a), points[-1])

    @classmethod
    def trapezoidal(
        cls,
        q0: ArrayLike,
        qt: ArrayLike,
        velocity: ArrayLike,
        acceleration: ArrayLike,
        *,
        start: float = 0.0,
    ) -> Self:
        """Speed up, go on, slow down: as fast as the limits of all joints allow.

        All joints begin and end together, and go along a straight line in the joint space.

        Parameters
        ----------
        q0, qt : array_like, shape (n,) [rad or m]
            First and last configuration.
        velocity, acceleration : float or array_like, shape (n,) [per s, per s^2]
            Limits for all joints or one per joint, above 0.
        start : float [s]
            First instant.

        Examples
        --------
        >>> Trajectory.trapezoidal([0, 0], [3, 1], velocity=1, acceleration=1).times
        array([0., 1., 3., 4.])
        """
        q0, qt = as_ends(q0, qt)
        limits = {"velocity": velocity, "acceleration": acceleration}
        v, a = (as_each_joint(x, len(q0), name, positive=True) for name, x in limits.items())
        h, a = ramps.trapezoid(qt - q0, v, a)
        times = as_number(start, "start") + np.cumsum([0, *h])
        return cls(times, polynomials.parabolas(h[:, None], q0, a), qt)

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.last)

    @property
    def duration(self) -> float:
        """Time from the first to the last instant [s]."""
        return float(self.times[-1] - self.times[0])

    def sample(self, t: ArrayLike) -> Sample:
        """Configuration, velocity and acceleration at one instant or at several.

        Parameters
        ----------
        t : float or array_like, shape (...) [s]

        Returns
        -------
        q, v, a : ndarray, shape (..., n)
            Where the acceleration jumps, the one behind the jump.
        """
        t = as_array(t, (...,), "t")
        first, end = self.times[0], self.times[-1]
        piece = np.searchsorted(self.times, t, side="right") - 1
        piece = np.clip(piece, 0, len(self.coefficients) - 1)
        u = np.clip(t, first, end) - self.times[piece]
        q, v, a = polynomials.evaluate(self.coefficients[piece], u)
        resting = ((t < first) | (t > end))[..., None]
        q = np.where((t >= end)[..., None], self.last, q)
        return Sample(q, np.where(resting, 0, v), np.where(resting, 0, a))

    def __call__(self, t: ArrayLike) -> NDArray[np.float64]:
        """Configuration at one instant, shape (n,), or at several, shape (..., n)."""
        return self.sample(t).q

    def plot(self, axes: "Sequence[Axes] | None" = None) -> "Sequence[Axes]":
        """Plot configuration, velocity and acceleration of each joint over time.

        Parameters
        ----------
        axes : sequence of 3 matplotlib axes, or None
            Where to plot, and what is returned; None: a new figure.
        """
        t = np.linspace(self.times[0], self.times[-1], 501)
        return plot_motion(t, self.sample(t), axes)

    def __repr__(self) -> str:
        degree = self.coefficients.shape[1] - 1
        span = f"{self.times[0]:g} s to {self.times[-1]:g} s in {len(self.times) - 1} pieces"
        return f"Trajectory of {self.n} joints from {span} of degree {degree}"
