"""Plane outlines: points in rows that prisms and surfaces of revolution are made of."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dhlab.arrays import as_number, as_points, as_vector, read_only
from dhlab.errors import InputError
from dhlab.shapes.outline import fault_of


def arc(p1: ArrayLike, p2: ArrayLike, radius: float, segments: int = 16) -> NDArray[np.float64]:
    """Points along an arc of a circle that bulges to the left of the way from p1 to p2.

    Parameters
    ----------
    p1, p2 : array_like, shape (2,) [m]
        Where the arc begins and ends.
    radius : float [m]
        At least half the distance of the two points; just half makes a half circle.
    segments : int
        How many straight pieces stand for the arc.

    Returns
    -------
    points : ndarray, shape (segments + 1, 2) [m]
        From p1 to p2, both included.

    Raises
    ------
    InputError
        If the radius is too small to reach from p1 to p2, or the two are one point.

    Examples
    --------
    The fingertip of the paper, round outwards:

    >>> arc([0.015, 0.01], [0.015, -0.01], 0.01, segments=3).round(4)
    array([[ 0.015 ,  0.01  ],
           [ 0.0237,  0.005 ],
           [ 0.0237, -0.005 ],
           [ 0.015 , -0.01  ]])
    >>> arc([0, 0], [2, 0], 0.5)
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: radius of arc must be at least half the distance of its ends, 1, \
got 0.5

    References
    ----------
    Pajak, The Matlab toolbox for modeling complex mechanisms, section 4.3.
    """
    start, end = as_vector(p1, "p1 of arc", 2), as_vector(p2, "p2 of arc", 2)
    r = as_number(radius, "radius of arc", above=0)
    pieces = as_count(segments, "segments of arc", minimum=1)
    half = (end - start) / 2
    reach = float(np.hypot(*half))
    if reach == 0:
        raise InputError("p1 and p2 of arc must be two points, got the same twice")
    if r < reach * (1 - 1e-9):
        least = f"at least half the distance of its ends, {reach:g}"
        raise InputError(f"radius of arc must be {least}, got {r:g}")
    left = np.array([-half[1], half[0]]) / reach
    centre = start + half - left * np.sqrt(max(r**2 - reach**2, 0))
    spoke = start - centre
    turn = -2 * np.arcsin(min(reach / r, 1)) * np.linspace(0, 1, pieces + 1)[:, None]
    points = centre + np.cos(turn) * spoke + np.sin(turn) * np.array([-spoke[1], spoke[0]])
    points[[0, -1]] = start, end
    return read_only(points)


def as_outline(points: ArrayLike, what: str) -> NDArray[np.float64]:
    """Corners of a simple polygon, shape (k, 2) or (k, 3); the last is joined to the first."""
    outline = as_plane_or_space(points, what)
    if len(outline) < 3:
        raise InputError(f"{what} must have at least 3 corners, got {len(outline)}")
    if (outline[0] == outline[-1]).all():
        raise InputError(f"{what} closes by itself: leave out its last corner, the first again")
    flat = outline if outline.shape[1] == 3 else in_space(outline)
    fault = fault_of(flat, range(len(flat)))
    if fault:
        raise InputError(f"{what} {fault}")
    return outline


def as_plane_or_space(points: ArrayLike, what: str) -> NDArray[np.float64]:
    """Points in rows of two or three coordinates."""
    is_plane = np.ndim(points) == 2 and np.shape(points)[1] == 2
    return as_points(points, what, 2 if is_plane else 3)


def as_count(value: int, what: str, minimum: int) -> int:
    """Give a whole number that is large enough."""
    number = as_number(value, what, minimum=minimum)
    if number != int(number):
        raise InputError(f"{what} must be a whole number, got {value!r}")
    return int(number)


def in_space(points: NDArray[np.float64], z: float = 0.0) -> NDArray[np.float64]:
    """Give plane points at a height z, shape (k, 3)."""
    return np.column_stack([points, np.full(len(points), z)])


def signed_area(outline: NDArray[np.float64]) -> float:
    """Area within a plane outline, negative if it turns clockwise."""
    x, y = (outline - outline.mean(axis=0)).T
    return float(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2
