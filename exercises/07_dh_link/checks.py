"""Checks of exercise 7: the function of one row."""

import numpy as np

from dhlab import csys, deg, dh, robot
from dhlab.diagnosis import LinkTask, MatrixTask, slide, turn
from dhlab.grading import Question


def numbers(rng):
    """A row as a data sheet has it: degrees and millimetres, and no two numbers are alike."""
    alpha, theta = rng.choice([20, 25, 35, 75, 80], 2, replace=False) * rng.choice([-1, 1], 2)
    return {
        "alpha": int(alpha),
        "a": int(rng.integers(5, 12) * 50),
        "d": int(rng.integers(5, 12) * 40 + 35),
        "theta": int(theta),
    }


def questions(given):
    """The questions, for a student's row."""
    alpha, theta = given["alpha"] * deg, given["theta"] * deg
    a, d = given["a"] / 1000, given["d"] / 1000
    return [
        Question(
            "dh_link",
            LinkTask(),
            points=4,
            examples=[(0.4, 0.5, 0.3, 1.1), (-0.9, 0.2, -0.4, 0.6), (np.pi / 2, 0.0, 0.7, -2.0)],
            inputs=rows,
            hint="Write the four factors down as 4x4 matrices, and multiply them in their order.",
        ),
        Question(
            "T_own",
            MatrixTask(
                turn("x", alpha), slide((a, 0, 0)), turn("z", theta), slide((0, 0, d)), size=4
            ),
            points=2,
            hint="It is one call of your function, in radians and metres.",
        ),
    ]


def rows(rng):
    """Further rows: special ones, and any."""
    special = [(0.0, 0.0, 0.0, 0.0), (np.pi / 2, -0.3, 0.0, 0.0), (0.0, 0.4, 0.2, np.pi)]
    low, high = (-3, -1, -1, -3), (3, 1, 1, 3)
    return special + [tuple(row) for row in rng.uniform(low, high, (3, 4)).tolist()]


def pictures(given):
    """A row with its four numbers as dimensions."""
    alpha, theta = given["alpha"] * deg, given["theta"] * deg
    a, d = given["a"] / 1000, given["d"] / 1000
    return {"row": drawn(0.6, 0.9, 0.7, 0.9), "own row": drawn(alpha, a, d, theta)}


def drawn(alpha, a, d, theta):
    """One link, with its frames and dimensions."""
    link = robot([dh(alpha, a, d, theta)], "r", name="link", opacity=0.3, radius=0.012)
    link.frame_size = 0.3
    link.show_csys = True
    link.dimensions = 1
    return [csys(name="i-1", size=0.3), link]
