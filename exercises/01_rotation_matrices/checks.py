"""Checks of exercise 1: rotation matrices."""

import numpy as np

from dhlab import csys, deg, rotx, roty, rotz, rp2t
from dhlab.diagnosis import MatrixTask, turn
from dhlab.grading import Question

ORIGIN, BESIDE = (0, 0, 0), (1.8, 0.9, 0)
TURNS = {"x": rotx, "y": roty, "z": rotz}
READ = [  # two quarter turns, about the fixed axes and in this order
    (("x", 90), ("z", 90)),
    (("x", 90), ("z", -90)),
    (("x", -90), ("z", 90)),
    (("y", 90), ("x", 90)),
    (("y", 90), ("x", -90)),
    (("y", -90), ("x", 90)),
    (("z", 90), ("y", 90)),
    (("z", -90), ("y", 90)),
]


def numbers(rng):
    """Which of the pictures a student gets."""
    return {"picture": int(rng.integers(len(READ)))}


def questions(given):
    """The questions, for a student's picture."""
    read = READ[given["picture"]]
    return [
        Question(
            "rot_z",
            MatrixTask(turn("z", lambda angle: angle), size=3),
            points=2,
            examples=[(30 * deg,), (-75 * deg,), (2.0,)],
            inputs=angles,
            hint="Where does x go when the frame turns about z? That is the first column.",
        ),
        Question(
            "rot_y",
            MatrixTask(turn("y", lambda angle: angle), size=3),
            points=2,
            examples=[(30 * deg,), (-75 * deg,), (2.0,)],
            inputs=angles,
            hint="Right thumb along y: does z go towards x, or away from it?",
        ),
        Question(
            "R_AB",
            MatrixTask(*(turn(axis, angle * deg) for axis, angle in read), about="fixed", size=3),
            points=2,
            hint="Each column is one axis of {B}, told in {A}. Begin with the red one.",
        ),
    ]


def angles(rng):
    """Further angles: special ones, and any."""
    return [(0.0,), (np.pi / 2,), (-np.pi,), *((angle,) for angle in rng.uniform(-3, 3, 3))]


def pictures(given):
    """What is drawn beside the questions."""
    first, second = READ[given["picture"]]
    R = TURNS[second[0]](second[1] * deg) @ TURNS[first[0]](first[1] * deg)
    A = csys(name="A", opacity=0.35)
    return {
        "about z": [A, csys(rp2t(rotz(50 * deg), ORIGIN), name="B")],
        "about y": [A, csys(rp2t(roty(50 * deg), ORIGIN), name="B")],
        "A and B": [csys(name="A"), csys(rp2t(R, BESIDE), name="B")],
    }
