"""Checks of exercise 8: the table of a planar arm."""

import numpy as np

from dhlab import Chain, arrow, csys, deg, dh, robot
from dhlab.diagnosis import TableTask
from dhlab.grading import Question
from dhlab.grading.drawing import joint_axes

DRAWN = np.array([30, 50, -40]) * deg
UPRIGHT = 90 * deg


def numbers(rng):
    """Lengths of the three links, all different."""
    l1, l2, l3 = rng.choice([0.24, 0.26, 0.28, 0.32, 0.34, 0.36, 0.38, 0.42], 3, replace=False)
    return {"l1": l1, "l2": l2, "l3": l3}


def questions(given):
    """The questions, for a student's lengths."""
    return [
        Question(
            "table",
            TableTask(chain(given, 0), tool_free=True),
            points=3,
            hint="One row a joint, and in each: how do I get from the axis before to this one?",
        ),
        Question(
            "table_upright",
            TableTask(chain(given, UPRIGHT), tool_free=True),
            points=2,
            hint="Only one axis lies otherwise in {0} than before: which row leads to it?",
        ),
    ]


def chain(given, alpha):
    """The arm; the frame of its last joint is where the last link begins."""
    q1, q2, q3 = DRAWN
    rows = [dh(alpha, 0, 0, q1), dh(0, given["l1"], 0, q2), dh(0, given["l2"], 0, q3)]
    return Chain(rows, "rrr", grasper=(given["l3"], 0, 0))


def pictures(given):
    """Arm, axes and lengths: lying flat, and upright."""
    return {"flat": drawing(given, 0), "upright": drawing(given, UPRIGHT)}


def drawing(given, alpha):
    """The arm as it is drawn, without any frame but {0}."""
    c = chain(given, alpha)
    arm = robot(c.rows, c.joints, grasper=c.grasper, name="arm", opacity=0.45, radius=0.022)
    at = [*c.frames(DRAWN)[:, :3, 3], c.tip(DRAWN)[:3, 3]]
    normal = c.frames(DRAWN)[0, :3, 2]
    lengths = [
        arrow(p + side, q + side, f"{given[name]:.2f} m", heads="both", head=0.03, name=name)
        for name, p, q in zip(("l1", "l2", "l3"), at, at[1:], strict=False)
        for side in [0.08 * np.cross(normal, q - p) / np.linalg.norm(q - p)]
    ]
    return [csys(name="0", size=0.12), arm, *joint_axes(arm, 0.12, {1: (0.12, 0.2)}), *lengths]
