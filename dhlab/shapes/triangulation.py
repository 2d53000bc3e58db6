"""Triangles of flat faces: a fan where a face is convex, ear cutting where it is not."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from dhlab.errors import InputError
from dhlab.shapes.outline import FLATNESS, SLENDER, fault_of


def triangulate(
    vertices: NDArray[np.float64], faces: Sequence[Sequence[int]]
) -> tuple[NDArray[np.intp], NDArray[np.float64]]:
    """Triangles and normals of faces, each a simple polygon.

    Parameters
    ----------
    vertices : ndarray, shape (m, 3) [m]
    faces : sequence of f sequences of int

    Returns
    -------
    triangles : ndarray of int, shape (k, 3)
        Corners, counted through all faces.
    normals : ndarray, shape (f, 3)
        Unit normals of the faces.

    Raises
    ------
    InputError
        Naming the first face that is not flat, has no area or crosses itself.
    """
    sizes = np.array([len(face) for face in faces])
    starts = np.cumsum(sizes) - sizes
    normals = np.empty((len(faces), 3))
    is_convex = np.empty(len(faces), dtype=bool)
    triangles = []
    for size in sorted(set(sizes.tolist())):
        members = np.flatnonzero(sizes == size)
        outlines = vertices[np.array([faces[i] for i in members.tolist()])]
        normals[members], convex = _normals(outlines)
        is_convex[members] = convex
        fan = np.array([(0, k, k + 1) for k in range(1, size - 1)])
        triangles.append((starts[members[convex], None, None] + fan).reshape(-1, 3))
    for i in np.flatnonzero(~is_convex).tolist():
        outline = vertices[list(faces[i])]
        fault = fault_of(outline, faces[i])
        if fault:
            raise InputError(f"face {i} {fault}")
        triangles.append(starts[i] + _cut_ears(outline, normals[i]))
    return np.concatenate(triangles), normals


def _normals(
    outlines: NDArray[np.float64],
) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """Unit normals of outlines of one size (Newell's formula), and which are flat and convex."""
    centred = outlines - outlines.mean(axis=1, keepdims=True)
    sides = np.roll(outlines, -1, axis=1) - outlines
    doubled = np.cross(centred, sides).sum(axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        normals = doubled / np.linalg.norm(doubled, axis=1, keepdims=True)
        directions = sides / np.linalg.norm(sides, axis=2, keepdims=True)
    before = np.roll(directions, 1, axis=1)
    sine = np.einsum("fi,fki->fk", normals, np.cross(before, directions))
    turns = np.arctan2(sine, np.einsum("fki,fki->fk", before, directions))
    height = np.abs(np.einsum("fi,fki->fk", normals, centred)).max(axis=1)
    is_flat = height <= FLATNESS * np.ptp(outlines, axis=1).max(axis=1)
    is_convex = (sine > SLENDER).all(axis=1) & (turns.sum(axis=1) < 3 * np.pi)
    return normals, is_flat & is_convex


def _cut_ears(outline: NDArray[np.float64], normal: NDArray[np.float64]) -> NDArray[np.intp]:
    """Triangles of a simple polygon, seen along the axis that it faces most."""
    from mapbox_earcut import triangulate_float64

    axis = int(np.abs(normal).argmax())
    seen = [(axis + 1) % 3, (axis + 2) % 3]
    if normal[axis] < 0:
        seen.reverse()
    points = np.ascontiguousarray(outline[:, seen])
    corners = triangulate_float64(points, np.array([len(points)], dtype=np.uint32))
    return np.asarray(corners, dtype=np.intp).reshape(-1, 3)
