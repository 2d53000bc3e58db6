"""What a trajectory is asked to do, checked: instants, ends, via points, limits."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dhlab.arrays import as_array, as_vector
from dhlab.errors import InputError


def as_instants(t: ArrayLike) -> NDArray[np.float64]:
    """Two or more increasing instants, shape (m,) [s].

    Examples
    --------
    >>> as_instants([0, 2, 1])
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: t must be two or more increasing instants, got [0.0, 2.0, 1.0]
    """
    t = as_array(t, (None,), "t")
    if len(t) < 2 or (np.diff(t) <= 0).any():
        raise InputError(f"t must be two or more increasing instants, got {t.tolist()}")
    return t


def as_ends(q0: ArrayLike, qt: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """First and last configuration, both of shape (n,)."""
    q0 = as_array(q0, (None,), "q0")
    return q0, as_vector(qt, "qt", len(q0))


def as_via_points(
    t: ArrayLike, points: ArrayLike
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Increasing instants, shape (m,), and a configuration for each, shape (m, n)."""
    t, points = as_instants(t), as_array(points, (None, None), "points")
    if len(points) != len(t):
        raise InputError(f"points must be one for each of {len(t)} instants, got {len(points)}")
    return t, points


def as_each_joint(
    value: ArrayLike, n: int, what: str, *, positive: bool = False
) -> NDArray[np.float64]:
    """One number for all joints or one for each, shape (n,)."""
    a = as_array(value, (...,), what)
    if a.shape not in {(), (n,)}:
        raise InputError(
            f"{what} must be one number or one for each of {n} joints, got shape {a.shape}"
        )
    if positive and (a <= 0).any():
        raise InputError(f"{what} must be above 0, got {a.tolist()}")
    return np.full(n, a)
