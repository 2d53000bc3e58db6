"""The blocks of the toolbox, one factory each: a shape made a handle.

Where a block stands in its own coordinates is said by the function of the same name in
`dhlab.shapes`; every factory takes the options of `BlockOptions` by keyword.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Unpack

from numpy.typing import ArrayLike

import dhlab.shapes as shapes
from dhlab.scene.block import Block, BlockOptions


def block(p: ArrayLike, f: Iterable[Any], **options: Unpack[BlockOptions]) -> Block:
    """Make a block of corners and flat faces.

    Parameters
    ----------
    p : array_like, shape (m, 3) [m]
        Corners in rows.
    f : iterable
        Each face as the indices of its corners, from 0, in order around it; or connection
        matrices that group faces of equal size, a row a face. A face may be concave.
    **options
        Those of every block (`BlockOptions`).

    Returns
    -------
    b : Block

    Raises
    ------
    InputError
        A face names no corner, crosses itself or is not flat; the message names it.

    Examples
    --------
    >>> b = block([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)],
    ...           [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)], name="corner")
    >>> b
    Block 'corner': 4 vertices, 4 faces, at (0.0000, 0.0000, 0.0000), axes of its parent

    References
    ----------
    Pajak, section 2.2.
    """
    return Block(shapes.polyhedron(p, f), **options)


def cone(
    radius: float, height: float, *, segments: int = 32, **options: Unpack[BlockOptions]
) -> Block:
    """Make a cone that stands on z = 0.

    Parameters
    ----------
    radius, height : float [m]
    segments : int
    **options
        Those of every block (`BlockOptions`).

    Returns
    -------
    b : Block
    """
    return Block(shapes.cone(radius, height, segments), **options)


def cube(a: float, **options: Unpack[BlockOptions]) -> Block:
    """Make a cube that stands on z = 0.

    Parameters
    ----------
    a : float [m]
        Length of an edge.
    **options
        Those of every block (`BlockOptions`).

    Returns
    -------
    b : Block

    Examples
    --------
    >>> c = cube(1)
    >>> c.move((1, 1, 1)).pose[:3, 3]
    array([1., 1., 1.])
    """
    return Block(shapes.cube(a), **options)


def cuboid(a: float, b: float, c: float, **options: Unpack[BlockOptions]) -> Block:
    """Make a cuboid that stands on z = 0.

    Parameters
    ----------
    a, b, c : float [m]
        Lengths along x, y and z.
    **options
        Those of every block (`BlockOptions`).

    Returns
    -------
    b : Block
    """
    return Block(shapes.cuboid(a, b, c), **options)


def cylinder(
    radius: float, height: float, *, segments: int = 32, **options: Unpack[BlockOptions]
) -> Block:
    """Make a cylinder that stands on z = 0.

    Parameters
    ----------
    radius, height : float [m]
    segments : int
    **options
        Those of every block (`BlockOptions`).

    Returns
    -------
    b : Block
    """
    return Block(shapes.cylinder(radius, height, segments), **options)


def polygon(points: ArrayLike, **options: Unpack[BlockOptions]) -> Block:
    """Make a flat face.

    Parameters
    ----------
    points : array_like, shape (k, 2) or (k, 3) [m]
        Corners in order.
    **options
        Those of every block (`BlockOptions`).

    Returns
    -------
    b : Block
    """
    return Block(shapes.polygon(points), **options)


def polyline(points: ArrayLike, *, closed: bool = False, **options: Unpack[BlockOptions]) -> Block:
    """Make a line from point to point.

    Parameters
    ----------
    points : array_like, shape (k, 2) or (k, 3) [m]
    closed : bool
        Whether it goes back to its first point.
    **options
        Those of every block (`BlockOptions`).

    Returns
    -------
    b : Block
    """
    return Block(shapes.polyline(points, closed), **options)


def prism(profile: ArrayLike, height: float, **options: Unpack[BlockOptions]) -> Block:
    """Make a prism from z = 0 up.

    Parameters
    ----------
    profile : array_like, shape (k, 2) [m]
        Corners of its floor, in either turning sense.
    height : float [m]
    **options
        Those of every block (`BlockOptions`).

    Returns
    -------
    b : Block
    """
    return Block(shapes.prism(profile, height), **options)


def pyramid(a: float, b: float, height: float, **options: Unpack[BlockOptions]) -> Block:
    """Make a pyramid on a rectangle on z = 0.

    Parameters
    ----------
    a, b : float [m]
        Lengths of the rectangle along x and y.
    height : float [m]
    **options
        Those of every block (`BlockOptions`).

    Returns
    -------
    b : Block
    """
    return Block(shapes.pyramid(a, b, height), **options)


def sphere(radius: float, *, segments: int = 32, **options: Unpack[BlockOptions]) -> Block:
    """Make a sphere around the origin.

    Parameters
    ----------
    radius : float [m]
    segments : int
    **options
        Those of every block (`BlockOptions`).

    Returns
    -------
    b : Block
    """
    return Block(shapes.sphere(radius, segments), **options)


def srevolution(
    profile: ArrayLike, *, segments: int = 32, **options: Unpack[BlockOptions]
) -> Block:
    """Make a surface of revolution about z.

    Parameters
    ----------
    profile : array_like, shape (k, 2) [m]
        Points (r, z) of the curve that turns.
    segments : int
    **options
        Those of every block (`BlockOptions`).

    Returns
    -------
    b : Block
    """
    return Block(shapes.srevolution(profile, segments), **options)


def tetrahedron(a: float, **options: Unpack[BlockOptions]) -> Block:
    """Make a regular tetrahedron that stands on z = 0.

    Parameters
    ----------
    a : float [m]
        Length of an edge.
    **options
        Those of every block (`BlockOptions`).

    Returns
    -------
    b : Block
    """
    return Block(shapes.tetrahedron(a), **options)
