"""The angles of a rotation, forth and back, and the way from one pose to another.

Three angles tell a rotation in many ways; dhlab has the two that Craig begins with, and the angle
about one axis. All angles are in radians; every function works on arrays of rotations too.

References
----------
Craig, Introduction to Robotics, section 2.8.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dhlab.arrays import as_array, as_pose, as_rotation
from dhlab.errors import InputError
from dhlab.kinematics.transforms import matrix, pose_of, rotx, roty, rotz

SINGULAR = 1e-12
"""Sine of the angle between two axes below which they count as one line."""


def rpy2r(roll: ArrayLike, pitch: ArrayLike, yaw: ArrayLike) -> NDArray[np.float64]:
    r"""Rotation from roll, pitch and yaw about the fixed axes x, y, z, in this order.

    .. math:: R = R_z(yaw)\, R_y(pitch)\, R_x(roll)

    Parameters
    ----------
    roll, pitch, yaw : float or array_like, shape (...) [rad]

    Returns
    -------
    R : ndarray, shape (..., 3, 3)

    Examples
    --------
    >>> np.allclose(rpy2r(0.1, 0.2, 0.3), rotz(0.3) @ roty(0.2) @ rotx(0.1))
    True

    References
    ----------
    Craig, Introduction to Robotics, section 2.8, X-Y-Z fixed angles.
    """
    return rotz(yaw) @ roty(pitch) @ rotx(roll)


def r2rpy(R: ArrayLike) -> NDArray[np.float64]:
    """Roll, pitch and yaw of a rotation.

    The pitch lies in [-pi/2, pi/2]. At its ends the other two turn about one line, and only the
    sum or the difference of their angles is known: the yaw is then 0.

    Parameters
    ----------
    R : array_like, shape (..., 3, 3)

    Returns
    -------
    rpy : ndarray, shape (..., 3) [rad]

    Examples
    --------
    >>> r2rpy(rpy2r(0.1, 0.2, 0.3)).round(6)
    array([0.1, 0.2, 0.3])
    >>> r2rpy(rpy2r(0.1, np.pi / 2, 0.3)).round(6)
    array([-0.2     ,  1.570796,  0.      ])
    """
    R = as_rotation(R, "R", leading=(...,))
    cos_pitch = np.hypot(R[..., 0, 0], R[..., 1, 0])
    pitch = np.arctan2(-R[..., 2, 0], cos_pitch)
    yaw = np.where(cos_pitch > SINGULAR, np.arctan2(R[..., 1, 0], R[..., 0, 0]), 0.0)
    rest = rotz(-yaw) @ R
    roll = np.arctan2(-rest[..., 1, 2], rest[..., 1, 1])
    return np.stack([roll, pitch, yaw], axis=-1)


def eul2r(alpha: ArrayLike, beta: ArrayLike, gamma: ArrayLike) -> NDArray[np.float64]:
    r"""Rotation from Euler angles about the moving axes z, y, z, in this order.

    .. math:: R = R_z(\alpha)\, R_y(\beta)\, R_z(\gamma)

    Parameters
    ----------
    alpha, beta, gamma : float or array_like, shape (...) [rad]

    Returns
    -------
    R : ndarray, shape (..., 3, 3)

    Examples
    --------
    >>> np.allclose(eul2r(0.1, 0.2, 0.3), rotz(0.1) @ roty(0.2) @ rotz(0.3))
    True

    References
    ----------
    Craig, Introduction to Robotics, section 2.8, Z-Y-Z Euler angles.
    """
    return rotz(alpha) @ roty(beta) @ rotz(gamma)


def r2eul(R: ArrayLike) -> NDArray[np.float64]:
    """Z-Y-Z Euler angles alpha, beta, gamma of a rotation.

    `beta` lies in [0, pi]. At its ends the other two turn about one line, and only the sum or the
    difference of their angles is known: `alpha` is then 0.

    Parameters
    ----------
    R : array_like, shape (..., 3, 3)

    Returns
    -------
    eul : ndarray, shape (..., 3) [rad]

    Examples
    --------
    >>> r2eul(eul2r(0.1, 0.2, 0.3)).round(6)
    array([0.1, 0.2, 0.3])
    >>> r2eul(eul2r(0.1, 0, 0.3)).round(6)
    array([0. , 0. , 0.4])
    """
    R = as_rotation(R, "R", leading=(...,))
    sin_beta = np.hypot(R[..., 0, 2], R[..., 1, 2])
    beta = np.arctan2(sin_beta, R[..., 2, 2])
    alpha = np.where(sin_beta > SINGULAR, np.arctan2(R[..., 1, 2], R[..., 0, 2]), 0.0)
    rest = rotz(-alpha) @ R
    gamma = np.arctan2(rest[..., 1, 0], rest[..., 1, 1])
    return np.stack([alpha, beta, gamma], axis=-1)


def angvec2r(angle: ArrayLike, axis: ArrayLike) -> NDArray[np.float64]:
    r"""Rotation by an angle about an axis: Rodrigues' formula.

    .. math:: R = \cos\theta\, I + \sin\theta\, [k]_\times + (1 - \cos\theta)\, k k^T

    Parameters
    ----------
    angle : float or array_like, shape (...) [rad]
    axis : array_like, shape (..., 3)
        Of any length but 0.

    Returns
    -------
    R : ndarray, shape (..., 3, 3)

    Raises
    ------
    InputError
        The axis has length 0.

    Examples
    --------
    >>> np.allclose(angvec2r(0.5, (0, 0, 2)), rotz(0.5))
    True
    >>> angvec2r(0.5, (0, 0, 0))
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: axis must not have length 0

    References
    ----------
    Craig, Introduction to Robotics, section 2.8, equivalent angle-axis representation.
    """
    axis = as_array(axis, (..., 3), "axis")
    length = np.linalg.norm(axis, axis=-1, keepdims=True)
    if (length == 0).any():
        raise InputError("axis must not have length 0")
    k: NDArray[np.float64] = axis / length
    kx, ky, kz = np.moveaxis(k, -1, 0)
    k_cross = matrix([0, -kz, ky], [kz, 0, -kx], [-ky, kx, 0])
    k_kT = k[..., :, None] * k[..., None, :]
    theta = as_array(angle, (...,), "angle")[..., None, None]
    c, s = np.cos(theta), np.sin(theta)
    return c * np.eye(3) + s * k_cross + (1 - c) * k_kT


def r2angvec(R: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Angle and axis of a rotation.

    A rotation by 0 has any axis: it is given as z. A rotation by pi has an axis and its opposite:
    one of them is given.

    Parameters
    ----------
    R : array_like, shape (..., 3, 3)

    Returns
    -------
    angle : ndarray, shape (...) [rad]
        In [0, pi].
    axis : ndarray, shape (..., 3)
        Of length 1.

    Examples
    --------
    >>> angle, axis = r2angvec(rotx(0.5))
    >>> float(angle), axis
    (0.5, array([1., 0., 0.]))
    """
    R = as_rotation(R, "R", leading=(...,))
    R_T = np.swapaxes(R, -1, -2)
    c = (np.trace(R, axis1=-2, axis2=-1) - 1) / 2
    cross = (R - R_T) / 2
    s_k = np.stack([cross[..., 2, 1], cross[..., 0, 2], cross[..., 1, 0]], axis=-1)
    angle = np.arctan2(np.linalg.norm(s_k, axis=-1), c)
    # Towards half a turn s k fades away; then (1 - c) k k^T has the axis in its columns, but for
    # the sign. The longest column, the one with the largest square of a component, is the safest.
    squares = (R + R_T) / 2 - c[..., None, None] * np.eye(3)
    largest = np.diagonal(squares, axis1=-2, axis2=-1).argmax(axis=-1)
    column = np.take_along_axis(squares, largest[..., None, None], axis=-1)[..., 0]
    column = np.where(np.vecdot(column, s_k)[..., None] < 0, -column, column)
    k = np.where(c[..., None] < 0, column, s_k)
    length = np.linalg.norm(k, axis=-1, keepdims=True)
    return angle, np.where(length > 0, k / np.where(length > 0, length, 1), (0.0, 0.0, 1.0))


