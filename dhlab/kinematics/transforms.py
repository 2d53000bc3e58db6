r"""Rotations and poses.

A rotation `R_AB` is a (3, 3) array whose columns are the axes of frame B seen from frame A; a pose
`T_AB` is a (4, 4) array that also holds the origin of B. Points and poses follow one rule: the
inner letters meet and cancel, ``p_A = T_AB @ p_B`` and ``T_AC = T_AB @ T_BC``.

Every function works on one rotation or pose, and as well on an array of them: the leading axes
stay as they are. Angles are in radians, lengths in metres.

References
----------
Craig, Introduction to Robotics, chapter 2.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dhlab.arrays import as_array, as_pose, as_rotation
from dhlab.errors import InputError

SINGULAR = 1e-12
"""Sine of the angle between two axes below which they count as one line."""


def rotx(angle: ArrayLike) -> NDArray[np.float64]:
    """Rotation about the x axis, shape (..., 3, 3), by `angle` [rad].

    Examples
    --------
    >>> (rotx(np.pi / 2) @ [0, 1, 0]).round(6)
    array([0., 0., 1.])
    """
    c, s = _cos_sin(angle)
    return _matrix([1, 0, 0], [0, c, -s], [0, s, c])


def roty(angle: ArrayLike) -> NDArray[np.float64]:
    """Rotation about the y axis, shape (..., 3, 3), by `angle` [rad].

    Examples
    --------
    >>> (roty(np.pi / 2) @ [0, 0, 1]).round(6)
    array([1., 0., 0.])
    """
    c, s = _cos_sin(angle)
    return _matrix([c, 0, s], [0, 1, 0], [-s, 0, c])


def rotz(angle: ArrayLike) -> NDArray[np.float64]:
    """Rotation about the z axis, shape (..., 3, 3), by `angle` [rad].

    Examples
    --------
    >>> (rotz(np.pi / 2) @ [1, 0, 0]).round(6)
    array([0., 1., 0.])
    """
    c, s = _cos_sin(angle)
    return _matrix([c, -s, 0], [s, c, 0], [0, 0, 1])


def transl(p: ArrayLike) -> NDArray[np.float64]:
    """Pose, shape (..., 4, 4), of a frame with the axes of its parent and the origin `p` [m].

    Examples
    --------
    >>> transl((1, 2, 3))
    array([[1., 0., 0., 1.],
           [0., 1., 0., 2.],
           [0., 0., 1., 3.],
           [0., 0., 0., 1.]])
    """
    return pose_of(np.eye(3), as_array(p, (..., 3), "p"))


def rp2t(R: ArrayLike, p: ArrayLike) -> NDArray[np.float64]:
    """Pose, shape (..., 4, 4), from a rotation and an origin [m].

    Examples
    --------
    >>> rp2t(rotz(np.pi), (1, 2, 0)).round(6) + 0
    array([[-1.,  0.,  0.,  1.],
           [ 0., -1.,  0.,  2.],
           [ 0.,  0.,  1.,  0.],
           [ 0.,  0.,  0.,  1.]])
    """
    return pose_of(as_rotation(R, "R", leading=(...,)), as_array(p, (..., 3), "p"))


def inverse(T: ArrayLike) -> NDArray[np.float64]:
    r"""Pose of A in B from the pose of B in A, shape (..., 4, 4).

    .. math:: T_{AB}^{-1} = \begin{bmatrix} R^T & -R^T p \\ 0 & 1 \end{bmatrix}

    Examples
    --------
    >>> inverse(rp2t(rotz(np.pi / 2), (1, 2, 0)))[:3, 3].round(6)
    array([-2.,  1., -0.])

    References
    ----------
    Craig, Introduction to Robotics, section 2.6.
    """
    T = as_pose(T, "T", leading=(...,))
    R_BA = np.swapaxes(T[..., :3, :3], -1, -2)
    return pose_of(R_BA, -(R_BA @ T[..., :3, 3, None])[..., 0])


def rpy2r(roll: ArrayLike, pitch: ArrayLike, yaw: ArrayLike) -> NDArray[np.float64]:
    r"""Rotation from roll, pitch and yaw about the fixed axes x, y, z, in this order.

    .. math:: R = R_z(yaw)\, R_y(pitch)\, R_x(roll)

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
    """Roll, pitch and yaw of a rotation, shape (..., 3) [rad].

    The pitch lies in [-pi/2, pi/2]. At its ends x and z turn about one line and only the sum or
    difference of their angles is known: the yaw is then 0.

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
    """Z-Y-Z Euler angles alpha, beta, gamma of a rotation, shape (..., 3) [rad].

    `beta` lies in [0, pi]. At its ends both z axes lie on one line and only the sum or difference
    of their angles is known: `alpha` is then 0.

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
    r"""Rotation by `angle` [rad] about `axis`, a vector of any length but 0: Rodrigues' formula.

    .. math:: R = \cos\theta\, I + \sin\theta\, [k]_\times + (1 - \cos\theta)\, k k^T

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
    c, s = _cos_sin(as_array(angle, (...,), "angle")[..., None, None])
    k_cross = _matrix([0, -kz, ky], [kz, 0, -kx], [-ky, kx, 0])
    k_kT = k[..., :, None] * k[..., None, :]
    return c * np.eye(3) + s * k_cross + (1 - c) * k_kT


def r2angvec(R: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Angle in [0, pi], shape (...), and unit axis, shape (..., 3), of a rotation.

    Without a rotation every axis serves: it is then z. At half a turn an axis and its opposite
    both serve, and one of them is given.

    Examples
    --------
    >>> angle, axis = r2angvec(rotx(0.5))
    >>> angle.round(6), axis.round(6)
    (np.float64(0.5), array([1., 0., 0.]))
    """
    R = as_rotation(R, "R", leading=(...,))
    R_T = np.swapaxes(R, -1, -2)
    c = (np.trace(R, axis1=-2, axis2=-1) - 1) / 2
    cross = (R - R_T) / 2
    s_k = np.stack([cross[..., 2, 1], cross[..., 0, 2], cross[..., 1, 0]], axis=-1)
    angle = np.arctan2(np.linalg.norm(s_k, axis=-1), c)
    # Near half a turn s k fades away; a column of (1 - c) k k^T shows the axis, but for its sign.
    squares = (R + R_T) / 2 - c[..., None, None] * np.eye(3)
    largest = np.argmax(np.diagonal(squares, axis1=-2, axis2=-1), axis=-1)
    column = np.take_along_axis(squares, largest[..., None, None], axis=-1)[..., 0]
    column = np.where(np.vecdot(column, s_k)[..., None] < 0, -column, column)
    k = np.where(c[..., None] < 0, column, s_k)
    length = np.linalg.norm(k, axis=-1, keepdims=True)
    return angle, np.where(length > 0, k / np.where(length > 0, length, 1), (0.0, 0.0, 1.0))


