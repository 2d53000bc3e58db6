"""The polynomials that trajectories are made of.

A piece of a trajectory is one polynomial per joint in the time `u` since the piece began. Its
coefficients stand in rows, the highest power first: shape (powers, n); several pieces: (pieces,
powers, n). Durations `h` of pieces have shape (pieces, 1), values at their ends (pieces, n).

References
----------
Craig, Introduction to Robotics, section 7.3.
"""

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def evaluate(c: Floats, u: Floats) -> tuple[Floats, Floats, Floats]:
    """Value and first two derivatives by Horner's rule.

    Parameters
    ----------
    c : ndarray, shape (..., powers, n)
    u : ndarray, shape (...) [s]

    Returns
    -------
    q, v, a : ndarray, shape (..., n)
    """
    u = u[..., None]
    q = v = a = np.zeros_like(c[..., 0, :])
    for power in range(c.shape[-2]):
        a = a * u + 2 * v
        v = v * u + q
        q = q * u + c[..., power, :]
    return q, v, a


def cubics(h: Floats, q0: Floats, qt: Floats, v0: Floats, vt: Floats) -> Floats:
    """Cubics with given values and velocities at both ends."""
    way = qt - q0
    c2 = (3 * way - (2 * v0 + vt) * h) / h**2
    c3 = ((v0 + vt) * h - 2 * way) / h**3
    return np.stack([c3, c2, v0, q0], axis=-2)


def quintics(
    h: Floats, q0: Floats, qt: Floats, v0: Floats, vt: Floats, a0: Floats, at: Floats
) -> Floats:
    """Quintics with given values, velocities and accelerations at both ends."""
    way = qt - q0
    c3 = (20 * way - (12 * v0 + 8 * vt) * h - (3 * a0 - at) * h**2) / (2 * h**3)
    c4 = (-30 * way + (16 * v0 + 14 * vt) * h + (3 * a0 - 2 * at) * h**2) / (2 * h**4)
    c5 = (12 * way - 6 * (v0 + vt) * h - (a0 - at) * h**2) / (2 * h**5)
    return np.stack([c5, c4, c3, a0 / 2, v0, q0], axis=-2)


def parabolas(h: Floats, q0: Floats, a: Floats) -> Floats:
    """Pieces of constant acceleration, one behind the other, from rest at `q0`, shape (n,)."""
    v = np.cumsum(a * h, axis=0) - a * h
    step = v * h + a * h**2 / 2
    q = q0 + (np.cumsum(step, axis=0) - step)
    return np.stack([a / 2, v, q], axis=-2)


def smooth_velocities(h: Floats, points: Floats) -> Floats:
    r"""Velocities, shape (m, n), that keep the acceleration of cubics through m points continuous.

    At both ends they are 0. At each point k between, the cubics on both sides have one
    acceleration:

    .. math::
        \frac{v_{k-1}}{h_{k-1}} + 2 \Big(\frac{1}{h_{k-1}} + \frac{1}{h_k}\Big) v_k
        + \frac{v_{k+1}}{h_k}
        = 3 \Big(\frac{q_k - q_{k-1}}{h_{k-1}^2} + \frac{q_{k+1} - q_k}{h_k^2}\Big)
    """
    m = len(points)
    slopes = 3 * np.diff(points, axis=0) / h**2
    A, b = np.eye(m), np.zeros_like(points)
    for k in range(1, m - 1):
        before, after = 1 / h[k - 1, 0], 1 / h[k, 0]
        A[k, k - 1 : k + 2] = before, 2 * (before + after), after
        b[k] = slopes[k - 1] + slopes[k]
    v: Floats = np.linalg.solve(A, b).astype(np.float64, copy=False)
    return v


def in_absolute_time(c: Floats, start: float) -> Floats:
    """Coefficients of a cubic in the time t instead of ``t - start``, shape (4, n)."""
    c3, c2, c1, c0 = c
    return np.stack(
        [
            c3,
            c2 - 3 * c3 * start,
            c1 - 2 * c2 * start + 3 * c3 * start**2,
            c0 - c1 * start + c2 * start**2 - c3 * start**3,
        ]
    )
