"""The industrial robots: their numbers, their limits, and bodies that fit together."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from dhlab import LimitError, deg
from dhlab.models import gripper, industrial_arm, puma, scara

ROBOTS = {"arm": industrial_arm, "puma": puma, "scara": scara, "gripper": gripper}


def handling_arm():
    arm, hand = industrial_arm(), gripper()
    hand.base = arm.grasper
    return arm.connect(hand)


def wrist(q):
    """Where the axes 4, 5 and 6 of the arm meet."""
    return industrial_arm().frames(np.r_[q, 0, 0, 0])["arm/6"][:3, 3]


@pytest.mark.parametrize("make", ROBOTS.values(), ids=ROBOTS)
def test_each_call_gives_a_fresh_robot_at_home_within_its_limits(make):
    one, other = make(), make()
    assert one is not other
    assert_allclose(one.q, one.home)
    assert_allclose(one.clip(one.q), one.q)


def test_the_arm_at_zero_stands_upright_with_its_forearm_level():
    frames = industrial_arm().frames()
    assert_allclose(frames["arm/3"][:3, 3], (0.175, 0, 1.395), atol=1e-12)
    assert_allclose(frames["arm/5"][:3, 3], (1.135, 0, 1.57), atol=1e-12)
    assert_allclose(frames["arm/grasper"][:3, 3], (1.27, 0, 1.57), atol=1e-12)
    assert_allclose(frames["arm/grasper"][:3, 2], (1, 0, 0), atol=1e-12)


def test_positive_angles_of_the_arm_lean_it_forward_and_bow_its_hand():
    assert wrist((0, 0.1, 0))[0] > wrist((0, 0, 0))[0]
    assert wrist((0, 0, 0.1))[2] < wrist((0, 0, 0))[2]
    nodding = industrial_arm().frames([0, 0, 0, 0, 90 * deg, 0])["arm/grasper"]
    assert_allclose(nodding[:3, 2], (0, 0, -1), atol=1e-12)


def test_the_arm_reaches_2_05_metres():
    straight = -np.arctan2(0.96, 0.175)
    reach = np.hypot(*(wrist((0, 90 * deg, straight)) - (0, 0, 0.495))[[0, 2]])
    assert_allclose(reach, 0.175 + 0.9 + np.hypot(0.96, 0.175), atol=1e-12)
    assert 2.045 < reach < 2.055


def test_the_limits_are_those_of_the_data_sheet():
    assert_allclose(
        industrial_arm().limits / deg,
        [(-180, 180), (-90, 150), (-180, 75), (-400, 400), (-125, 120), (-400, 400)],
    )
    with pytest.raises(LimitError, match=r"joint 3 of 'arm'.*\(80\.0 deg\)"):
        industrial_arm().q = np.array([0, 0, 80, 0, 0, 0]) * deg


def test_the_gripper_makes_the_arm_one_mechanism_of_eight_variables():
    arm = handling_arm()
    assert [(part.name, part.n) for part in arm.components] == [
        ("arm", 6),
        ("left", 1),
        ("right", 1),
    ]
    assert_allclose(arm.limits[6:], 2 * [(0.01, 0.12)])


def test_the_jaws_close_towards_each_other_across_the_flange():
    arm = handling_arm()
    frames = arm.frames([*np.zeros(6), 0.03, 0.04])
    flange = frames["arm/6"] @ arm.grasper
    left, right = (
        np.linalg.inv(flange) @ frames[f"arm/gripper/{side}/1"] for side in ("left", "right")
    )
    assert_allclose(left[:3, 3], (0, 0.03, 0.11), atol=1e-12)
    assert_allclose(right[:3, 3], (0, -0.04, 0.11), atol=1e-12)


@pytest.mark.parametrize("side", ["left", "right"])
def test_the_pad_of_a_jaw_is_where_its_variable_says(side):
    hand = gripper().set(look="user", q=(0.03, 0.03))
    own = hand.components[("left", "right").index(side)]
    pose = hand.frames()[f"gripper/{side}/1"]
    pad = next(b for b in own.parts[1].components if b.name == "dark")
    y = (pad.vertices @ pose[:3, :3].T + pose[:3, 3])[:, 1]
    assert_allclose(np.abs(y).min(), 0.03, atol=1e-12)
    tip = (pad.vertices @ pose[:3, :3].T + pose[:3, 3])[:, 2]
    assert tip.min() < 0.23 < tip.max()


def test_pumas_frames_are_craigs():
    q = np.array([0.3, -0.7, 0.4, 0.5, 0.6, -0.8])
    c1, c2, s1, s2 = np.cos(q[0]), np.cos(q[1]), np.sin(q[0]), np.sin(q[1])
    c23, s23 = np.cos(q[1] + q[2]), np.sin(q[1] + q[2])
    a2, a3, d3, d4 = 0.4318, 0.02032, 0.14909, 0.43307
    reach = a2 * c2 + a3 * c23 - d4 * s23
    px, py = c1 * reach - d3 * s1, s1 * reach + d3 * c1
    pz = -a3 * s23 - a2 * s2 - d4 * c23
    assert_allclose(puma().frames(q)["puma/6"][:3, 3], (px, py, pz), atol=1e-12)


def test_the_scara_keeps_its_tool_upright_and_counts_down():
    q = [0.4, -1.1, 0.15, 0.9]
    tool = scara().frames(q)["scara/grasper"]
    assert_allclose(tool[:3, 2], (0, 0, -1), atol=1e-12)
    assert_allclose(tool[2, 3], 0.387 - 0.15 - 0.12, atol=1e-12)


@pytest.mark.parametrize("look", ["stick", "solid"])
@pytest.mark.parametrize("make", [*ROBOTS.values(), handling_arm])
def test_the_default_looks_draw_every_robot(make, look):
    nodes = make().set(look=look).describe()
    assert sum(node.shape is not None for node in nodes.values()) >= 3


PARTS = {
    f"{name} {path}": node.shape
    for name, make in ROBOTS.items()
    for path, node in make().set(look="user").describe().items()
    if node.shape is not None
}


@pytest.mark.parametrize("part", PARTS)
def test_every_body_is_closed_and_looks_outwards(part):
    assert PARTS[part].is_closed
    assert PARTS[part].volume > 0


def test_the_painted_bodies_take_the_colour_of_their_robot():
    arm = industrial_arm().set(look="user", color="#e8731c")
    nodes = arm.describe()
    paints = {node.style.color for path, node in nodes.items() if path.endswith("paint")}
    assert paints == {arm.components[0].color}
