"""Faces as lists of vertices: the forms they are accepted in, and their corners as arrays."""

from collections.abc import Iterable, Sequence
from operator import index
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from dhlab.errors import InputError


class Corners(NamedTuple):
    """The corners of all faces in one row, face after face.

    Attributes
    ----------
    vertex, face : ndarray of int, shape (c,)
        The vertex at each corner, and the face that the corner belongs to.
    following, preceding : ndarray of int, shape (c,)
        The next corner of the same face, and the one before.
    """

    vertex: NDArray[np.intp]
    face: NDArray[np.intp]
    following: NDArray[np.intp]
    preceding: NDArray[np.intp]


def corners_of(faces: Sequence[Sequence[int]]) -> Corners:
    """All corners of some faces as arrays, read-only: many meshes may share them."""
    sizes = np.array([len(face) for face in faces])
    ends = np.cumsum(sizes)
    here = np.arange(ends[-1])
    following, preceding = here + 1, here - 1
    following[ends - 1] = ends - sizes
    preceding[ends - sizes] = ends - 1
    vertex = np.array([v for face in faces for v in face])
    corners = Corners(vertex, np.repeat(np.arange(len(faces)), sizes), following, preceding)
    for row in corners:
        row.flags.writeable = False
    return corners


def ungrouped(faces: Iterable[Any]) -> list[Any]:
    """One index list per face, from such lists or from matrices with a face in each row.

    Examples
    --------
    >>> ungrouped([[[0, 1, 2], [2, 1, 3]], [0, 2, 3, 4, 5]])
    [[0, 1, 2], [2, 1, 3], [0, 2, 3, 4, 5]]
    """
    rows: list[Any] = []
    for entry in _items(faces, "faces must be a list of index lists"):
        is_matrix = np.iterable(entry) and all(np.iterable(row) for row in entry)
        rows.extend(entry) if is_matrix else rows.append(entry)
    return rows


def as_faces(faces: Iterable[Iterable[int]], vertices: int) -> tuple[tuple[int, ...], ...]:
    """Index lists that name existing vertices, each at most once and at least three of them.

    Parameters
    ----------
    faces : iterable of iterables of int
    vertices : int
        How many vertices there are.

    Examples
    --------
    >>> as_faces([[0, 1, 2], [1, 2, 3]], 3)
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: face 1 names vertex 3; there are 3 vertices, counted from 0 to 2
    """
    checked = tuple(
        _as_face(face, vertices, f"face {number}")
        for number, face in enumerate(_items(faces, "faces must be a list of index lists"))
    )
    if not checked:
        raise InputError("a mesh must have at least one face")
    return checked


def _as_face(face: Iterable[int], vertices: int, what: str) -> tuple[int, ...]:
    try:
        checked = tuple(map(index, _items(face, f"{what} must be a list of vertex numbers")))
    except TypeError:
        raise InputError(f"{what} must be a list of whole vertex numbers, got {face!r}") from None
    if len(checked) < 3:
        raise InputError(f"{what} must have at least 3 corners, got {len(checked)}")
    if min(checked) < 0 or max(checked) >= vertices:
        wrong = next(v for v in checked if not 0 <= v < vertices)
        there = f"there are {vertices} vertices, counted from 0 to {vertices - 1}"
        raise InputError(f"{what} names vertex {wrong}; {there}")
    if len(set(checked)) < len(checked):
        twice = next(v for v in checked if checked.count(v) > 1)
        raise InputError(f"{what} names vertex {twice} more than once")
    return checked


def _items(value: Any, wanted: str) -> Iterable[Any]:
    if not np.iterable(value) or isinstance(value, str):
        raise InputError(f"{wanted}, got {value!r}")
    return value
