"""Limits and poses, under each renaming of the joints that is right."""

from math import pi

import numpy as np
import pytest

from dhlab import robot
from dhlab.diagnosis import RobotTask
from dhlab.grading.values import from_json, to_json
from dhlab.kinematics.chain import Chain
from dhlab.kinematics.transforms import rotx, rp2t

POLAR = Chain(
    [(0, 0, 0, 0), (pi / 2, 0, 0, 0), (-pi / 2, 0, 0, 0)],
    "rpr",
    grasper=(0.2, 0.1, 0),
    limits=[(-1, 2), (0.1, 0.5), (-0.5, 0.4)],
)


def came(chain, limits, q, **changes):
    told = {"rows": chain.rows, "joints": chain.joints, "grasper": chain.grasper}
    one = robot(**told | {"limits": limits, "q": q} | changes)
    return [((), from_json(to_json(one, "robot")))]


def mirrored(values):
    """An arm that turns half about and draws in its slide reaches the same point."""
    values = np.array(values)
    return np.stack([values[0] + pi, -values[1], values[2] - pi])


def test_limits_of_an_arm_that_reaches_the_same_the_other_way_are_right():
    other = np.sort(mirrored(POLAR.limits), axis=1)
    task = RobotTask(POLAR, limits=True, q=[0.3, 0.2, 0.1])
    assert task.judge(came(POLAR, POLAR.limits, [0.3, 0.2, 0.1])).right
    assert task.judge(came(POLAR, other, mirrored([0.3, 0.2, 0.1]))).right
    assert not task.judge(came(POLAR, other, mirrored([0.3, 0.3, 0.1]))).right
    other[1] = POLAR.limits[1]
    assert not task.judge(came(POLAR, other, [0.3 + pi, 0.2, 0.1 - pi])).right


@pytest.mark.parametrize("turns", [-2, -1, 0, 1, 2])
def test_a_zero_may_be_full_turns_away(turns):
    task = RobotTask(POLAR, limits=True)
    offset = np.array([2 * pi * turns, 0, 0])
    limits = POLAR.limits - offset[:, None]
    q = limits.mean(axis=1)
    assert task.judge(came(POLAR, limits, q, offset=offset)).right
    limits[0, 1] += 0.1
    wrong = task.judge(came(POLAR, limits, q, offset=offset))
    assert not wrong.right
    assert "The upper limit of joint 1" in wrong.text


def test_a_zero_that_is_told_may_not_be_full_turns_away():
    task = RobotTask(POLAR, limits=True, zero_free=False)
    limits = POLAR.limits + np.array([[2 * pi], [0], [0]])
    assert task.judge(came(POLAR, POLAR.limits, POLAR.limits[:, 0])).right
    assert not task.judge(came(POLAR, limits, limits[:, 0])).right


def test_slides_that_do_the_same_stand_right_where_their_tip_does():
    lift = Chain([(0, 0, 0, 0), (0, 0.2, 0, 0)], "pp", grasper=(0.1, 0, 0))
    task = RobotTask(lift, q=[0.3, 0.2])
    assert task.judge(came(lift, None, [0.1, 0.4])).right
    assert not task.judge(came(lift, None, [0.1, 0.3])).right
    limits = lift.replace(limits=[(0, 1), (0, 0.5)])
    both = RobotTask(limits, limits=True, q=[0.3, 0.2])
    assert both.judge(came(lift, [(0.2, 1.2), (-0.2, 0.3)], [0.5, 0])).right
    assert not both.judge(came(lift, [(0, 1), (0, 0.5)], [0.1, 0.4])).right


def test_limits_of_one_side_fit_too():
    task = RobotTask(POLAR.replace(limits=[(-np.inf, 2), (0, np.inf), (-1, 1)]), limits=True)
    offset = np.array([0.3, -0.1, 0])
    limits = np.array([(-np.inf, 1.7), (0.1, np.inf), (-1, 1)])
    assert task.judge(came(POLAR, limits, [0, 0.2, 0], offset=offset)).right
    limits[0, 0] = -5
    assert "lower limit of joint 1" in task.judge(came(POLAR, limits, [0, 0.2, 0])).text


def test_a_table_with_its_axis_turned_over_needs_other_limits(keys):
    swing = Chain([(0, 0, 0, 0), (0, 0.3, 0, 0)], "rr", limits=[(-1, 2), (-0.5, 0.4)])
    over = [(pi, 0, 0, 0), (0, 0.3, 0, 0)]
    task = RobotTask(swing, limits=True)
    other = np.sort(-swing.limits, axis=1)
    turned = {"rows": over, "grasper": rp2t(rotx(pi), (0, 0, 0))}
    assert task.judge(came(swing, other, [0, 0], **turned)).right
    verdict = task.judge(came(swing, swing.limits, [0, 0], **turned))
    assert keys(verdict) == [{"limits-sense"}]
    assert "if joint 1, 2 counts the other way than in our table" in verdict.text


def test_limits_and_a_pose_that_nobody_asks_for_are_not_read():
    told = {"rows": POLAR.rows, "joints": "rpr", "grasper": POLAR.grasper}
    told |= {"limits": "none", "q": "anywhere"}
    assert RobotTask(POLAR).judge([((), told)]).right
    text = RobotTask(POLAR, limits=True).judge([((), told)]).text
    assert text == "The limits are not made of numbers."
