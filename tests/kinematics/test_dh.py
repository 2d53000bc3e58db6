import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhlab.errors import DegreesWarning, InputError
from dhlab.kinematics.dh import (
    as_kinds,
    as_rows,
    deg,
    dh,
    joint_motion,
    link_constants,
    link_transform,
)
from dhlab.kinematics.transforms import rotx, rotz, rp2t, transl
from tests.kinematics.strategies import conventions, lengths, rows

close = {"rtol": 0, "atol": 1e-12}


def about_x(angle, distance):
    return rp2t(rotx(angle), (0, 0, 0)) @ transl((distance, 0, 0))


def about_z(angle, distance):
    return rp2t(rotz(angle), (0, 0, 0)) @ transl((0, 0, distance))


@given(rows)
def test_the_modified_convention_has_the_link_before_the_joint(row):
    wanted = about_x(row.alpha, row.a) @ about_z(row.theta, row.d)
    np.testing.assert_allclose(link_transform(row), wanted, **close)
    np.testing.assert_allclose(link_transform(row, "modified"), wanted, **close)


@given(rows)
def test_the_standard_convention_has_the_joint_before_the_link(row):
    wanted = about_z(row.theta, row.d) @ about_x(row.alpha, row.a)
    np.testing.assert_allclose(link_transform(row, "standard"), wanted, **close)


@given(rows)
def test_the_modified_transform_is_craigs_matrix(row):
    alpha, a, d, theta = row
    ca, sa, ct, st_ = np.cos(alpha), np.sin(alpha), np.cos(theta), np.sin(theta)
    craig = [  # Introduction to Robotics, eq. 3.6
        [ct, -st_, 0, a],
        [st_ * ca, ct * ca, -sa, -sa * d],
        [st_ * sa, ct * sa, ca, ca * d],
        [0, 0, 0, 1],
    ]
    np.testing.assert_allclose(link_transform(row), craig, **close)


@given(rows)
def test_the_standard_transform_is_the_textbooks_matrix(row):
    alpha, a, d, theta = row
    ca, sa, ct, st_ = np.cos(alpha), np.sin(alpha), np.cos(theta), np.sin(theta)
    spong = [  # Spong, Hutchinson, Vidyasagar: Robot Modeling and Control, eq. 3.10
        [ct, -st_ * ca, st_ * sa, a * ct],
        [st_, ct * ca, -ct * sa, a * st_],
        [0, sa, ca, d],
        [0, 0, 0, 1],
    ]
    np.testing.assert_allclose(link_transform(row, "standard"), spong, **close)


@given(rows, conventions, st.sampled_from("rp"))
def test_a_link_is_a_motion_between_two_constants_and_one_of_them_is_nothing(row, convention, kind):
    before, after = link_constants(row, kind, convention)
    variable = row.theta if kind == "r" else row.d
    T = before @ joint_motion(kind, variable) @ after
    np.testing.assert_allclose(T, link_transform(row, convention), **close)
    assert np.array_equal(after if convention == "modified" else before, np.eye(4))


@given(st.sampled_from("rp"), lengths, lengths)
def test_motions_of_one_joint_add_up(kind, x, y):
    both = joint_motion(kind, x) @ joint_motion(kind, y)
    np.testing.assert_allclose(both, joint_motion(kind, x + y), **close)


@given(st.lists(rows, min_size=1, max_size=4), conventions)
def test_many_rows_at_once_are_each_one_alone(table, convention):
    alone = [link_transform(row, convention) for row in table]
    np.testing.assert_allclose(link_transform(table, convention), alone, **close)


def test_a_degree_is_a_degree():
    assert 180 * deg == np.pi


@pytest.mark.parametrize(
    ("row", "text"),
    [
        ((90, 0, 0, 0), "alpha of a table row is 90 rad, which is 5157 deg; if 90 deg is meant"),
        ((0, 0, 0, -45), "theta of a table row is -45 rad, which is -2578 deg; if -45 deg is"),
    ],
)
def test_an_angle_that_looks_like_degrees_warns_and_says_what_it_is(row, text):
    with pytest.warns(DegreesWarning, match=f"^{re.escape(text)}.*write -?[0-9]+ \\* deg$") as told:
        dh(*row)
    assert told[0].filename == __file__


def test_a_full_turn_and_long_links_do_not_warn():
    dh(2 * np.pi, 90, 90, -2 * np.pi)


def test_a_row_is_four_floats():
    row = dh(0, np.float32(0.5), np.array(1), 0)
    assert row == (0.0, 0.5, 1.0, 0.0)
    assert [type(x) for x in row] == [float] * 4


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: dh(0, "1", 0, 0), "a of a table row must be made of numbers, got '1'"),
        (lambda: dh(0, 0, np.nan, 0), "d of a table row must be finite, got nan"),
        (lambda: dh(0, 0, 0, [1]), "theta of a table row must be one number, got shape (1,)"),
        (lambda: link_transform((0, 1, 2)), "row must have shape (4,), got (3,)"),
        (
            lambda: link_transform((0, 0, 0, 0), "craig"),
            "no convention 'craig'; use 'modified' or 'standard'",
        ),
        (lambda: as_kinds("rx", 2), "joint 2: no joint type 'x'; use 'r' or 'p'"),
        (lambda: as_kinds(["r", "rp"], 2), "joint 2: no joint type 'rp'; use 'r' or 'p'"),
        (lambda: as_kinds(["r", ["p"]], 2), "joint 2: no joint type ['p']; use 'r' or 'p'"),
        (lambda: as_kinds(3, 3), "joints must be letters 'r' or 'p', one per joint, got 3"),
        (lambda: as_rows(3), "a table must be rows of alpha, a, d, theta, got 3"),
        (
            lambda: as_rows(["ab"]),
            "row 1 of the table (alpha, a, d, theta) must be made of numbers, got 'ab'",
        ),
        (lambda: as_kinds("rr", 3), "a table of 3 rows needs 3 joint letters, got 2"),
        (
            lambda: as_rows([(0, 0, 0, 0), (0, 1)]),
            "row 2 of the table (alpha, a, d, theta) must have shape (4,), got (2,)",
        ),
    ],
)
def test_what_is_no_row_or_joint_is_told_why(call, text):
    with pytest.raises(InputError, match=f"^{re.escape(text)}$"):
        call()


def test_joint_letters_come_as_text_or_as_a_list():
    assert as_kinds("rpd", 3) == as_kinds(["r", "p", "d"], 3) == ("r", "p", "p")


def test_a_row_that_was_warned_of_is_not_warned_of_again():
    with pytest.warns(DegreesWarning):
        row = dh(90, 0, 0, 0)
    assert as_rows([row]) == (row,)
    with pytest.warns(DegreesWarning):
        as_rows([(90, 0, 0, 0)])
