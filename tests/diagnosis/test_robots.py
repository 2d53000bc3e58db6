"""Robots as plain data: simple ones, and several that hang on each other."""

from math import pi

import numpy as np
import pytest

from dhlab import robot, robot_complex
from dhlab.diagnosis import RobotTask
from dhlab.diagnosis.chain_slips import table_slips
from dhlab.diagnosis.table_model import chain_of, table_of
from dhlab.errors import InputError
from dhlab.grading.values import from_json, to_json
from dhlab.kinematics.chain import Chain
from dhlab.models import upper_limb
from dhlab.models.industrial import puma

PLANAR = Chain(
    [(0, 0, 0, 0), (0, 0.3, 0, 0), (0, 0.2, 0, 0)],
    "rrr",
    grasper=(0.1, 0, 0),
    limits=[(-1, 2), (0, 2), (-1, 1)],
)


def plain(handle):
    """What leaves the student's process."""
    return from_json(to_json(handle, "robot"))


def as_robot(chain, **changes):
    told = ("rows", "joints", "convention", "base", "grasper", "limits", "offset")
    return robot(**{name: getattr(chain, name) for name in told} | changes)


def finger(name, base, a=0.04):
    return robot([(0, 0, 0, 0), (0, a, 0, 0)], "rr", name=name, base=base, grasper=(0.03, 0, 0))


def hand(a=0.04, lower=(0.1, 0, 0)):
    palm = robot([(0, 0, 0.1, 0)], "r", name="palm")
    return palm.connect(finger("upper", (0.1, 0.05, 0)), finger("lower", lower, a))


def changed(number, **fields):
    """Components of a hand, one of them changed."""
    parts = plain(hand())["components"]
    parts[number] |= fields
    return parts


def test_robots_of_the_models_are_right(tally):
    for make in (puma, upper_limb, hand):
        task = RobotTask(make().mechanism, limits=True, q=make().q)
        tally.judge(task, [((), plain(make()))])
    tally.judge(RobotTask(PLANAR), [((), plain(as_robot(PLANAR.to_standard())))])
    tally.check(share=0)


def test_mistakes_in_the_table_of_a_robot_are_named(chains, tally):
    rng = np.random.default_rng(2)
    for _ in range(60):
        chain = chains(rng)
        slips = [s for s in table_slips(chain) if s.mistake.key != "radians"]
        slip = slips[rng.integers(len(slips))]
        table = slip.change(table_of(chain, chain.home))
        if table.is_chain(chain.n):
            tally.judge(
                RobotTask(chain), [((), plain(as_robot(chain_of(table))))], {slip.mistake.key}
            )
    tally.check()


@pytest.mark.parametrize(
    ("limits", "key"),
    [
        (np.degrees(PLANAR.limits), "limits-degrees"),
        (None, "limits-missing"),
        (-PLANAR.limits[:, ::-1], "limits-sign"),
    ],
)
def test_limits_count_where_they_are_asked_for(limits, key, keys):
    came = plain(as_robot(PLANAR, limits=limits))
    assert RobotTask(PLANAR).judge([((), came)]).right
    verdict = RobotTask(PLANAR, limits=True).judge([((), came)])
    assert not verdict.right
    assert keys(verdict) == [{key}]


def test_limits_go_with_the_zero_and_the_sense_of_a_joint():
    offset = np.array([0.3, 0, -0.2])
    other = as_robot(PLANAR, offset=offset, limits=PLANAR.limits - offset[:, None])
    task = RobotTask(PLANAR, limits=True)
    assert task.judge([((), plain(other))]).right
    kept = plain(as_robot(PLANAR, offset=offset))
    assert [m.key for m in task.judge([((), kept)]).mistakes] == ["limits-zero"]


def test_where_a_robot_stands_counts_where_it_is_asked_for(keys):
    arm = as_robot(PLANAR, limits=None)
    task = RobotTask(PLANAR, q=[0.3, 0.5, -0.7])
    arm.q = [0.3 + 2 * pi, 0.5, -0.7]
    assert task.judge([((), plain(arm))]).right
    arm.q = np.degrees([0.3, 0.5, -0.7])
    assert keys(task.judge([((), plain(arm))])) == [{"degrees"}]
    arm.q = arm.home
    verdict = task.judge([((), plain(arm))])
    assert keys(verdict) == [{"home"}]
    assert "joint 1 does not stand where" in verdict.text


def test_a_part_of_a_hand_that_is_wrong_is_named(keys):
    task = RobotTask(hand().mechanism)
    wrong = task.judge([((), plain(hand(a=40)))])
    assert wrong.text.startswith("lower: The axes of joints 1 and 2 are not as far apart")
    assert keys(wrong) == [{"millimetres"}]
    assert "lower: " in task.judge([((), plain(hand(lower=(0.1, 0.01, 0))))]).text


def test_a_part_that_hangs_elsewhere_is_named():
    task = RobotTask(hand().mechanism)
    palm = robot([(0, 0, 0.1, 0)], "r", name="palm")
    loose = robot_complex(palm, finger("upper", (0.1, 0.05, 0)), finger("lower", (0.1, 0, 0)))
    verdict = task.judge([((), plain(loose))])
    assert [m.key for m in verdict.mistakes] == ["attached-elsewhere"]
    assert "The tip of upper is" in verdict.text


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"components": []}, "2 fewer"),
        ({"components": [{"rows": 1}] * 3}, "palm: The table has shape"),
        ({"components": 7}, "A robot of 3 chains is asked for"),
        ({"components": changed(1, on=None)}, "does not tell what hangs on what"),
        ({"components": changed(1, on=3)}, "does not tell what hangs on what"),
        ({"components": changed(1, at=2)}, "hangs on a frame that is not there"),
        ({"components": changed(1, stand=[1, 2])}, "The base has shape (2,)"),
    ],
)
def test_what_is_no_such_robot_gets_a_sentence(change, sentence):
    sentence = sentence.replace("2 fewer", "fewer chains than the one asked for")
    verdict = RobotTask(hand().mechanism).judge([((), plain(hand()) | change)])
    assert not verdict.right
    assert sentence in verdict.text


def test_one_chain_is_no_hand_and_a_hand_no_chain():
    assert "One chain is asked for" in RobotTask(PLANAR).judge([((), plain(hand()))]).text
    text = RobotTask(hand().mechanism).judge([((), plain(as_robot(PLANAR)))]).text
    assert "A robot of 3 chains is asked for" in text
    assert "A robot is asked for" in RobotTask(PLANAR).judge([((), [1, 2])]).text


def test_base_and_tool_of_a_robot_with_several_tips_are_not_free_at_once():
    wanted = "the robot has 2 tips, and base_free and tool_free are both given; choose one"
    with pytest.raises(InputError, match=wanted):
        RobotTask(hand().mechanism, base_free=True, tool_free=True)
    assert RobotTask(PLANAR, base_free=True, tool_free=True).judge([((), plain(as_robot(PLANAR)))])


def test_the_order_of_the_parts_counts_where_it_is_asked_for(keys):
    palm = robot([(0, 0, 0.1, 0)], "r", name="palm")
    swapped = palm.connect(finger("lower", (0.1, 0, 0)), finger("upper", (0.1, 0.05, 0)))
    assert RobotTask(hand().mechanism).judge([((), plain(swapped))]).right
    task = RobotTask(hand().mechanism, ordered=True)
    assert task.judge([((), plain(hand()))]).right
    verdict = task.judge([((), plain(swapped))])
    assert keys(verdict) == [{"parts-order"}]
    assert RobotTask(PLANAR, ordered=True).judge([((), plain(as_robot(PLANAR)))]).right
