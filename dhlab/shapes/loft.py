"""A skin over sections: bodies that taper and swell, such as a forearm."""

import numpy as np
from numpy.typing import ArrayLike

from dhlab.arrays import as_array
from dhlab.errors import InputError
from dhlab.shapes.mesh import Mesh
from dhlab.shapes.polyhedra import polyhedron


def loft(sections: ArrayLike) -> Mesh:
    """Body with a skin of triangles over plane sections and a flat face at each end.

    Parameters
    ----------
    sections : array_like, shape (s, k, 3) [m]
        At least two outlines of k points each, one behind the other; point for point they lie on
        the lines of the skin. Each turns counter-clockwise seen from the last one.

    Returns
    -------
    mesh : Mesh

    Raises
    ------
    InputError
        For fewer than two sections, or less than three points in each.

    Examples
    --------
    >>> square = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    >>> loft([square, [[x / 2, y / 2, 2] for x, y, _ in square]])
    Mesh(8 vertices, 10 faces)
    """
    rings = as_array(sections, (None, None, 3), "sections of loft")
    s, k = rings.shape[:2]
    if s < 2 or k < 3:
        raise InputError(f"loft must have 2 sections or more of 3 points or more, got {s} of {k}")
    here = np.arange(k) + k * np.arange(s - 1)[:, None]
    beside = np.roll(here, -1, axis=1)
    skin = np.concatenate(
        [
            np.stack([here, beside, beside + k], axis=-1).reshape(-1, 3),
            np.stack([here, beside + k, here + k], axis=-1).reshape(-1, 3),
        ]
    )
    ends = [list(range(k))[::-1], list(range((s - 1) * k, s * k))]
    return polyhedron(rings.reshape(-1, 3), [*ends, skin])
