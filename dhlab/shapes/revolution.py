"""Round blocks: every one is a profile turned about the z axis."""

from functools import lru_cache
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dhlab.arrays import as_number, as_points
from dhlab.errors import InputError
from dhlab.shapes.mesh import Mesh
from dhlab.shapes.outline import SLENDER, crossing_sides, is_plump
from dhlab.shapes.profile import as_count

SEGMENTS = 32


def srevolution(profile: ArrayLike, segments: int = SEGMENTS) -> Mesh:
    """Surface that a profile in the half plane (r, z) leaves when it turns about the z axis.

    Parameters
    ----------
    profile : array_like, shape (k, 2) [m]
        Points (r, z) with r >= 0, in either sense. The surface is closed if the profile begins
        and ends on the axis, or ends where it begins (a ring); else it is open.
    segments : int
        How many flat pieces stand for the full turn.

    Returns
    -------
    mesh : Mesh
        Its faces look outwards; for an open surface that is away from the axis.

    Raises
    ------
    InputError
        If the profile lies beyond the axis, stays on it, stands still or crosses itself.

    Examples
    --------
    A ring, a bowl, and a profile on the wrong side of the axis:

    >>> srevolution([[2, 0], [3, 0], [3, 1], [2, 1], [2, 0]]).is_closed
    True
    >>> srevolution([[0, 0], [1, 0.5], [1.2, 1]]).is_closed
    False
    >>> srevolution([[0, 0], [-1, 1], [0, 2]])
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: profile of srevolution has point 1 beyond the axis: r is -1
    """
    points = _as_profile(profile)
    n = as_count(segments, "segments of srevolution", minimum=3)
    if _swept(points) < 0:
        points = points[::-1]
    is_ring = _is_ring(points)
    turn = 2 * np.pi / n * np.arange(n)
    circle = np.column_stack([np.cos(turn), np.sin(turn), np.ones(n)])
    levels = [circle[: n if r else 1] * (r, r, z) for r, z in points[: -1 if is_ring else None]]
    ends = np.cumsum([len(level) for level in levels]).tolist()
    numbers = [range(end - len(level), end) for end, level in zip(ends, levels, strict=True)]
    if is_ring:
        numbers.append(numbers[0])
    faces = [face for lower, upper in pairwise(numbers) for face in _band(lower, upper)]
    return Mesh(np.vstack(levels), tuple(faces))


def cylinder(radius: float, height: float, segments: int = SEGMENTS) -> Mesh:
    """Cylinder about the z axis; stands on z = 0.

    Parameters
    ----------
    radius, height : float [m]
    segments : int
        How many flat pieces stand for the full turn.

    Returns
    -------
    mesh : Mesh

    Examples
    --------
    >>> cylinder(1, 2).bounds
    array([[-1., -1.,  0.],
           [ 1.,  1.,  2.]])
    """
    r = as_number(radius, "radius of cylinder", above=0)
    top = as_number(height, "height of cylinder", above=0)
    n = as_count(segments, "segments of cylinder", minimum=3)
    if is_plump(r, top):
        return _unit_cylinder(n).scaled(r, r, top)
    return srevolution([(0, 0), (r, 0), (r, top), (0, top)], n)


def cone(radius: float, height: float, segments: int = SEGMENTS) -> Mesh:
    """Cone about the z axis; stands on z = 0, its tip at z = height.

    Parameters
    ----------
    radius, height : float [m]
    segments : int
        How many flat pieces stand for the full turn.

    Returns
    -------
    mesh : Mesh

    Examples
    --------
    >>> cone(1, 2).bounds
    array([[-1., -1.,  0.],
           [ 1.,  1.,  2.]])
    """
    r = as_number(radius, "radius of cone", above=0)
    tip = as_number(height, "height of cone", above=0)
    return srevolution([(0, 0), (r, 0), (0, tip)], segments)


def sphere(radius: float, segments: int = SEGMENTS) -> Mesh:
    """Sphere about the origin, its poles on the z axis.

    Parameters
    ----------
    radius : float [m]
    segments : int
        How many flat pieces stand for the full turn; half as many from pole to pole.

    Returns
    -------
    mesh : Mesh

    Examples
    --------
    >>> sphere(2).bounds.round(6)
    array([[-2., -2., -2.],
           [ 2.,  2.,  2.]])
    """
    r = as_number(radius, "radius of sphere", above=0)
    n = as_count(segments, "segments of sphere", minimum=3)
    return _unit_sphere(n).scaled(r, r, r)


@lru_cache(maxsize=16)
def _unit_cylinder(segments: int) -> Mesh:
    return srevolution([(0, 0), (1, 0), (1, 1), (0, 1)], segments)


@lru_cache(maxsize=16)
def _unit_sphere(segments: int) -> Mesh:
    height = np.linspace(-np.pi / 2, np.pi / 2, max(segments // 2, 2) + 1)
    return srevolution(np.column_stack([np.cos(height), np.sin(height)]), segments)


def _as_profile(profile: ArrayLike) -> NDArray[np.float64]:
    """Points (r, z) of a profile that can be turned; what is on the axis is there exactly."""
    what = "profile of srevolution"
    points = np.array(as_points(profile, what, 2))
    if len(points) < 2:
        raise InputError(f"{what} must have at least 2 points, got {len(points)}")
    points[np.abs(points[:, 0]) <= SLENDER * np.ptp(points, axis=0).max(), 0] = 0
    if points[:, 0].min() < 0:
        beyond = int(points[:, 0].argmin())
        raise InputError(f"{what} has point {beyond} beyond the axis: r is {points[beyond, 0]:g}")
    still = (points[1:] == points[:-1]).all(axis=1)
    if still.any():
        k = int(still.argmax())
        raise InputError(f"{what} has its points {k} and {k + 1} at the same place")
    if not np.maximum(points[1:, 0], points[:-1, 0]).any():
        raise InputError(f"{what} stays on the axis: it leaves no surface")
    is_ring = _is_ring(points)
    crossing = crossing_sides(points[: -1 if is_ring else None], closed=is_ring)
    if crossing:
        one, other = (f"{i}-{i + 1}" for i in crossing)
        raise InputError(f"{what} crosses itself: its sides {one} and {other} meet")
    return points


def _is_ring(points: NDArray[np.float64]) -> bool:
    """Whether a profile ends where it begins."""
    return bool((points[0] == points[-1]).all())


def _swept(points: NDArray[np.float64]) -> float:
    """Volume between a profile and the axis, up to a factor; negative where it runs down."""
    (r, z), (s, t) = points[:-1].T, points[1:].T
    return float(((t - z) * (r**2 + r * s + s**2)).sum())


def _band(lower: range, upper: range) -> list[tuple[int, ...]]:
    """Faces between two levels, each a circle of vertices or one on the axis."""
    n = max(len(lower), len(upper))
    if n == 1:
        return []
    around = [(k, (k + 1) % n) for k in range(n)]
    if len(lower) == 1:
        return [(lower[0], upper[j], upper[i]) for i, j in around]
    if len(upper) == 1:
        return [(lower[i], lower[j], upper[0]) for i, j in around]
    return [(lower[i], lower[j], upper[j], upper[i]) for i, j in around]
