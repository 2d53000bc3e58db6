"""Blocks from one point to another: what the links and axes of robots are drawn with."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dhlab.arrays import as_number, as_vector
from dhlab.errors import InputError
from dhlab.shapes.mesh import Mesh
from dhlab.shapes.polyhedra import cuboid
from dhlab.shapes.revolution import SEGMENTS, cylinder, srevolution

HEAD_RADIUS = 2.2
"""Of an arrow's head, in radii of its shaft; it is `HEAD_LENGTH` of them long."""

HEAD_LENGTH = 6.0


def tube(p: ArrayLike, q: ArrayLike, radius: float, segments: int = SEGMENTS) -> Mesh:
    """Cylinder whose axis goes from p to q.

    Parameters
    ----------
    p, q : array_like, shape (3,) [m]
    radius : float [m]
    segments : int
        How many flat pieces stand for the full turn.

    Returns
    -------
    mesh : Mesh

    Examples
    --------
    >>> tube((0, 0, 0), (2, 0, 0), 0.5).bounds.round(6)
    array([[ 0. , -0.5, -0.5],
           [ 2. ,  0.5,  0.5]])
    """
    start, way = _way(p, q, "tube")
    return cylinder(radius, _length(way), segments).transformed(pose_along(start, way))


def beam(p: ArrayLike, q: ArrayLike, width: float) -> Mesh:
    """Bar of square section whose axis goes from p to q.

    Parameters
    ----------
    p, q : array_like, shape (3,) [m]
    width : float [m]
        Edge of the section.

    Returns
    -------
    mesh : Mesh

    Examples
    --------
    >>> beam((0, 0, 0), (2, 0, 0), 0.5).volume
    0.5
    """
    start, way = _way(p, q, "beam")
    side = as_number(width, "width of beam", above=0)
    return cuboid(side, side, _length(way)).transformed(pose_along(start, way))


def arrow(length: float, radius: float, axis: ArrayLike = (0, 0, 1), segments: int = 16) -> Mesh:
    """Arrow from the origin along an axis.

    Parameters
    ----------
    length : float [m]
        From its foot to its tip.
    radius : float [m]
        Of the shaft; the head is thicker.
    axis : array_like, shape (3,)
        Where it points; its length does not matter.
    segments : int
        How many flat pieces stand for the full turn.

    Returns
    -------
    mesh : Mesh

    Examples
    --------
    >>> arrow(1, 0.02, axis=(1, 0, 0)).bounds[:, 0]
    array([0., 1.])
    """
    tip, r = as_number(length, "length of arrow", above=0), as_number(radius, "radius of arrow")
    neck = max(tip - HEAD_LENGTH * r, tip / 2)
    profile = [(0, 0), (r, 0), (r, neck), (HEAD_RADIUS * r, neck), (0, tip)]
    start, way = _way((0, 0, 0), axis, "arrow")
    return srevolution(profile, segments).transformed(pose_along(start, way))


def _way(p: ArrayLike, q: ArrayLike, what: str) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Where a body from p to q begins, and the way to its end."""
    start, end = as_vector(p, f"the start of {what}"), as_vector(q, f"the end of {what}")
    if (start == end).all():
        raise InputError(f"{what} must have some length: it begins and ends at {start.tolist()}")
    return start, end - start


def _length(way: NDArray[np.float64]) -> float:
    return float(np.linalg.norm(way))


def pose_along(origin: NDArray[np.float64], way: NDArray[np.float64]) -> NDArray[np.float64]:
    """Pose at an origin with its z axis along a way and x level, shape (4, 4)."""
    z = way / np.linalg.norm(way)
    side = np.eye(3)[2] if abs(z[2]) < 1 - 1e-9 else np.eye(3)[1]
    x = np.cross(side, z)
    x /= np.linalg.norm(x)
    T = np.eye(4)
    T[:3, :3] = np.column_stack([x, np.cross(z, x), z])
    T[:3, 3] = origin
    return T
