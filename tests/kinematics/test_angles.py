import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from dhlab.errors import InputError
from dhlab.kinematics.angles import (
    angvec2r,
    eul2r,
    interpolate,
    r2angvec,
    r2eul,
    r2rpy,
    rpy2r,
)
from dhlab.kinematics.transforms import inverse, rotx, roty, rotz, rp2t
from tests.kinematics.strategies import angles, lengths, points, poses, rotations

pi = np.pi
close = {"rtol": 0, "atol": 4e-12}
axes = points.filter(lambda p: np.linalg.norm(p) > 1e-3)
THREE_ANGLES = [(rpy2r, r2rpy), (eul2r, r2eul)]


@given(angles, angles, angles)
def test_roll_pitch_and_yaw_turn_about_fixed_axes(roll, pitch, yaw):
    R = rotz(yaw) @ roty(pitch) @ rotx(roll)
    np.testing.assert_allclose(rpy2r(roll, pitch, yaw), R, **close)


@given(angles, angles, angles)
def test_euler_angles_turn_about_moving_axes(alpha, beta, gamma):
    R = rotz(alpha) @ roty(beta) @ rotz(gamma)
    np.testing.assert_allclose(eul2r(alpha, beta, gamma), R, **close)


@pytest.mark.parametrize(("forth", "back"), THREE_ANGLES)
@given(R=rotations)
def test_the_angles_of_a_rotation_make_it_again_at_singularities_too(forth, back, R):
    np.testing.assert_allclose(forth(*back(R)), R, **close)


@given(st.floats(-3, 3), st.floats(-1.5, 1.5), st.floats(-3, 3))
def test_away_from_singularities_roll_pitch_and_yaw_come_back(roll, pitch, yaw):
    np.testing.assert_allclose(r2rpy(rpy2r(roll, pitch, yaw)), (roll, pitch, yaw), atol=1e-12)


@given(st.floats(-3, 3), st.floats(0.1, 3), st.floats(-3, 3))
def test_away_from_singularities_euler_angles_come_back(alpha, beta, gamma):
    np.testing.assert_allclose(r2eul(eul2r(alpha, beta, gamma)), (alpha, beta, gamma), atol=1e-12)


@given(rotations)
def test_the_middle_angle_stays_in_its_range(R):
    assert abs(r2rpy(R)[1]) <= pi / 2
    assert 0 <= r2eul(R)[1] <= pi


@pytest.mark.parametrize("sign", [-1, 1])
def test_at_a_singular_pitch_the_yaw_is_zero(sign):
    rpy = r2rpy(rpy2r(0.1, sign * pi / 2, 0.3))
    np.testing.assert_allclose(rpy, (0.1 - sign * 0.3, sign * pi / 2, 0), atol=1e-12)


@pytest.mark.parametrize(("beta", "gamma"), [(0, 0.4), (pi, 0.2)])
def test_at_a_singular_beta_alpha_is_zero(beta, gamma):
    np.testing.assert_allclose(r2eul(eul2r(0.1, beta, 0.3)), (0, beta, gamma), atol=1e-12)


@given(angles, axes, st.floats(0.01, 100))
def test_the_length_of_the_axis_does_not_matter(angle, axis, factor):
    np.testing.assert_allclose(angvec2r(angle, factor * axis), angvec2r(angle, axis), **close)


@given(angles)
def test_a_turn_about_a_coordinate_axis_is_the_one_of_its_name(angle):
    for axis, turn in zip(np.eye(3), (rotx, roty, rotz), strict=True):
        np.testing.assert_allclose(angvec2r(angle, axis), turn(angle), **close)


@given(angles, axes)
def test_a_turn_leaves_its_axis_where_it_is(angle, axis):
    np.testing.assert_allclose(angvec2r(angle, axis) @ axis, axis, atol=1e-12)


@given(st.one_of(rotations, st.builds(angvec2r, angles, axes)))
def test_angle_and_axis_of_a_rotation_make_it_again(R):
    angle, axis = r2angvec(R)
    assert 0 <= angle <= pi
    assert np.linalg.norm(axis) == pytest.approx(1)
    np.testing.assert_allclose(angvec2r(angle, axis), R, **close)


@given(st.floats(1e-3, pi - 1e-3), axes)
def test_angle_and_axis_come_back(angle, axis):
    again, direction = r2angvec(angvec2r(angle, axis))
    assert again == pytest.approx(angle, abs=1e-12)
    np.testing.assert_allclose(direction, axis / np.linalg.norm(axis), atol=1e-9)


