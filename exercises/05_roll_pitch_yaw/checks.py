"""Checks of exercise 5: roll, pitch and yaw."""

import numpy as np

from dhlab import csys, deg, prism, rotx, roty, rotz, rp2t, rpy2r
from dhlab.diagnosis import AnglesTask, MatrixTask, turn
from dhlab.grading import Question

SHAPE = [(0.9, 0), (-0.5, 0.6), (-0.3, 0), (-0.5, -0.6)]
"""Outline of the paper plane: its nose at x."""


def numbers(rng):
    """The attitude of a student's plane: no two angles are equal or make a right angle."""
    roll, pitch, yaw = rng.integers([15, 52, 76], [31, 59, 83]) * rng.choice([-1, 1], 3)
    return {"R": rpy2r(roll * deg, pitch * deg, yaw * deg).round(9).tolist()}


def questions(given):
    """The questions, for a student's plane."""
    return [
        Question(
            "rpy_matrix",
            MatrixTask(
                turn("x", lambda roll, pitch, yaw: roll),
                turn("y", lambda roll, pitch, yaw: pitch),
                turn("z", lambda roll, pitch, yaw: yaw),
                about="fixed",
                size=3,
            ),
            points=2,
            examples=[(0.3, -0.5, 1.1), (-1.2, 0.4, 2.0), (0.7, 1.0, -0.6)],
            inputs=triples,
            hint="About fixed axes, the turn that is made first stands on the right.",
        ),
        Question(
            "rpy_angles",
            AnglesTask(lambda R: R),
            points=3,
            examples=[(rpy2r(0.3, -0.5, 1.1),), (rpy2r(-1.2, 0.4, 2.0),), (rpy2r(2.5, 1.0, -2.6),)],
            inputs=lambda rng: [(rpy2r(*triple),) for triple in triples(rng)],
            hint="Look at the first column and the last row: which angles stand there alone?",
        ),
        Question(
            "attitude",
            AnglesTask(np.array(given["R"]), tolerance=2e-3),
            points=1,
            hint="It is one call of your function; three numbers, in radians.",
        ),
    ]


def triples(rng):
    """Further angles: special ones, and any; the pitch stays below a quarter turn."""
    special = [(0.0, 0.0, 0.0), (np.pi / 2, 0.0, 0.0), (0.0, 0.0, -2.0)]
    return special + [tuple(triple) for triple in rng.uniform(-1.4, 1.4, (3, 3)).tolist()]


def pictures(given):
    """A paper plane in the attitude of the three parts."""
    X, Y, Z = rotx(35 * deg), roty(-25 * deg), rotz(60 * deg)
    strip = [np.eye(3), X, Y @ X, Z @ Y @ X]
    return {
        "turns": [handle for k, R in enumerate(strip) for handle in plane(R, 2.2 * k, "A123"[k])],
        "own plane": [csys(name="A", opacity=0.35), *plane(np.array(given["R"]), 0, "B")],
    }


def plane(R, x, name):
    """A paper plane with its frame."""
    paper = prism(SHAPE, 0.04, name=f"plane {name}", color="#8fb7d9", opacity=0.75)
    return [csys(rp2t(R, (x, 0, 0)), name=name), paper.move(rp2t(R, (x, 0, 0)))]
