"""Mesh, Lines and Label as values: checks at the door, triangles, shading, edges, content."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from dhlab import shapes
from dhlab.errors import InputError
from dhlab.shapes import Label, Lines, Mesh

SEEDED = settings(derandomize=True, max_examples=40, deadline=None)
SEED = st.integers(0, 2**32 - 1)
BOX = shapes.cuboid(1, 2, 3)


def random_pose(rng):
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q *= np.sign(np.diag(r))
    q[:, 0] *= np.sign(np.linalg.det(q))
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = q, rng.normal(size=3)
    return T


def triangle_areas(mesh):
    a, b, c = mesh.vertices[mesh.triangles.T]
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def stairs(steps, middles):
    """A staircase of `steps` steps, each side of which has some corners in its middle."""
    corners = [(0.0, 0.0), (float(steps), 0.0)]
    for i in range(steps, 0, -1):
        corners += [(i, steps - i + 1.0), (i - 1.0, steps - i + 1.0)]
    ends = np.roll(np.array(corners), -1, axis=0)
    parts = np.arange(middles + 1)[:, None] / (middles + 1)
    return np.vstack([a + parts * (b - a) for a, b in zip(corners, ends, strict=True)])


@SEEDED
@given(st.integers(1, 6), st.integers(0, 3), SEED)
def test_a_concave_face_falls_into_triangles_that_cover_it_once(steps, middles, seed):
    T = random_pose(np.random.default_rng(seed))
    outline = stairs(steps, middles)
    face = shapes.polygon(outline).transformed(T)
    assert len(face.triangles) == len(outline) - 2
    assert set(face.triangles.ravel()) == set(range(len(outline)))
    assert_allclose(triangle_areas(face).sum(), steps * (steps + 1) / 2)
    assert_allclose(face.normals, [T[:3, 2]], atol=1e-12)


def test_a_face_of_26_corners_may_be_concave_like_a_palm():
    comb = [(x, 1 if x % 4 < 2 else 3) for k in range(12) for x in [2 * k]]
    outline = [*comb, (24, 1), (24, 0)] + [(x, 0) for x in range(22, -2, -2)]
    assert len(outline) == 26
    palm = shapes.prism(outline, 1)
    assert palm.is_closed
    assert_allclose(palm.volume, triangle_areas(shapes.polygon(outline)).sum())


@SEEDED
@given(SEED)
def test_moving_a_mesh_keeps_its_volume_and_turns_its_normals(seed):
    T = random_pose(np.random.default_rng(seed))
    moved = BOX.transformed(T)
    assert_allclose(moved.volume, BOX.volume)
    assert_allclose(moved.normals, BOX.normals @ T[:3, :3].T, atol=1e-12)
    assert_allclose(moved.vertices, BOX.vertices @ T[:3, :3].T + T[:3, 3])
    assert moved.faces == BOX.faces


def test_merging_adds_up_volumes_and_leaves_the_parts_as_they_were():
    parts = [BOX, shapes.cone(1, 1), shapes.sphere(2)]
    merged = parts[0].merged(*parts[1:])
    assert_allclose(merged.volume, sum(part.volume for part in parts))
    assert merged.is_closed
    assert len(merged.vertices) == sum(len(part.vertices) for part in parts)
    assert merged.digest == Mesh.merged(*parts).digest


def assert_as_good_as_new(mesh):
    """What a mesh took over from others is what its vertices and faces give by themselves."""
    new = Mesh(mesh.vertices, mesh.faces)
    assert_allclose(mesh.normals, new.normals, atol=1e-12)
    for mine, own in zip(mesh.corners, new.corners, strict=True):
        assert_array_equal(mine, own)
    assert mesh.triangles.shape == new.triangles.shape
    assert_allclose(triangle_areas(mesh).sum(), triangle_areas(new).sum())
    assert_allclose(mesh.volume, new.volume)
    assert mesh.digest == new.digest
    assert_array_equal(mesh.edges, new.edges)


STEPS = shapes.prism(stairs(3, 1), 2)
BODIES = [BOX, shapes.cone(1, 2), shapes.sphere(1, 7), STEPS, shapes.cylinder(1, 3, 5)]


@SEEDED
@given(st.lists(st.sampled_from(BODIES), min_size=1, max_size=4), SEED)
def test_a_mesh_made_of_others_is_as_one_made_of_its_vertices_and_faces(bodies, seed):
    rng = np.random.default_rng(seed)
    parts = [body.scaled(*rng.uniform(0.1, 9, 3)).transformed(random_pose(rng)) for body in bodies]
    assert_as_good_as_new(parts[0])
    assert_as_good_as_new(parts[0].merged(*parts[1:]))


@pytest.mark.parametrize(
    ("block", "profile"),
    [
        (shapes.cylinder(0.2, 3), [(0, 0), (0.2, 0), (0.2, 3), (0, 3)]),
        (shapes.cylinder(2, 0.1, 5), [(0, 0), (2, 0), (2, 0.1), (0, 0.1)]),
    ],
)
def test_a_cylinder_is_its_profile_turned(block, profile):
    turned = shapes.srevolution(profile, (len(block.vertices) - 2) // 2)
    assert_allclose(block.vertices, turned.vertices, atol=1e-15)
    assert_as_good_as_new(block)


@pytest.mark.parametrize("scale", [1e-60, 1e-6, 1, 1e6, 1e60])
def test_a_box_and_a_sphere_of_any_size_are_what_they_say(scale):
    box, ball = shapes.cuboid(scale, 2 * scale, 3 * scale), shapes.sphere(scale, 8)
    assert_allclose(np.ptp(box.bounds, axis=0), [scale, 2 * scale, 3 * scale])
    assert_allclose(np.linalg.norm(ball.vertices, axis=1), scale)
    assert_as_good_as_new(box)
    assert_as_good_as_new(ball)


@pytest.mark.parametrize(
    ("make", "text"),
    [
        (lambda: shapes.cylinder(1e-12, 1), "points 0 and 1 at the same place"),
        (lambda: shapes.cuboid(1e-12, 1, 1), "profile of prism has no area"),
        (lambda: BOX.scaled(1, 0, 1), "y of scaled must be above 0, got 0"),
    ],
)
def test_a_body_without_width_is_refused(make, text):
    with pytest.raises(InputError, match=text):
        make()


def test_equal_content_has_an_equal_digest_and_any_change_another():
    p, f = BOX.vertices, BOX.faces
    flipped = tuple(tuple(reversed(face)) for face in f)
    digests = {
        Mesh(p, f).digest,
        Mesh(p + 1e-9, f).digest,
        Mesh(p, f[:-1]).digest,
        Mesh(p, flipped).digest,
        Lines(p, [[0, 1]]).digest,
        Lines(p, [[1, 0]]).digest,
        Label("0").digest,
        Label("0", size=20).digest,
    }
    assert len(digests) == 8
    assert Mesh(p.tolist(), [list(face) for face in f]).digest == BOX.digest
    assert shapes.cuboid(1, 2, 3).digest == BOX.digest
    assert Mesh(p * -0.0 + p, f).digest == BOX.digest
    assert Label("x_1").digest == Label("x_1").digest


def test_what_a_mesh_gives_cannot_be_written_to():
    plain = BOX.vertices, BOX.normals, BOX.triangles, BOX.edges
    for array in (*plain, *BOX.corners, BOX._triangles, *BOX.render_arrays()):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0


def test_what_is_derived_is_worked_out_once():
    assert BOX.triangles is BOX.triangles
    assert BOX.render_arrays() is BOX.render_arrays()
    assert BOX.edges is BOX.edges


def test_a_later_change_of_the_callers_array_does_not_reach_the_mesh():
    p = BOX.vertices.copy()
    mesh = Mesh(p, BOX.faces)
    p[:] = 0
    assert mesh.digest == BOX.digest


@pytest.mark.parametrize(
    ("block", "count"),
    [
        (shapes.cube(1), 12),
        (shapes.tetrahedron(1), 6),
        (shapes.sphere(1), 0),
        (shapes.cylinder(1, 1), 64),
        (shapes.cylinder(1, 1, 6), 18),
        (shapes.cylinder(1, 1, 12), 24),
        (shapes.polygon([[0, 0], [1, 0], [0, 1]]), 3),
        (shapes.srevolution([[1, 0], [1, 1]]), 64),
    ],
)
def test_feature_edges_are_creases_of_more_than_30_degrees_and_borders(block, count):
    assert len(block.edges) == count


def test_render_arrays_shade_a_sphere_smoothly_and_a_cube_flat():
    ball = shapes.sphere(2, 64).render_arrays()
    assert len(ball.positions) == len(shapes.sphere(2, 64).vertices)
    assert_allclose(ball.normals, ball.positions / 2, atol=0.01)
    box = shapes.cube(1).render_arrays()
    assert box.positions.shape == box.normals.shape == (24, 3)
    assert box.triangles.shape == (12, 3)
    assert (np.abs(box.normals).max(axis=1) == 1).all()


def test_the_rim_of_a_cylinder_is_sharp_and_its_side_smooth():
    positions, normals, _ = shapes.cylinder(1, 1).render_arrays()
    is_side = np.abs(normals[:, 2]) < 0.5
    assert is_side.sum() == 64
    assert_allclose(normals[is_side], positions[is_side] * [1, 1, 0], atol=1e-6)
    assert_allclose(np.abs(normals[~is_side]), np.tile([0, 0, 1], (66, 1)), atol=1e-6)


@SEEDED
@given(SEED)
def test_render_arrays_draw_the_same_triangles_as_the_mesh(seed):
    block = shapes.cone(1, 2, 9).transformed(random_pose(np.random.default_rng(seed)))
    arrays = block.render_arrays()
    assert [a.dtype for a in arrays] == [np.float32, np.float32, np.uint32]
    assert_allclose(arrays.positions[arrays.triangles], block.vertices[block.triangles], rtol=1e-5)
    a, b, c = arrays.positions[arrays.triangles].swapaxes(0, 1)
    facing = np.einsum("ij,ij->i", np.cross(b - a, c - a), arrays.normals[arrays.triangles[:, 0]])
    assert (facing > 0).all()
    assert_allclose(np.linalg.norm(arrays.normals, axis=1), 1, rtol=1e-6)


P = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.5, 0.5, 1]]


@pytest.mark.parametrize(
    "faces",
    [
        [[3, 2, 1, 0], [0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]],
        [[[3, 2, 1, 0]], [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]],
        [np.array([[3, 2, 1, 0]]), np.array([[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]])],
        [range(3, -1, -1), np.array([[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]])],
    ],
)
def test_faces_are_one_list_each_or_grouped_in_matrices(faces):
    body = shapes.polyhedron(P, faces)
    assert_allclose(body.volume, 1 / 3)
    assert body.is_closed


def test_faces_of_one_size_may_be_one_matrix():
    box = shapes.polyhedron(BOX.vertices, np.array(BOX.faces))
    assert box.digest == BOX.digest


@pytest.mark.parametrize(
    ("p", "f", "message"),
    [
        (P, [[0, 1, 5]], "face 0 names vertex 5; there are 5 vertices, counted from 0 to 4"),
        (P, [[0, 1, 2], [0, -1, 2]], "face 1 names vertex -1"),
        (P, [[0, 1, 2], [0, 1]], "face 1 must have at least 3 corners, got 2"),
        (P, [[0, 1, 2, 1]], "face 0 names vertex 1 more than once"),
        (P, [[0, 1.5, 2]], r"face 0 must be a list of whole vertex numbers, got \[0, 1.5, 2\]"),
        (P, [0, 1, 2], "face 0 must be a list of vertex numbers, got 0"),
        (P, 5, "faces must be a list of index lists, got 5"),
        (P, [], "a mesh must have at least one face"),
        (P, [[0, 1, 2], [0, 1, 2, 4]], "face 1 is not flat: its corner"),
        (P, [[0, 2, 1, 3]], "face 0 crosses itself: its sides 0-2 and 1-3 meet"),
        ([[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 2]], "face 0 has no area"),
        ([[0, 0, 0], [0, 0, 0], [2, 0, 0]], [[0, 1, 2]], "corners 0 and 1 at the same point"),
        (
            np.transpose(P),
            [[0, 1, 2]],
            "a vertex in each row, it has 5 columns: give p.T",
        ),
        (np.ones((4, 2)), [[0, 1, 2]], r"p must have shape \(m, 3\), got \(4, 2\)"),
        ([[0, 0, 0], [1, 0], [0, 1, 0]], [[0, 1, 2]], "p must have rows of equal length"),
        ([[0, 0, np.inf], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]], "p must be finite, got inf"),
    ],
)
def test_faces_that_cannot_be_drawn_are_refused_by_number(p, f, message):
    with pytest.raises(InputError, match=message):
        shapes.polyhedron(p, f)


@pytest.mark.parametrize(
    "outline",
    [
        [(0, 0), (4, 0), (4, 4), (2, 0), (0, 4)],  # a corner on another side
        [(0, 0), (2, 0), (1, 0), (1, 1)],  # a side that runs back on itself
        [(0, 0), (4, 4), (4, 0), (0, 4), (2, 5)],  # two sides that cross
        [(0, 0), (4, 0), (2, 2), (4, 4), (0, 4), (2, 2.0)],  # two corners at one point
        [np.round((np.cos(4 * k), np.sin(4 * k)), 9) for k in np.arange(5) * np.pi / 5],
    ],
)
def test_an_outline_that_touches_itself_is_not_simple(outline):
    with pytest.raises(InputError, match="polygon crosses itself"):
        shapes.polygon(outline)


def test_coordinates_of_three_digits_make_a_flat_face():
    T = random_pose(np.random.default_rng(4))
    hexagon = [(np.cos(a), np.sin(a)) for a in np.arange(6) * np.pi / 3]
    written = np.round(shapes.polygon(hexagon).transformed(T).vertices, 3)
    assert len(shapes.polygon(written).triangles) == 4


def test_lines_are_moved_and_merged_like_meshes():
    T = np.eye(4)
    T[:3, 3] = 1, 2, 3
    lines = shapes.polyline([[0, 0], [1, 0], [1, 1]])
    both = lines.merged(lines.transformed(T))
    assert both.segments.tolist() == [[0, 1], [1, 2], [3, 4], [4, 5]]
    assert_allclose(both.bounds, [[0, 0, 0], [2, 3, 3]])


@pytest.mark.parametrize(
    ("segments", "message"),
    [
        ([[0, 3]], "segment 0 names point 3; there are 3 points, counted from 0 to 2"),
        ([[0, 1, 2]], "segments must be pairs of point numbers"),
        ([[0.0, 1.0]], "segments must be pairs of point numbers"),
    ],
)
def test_segments_name_existing_points(segments, message):
    with pytest.raises(InputError, match=message):
        Lines(P[:3], segments)


@pytest.mark.parametrize(
    ("text", "size", "message"),
    [("", 18, "text of a label must not be empty"), ("x", 0, "size of a label must be above 0")],
)
def test_a_label_has_a_text_and_a_size(text, size, message):
    with pytest.raises(InputError, match=message):
        Label(text, size)
