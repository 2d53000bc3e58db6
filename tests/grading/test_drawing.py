"""Axes in drawings: they lie where the joints are, and give no sense of z away."""

import numpy as np
import pytest

from dhlab import deg, dh, robot
from dhlab.grading.drawing import joint_axes


def arm(twist):
    return robot(
        [dh(0, 0, 0.3, 0.4), dh(twist, 0.1, 0, -0.3), dh(0, 0.5, 0.2, 0.9)], "rrr", name="arm"
    )


@pytest.mark.parametrize("twist", [0, 90 * deg, -90 * deg, 40 * deg])
def test_each_line_lies_in_the_axis_of_its_joint(twist):
    drawn = arm(twist)
    for i, axis in enumerate(joint_axes(drawn, 0.2), start=1):
        T = drawn.frames()[f"arm/{i}"]
        off = axis.points - T[:3, 3]
        assert np.cross(off, T[:3, 2]) == pytest.approx(np.zeros((2, 3)))
        assert np.linalg.norm(off, axis=1) == pytest.approx([0.2, 0.2])
        assert axis.label == f"axis {i}"


def test_whether_z_points_one_way_or_the_other_is_not_to_be_seen():
    up, down = (robot([dh(a, 0, 0, 0)], "r", name="arm") for a in (70 * deg, 70 * deg - 180 * deg))
    (one,), (other,) = joint_axes(up, 0.2), joint_axes(down, 0.2)
    assert one.points == pytest.approx(other.points)


def test_an_axis_can_reach_further_so_that_two_on_one_line_are_told_apart():
    axes = joint_axes(robot([dh(0, 0, 0, 0), dh(0, 0, 0, 0)], "rp"), 0.1, {2: (0.3, 0.5)})
    assert axes[1].points[:, 2] == pytest.approx([-0.3, 0.5])
    assert axes[0].points[:, 2] == pytest.approx([-0.1, 0.1])
