"""Checks of exercise 10: the table of an arm with six axes and a spherical wrist."""

import numpy as np

from dhlab import Chain, arrow, csys, deg, dh, robot
from dhlab.diagnosis import TableTask
from dhlab.grading import Question
from dhlab.grading.drawing import joint_axes

DRAWN = np.array([0, -45, -45, 0, 30, 0]) * deg


def numbers(rng):
    """Lengths of the arm: upper arm, step sideways, step at the elbow, forearm."""
    return {
        "upper": rng.choice([0.4, 0.42, 0.44, 0.46, 0.48]),
        "aside": rng.choice([0.16, 0.17, 0.18, 0.19]),
        "step": rng.choice([0.11, 0.12, 0.13, 0.14]),
        "fore": rng.choice([0.37, 0.39, 0.41, 0.43]),
    }


def questions(given):
    """The questions, for a student's lengths."""
    return [
        Question(
            "arm_table",
            TableTask(chain(given, 4), tool_free=True),
            points=4,
            hint="Axis by axis: are the two parallel, do they meet, how far apart are they?",
        ),
        Question(
            "table",
            TableTask(chain(given, 6), tool_free=True),
            points=3,
            hint="The first four rows are those above. The last three axes meet in one point.",
        ),
    ]


def chain(given, joints):
    """The first joints of the arm."""
    rows = [
        dh(0, 0, 0, DRAWN[0]),
        dh(-90 * deg, 0, 0, DRAWN[1]),
        dh(0, given["upper"], given["aside"], DRAWN[2]),
        dh(-90 * deg, given["step"], given["fore"], DRAWN[3]),
        dh(90 * deg, 0, 0, DRAWN[4]),
        dh(-90 * deg, 0, 0, DRAWN[5]),
    ]
    return Chain(rows[:joints], joints * "r", grasper=(0, 0, 0.1) if joints == 6 else (0, 0, 0))


def pictures(given):
    """The arm with its axes and lengths; the second picture also has those of the wrist."""
    c = chain(given, 6)
    arm = robot(c.rows, c.joints, grasper=c.grasper, name="arm", opacity=0.4, radius=0.028)
    frames = c.frames(c.home)
    second, third, wrist = frames[1], frames[2], frames[3][:3, 3]
    bend = second[:3, 3] + given["upper"] * second[:3, 0]
    elbow = third[:3, 3]
    front = elbow + given["step"] * third[:3, 0]
    lengths = [
        (second[:3, 3], bend, "upper"),
        (bend, elbow, "aside"),
        (elbow, front, "step"),
        (front, wrist, "fore"),
    ]
    drawn = [
        arrow(p, q, f"{given[name]:.2f} m", heads="both", head=0.025, name=name)
        for p, q, name in lengths
    ]
    axes = joint_axes(arm, 0.2, {1: (0.2, 0.34), 4: (0.1, 0.3), 5: (0.15, 0.2), 6: (0.24, 0.14)})
    shown = [csys(name="0", size=0.2), arm, *drawn]
    return {"arm": [*shown, *axes[:4]], "wrist": [*shown, *axes]}
