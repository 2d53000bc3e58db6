"""Blocks with flat faces, and the two that are no bodies: a polygon and a polyline."""

from collections.abc import Iterable
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from dhlab.arrays import as_number, as_points
from dhlab.errors import InputError
from dhlab.shapes.faces import ungrouped
from dhlab.shapes.lines import Lines
from dhlab.shapes.mesh import Mesh
from dhlab.shapes.outline import is_plump
from dhlab.shapes.profile import as_outline, as_plane_or_space, in_space, signed_area


def polyhedron(p: ArrayLike, f: Iterable[Any]) -> Mesh:
    """Any body by its vertices and faces.

    Parameters
    ----------
    p : array_like, shape (m, 3) [m]
        Vertices.
    f : list
        For each face the vertices around it, counted from 0, counter-clockwise seen from outside.
        Faces of one size may be grouped: a matrix has a face in each row.

    Returns
    -------
    mesh : Mesh

    Raises
    ------
    InputError
        For a face that is no simple flat polygon of existing vertices, and for vertices in
        columns.

    Examples
    --------
    >>> p = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.5, 0.5, 1]]
    >>> polyhedron(p, [[3, 2, 1, 0], [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]])
    Mesh(5 vertices, 5 faces)
    >>> polyhedron(p, [[0, 1, 5]])
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: face 0 names vertex 5; there are 5 vertices, counted from 0 to 4

    References
    ----------
    Pajak, The Matlab toolbox for modeling complex mechanisms, section 2.2, ``block(p, f)``.
    """
    sizes = [np.size(row) for row in p] if np.iterable(p) else []
    if len(sizes) == 3 and min(sizes) == max(sizes) > 3:
        raise InputError(f"p must have a vertex in each row, it has {sizes[0]} columns: give p.T")
    return Mesh(as_points(p, "p"), tuple(ungrouped(f)))


def cuboid(a: float, b: float, c: float) -> Mesh:
    """Box of a by b by c along x, y and z; stands on z = 0, centred in x and y.

    Parameters
    ----------
    a, b, c : float [m]

    Returns
    -------
    mesh : Mesh

    Examples
    --------
    >>> cuboid(2, 4, 1).bounds
    array([[-1., -2.,  0.],
           [ 1.,  2.,  1.]])
    >>> cuboid(2, 0, 1)
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: b of cuboid must be above 0, got 0
    """
    lengths = zip("abc", (a, b, c), strict=True)
    x, y, z = (as_number(length, f"{name} of cuboid", above=0) for name, length in lengths)
    return _unit_cube().scaled(x, y, z) if is_plump(x, y, z) else prism(_rectangle(x, y), z)


def cube(a: float) -> Mesh:
    """Cube of edge a; stands on z = 0, centred in x and y.

    Parameters
    ----------
    a : float [m]

    Returns
    -------
    mesh : Mesh

    Examples
    --------
    >>> cube(2).bounds
    array([[-1., -1.,  0.],
           [ 1.,  1.,  2.]])
    """
    edge = as_number(a, "a of cube", above=0)
    return cuboid(edge, edge, edge)


def pyramid(a: float, b: float, height: float) -> Mesh:
    """Pyramid on a base of a by b along x and y; stands on z = 0, its tip above the centre.

    Parameters
    ----------
    a, b, height : float [m]

    Returns
    -------
    mesh : Mesh

    Examples
    --------
    >>> pyramid(2, 4, 3).vertices[-1]
    array([0., 0., 3.])
    """
    x, y = as_number(a, "a of pyramid", above=0), as_number(b, "b of pyramid", above=0)
    tip = (0, 0, as_number(height, "height of pyramid", above=0))
    sides = [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]
    return Mesh(np.vstack([in_space(_rectangle(x, y)), tip]), ((3, 2, 1, 0), *sides))


