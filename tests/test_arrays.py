import re

import numpy as np
import pytest

from dhlab import arrays
from dhlab.arrays import (
    as_array,
    as_color,
    as_config,
    as_configs,
    as_limits,
    as_name,
    as_number,
    as_placement,
    as_points,
    as_pose,
    as_poses,
    as_rotation,
    as_vector,
    read_only,
)
from dhlab.errors import InputError

HALF_TURN = np.diag([-1.0, -1, 1, 1])
MIRROR = np.diag([1.0, 1, -1, 1])
inf, nan = np.inf, np.nan

CHECKS = {
    "as_array": (lambda x: as_array(x, (None, 2), "x"), [[1, 2], [3, 4]]),
    "as_vector": (lambda x: as_vector(x, "x"), [1, 2, 3]),
    "as_points": (lambda x: as_points(x, "x"), [[1, 2, 3], [4, 5, 6]]),
    "as_rotation": (lambda x: as_rotation(x, "x"), HALF_TURN[:3, :3]),
    "as_pose": (lambda x: as_pose(x, "x"), HALF_TURN),
    "as_poses": (lambda x: as_poses(x, "x"), [HALF_TURN, np.eye(4)]),
    "as_placement": (lambda x: as_placement(x, "x"), HALF_TURN),
    "as_config": (lambda x: as_config(x, 2, "x"), [1, 2]),
    "as_configs": (lambda x: as_configs(x, 2, "x"), [[1, 2], [3, 4], [5, 6]]),
    "as_limits": (lambda x: as_limits(x, 2, "x"), [(-1, 1), (-inf, inf)]),
}


def refused(check, value, text):
    with pytest.raises(InputError, match=f"^{re.escape(text)}$"):
        check(value)


@pytest.mark.parametrize(("check", "value"), CHECKS.values(), ids=CHECKS)
def test_what_passes_the_door_is_read_only_and_nobody_elses(check, value):
    given = np.array(value, dtype=np.float64)
    result = check(given)
    np.testing.assert_array_equal(result, given)
    assert result.dtype == np.float64
    assert not result.flags.writeable
    given[...] = 9
    np.testing.assert_array_equal(result, value)


@pytest.mark.parametrize(("check", "value"), CHECKS.values(), ids=CHECKS)
def test_what_has_passed_the_door_is_not_copied_again(check, value):
    once = check(value)
    assert check(once) is once


@pytest.mark.parametrize(("check", "value"), CHECKS.values(), ids=CHECKS)
@pytest.mark.parametrize("bad", ["text", [None], [1, [2, 3]], [1j], [True], object()])
def test_what_is_not_a_real_number_is_refused(check, value, bad):
    with pytest.raises(InputError, match=r"^x must (be made of numbers|have rows of equal length)"):
        check(bad)


@pytest.mark.parametrize(("check", "value"), CHECKS.values(), ids=CHECKS)
def test_a_wrong_shape_is_told(check, value):
    with pytest.raises(InputError, match=r"^x must .*shape.*\(7, 7, 7\)$"):
        check(np.zeros((7, 7, 7)))


def test_a_read_only_view_of_somebody_elses_array_is_copied():
    theirs = np.zeros(3)
    view = theirs[:]
    view.flags.writeable = False
    mine = read_only(view)
    theirs[0] = 1
    assert mine[0] == 0


def test_whole_numbers_become_floats():
    assert read_only([1, 2]).dtype == np.float64


@pytest.mark.parametrize(
    ("value", "shape", "text"),
    [
        ([1, 2], (3,), "x must have shape (3,), got (2,)"),
        ([1, 2], (None, 3), "x must have shape (m, 3), got (2,)"),
        (1, (2, 2), "x must have shape (2, 2), got ()"),
        ([1, 2], (..., 3), "x must have shape (3,), got (2,)"),
        ([[1, 2]], (..., 3), "x must have shape (..., 3), got (1, 2)"),
        ([[1, 2, nan]], (None, 3), "x must be finite, got nan at [0, 2]"),
        (-inf, (), "x must be finite, got -inf"),
        ([[1], [2, 3]], (2, 2), "x must have rows of equal length, got [[1], [2, 3]]"),
        (["1"], (1,), "x must be made of numbers, got ['1']"),
    ],
)
def test_an_array_that_does_not_fit_is_told_why(value, shape, text):
    refused(lambda v: as_array(v, shape, "x"), value, text)


@pytest.mark.parametrize("axes", [(), (2,), (2, 5), (0,)])
def test_three_dots_let_any_leading_axes_pass(axes):
    assert as_array(np.zeros((*axes, 3)), (..., 3), "x").shape == (*axes, 3)


SHEARED = np.array([[1, 0.1, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
MOVED_ROW = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [1, 2, 3, 1.0]])


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (np.eye(3), "x must have shape (4, 4), got (3, 3)"),
        (MOVED_ROW, "x has the last row [1, 2, 3, 1], it must be [0, 0, 0, 1] (is it transposed?)"),
        (2 * np.eye(4), "x has the last row [0, 0, 0, 2], it must be [0, 0, 0, 1]"),
        (
            np.diag([1, 2, 1, 1]),
            "x is not a rotation: its y axis has length 2, it must have length 1",
        ),
        (
            MIRROR,
            "x is not a rotation but a reflection: its determinant is -1, its axes are left-handed",
        ),
    ],
)
def test_a_matrix_that_is_no_pose_is_told_why(value, text):
    refused(lambda v: as_pose(v, "x"), value, text)


def test_axes_that_are_not_perpendicular_are_told():
    with pytest.raises(InputError, match=r"x and y axes are not perpendicular.* product is 0.1"):
        as_pose(SHEARED, "x")


