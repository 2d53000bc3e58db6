"""Checks of exercise 6: a chain by hand."""

import numpy as np

from dhlab import Chain, csys, deg, robot
from dhlab.diagnosis import ForwardTask, PointTask, slide, turn
from dhlab.grading import Question


def numbers(rng):
    """Lengths of an arm [m] and a configuration [deg] in which no mistake looks like another."""
    return {
        "l1": int(rng.integers(6, 11)) / 10,
        "l2": int(rng.integers(3, 6)) / 10,
        "q": [int(rng.choice([20, 25, 28, 35])), int(rng.choice([37, 52, 57, 73]))],
    }


def questions(given):
    """The questions, for a student's arm."""
    l1, l2 = given["l1"], given["l2"]
    q1, q2 = (angle * deg for angle in given["q"])
    return [
        Question(
            "tip",
            PointTask(turn("z", q1), slide((l1, 0, 0)), turn("z", q2), point=(l2, 0, 0)),
            points=2,
            hint="Which angle does the second link make with x of the ground?",
        ),
        Question(
            "arm_pose",
            ForwardTask(arm(given)),
            points=4,
            examples=[(np.array(q),) for q in ([0.4, 0.9], [-1.2, 0.7], [2.0, -1.5])],
            inputs=configurations,
            hint="Four factors: turn, slide, turn, slide. What does each take from its link?",
        ),
    ]


def configurations(rng):
    """Further configurations: special ones, and any."""
    special = [(np.zeros(2),), (np.array([np.pi / 2, 0.0]),), (np.array([0.0, np.pi]),)]
    return special + [(q,) for q in rng.uniform(-3, 3, (3, 2))]


def arm(given):
    """The arm: two turning joints and a tip."""
    return Chain([(0, 0, 0, 0), (0, given["l1"], 0, 0)], "rr", grasper=(given["l2"], 0, 0))


def pictures(given):
    """The arm with its frames, at the student's configuration."""
    drawn = robot(arm(given).rows, "rr", name="arm", grasper=(given["l2"], 0, 0), opacity=0.45)
    drawn.show_csys = True
    drawn.q = [angle * deg for angle in given["q"]]
    return {"arm": [csys(name="0", size=0.3), drawn]}
