"""Checks of exercise 2: sequences of turns."""

import numpy as np

from dhlab import csys, cylinder, deg, rotx, roty, rotz, rp2t
from dhlab.diagnosis import MatrixTask, turn
from dhlab.grading import Question

STEP = 1.7
"""How far apart the frames of a strip stand."""


def numbers(rng):
    """Three angles in degrees: none is special, and no two are equal or make a right angle."""
    angles = rng.choice([20, 25, 35, 75, 80], 3, replace=False) * rng.choice([-1, 1], 3)
    return dict(zip("abc", angles.tolist(), strict=True))


def questions(given):
    """The questions, for a student's angles."""
    a, b, c = (given[name] * deg for name in "abc")
    return [
        Question(
            "R_moving",
            MatrixTask(turn("z", a), turn("x", b), turn("y", c), about="moving", size=3),
            points=2,
            hint="Each turn is about an axis that the turns before have carried along.",
        ),
        Question(
            "R_fixed",
            MatrixTask(turn("z", a), turn("x", b), turn("y", c), about="fixed", size=3),
            points=2,
            hint="Each turn is about an axis of {A}, which does not move.",
        ),
        Question(
            "wheel",
            MatrixTask(
                turn("z", lambda heading, lean, spin: heading),
                turn("x", lambda heading, lean, spin: lean),
                turn("y", lambda heading, lean, spin: spin),
                size=3,
            ),
            points=3,
            examples=[(0.5, 0.3, 1.2), (-1.0, -0.4, 0.7), (2.0, 0.2, -2.5)],
            inputs=rides,
            hint="Which axes lean with the bicycle, and which do not?",
        ),
    ]


def rides(rng):
    """Further rides: special ones, and any."""
    special = [(0.0, 0.0, 0.0), (np.pi / 2, 0.0, 0.0), (0.0, 0.0, -np.pi)]
    return special + [tuple(ride) for ride in rng.uniform(-1.4, 1.4, (3, 3)).tolist()]


def pictures(given):
    """Strips of frames, one after each turn."""
    Z, X, Y = rotz(given["a"] * deg), rotx(given["b"] * deg), roty(given["c"] * deg)
    A, at = csys(name="A", opacity=0.35), (0, 0, 0)
    return {
        "moving": strip([np.eye(3), Z, Z @ X, Z @ X @ Y]),
        "fixed": strip([np.eye(3), Z, X @ Z, Y @ X @ Z]),
        "moving, B": [A, csys(rp2t(Z @ X @ Y, at), name="B", opacity=0.35)],
        "fixed, B": [A, csys(rp2t(Y @ X @ Z, at), name="B", opacity=0.35)],
        "wheel": wheel(rotz(40 * deg) @ rotx(-20 * deg) @ roty(60 * deg)),
    }


def wheel(R):
    """A wheel, its axle along its own y, and where it comes from."""
    rim = cylinder(0.7, 0.1, name="rim", opacity=0.35)
    rim.move(rp2t(R @ rotx(90 * deg), R @ (0, 0.05, 0)))
    return [csys(name="A", opacity=0.35), csys(rp2t(R, (0, 0, 0)), name="W"), rim]


def strip(rotations):
    """Frames beside each other, as in a comic strip."""
    names = ["A", "1", "2", "B"]
    return [
        csys(rp2t(R, (k * STEP, 0, 0)), name=name)
        for k, (R, name) in enumerate(zip(rotations, names, strict=True))
    ]