@pytest.mark.parametrize(
    ("bad", "text"),
    [
        (MOVED_ROW, "T [2] has the last row"),
        (SHEARED, "T [2] is not a rotation: "),
        (MIRROR, "T [2] is not a rotation but a reflection"),
    ],
)
def test_the_first_wrong_pose_of_many_is_named(bad, text):
    with pytest.raises(InputError, match=f"^{re.escape(text)}"):
        as_poses([np.eye(4), HALF_TURN, bad, bad], "T")


def test_a_pose_may_be_as_inexact_as_single_precision_and_stays_as_it_came():
    c, s = np.float32(np.cos(1)), np.float32(np.sin(1))
    R = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    np.testing.assert_array_equal(as_rotation(R, "R"), R)
    with pytest.raises(InputError):
        as_rotation(np.round(R, 3), "R")


TILTED = np.array([[0.0, -1, 0, 4], [1, 0, 0, 5], [0, 0, 1, 6], [0, 0, 0, 1]])


@pytest.mark.parametrize("value", [(1, 2, 3), [[1], [2], [3]]])
def test_an_origin_is_a_placement_and_keeps_the_present_orientation(value):
    new, moved = as_placement(value, "base"), as_placement(value, "pose", TILTED)
    np.testing.assert_array_equal(new[:3, :3], np.eye(3))
    np.testing.assert_array_equal(moved[:3, :3], TILTED[:3, :3])
    for T in (new, moved):
        np.testing.assert_array_equal(T[:, 3], [1, 2, 3, 1])
        assert not T.flags.writeable


def test_a_rotation_is_a_placement_only_where_there_is_an_origin_to_keep():
    turned = as_placement(np.eye(3), "pose", TILTED)
    np.testing.assert_array_equal(turned[:, 3], TILTED[:, 3])
    np.testing.assert_array_equal(turned[:3, :3], np.eye(3))
    text = "base must be a 3-vector or a 4x4 pose, got shape (3, 3)"
    refused(lambda v: as_placement(v, "base"), np.eye(3), text)


def test_a_placement_that_is_none_names_the_choices():
    text = "pose must be a 3-vector, a 4x4 pose or a 3x3 rotation, got shape (2,)"
    refused(lambda v: as_placement(v, "pose", TILTED), [1, 2], text)


@pytest.mark.parametrize(
    ("value", "text"),
    [
        ([(0, 1)], "L must have shape (2, 2), a row (lower, upper) per joint, got (1, 2)"),
        ((0, 1), "L must have shape (2, 2), a row (lower, upper) per joint, got (2,)"),
        ([(0, 1), (1, 0)], "L, joint 2: the lower limit 1 is above the upper limit 0"),
        ([(nan, 1), (1, 0)], "L, joint 1: no number lies in [nan, 1]"),
        ([(0, 1), (inf, inf)], "L, joint 2: no number lies in [inf, inf]"),
    ],
)
def test_limits_that_limit_nothing_are_told_why(value, text):
    refused(lambda v: as_limits(v, 2, "L"), value, text)


def test_no_limits_are_infinite_limits():
    np.testing.assert_array_equal(as_limits(None, 2, "L"), [(-inf, inf)] * 2)
    assert as_limits(None, 0, "L").shape == (0, 2)


def test_a_joint_may_be_fixed_by_equal_limits():
    np.testing.assert_array_equal(as_limits([(1, 1)], 1, "L"), [(1, 1)])


@pytest.mark.parametrize(
    ("value", "color"),
    [
        ("#ff0000", (1, 0, 0)),
        ("#00FF00", (0, 1, 0)),
        ((1, 0, 0), (1, 0, 0)),
        (np.array([0.5, 0, 1]), (0.5, 0, 1)),
    ],
)
def test_a_color_is_three_floats(value, color):
    result = as_color(value, "color")
    assert result == color
    assert [type(x) for x in result] == [float] * 3


@pytest.mark.parametrize("value", ["red", "#fff", (255, 0, 0), (1, 0), (nan, 0, 0), (0, 0, -0.1)])
def test_what_is_no_color_is_refused_with_the_choices(value):
    with pytest.raises(InputError, match=r"^color must be three numbers in 0..1 or '#rrggbb', got"):
        as_color(value, "color")


@pytest.mark.parametrize(
    ("value", "bounds", "text"),
    [
        (-1, {"minimum": 0}, "r must be at least 0, got -1"),
        (0, {"above": 0}, "r must be above 0, got 0"),
        (2, {"maximum": 1.5}, "r must be at most 1.5, got 2"),
        ([1], {}, "r must be one number, got shape (1,)"),
        (nan, {}, "r must be finite, got nan"),
        ("1", {}, "r must be made of numbers, got '1'"),
    ],
)
def test_a_number_out_of_bounds_is_told(value, bounds, text):
    refused(lambda v: as_number(v, "r", **bounds), value, text)


@pytest.mark.parametrize("value", [1, 1.0, np.float32(1), np.array(1)])
def test_a_number_is_a_float(value):
    assert as_number(value, "r", minimum=1, maximum=1) == 1.0
    assert type(as_number(value, "r")) is float


@pytest.mark.parametrize("value", ["", "  ", "a/b", 3, None])
def test_what_cannot_name_a_part_is_refused(value):
    with pytest.raises(InputError, match=r"^name must be text, not empty and without '/', got"):
        as_name(value, "name")


def test_every_check_of_the_door_is_tested_here():
    there = {name for name in vars(arrays) if name.startswith("as_")}
    assert there == {*CHECKS, "as_color", "as_number", "as_name"}