def interpolate(T0: ArrayLike, T1: ArrayLike, s: ArrayLike) -> NDArray[np.float64]:
    """Pose at the part `s` of the way from `T0` (s = 0) to `T1` (s = 1), shape (..., 4, 4).

    The origin goes along a straight line; meanwhile the frame turns about one fixed axis, the
    shorter way round. Outside 0..1 the motion goes on in the same way.

    Parameters
    ----------
    T0, T1 : array_like, shape (4, 4)
        The two poses.
    s : array_like, any shape (...)
        Part of the way.

    Examples
    --------
    >>> T = interpolate(np.eye(4), rp2t(rotz(1.0), (2, 0, 0)), [0, 0.25, 1])
    >>> T[:, 0, 3]
    array([0. , 0.5, 2. ])
    >>> np.allclose(T[1, :3, :3], rotz(0.25))
    True
    """
    T0, T1 = as_pose(T0, "T0"), as_pose(T1, "T1")
    s = as_array(s, (...,), "s")
    angle, axis = r2angvec(T0[:3, :3].T @ T1[:3, :3])
    p = T0[:3, 3] + s[..., None] * (T1[:3, 3] - T0[:3, 3])
    return pose_of(T0[:3, :3] @ angvec2r(s * angle, axis), p)


def pose_of(R: NDArray[np.float64], p: NDArray[np.float64]) -> NDArray[np.float64]:
    """Pose from a rotation and an origin that are known to be sound: `rp2t` without its checks."""
    T = np.zeros((*np.broadcast_shapes(R.shape[:-2], p.shape[:-1]), 4, 4))
    T[..., :3, :3] = R
    T[..., :3, 3] = p
    T[..., 3, 3] = 1
    return T


def _cos_sin(angle: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    angle = as_array(angle, (...,), "angle")
    return np.cos(angle), np.sin(angle)


def _matrix(*rows: list[float | NDArray[np.float64]]) -> NDArray[np.float64]:
    """Matrices, shape (..., 3, 3), from three rows whose entries are numbers or arrays (...)."""
    entries = np.broadcast_arrays(*rows[0], *rows[1], *rows[2])
    flat = np.stack(entries, axis=-1, dtype=np.float64)
    return flat.reshape(*flat.shape[:-1], 3, 3)
