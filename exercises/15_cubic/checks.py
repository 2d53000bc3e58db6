"""Checks of exercise 15: a cubic from rest to rest."""

import numpy as np

from dhlab import csys, deg, dh, robot
from dhlab.diagnosis import TrajectoryTask
from dhlab.grading import Question

MOTIONS = [
    (np.linspace(1, 3.5, 5), 0.2, 1.4, 1.0, 3.5),
    (np.array([0.9, 1.3, 2.0]), 1.1, -0.4, 0.7, 2.3),
]


def numbers(rng):
    """Where the arm begins and ends [degrees], and when [s]."""
    start = int(rng.integers(1, 4))
    return {
        "q0": [int(rng.integers(-8, 0) * 10), int(rng.integers(4, 10) * 10)],
        "qt": [int(rng.integers(3, 9) * 10), int(rng.integers(-9, -2) * 10)],
        "start": start,
        "end": start + int(rng.integers(2, 5)),
    }


def questions(given):
    """The questions; the functions are the same for all."""
    timed = {
        "q0": lambda t, q0, qt, start, end: q0,
        "qt": lambda t, q0, qt, start, end: qt,
        "start": lambda t, q0, qt, start, end: start,
        "end": lambda t, q0, qt, start, end: end,
    }
    return [
        Question(
            "cubic",
            TrajectoryTask(
                lambda q0, qt, T: q0,
                lambda q0, qt, T: qt,
                0.0,
                lambda q0, qt, T: T,
                answer="coefficients",
            ),
            points=3,
            examples=[(0.2, 1.4, 2.0), (1.0, -0.5, 0.7)],
            inputs=ways,
            hint="Four conditions: q and its derivative at t = 0 and at t = T.",
        ),
        Question(
            "position",
            TrajectoryTask(**timed, answer="q"),
            points=3,
            examples=MOTIONS,
            inputs=motions,
            hint="Your coefficients count the time from 0: from when on does this motion?",
        ),
        Question(
            "velocity",
            TrajectoryTask(**timed, answer="v"),
            points=2,
            examples=MOTIONS,
            inputs=motions,
            hint="Differentiate the polynomial: what becomes of c3 times t cubed?",
        ),
    ]


def ways(rng):
    """Further ways: none, back, and any."""
    return [(0.5, 0.5, 1.0), (0.0, -2.0, 3.0), *map(tuple, rng.uniform(0.3, 3, (3, 3)).tolist())]


def motions(rng):
    """Further motions: from 0 on, from before 0, some instants on the way, and any."""
    found = [
        (np.linspace(0, 2, 4), 0.0, 1.0, 0.0, 2.0),
        (np.linspace(-1, 0.5, 4), 1.0, -1.0, -1.0, 0.5),
        (np.array([2.1, 2.6, 2.9]), -0.3, 0.9, 1.7, 3.1),
    ]
    for q0, qt, start, length in rng.uniform(0.4, 2.5, (3, 4)).tolist():
        found.append((np.linspace(start, start + length, 6), q0, -qt, start, start + length))
    return found


def pictures(given):
    """The arm where it begins (pale) and where it ends."""
    q0, qt = (np.array(given[name]) * deg for name in ("q0", "qt"))
    begin, end = arm("begin", q0, 0.25), arm("end", qt, 0.6)
    return {"ends": [csys(name="0", size=0.15), begin, end]}


def arm(name, q, opacity):
    """A planar arm of two joints."""
    rows = [dh(0, 0, 0, 0), dh(0, 0.4, 0, 0)]
    return robot(rows, "rr", grasper=(0.3, 0, 0), q=q, name=name, opacity=opacity, radius=0.025)
