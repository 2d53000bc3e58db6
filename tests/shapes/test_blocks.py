"""The blocks of the paper: where they stand, that they are closed, and what they enclose."""

from collections import Counter
from time import perf_counter

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from dhlab import shapes
from dhlab.errors import InputError

SIZE = st.floats(1e-3, 1e3)
COUNT = st.integers(3, 40)
SEEDED = settings(derandomize=True, max_examples=30, deadline=None)


def ngon(n):
    """Area of a regular n-gon in the unit circle."""
    return n / 2 * np.sin(2 * np.pi / n)


def turn_cone(n, r, s, height):
    """Volume of a frustum of n sides between the radii r and s."""
    return ngon(n) * height / 3 * (r * r + r * s + s * s)


def star(k, rng):
    """Outline of a simple, mostly concave polygon of k corners around the origin."""
    turn = 2 * np.pi * (np.arange(k) + rng.uniform(-0.4, 0.4, k)) / k
    return rng.uniform(0.3, 2, (k, 1)) * np.column_stack([np.cos(turn), np.sin(turn)])


def area(outline):
    x, y = outline.T
    return (x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2


CLOSED = {
    "cuboid": lambda a, b, c, n: (shapes.cuboid(a, b, c), a * b * c),
    "cube": lambda a, b, c, n: (shapes.cube(a), a**3),
    "pyramid": lambda a, b, c, n: (shapes.pyramid(a, b, c), a * b * c / 3),
    "tetrahedron": lambda a, b, c, n: (shapes.tetrahedron(a), a**3 / (6 * np.sqrt(2))),
    "cylinder": lambda a, b, c, n: (shapes.cylinder(a, b, n), turn_cone(n, a, a, b)),
    "cone": lambda a, b, c, n: (shapes.cone(a, b, n), turn_cone(n, a, 0, b)),
    "ring": lambda a, b, c, n: (
        shapes.srevolution([[a, 0], [a + b, 0], [a + b, c], [a, c], [a, 0]], n),
        turn_cone(n, a + b, a + b, c) - turn_cone(n, a, a, c),
    ),
    "hourglass": lambda a, b, c, n: (
        shapes.srevolution([[0, -b], [a, -b], [0, 0], [a, c], [0, c]], n),
        turn_cone(n, a, 0, b + c),
    ),
    "prism": lambda a, b, c, n: (
        shapes.prism([[0, 0], [2 * a, 0], [2 * a, b], [a, b], [a, 2 * b], [0, 2 * b]], c),
        3 * a * b * c,
    ),
    "tube": lambda a, b, c, n: (
        shapes.tube((a, b, c), (b, c, a + 1), a, n),
        turn_cone(n, a, a, np.linalg.norm([b - a, c - b, a + 1 - c])),
    ),
    "beam": lambda a, b, c, n: (
        shapes.beam((0, 0, 0), (a, b, -c), b),
        b * b * np.linalg.norm([a, b, c]),
    ),
}


@SEEDED
@given(st.sampled_from(sorted(CLOSED)), SIZE, SIZE, SIZE, COUNT)
def test_a_closed_block_encloses_its_volume_and_looks_outwards(name, a, b, c, n):
    block, volume = CLOSED[name](a, b, c, n)
    assert block.is_closed
    assert_allclose(block.volume, volume, rtol=1e-6)


@pytest.mark.parametrize("name", sorted(CLOSED))
def test_every_edge_of_a_closed_block_is_passed_once_each_way(name):
    block, _ = CLOSED[name](1, 2, 3, 7)
    for polygons in (block.faces, block.triangles.tolist()):
        sides = Counter((f[i - 1], f[i]) for f in polygons for i in range(len(f)))
        assert set(sides.values()) == {1}
        assert all((b, a) in sides for a, b in sides)


@pytest.mark.parametrize(
    ("block", "volume"),
    [
        (lambda n: shapes.cylinder(0.5, 3, n), np.pi * 0.25 * 3),
        (lambda n: shapes.cone(0.5, 3, n), np.pi * 0.25),
        (lambda n: shapes.sphere(0.5, n), np.pi / 6),
    ],
)
def test_round_blocks_come_to_the_formula_as_their_segments_grow(block, volume):
    gaps = [abs(block(n).volume / volume - 1) for n in (32, 64, 128)]
    assert gaps[0] < 0.02
    assert_allclose([gaps[0] / gaps[1], gaps[1] / gaps[2]], 4, rtol=0.02)


@pytest.mark.parametrize(
    ("block", "low", "high"),
    [
        (shapes.cuboid(2, 4, 6), (-1, -2, 0), (1, 2, 6)),
        (shapes.cube(2), (-1, -1, 0), (1, 1, 2)),
        (shapes.cylinder(1, 3), (-1, -1, 0), (1, 1, 3)),
        (shapes.cone(1, 3), (-1, -1, 0), (1, 1, 3)),
        (shapes.pyramid(2, 4, 6), (-1, -2, 0), (1, 2, 6)),
        (shapes.sphere(2), (-2, -2, -2), (2, 2, 2)),
        (shapes.prism([[1, 1], [2, 1], [2, 3]], 4), (1, 1, 0), (2, 3, 4)),
        (shapes.polygon([[1, 1], [2, 1], [2, 3]]), (1, 1, 0), (2, 3, 0)),
        (shapes.polyline([[1, 1, 5], [2, 1, 6]]), (1, 1, 5), (2, 1, 6)),
        (shapes.srevolution([[1, 2], [3, 4]]), (-3, -3, 2), (3, 3, 4)),
        (shapes.arrow(2, 0.1, (0, -5, 0)), (-0.22, -2, -0.22), (0.22, 0, 0.22)),
    ],
)
def test_a_block_stands_where_its_docstring_says(block, low, high):
    assert_allclose(block.bounds, [low, high], atol=1e-12)


def test_the_edges_of_a_tetrahedron_are_equal_and_its_centre_is_above_the_origin():
    p = shapes.tetrahedron(3).vertices
    gaps = np.linalg.norm(p[:, None] - p[None], axis=2)
    assert_allclose(gaps[~np.eye(4, dtype=bool)], 3)
    assert_allclose(p.mean(axis=0)[:2], 0, atol=1e-12)
    assert p[:, 2].min() == 0


@SEEDED
@given(st.integers(3, 30), st.integers(0, 2**32 - 1))
def test_a_prism_takes_either_turning_sense_of_any_simple_profile(k, seed):
    profile = star(k, np.random.default_rng(seed))
    for outline in (profile, profile[::-1]):
        block = shapes.prism(outline, 0.5)
        assert block.is_closed
        assert_allclose(block.volume, area(profile) / 2, rtol=1e-9)


@pytest.mark.parametrize("step", [1, -1])
def test_a_profile_of_revolution_may_run_up_or_down(step):
    profile = np.array([[0, 0], [1, 0], [0.5, 1], [1, 2], [0, 2]])
    block = shapes.srevolution(profile[::step], 12)
    assert_allclose(block.volume, 2 * turn_cone(12, 1, 0.5, 1))


def test_an_open_surface_of_revolution_looks_away_from_the_axis():
    tube = shapes.srevolution([[1, 0], [1, 2]], 8)
    assert not tube.is_closed
    assert (
        np.einsum("ij,ij->i", tube.normals, tube.vertices[[f[0] for f in tube.faces]]) > 0
    ).all()


def test_a_half_circle_from_sine_and_cosine_closes_at_both_poles():
    height = np.linspace(0, np.pi, 9)
    ball = shapes.srevolution(np.column_stack([np.sin(height), np.cos(height)]))
    assert ball.is_closed
    assert len(ball.vertices) == 7 * 32 + 2


def test_a_profile_may_lie_along_the_axis():
    rectangle = [[0, 0], [1, 0], [1, 2], [0, 2], [0, 0]]
    assert_allclose(shapes.srevolution(rectangle).volume, shapes.cylinder(1, 2).volume)


def test_an_arc_bulges_to_the_left_of_its_way():
    above = shapes.arc([1, 0], [-1, 0], 1, segments=2)
    below = shapes.arc([-1, 0], [1, 0], 1, segments=2)
    assert_allclose(above[1], [0, -1], atol=1e-12)
    assert_allclose(below[1], [0, 1], atol=1e-12)


@SEEDED
@given(
    st.tuples(*4 * [st.floats(-10, 10)]).filter(
        lambda p: np.hypot(p[0] - p[2], p[1] - p[3]) > 0.01
    ),
    st.floats(1, 5),
    st.integers(1, 20),
)
def test_an_arc_lies_on_its_circle_and_keeps_its_ends(ends, stretch, segments):
    p1, p2 = np.reshape(ends, (2, 2))
    radius = stretch * np.linalg.norm(p2 - p1) / 2
    points = shapes.arc(p1, p2, radius, segments)
    assert points.shape == (segments + 1, 2)
    assert (points[0] == p1).all()
    assert (points[-1] == p2).all()
    way = (p2 - p1) / np.linalg.norm(p2 - p1)
    left = np.array([-way[1], way[0]])
    centre = (p1 + p2) / 2 - left * np.sqrt(max(radius**2 - np.sum((p2 - p1) ** 2) / 4, 0))
    assert_allclose(np.linalg.norm(points - centre, axis=1), radius, rtol=1e-6)
    assert ((points - p1) @ left > -1e-6).all()


def test_the_fingertip_of_the_paper_is_round_outwards():
    tip = shapes.prism(shapes.arc([0.015, 0.01], [0.015, -0.01], 0.01), 0.02)
    assert_allclose(tip.bounds, [[0.015, -0.01, 0], [0.025, 0.01, 0.02]], atol=1e-12)
    assert_allclose(tip.volume, np.pi / 2 * 0.01**2 * 0.02, rtol=0.01)


def test_the_prongs_of_the_paper_leave_the_gap_that_the_next_tongue_fills():
    pentagon = [[-0.01, -0.01], [0, -0.01], [0.01, 0], [0.01, 0.01], [-0.01, 0.01]]
    low, high = (shapes.prism(pentagon, 0.007).bounds[:, 2] + z for z in (-0.01, 0.003))
    tongue = shapes.cuboid(0.02, 0.01, 0.005).bounds[:, 2] - 0.0025
    assert low[1] < tongue[0] < tongue[1] < high[0]


@pytest.mark.parametrize(("z", "axis"), [(1, (0, 0, 3)), (-1, (0, 0, -2))])
def test_an_arrow_points_along_its_axis(z, axis):
    tip = shapes.arrow(2, 0.1, axis).vertices[-1]
    assert_allclose(tip, [0, 0, 2 * z], atol=1e-12)


@SEEDED
@given(SIZE, SIZE, SIZE, COUNT)
def test_a_loft_between_two_polygons_of_one_shape_is_a_frustum(r, s, height, n):
    turn = 2 * np.pi * np.arange(n) / n
    circle = np.column_stack([np.cos(turn), np.sin(turn)])
    levels = (r, 0), (s, height)
    body = shapes.loft([np.column_stack([k * circle, np.full(n, z)]) for k, z in levels])
    assert body.is_closed
    assert_allclose(body.volume, turn_cone(n, r, s, height), rtol=1e-6)


def test_a_closed_polyline_comes_back_to_its_first_point():
    square = [[0, 0], [1, 0], [1, 1], [0, 1]]
    assert shapes.polyline(square).segments.tolist() == [[0, 1], [1, 2], [2, 3]]
    assert shapes.polyline(square, closed=True).segments.tolist()[-1] == [3, 0]


SQUARE = [[0, 0], [1, 0], [1, 1], [0, 1]]


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: shapes.cube(-1), "a of cube must be above 0, got -1"),
        (lambda: shapes.cuboid(1, np.nan, 1), "b of cuboid must be finite, got nan"),
        (lambda: shapes.cylinder(0, 1), "radius of cylinder must be above 0"),
        (lambda: shapes.cone(1, "high"), "height of cone must be made of numbers"),
        (lambda: shapes.sphere(1, 2), "segments of sphere must be at least 3, got 2"),
        (lambda: shapes.sphere(1, 7.5), "segments of sphere must be a whole number, got 7.5"),
        (lambda: shapes.pyramid(1, 1, 0), "height of pyramid must be above 0"),
        (lambda: shapes.prism(SQUARE, 0), "height of prism must be above 0"),
        (lambda: shapes.prism(SQUARE[:2], 1), "profile of prism must have at least 3 corners"),
        (lambda: shapes.prism([*SQUARE, [0, 0]], 1), "leave out its last corner"),
        (lambda: shapes.prism([[0, 0, 0]], 1), r"profile of prism must have shape \(m, 2\)"),
        (lambda: shapes.prism([[0, 0], [1, 1], [1, 0], [0, 1]], 1), "sides 0-1 and 2-3 meet"),
        (lambda: shapes.prism([[0, 0], [1, 0], [2, 0]], 1), "corners lie on one line"),
        (lambda: shapes.polygon([[0, 0], [1, 0], [1, 0], [0, 1]]), "corners 1 and 2 at the same"),
        (lambda: shapes.polyline([[0, 0]]), "polyline must have at least 2 points, got 1"),
        (lambda: shapes.srevolution([[0, 0]]), "must have at least 2 points, got 1"),
        (lambda: shapes.srevolution([[0, 0], [0, 1]]), "stays on the axis"),
        (lambda: shapes.srevolution([[1, 0], [1, 0], [2, 0]]), "points 0 and 1 at the same place"),
        (lambda: shapes.srevolution([[1, 0], [-1, 1]]), "has point 1 beyond the axis: r is -1"),
        (lambda: shapes.srevolution([[1, 0], [2, 1], [2, 0], [1, 1]]), "sides 0-1 and 2-3 meet"),
        (lambda: shapes.arc([0, 0], [2, 0], 0.9), "at least half the distance of its ends, 1"),
        (lambda: shapes.arc([0, 0], [0, 0], 1), "must be two points, got the same twice"),
        (lambda: shapes.loft(np.ones((1, 4, 3))), "2 sections or more of 3 points or more, got 1"),
        (lambda: shapes.tube((1, 2, 3), (1, 2, 3), 1), r"begins and ends at \[1.0, 2.0, 3.0\]"),
    ],
)
def test_bad_sizes_and_outlines_are_refused_in_words(call, message):
    with pytest.raises(InputError, match=message):
        call()


def test_a_block_is_made_in_well_under_ten_milliseconds():
    start = perf_counter()
    for i in range(100):
        shapes.cylinder(1, 1 + i).render_arrays()
    assert perf_counter() - start < 1
