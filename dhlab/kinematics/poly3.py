"""The planner of the paper, with the outputs that the paper gives it."""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dhlab.kinematics.polynomials import in_absolute_time
from dhlab.kinematics.task import as_instants
from dhlab.kinematics.trajectory import Trajectory


class Poly3(NamedTuple):
    """The five outputs of `trj_poly3`.

    Attributes
    ----------
    q, v, a : ndarray, shape (m, n) [rad or m], per s, per s^2
        Configuration, velocity, acceleration at each instant.
    t : ndarray, shape (m,) [s]
        The instants.
    c : ndarray, shape (4, n)
        Coefficients of t^3, t^2, t and 1: ``q = c.T @ [t**3, t**2, t, 1]``.
    """

    q: NDArray[np.float64]
    v: NDArray[np.float64]
    a: NDArray[np.float64]
    t: NDArray[np.float64]
    c: NDArray[np.float64]


def trj_poly3(t: ArrayLike, q0: ArrayLike, qt: ArrayLike) -> Poly3:
    """One cubic per joint, at rest at both ends, sampled at the instants `t`.

    Parameters
    ----------
    t : array_like, shape (m,) [s]
        Increasing instants; the motion goes from the first to the last.
    q0, qt : array_like, shape (n,) [rad or m]
        Configurations at the first and the last instant.

    Returns
    -------
    q, v, a : ndarray, shape (m, n)
        Configuration, velocity, acceleration at each instant.
    t : ndarray, shape (m,)
    c : ndarray, shape (4, n)
        Coefficients in the time as given: ``q = c.T @ [t**3, t**2, t, 1]``.

    Examples
    --------
    >>> q, v, a, t, c = trj_poly3([0, 1, 2], q0=[0], qt=[8])
    >>> q.ravel(), c.ravel()
    (array([0., 4., 8.]), array([-2.,  6.,  0.,  0.]))

    References
    ----------
    Pajak, section 4.4.
    """
    t = as_instants(t)
    wave = Trajectory.poly3(t, q0, qt)
    c = in_absolute_time(wave.coefficients[0], t[0])
    return Poly3(*wave.sample(t), t, c)
