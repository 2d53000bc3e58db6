"""A mesh: corners in space and the flat faces between them."""

from dataclasses import dataclass, field, fields
from functools import cached_property
from typing import Any, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from dhlab.arrays import as_number, as_points, as_pose, read_only
from dhlab.shapes.faces import Corners, as_faces, corners_of
from dhlab.shapes.shading import corner_normals, feature_edges
from dhlab.shapes.triangulation import triangulate

_Array = TypeVar("_Array", bound=NDArray[Any])


class RenderArrays(NamedTuple):
    """What a renderer wants of a mesh: one row per corner that is shaded differently.

    Attributes
    ----------
    positions : ndarray of float32, shape (r, 3) [m]
    normals : ndarray of float32, shape (r, 3)
        Unit vectors, smooth across edges up to the crease angle.
    triangles : ndarray of uint32, shape (k, 3)
        Rows of the two arrays above.
    """

    positions: NDArray[np.float32]
    normals: NDArray[np.float32]
    triangles: NDArray[np.uint32]


@dataclass(frozen=True, eq=False, repr=False)
class Mesh:
    """Vertices, and faces that are simple polygons; a mesh that exists can be drawn.

    Attributes
    ----------
    vertices : ndarray, shape (m, 3) [m]
    faces : tuple of tuples of int
        The vertices around each face, counted from 0, counter-clockwise seen from outside.
    corners : Corners
        All corners of the faces in one row, for array arithmetic.
    normals : ndarray, shape (f, 3)
        Unit normal of each face.

    Raises
    ------
    InputError
        For a face that names no vertex, repeats one, has fewer than three, is not flat, has no
        area or crosses itself.

    Examples
    --------
    >>> Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2, 3]])
    Mesh(4 vertices, 1 face)
    >>> Mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 2, 1, 3]])
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: face 0 crosses itself: its sides 0-2 and 1-3 meet
    """

    vertices: NDArray[np.float64]
    faces: tuple[tuple[int, ...], ...]
    corners: Corners = field(init=False)
    normals: NDArray[np.float64] = field(init=False)
    _triangles: NDArray[np.intp] = field(init=False)

    def __post_init__(self) -> None:
        vertices = as_points(self.vertices, "the vertices of a mesh")
        faces = as_faces(self.faces, len(vertices))
        triangles, normals = triangulate(vertices, faces)
        self._keep(vertices, faces, corners_of(faces), read_only(normals), _sealed(triangles))

    def _keep(self, *checked: Any) -> None:
        for slot, value in zip(fields(self), checked, strict=True):
            object.__setattr__(self, slot.name, value)

    def __repr__(self) -> str:
        count = len(self.faces)
        return f"Mesh({len(self.vertices)} vertices, {count} face{'' if count == 1 else 's'})"

    @cached_property
    def triangles(self) -> NDArray[np.intp]:
        """Vertices of the triangles that the faces fall into, shape (k, 3)."""
        return _sealed(self.corners.vertex[self._triangles])

    @property
    def triangle_normals(self) -> NDArray[np.float64]:
        """Unit normal of each triangle, which is its face's, shape (k, 3)."""
        return self.normals[self.corners.face[self._triangles[:, 0]]]

    @cached_property
    def edges(self) -> NDArray[np.intp]:
        """Vertex pairs of the edges worth drawing, shape (e, 2): creases and borders."""
        return _sealed(feature_edges(self.corners, self.normals))

    @cached_property
    def bounds(self) -> NDArray[np.float64]:
        """Lowest and highest coordinates, shape (2, 3) [m]."""
        return read_only([self.vertices.min(axis=0), self.vertices.max(axis=0)])

    @cached_property
    def is_closed(self) -> bool:
        """Whether every edge belongs to two faces that pass it in opposite directions."""
        ends = np.stack([self.corners.vertex, self.corners.vertex[self.corners.following]])
        there, back = ends * len(self.vertices) + ends[::-1]
        return len(np.unique(there)) == len(there) and np.array_equal(np.sort(there), np.sort(back))

    @cached_property
    def volume(self) -> float:
        """Volume that a closed mesh encloses [m^3]; negative if its faces look inwards."""
        a, b, c = (self.vertices - self.bounds.mean(axis=0))[self.triangles.T]
        return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)

    @cached_property
    def digest(self) -> str:
        """Name of the content: equal for meshes with equal vertices and faces."""
        from hashlib import blake2b

        numbers = blake2b((self.vertices + 0.0).tobytes(), digest_size=16, person=b"mesh")
        numbers.update(self.corners.vertex.astype("<i8").tobytes())
        numbers.update(self.corners.face.astype("<i8").tobytes())
        return numbers.hexdigest()

    @cached_property
    def _render_arrays(self) -> RenderArrays:
        vertex = self.corners.vertex
        normals = corner_normals(self.vertices, self.corners, self.normals).astype(np.float32) + 0
        order = np.lexsort((*normals.T, vertex))
        shaded = np.column_stack([vertex, normals])[order]
        is_first = np.append(True, (shaded[1:] != shaded[:-1]).any(axis=1))
        first, row = order[is_first], np.empty_like(order)
        row[order] = np.cumsum(is_first) - 1
        positions = self.vertices[vertex[first]].astype(np.float32)
        triangles = row[self._triangles].astype(np.uint32)
        return RenderArrays(_sealed(positions), _sealed(normals[first]), _sealed(triangles))

    def render_arrays(self) -> RenderArrays:
        """Positions, normals and triangles as a renderer takes them, smooth up to a crease."""
        return self._render_arrays

    def transformed(self, T: NDArray[np.float64]) -> "Mesh":
        """Give this mesh moved by a pose: vertices ``p`` become ``T @ p``.

        Parameters
        ----------
        T : array_like, shape (4, 4)
            Pose of this mesh's coordinates in those of the result.
        """
        T = as_pose(T, "the pose of a mesh")
        turned = T[:3, :3].T
        return self._with(self.vertices @ turned + T[:3, 3], self.normals @ turned)

    def scaled(self, x: float, y: float, z: float) -> "Mesh":
        """Give this mesh stretched along the axes of its coordinates.

        Parameters
        ----------
        x, y, z : float
            How many times as long along each, above 0.

        Examples
        --------
        >>> from dhlab import shapes
        >>> shapes.cube(1).scaled(1, 2, 3).volume
        6.0
        """
        factors = [
            as_number(f, f"{a} of scaled", above=0) for f, a in zip((x, y, z), "xyz", strict=True)
        ]
        normals = self.normals * (min(factors) / np.array(factors))
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        return self._with(self.vertices * factors, normals)

    def _with(self, vertices: NDArray[np.float64], normals: NDArray[np.float64]) -> "Mesh":
        """Give a mesh with the faces of this one, which are as good with these vertices."""
        return _good(vertices, self.faces, self.corners, normals, self._triangles)

    def merged(self, *others: "Mesh") -> "Mesh":
        """Give one mesh with the vertices and faces of this and the others, in this order.

        Parameters
        ----------
        *others : Mesh

        Examples
        --------
        >>> from dhlab import shapes
        >>> shapes.cube(1).merged(shapes.pyramid(1, 1, 2))
        Mesh(13 vertices, 11 faces)
        """
        meshes = (self, *others)
        faces: list[tuple[int, ...]] = []
        first = 0
        for mesh in meshes:
            faces += [tuple(first + v for v in face) for face in mesh.faces]
            first += len(mesh.vertices)
        starts = np.cumsum([0, *(len(mesh.corners.face) for mesh in meshes[:-1])])
        triangles = [mesh._triangles + k for mesh, k in zip(meshes, starts, strict=True)]
        vertices = np.vstack([mesh.vertices for mesh in meshes])
        normals = np.vstack([mesh.normals for mesh in meshes])
        return _good(vertices, tuple(faces), corners_of(faces), normals, np.concatenate(triangles))


def _good(
    vertices: NDArray[np.float64],
    faces: tuple[tuple[int, ...], ...],
    corners: Corners,
    normals: NDArray[np.float64],
    triangles: NDArray[np.intp],
) -> Mesh:
    """Give a mesh of what is known to be good: faces of a mesh that exists."""
    mesh = object.__new__(Mesh)
    mesh._keep(_sealed(vertices), faces, corners, _sealed(normals), _sealed(triangles))
    return mesh


def _sealed(a: _Array) -> _Array:
    a.flags.writeable = False
    return a
