r"""Rotations and poses.

A rotation `R_AB` is a (3, 3) array whose columns are the axes of frame B seen from frame A; a pose
`T_AB` is a (4, 4) array that also holds the origin of B. Points and poses follow one rule: the
inner letters meet and cancel, ``p_A = T_AB @ p_B`` and ``T_AC = T_AB @ T_BC``.

Every function works on one rotation or pose, and as well on an array of them: the leading axes
stay as they are.

References
----------
Craig, Introduction to Robotics, chapter 2.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dhlab.arrays import as_array, as_pose, as_rotation


def rotx(angle: ArrayLike) -> NDArray[np.float64]:
    """Rotation about the x axis.

    Parameters
    ----------
    angle : float or array_like, shape (...) [rad]

    Returns
    -------
    R : ndarray, shape (..., 3, 3)

    Examples
    --------
    >>> (rotx(np.pi / 2) @ [0, 1, 0]).round(6)
    array([0., 0., 1.])
    """
    c, s = _cos_sin(angle)
    return matrix([1, 0, 0], [0, c, -s], [0, s, c])


def roty(angle: ArrayLike) -> NDArray[np.float64]:
    """Rotation about the y axis.

    Parameters
    ----------
    angle : float or array_like, shape (...) [rad]

    Returns
    -------
    R : ndarray, shape (..., 3, 3)

    Examples
    --------
    >>> (roty(np.pi / 2) @ [0, 0, 1]).round(6)
    array([1., 0., 0.])
    """
    c, s = _cos_sin(angle)
    return matrix([c, 0, s], [0, 1, 0], [-s, 0, c])


def rotz(angle: ArrayLike) -> NDArray[np.float64]:
    """Rotation about the z axis.

    Parameters
    ----------
    angle : float or array_like, shape (...) [rad]

    Returns
    -------
    R : ndarray, shape (..., 3, 3)

    Examples
    --------
    >>> (rotz(np.pi / 2) @ [1, 0, 0]).round(6)
    array([0., 1., 0.])
    """
    c, s = _cos_sin(angle)
    return matrix([c, -s, 0], [s, c, 0], [0, 0, 1])


def transl(p: ArrayLike) -> NDArray[np.float64]:
    """Pose of a frame with the axes of its parent.

    Parameters
    ----------
    p : array_like, shape (..., 3) [m]
        Its origin.

    Returns
    -------
    T : ndarray, shape (..., 4, 4)

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
    """Pose of a frame from its rotation and its origin.

    Parameters
    ----------
    R : array_like, shape (..., 3, 3)
    p : array_like, shape (..., 3) [m]

    Returns
    -------
    T : ndarray, shape (..., 4, 4)

    Examples
    --------
    >>> rp2t(rotz(np.pi), (1, 2, 0)).round(6) + 0
    array([[-1.,  0.,  0.,  1.],
           [ 0., -1.,  0.,  2.],
           [ 0.,  0.,  1.,  0.],
           [ 0.,  0.,  0.,  1.]])
    >>> rp2t((1, 2, 0), rotz(np.pi))
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: R must have shape (3, 3), got (3,)
    """
    return pose_of(as_rotation(R, "R", leading=(...,)), as_array(p, (..., 3), "p"))


def inverse(T: ArrayLike) -> NDArray[np.float64]:
    r"""Pose of A in B from the pose of B in A.

    .. math:: T_{AB}^{-1} = \begin{bmatrix} R^T & -R^T p \\ 0 & 1 \end{bmatrix}

    Parameters
    ----------
    T : array_like, shape (..., 4, 4)

    Returns
    -------
    T_inverse : ndarray, shape (..., 4, 4)

    Examples
    --------
    >>> inverse(rp2t(rotz(np.pi / 2), (1, 2, 0)))[:3, 3].round(6) + 0
    array([-2.,  1.,  0.])

    References
    ----------
    Craig, Introduction to Robotics, section 2.6.
    """
    T = as_pose(T, "T", leading=(...,))
    R_BA = np.swapaxes(T[..., :3, :3], -1, -2)
    p_BA = -(R_BA @ T[..., :3, 3, None])[..., 0]
    return pose_of(R_BA, p_BA)


def pose_of(R: NDArray[np.float64], p: NDArray[np.float64]) -> NDArray[np.float64]:
    """Pose from a rotation and an origin that are known to be sound: `rp2t` without its checks."""
    T = np.zeros((*np.broadcast_shapes(R.shape[:-2], p.shape[:-1]), 4, 4))
    T[..., :3, :3] = R
    T[..., :3, 3] = p
    T[..., 3, 3] = 1
    return T


def matrix(*rows: list[float | NDArray[np.float64]]) -> NDArray[np.float64]:
    """Matrices, shape (..., 3, 3), from three rows whose entries are numbers or arrays (...)."""
    entries = np.broadcast_arrays(*rows[0], *rows[1], *rows[2])
    flat = np.stack(entries, axis=-1, dtype=np.float64)
    return flat.reshape(*flat.shape[:-1], 3, 3)


def _cos_sin(angle: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    angle = as_array(angle, (...,), "angle")
    return np.cos(angle), np.sin(angle)