@given(axes, st.sampled_from([0, 1e-15, 1e-12, 1e-9, 1e-6]))
def test_at_half_a_turn_the_axis_comes_back_but_for_its_sign(axis, less):
    angle, direction = r2angvec(angvec2r(pi - less, axis))
    assert angle == pytest.approx(pi - less, abs=1e-12)
    assert abs(direction @ axis) / np.linalg.norm(axis) == pytest.approx(1, abs=1e-12)


def test_no_rotation_turns_by_zero_about_z():
    angle, axis = r2angvec(np.eye(3))
    assert angle == 0
    np.testing.assert_array_equal(axis, (0, 0, 1))


@given(st.lists(st.one_of(rotations, st.just(np.eye(3))), min_size=1, max_size=5))
def test_many_rotations_at_once_are_each_one_alone(parts):
    R = np.stack(parts)
    for convert in (r2rpy, r2eul):
        np.testing.assert_allclose(convert(R), [convert(one) for one in parts], **close)
    angle, axis = r2angvec(R)
    for k, one in enumerate(parts):
        np.testing.assert_allclose(angvec2r(angle[k], axis[k]), one, **close)
    np.testing.assert_allclose(angvec2r(angle, axis), R, **close)
    np.testing.assert_allclose(rpy2r(*r2rpy(R).T), R, **close)


@given(poses, poses)
def test_the_way_begins_at_one_pose_and_ends_at_the_other(A, B):
    np.testing.assert_allclose(interpolate(A, B, 0), A, atol=1e-12)
    np.testing.assert_allclose(interpolate(A, B, 1), B, **close)


@given(poses, poses, st.floats(0, 1), st.floats(0, 1))
def test_the_way_is_even_and_straight(A, B, s, u):
    angle, axis = r2angvec(A[:3, :3].T @ B[:3, :3])
    assume(angle < pi - 1e-6)
    first, second = interpolate(A, B, s), interpolate(A, B, u)
    np.testing.assert_allclose(
        second[:3, 3] - first[:3, 3], (u - s) * (B[:3, 3] - A[:3, 3]), atol=1e-12
    )
    turned = first[:3, :3].T @ second[:3, :3]
    np.testing.assert_allclose(turned, angvec2r((u - s) * angle, axis), **close)


@given(poses, poses, poses, st.floats(0, 1))
def test_the_way_does_not_depend_on_who_looks(A, B, viewer, s):
    assume(r2angvec(A[:3, :3].T @ B[:3, :3])[0] < pi - 1e-3)
    seen = interpolate(viewer @ A, viewer @ B, s)
    np.testing.assert_allclose(seen, viewer @ interpolate(A, B, s), atol=1e-9)


@given(rotations, st.lists(lengths, min_size=1, max_size=4))
def test_the_way_at_many_parts_is_each_one_alone(R, s):
    A, B = np.eye(4), rp2t(R, (1, 2, 3))
    np.testing.assert_allclose(interpolate(A, B, s), [interpolate(A, B, x) for x in s], **close)


def test_the_way_goes_the_shorter_way_round():
    T = interpolate(np.eye(4), rp2t(rotz(1.5 * pi), (0, 0, 0)), 0.5)
    np.testing.assert_allclose(T[:3, :3], rotz(-pi / 4), atol=1e-12)


def test_the_way_of_a_pose_to_itself_stands_still():
    A = rp2t(rpy2r(1, 2, 3), (1, 2, 3))
    np.testing.assert_allclose(interpolate(A, A, [0, 0.3, 1]), [A, A, A], atol=1e-12)
    np.testing.assert_allclose(inverse(A) @ interpolate(A, A, 0.5), np.eye(4), atol=1e-12)


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: r2rpy(np.ones((3, 3))), "R is not a rotation"),
        (lambda: r2angvec(np.eye(4)), r"R must have shape \(3, 3\), got \(4, 4\)"),
        (lambda: angvec2r(1, (0, 0, 0)), "axis must not have length 0"),
        (lambda: angvec2r((0, 0, 1), 1), r"axis must have shape \(3,\), got \(\)"),
        (lambda: interpolate(np.eye(4), np.eye(3), 0), r"T1 must have shape \(4, 4\)"),
        (lambda: interpolate(np.eye(4), np.eye(4), np.inf), "s must be finite, got inf"),
    ],
)
def test_what_has_no_angles_is_told_why(call, text):
    with pytest.raises(InputError, match=text):
        call()