def tetrahedron(a: float) -> Mesh:
    """Regular tetrahedron of edge a; stands on z = 0, its tip above the origin.

    Any other tetrahedron is a `polyhedron` of four vertices.

    Parameters
    ----------
    a : float [m]
        All six edges; one of the base is parallel to y.

    Returns
    -------
    mesh : Mesh

    Examples
    --------
    >>> tetrahedron(1).bounds.round(4)
    array([[-0.2887, -0.5   ,  0.    ],
           [ 0.5774,  0.5   ,  0.8165]])
    """
    edge = as_number(a, "a of tetrahedron", above=0)
    turn = 2 * np.pi / 3 * np.arange(3)
    base = edge / np.sqrt(3) * np.column_stack([np.cos(turn), np.sin(turn), np.zeros(3)])
    tip = (0, 0, edge * np.sqrt(2 / 3))
    return Mesh(np.vstack([base, tip]), ((2, 1, 0), (0, 1, 3), (1, 2, 3), (2, 0, 3)))


def prism(profile: ArrayLike, height: float) -> Mesh:
    """Body between a plane outline at z = 0 and the same outline at z = height.

    Parameters
    ----------
    profile : array_like, shape (k, 2) [m]
        Corners of a simple polygon, concave or not, in either turning sense; the last is joined
        to the first.
    height : float [m]

    Returns
    -------
    mesh : Mesh

    Raises
    ------
    InputError
        If the profile crosses itself or has no area.

    Examples
    --------
    >>> prism([[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]], 0.5).volume
    1.5
    >>> prism([[0, 0], [1, 1], [1, 0], [0, 1]], 1)
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: profile of prism crosses itself: its sides 0-1 and 2-3 meet
    """
    as_points(profile, "profile of prism", 2)
    outline = as_outline(profile, "profile of prism")
    top = as_number(height, "height of prism", above=0)
    if signed_area(outline) < 0:
        outline = outline[::-1]
    k = len(outline)
    sides = [(i, (i + 1) % k, k + (i + 1) % k, k + i) for i in range(k)]
    faces = (tuple(reversed(range(k))), tuple(range(k, 2 * k)), *sides)
    return Mesh(np.vstack([in_space(outline), in_space(outline, top)]), faces)


def polygon(points: ArrayLike) -> Mesh:
    """One flat face; its front is where its corners turn counter-clockwise.

    Parameters
    ----------
    points : array_like, shape (k, 2) or (k, 3) [m]
        Corners of a simple polygon in a plane, in the plane z = 0 if they have two coordinates;
        the last is joined to the first.

    Returns
    -------
    mesh : Mesh

    Examples
    --------
    >>> polygon([[0, 0], [1, 0], [0, 1]])
    Mesh(3 vertices, 1 face)
    >>> polygon([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.5]])
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: polygon is not flat: its corner 1 lies 0.131 off its plane
    """
    outline = as_outline(points, "polygon")
    vertices = outline if outline.shape[1] == 3 else in_space(outline)
    return Mesh(vertices, (tuple(range(len(vertices))),))


def polyline(points: ArrayLike, closed: bool = False) -> Lines:
    """Straight pieces from point to point.

    Parameters
    ----------
    points : array_like, shape (k, 2) or (k, 3) [m]
        In the plane z = 0 if they have two coordinates.
    closed : bool
        Whether the last point is joined to the first.

    Returns
    -------
    lines : Lines

    Raises
    ------
    InputError
        For fewer than two points.

    Examples
    --------
    >>> polyline([[0, 0], [1, 0], [1, 1]], closed=True)
    Lines(3 points, 3 segments)
    """
    rows = as_plane_or_space(points, "points of polyline")
    if len(rows) < 2:
        raise InputError(f"polyline must have at least 2 points, got {len(rows)}")
    ahead = np.arange(1, len(rows) + 1) % len(rows)
    segments = np.column_stack([np.arange(len(rows)), ahead])
    vertices = rows if rows.shape[1] == 3 else in_space(rows)
    return Lines(vertices, segments if closed else segments[:-1])


@cache
def _unit_cube() -> Mesh:
    return prism(_rectangle(1, 1), 1)


def _rectangle(a: float, b: float) -> np.ndarray[tuple[int, int], np.dtype[np.float64]]:
    return np.array([(-a, -b), (a, -b), (a, b), (-a, b)]) / 2
