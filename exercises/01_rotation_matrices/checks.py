"""Checks of exercise 1: rotation matrices."""

import numpy as np

from dhlab import csys, deg, rotx, roty, rotz, rp2t
from dhlab.diagnosis import MatrixTask, Verdict, turn
from dhlab.diagnosis import given as known
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
            Read(rotation(given)),
            points=2,
            hint="Each column is one axis of {B}, told in {A}. Begin with the red one.",
        ),
    ]


class Read:
    """A matrix read from a picture: of all mistakes, only those that a reader makes."""

    def __init__(self, R):
        self.task = MatrixTask(known("R_AB", R), size=3)

    def judge(self, cases):
        """Judge by what came."""
        verdict = self.task.judge(cases)
        read = [m for m in verdict.mistakes if m.key.startswith(("inverse", "left-handed"))]
        return Verdict(verdict.right, verdict.seen, tuple(read) if len(read) == 1 else ())


def angles(rng):
    """Further angles: special ones, and any."""
    return [(0.0,), (np.pi / 2,), (-np.pi,), *((angle,) for angle in rng.uniform(-3, 3, 3))]


def rotation(given):
    """Rotation in a student's picture."""
    first, second = READ[given["picture"]]
    return (TURNS[second[0]](second[1] * deg) @ TURNS[first[0]](first[1] * deg)).round()


def pictures(given):
    """What is drawn beside the questions."""
    A = csys(name="A", opacity=0.35)
    return {
        "about z": [A, csys(rp2t(rotz(50 * deg), ORIGIN), name="B")],
        "about y": [A, csys(rp2t(roty(50 * deg), ORIGIN), name="B")],
        "A and B": [csys(name="A"), csys(rp2t(rotation(given), BESIDE), name="B")],
    }
