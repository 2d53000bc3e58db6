"""Exercises with more than one right answer: what the solution does not choose is right too."""

from pathlib import Path

import numpy as np
import pytest

from dhlab import csys, deg, dh, robot, robot_complex, rotx, rp2t
from dhlab.grading.exercise import load_exercise
from dhlab.grading.judge import judge
from dhlab.grading.tried import values_of

ROOT = Path(__file__).parents[1]
HALF = 180 * deg


def said(folder, name, answer):
    """What is said of an answer, a function of the student's numbers."""
    exercise = load_exercise(ROOT / "exercises" / folder)
    given = exercise.numbers("Ada Lovelace", "dhlab")
    question = next(q for q in exercise.questions(given) if q.name == name)
    return judge(question, values_of(question, answer(given)))


@pytest.mark.parametrize(
    "rows",
    [
        lambda g: [dh(0, 0, 0.2, 0), dh(0, g["l1"], -0.3, 0), dh(0, g["l2"], 0.05, 0)],
        lambda g: [dh(HALF, 0, 0, 0), dh(0, g["l1"], 0, 0), dh(HALF, g["l2"], 0, 0)],
        lambda g: [dh(0, 0, 0, 1), dh(0, -g["l1"], 0, 2), dh(0, g["l2"], 0, 3)],
        lambda g: [[2 * HALF, 0, 0, 0], [0, g["l1"], 0, 0], [0, g["l2"], 0, 0]],
    ],
    ids=["other heights", "axes upside down", "x the other way", "a full turn"],
)
def test_tables_of_the_planar_arm(rows):
    assert said("08_planar_table", "table", rows).right


@pytest.mark.parametrize("alpha", [90 * deg, -90 * deg])
def test_either_sense_of_the_level_axes(alpha):
    def rows(g):
        return [dh(alpha, 0, 0, 0), dh(0, g["l1"], 0, 0), dh(0, g["l2"], 0, 0)]

    assert said("08_planar_table", "table_upright", rows).right


def upwards(g):
    """A SCARA whose axes all point up; the tool turns down behind the last."""
    rows = [dh(0, 0, 0, 0), dh(0, g["l1"], 0.1, 0), dh(0, g["l2"], 0, 0), dh(0, 0, g["h"] - 0.1, 0)]
    return robot(rows, "rrpr", grasper=rp2t(rotx(HALF), (0, 0, -g["tool"])))


def in_standard(g):
    """A SCARA by its standard table, which says so."""
    rows = [dh(0, g["l1"], g["h"], 0), dh(HALF, g["l2"], 0, 0), dh(0, 0, 0, 0), dh(0, 0, 0, 0)]
    return robot(rows, "rrpr", convention="standard", grasper=(0, 0, g["tool"]))


@pytest.mark.parametrize("scara", [upwards, in_standard])
def test_scaras(scara):
    assert said("09_scara", "scara", scara).right


@pytest.mark.parametrize("signs", [(1, 1), (-1, 1), (1, -1), (-1, -1)])
def test_six_axes_with_either_sense_of_the_shoulder_and_of_the_forearm(signs):
    shoulder, fore = signs

    def rows(g):
        return [
            dh(0, 0, 0, 0),
            dh(-90 * deg * shoulder, 0, 0, 0),
            dh(0, g["upper"], g["aside"], 0),
            dh(-90 * deg * fore, g["step"], fore * g["fore"], 0),
            dh(90 * deg * fore, 0, 0, 0),
            dh(-90 * deg, 0, 0, 0),
        ]

    assert said("10_six_axes", "table", rows).right


def test_a_standard_table_is_no_answer_where_the_modified_one_is_asked_for():
    def same(g):
        rows = [dh(alpha * deg, a, d, theta * deg) for alpha, a, d, theta in g["standard"]]
        return {"rows": rows, "convention": "standard", "joints": "rrr"}

    assert not said("11_two_conventions", "to_modified", same).right


def test_a_base_given_as_a_pose_or_with_an_offset_in_full_turns():
    exercise = load_exercise(ROOT / "exercises" / "12_base_tool_offset")

    def base(g):
        chain = exercise.questions(g)[2].task.robot
        return csys(chain.base, name="anything")

    def arm(g):
        chain = exercise.questions(g)[2].task.robot
        turned = np.add(chain.offset, [2 * np.pi, 0, -2 * np.pi])
        return robot(chain.rows, "rrr", base=chain.base, grasper=chain.grasper, offset=turned)

    assert said("12_base_tool_offset", "base", base).right
    assert said("12_base_tool_offset", "arm", arm).right


def test_a_hand_whose_fingers_are_named_and_bent_as_the_student_likes():
    exercise = load_exercise(ROOT / "exercises" / "14_hand")

    def hand(g):
        mechanism = exercise.questions(g)[1].task.robot
        fingers = [
            robot(
                b.chain.rows, "rrrr", name=f"finger {k}", base=b.chain.base,
                grasper=b.chain.grasper, limits=b.chain.limits, q=b.chain.limits.mean(axis=1),
            )
            for k, b in enumerate(mechanism.branches) if b.chain.n
        ]  # fmt: skip
        return robot_complex(*fingers, name="mine")

    assert said("14_hand", "hand", hand).text == "Right."