def interpolate(T0: ArrayLike, T1: ArrayLike, s: ArrayLike) -> NDArray[np.float64]:
    """Pose on the way from one pose to another.

    The origin goes along a straight line; meanwhile the frame turns about one fixed axis, the
    shorter way round. Outside 0..1 the motion goes on in the same way.

    Parameters
    ----------
    T0, T1 : array_like, shape (4, 4)
        The poses at s = 0 and at s = 1.
    s : float or array_like, shape (...)
        Part of the way.

    Returns
    -------
    T : ndarray, shape (..., 4, 4)

    Examples
    --------
    >>> from dhlab.kinematics.transforms import rp2t
    >>> T = interpolate(np.eye(4), rp2t(rotz(1.0), (2, 0, 0)), [0, 0.25, 1])
    >>> T[:, 0, 3]
    array([0. , 0.5, 2. ])
    >>> np.allclose(T[1, :3, :3], rotz(0.25))
    True
    """
    T0, T1, s = as_pose(T0, "T0"), as_pose(T1, "T1"), as_array(s, (...,), "s")
    R0, R1, p0, p1 = T0[:3, :3], T1[:3, :3], T0[:3, 3], T1[:3, 3]
    angle, axis = r2angvec(R0.T @ R1)
    return pose_of(R0 @ angvec2r(s * angle, axis), p0 + s[..., None] * (p1 - p0))
