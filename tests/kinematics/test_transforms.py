import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhlab.errors import InputError
from dhlab.kinematics.transforms import inverse, rotx, roty, rotz, rp2t, transl
from tests.kinematics.strategies import angles, points, poses, rotations

close = {"rtol": 0, "atol": 1e-12}
TURNS = [rotx, roty, rotz]


@pytest.mark.parametrize(("turn", "axis"), [(rotx, 0), (roty, 1), (rotz, 2)])
def test_a_turn_leaves_its_axis_and_takes_the_next_axis_to_the_one_after(turn, axis):
    x, y, z = np.roll(np.eye(3), -axis, axis=0)
    R = turn(np.pi / 2)
    np.testing.assert_allclose(R @ x, x, **close)
    np.testing.assert_allclose(R @ y, z, **close)
    np.testing.assert_allclose(R @ z, -y, **close)


@pytest.mark.parametrize("turn", TURNS)
@given(a=angles, b=angles)
def test_angles_about_one_axis_add_up(turn, a, b):
    np.testing.assert_allclose(turn(a) @ turn(b), turn(a + b), **close)


@given(poses, poses, poses)
def test_poses_form_a_group(A, B, C):
    np.testing.assert_allclose((A @ B) @ C, A @ (B @ C), atol=1e-12)
    np.testing.assert_allclose(A @ np.eye(4), A, **close)
    np.testing.assert_allclose(A @ inverse(A), np.eye(4), atol=1e-12)
    np.testing.assert_allclose(inverse(A) @ A, np.eye(4), atol=1e-12)
    np.testing.assert_allclose(inverse(A @ B), inverse(B) @ inverse(A), atol=1e-12)
    np.testing.assert_allclose(inverse(inverse(A)), A, atol=1e-12)


@given(poses, points, points)
def test_a_pose_keeps_distances_and_handedness(T, p, q):
    moved = T[:3, :3] @ np.column_stack([p, q]) + T[:3, 3:]
    np.testing.assert_allclose(
        np.linalg.norm(moved[:, 0] - moved[:, 1]), np.linalg.norm(p - q), atol=1e-12
    )
    assert np.linalg.det(T) == pytest.approx(1)


@given(rotations, points)
def test_a_pose_is_its_rotation_and_its_origin(R, p):
    T = rp2t(R, p)
    np.testing.assert_array_equal(T[:3, :3], R)
    np.testing.assert_array_equal(T[:3, 3], p)
    np.testing.assert_allclose(T, transl(p) @ rp2t(R, (0, 0, 0)), **close)


@given(st.lists(st.tuples(rotations, points, angles), min_size=1, max_size=4))
def test_many_at_once_are_each_one_alone(parts):
    R, p, a = (np.stack(list(part)) for part in zip(*parts, strict=True))
    T = np.stack([rp2t(*part[:2]) for part in parts])
    for turn in TURNS:
        np.testing.assert_array_equal(turn(a), [turn(angle) for angle in a])
    np.testing.assert_array_equal(rp2t(R, p), T)
    np.testing.assert_array_equal(transl(p), [transl(origin) for origin in p])
    np.testing.assert_allclose(inverse(T), [inverse(pose) for pose in T], **close)
    np.testing.assert_array_equal(inverse(T[None])[0], inverse(T))


def test_one_rotation_goes_with_many_origins():
    T = rp2t(rotz(1.0), [(0, 0, 1), (0, 0, 2)])
    assert T.shape == (2, 4, 4)
    np.testing.assert_array_equal(T[1], rp2t(rotz(1.0), (0, 0, 2)))


def test_a_result_may_be_changed_by_who_asked_for_it():
    T = transl((1, 2, 3))
    T[0, 3] = 5
    assert transl((1, 2, 3))[0, 3] == 1


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: rotx("90"), "angle must be made of numbers, got '90'"),
        (lambda: rotz(np.nan), "angle must be finite, got nan"),
        (lambda: transl((1, 2)), "p must have shape (3,), got (2,)"),
        (lambda: rp2t((1, 2, 3), np.eye(3)), "R must have shape (3, 3), got (3,)"),
        (lambda: rp2t(2 * np.eye(3), (0, 0, 0)), "R is not a rotation: its x axis has length 2"),
        (lambda: inverse(np.eye(3)), "T must have shape (4, 4), got (3, 3)"),
        (lambda: inverse(np.ones((4, 4))), "T has the last row [1, 1, 1, 1]"),
    ],
)
def test_what_cannot_be_a_transform_is_told_why(call, text):
    with pytest.raises(InputError, match=f"^{re.escape(text)}"):
        call()
