"""Smooth shading and feature edges: both ask where two faces meet in more than a crease."""

import numpy as np
from numpy.typing import NDArray

from dhlab.shapes.faces import Corners

CREASE = np.pi / 6
"""Faces that meet at a smaller angle are shaded as one smooth surface [rad]."""

_COS_CREASE = np.cos(CREASE) - 1e-9


def corner_normals(
    vertices: NDArray[np.float64], corners: Corners, normals: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Unit normal at each corner: the mean over the faces at its vertex up to the crease.

    Each face counts by its angle at the vertex (Thuermer and Wuethrich, Computing vertex normals
    from polygonal facets, 1998).

    Parameters
    ----------
    vertices : ndarray, shape (m, 3) [m]
    corners : Corners
        Of f faces, c corners in all.
    normals : ndarray, shape (f, 3)

    Returns
    -------
    normals : ndarray, shape (c, 3)
    """
    own = normals.T[:, corners.face]
    weighted = own * _angles(vertices, corners, own)
    order = np.argsort(corners.vertex, kind="stable")
    count = np.bincount(corners.vertex)[corners.vertex[order]]
    first = np.searchsorted(corners.vertex[order], corners.vertex[order])
    start = np.cumsum(count) - count
    one = np.repeat(order, count)
    other = order[np.repeat(first - start, count) + np.arange(len(one))]
    is_smooth = sum(n[one] * n[other] for n in own) >= _COS_CREASE
    one, other = one[is_smooth], other[is_smooth]
    sums = np.column_stack([np.bincount(one, part[other]) for part in weighted])
    result: NDArray[np.float64] = sums / np.linalg.norm(sums, axis=1, keepdims=True)
    return result


def feature_edges(corners: Corners, normals: NDArray[np.float64]) -> NDArray[np.intp]:
    """Vertex pairs, shape (e, 2), of the edges that are not inside a smooth surface.

    Parameters
    ----------
    corners : Corners
        Of f faces.
    normals : ndarray, shape (f, 3)
    """
    ends = np.sort(np.stack([corners.vertex, corners.vertex[corners.following]], axis=1))
    order = np.lexsort(ends.T)
    ends, face = ends[order], corners.face[order]
    start = np.flatnonzero(np.append(True, (ends[1:] != ends[:-1]).any(axis=1)))
    count = np.diff(np.append(start, len(ends)))
    pair = start[count == 2]
    cosine = np.einsum("ij,ij->i", normals[face[pair]], normals[face[pair + 1]])
    is_feature = np.ones(len(start), dtype=bool)
    is_feature[count == 2] = cosine < _COS_CREASE
    result: NDArray[np.intp] = ends[start[is_feature]]
    return result


def _angles(
    vertices: NDArray[np.float64], corners: Corners, normals: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Angle of the face at each corner, shape (c,) [rad], more than pi at a reflex one.

    The normals, shape (3, c), are those of the corners' faces.
    """
    here = vertices.T[:, corners.vertex]
    x, y, z = here[:, corners.following] - here
    u, v, w = here[:, corners.preceding] - here
    across = (y * w - z * v, z * u - x * w, x * v - y * u)
    sine = sum(part * normal for part, normal in zip(across, normals, strict=True))
    angles: NDArray[np.float64] = np.arctan2(sine, x * u + y * v + z * w) % (2 * np.pi)
    return angles
