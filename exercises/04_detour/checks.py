"""Checks of exercise 4: a pose that nobody measured, by a detour."""

import numpy as np

from dhlab import cone, csys, cuboid, deg, rotx, rotz, rp2t
from dhlab.diagnosis import ArrangementTask, MatrixTask, inverse_of
from dhlab.diagnosis import given as known
from dhlab.grading import Question


def numbers(rng):
    """Three measured poses: table and hand in the robot's base, part on the table."""

    def off(*middle):
        return (np.array(middle) + rng.integers(-2, 3, 3) * 0.05).round(2)

    turns = rng.choice([20, 30, 45, 55, 65, 75], 3, replace=False) * deg  # no two undo each other
    table = rp2t(rotz(turns[0]), off(0.8, 0.3, 0.2))
    part = rp2t(rotz(-turns[1]), off(0.15, -0.1, 0.15))
    hand = rp2t(rotz(turns[2]) @ rotx(150 * deg), off(0.4, -0.3, 0.9))
    return {"T_RT": table.tolist(), "T_TP": part.tolist(), "T_RH": hand.tolist()}


def questions(given):
    """The questions, for a student's poses."""
    T_RT, T_TP, T_RH = (known(name, given[name]) for name in ("T_RT", "T_TP", "T_RH"))
    return [
        Question(
            "drawing",
            ArrangementTask(
                {"R": np.eye(4), "T": given["T_RT"], "P": given["T_TP"], "H": given["T_RH"]},
                parents={"P": "T"},
            ),
            points=2,
            kind="scene",
            hint="`show(csys(name='R'), ...)` with the four frames; which pose is not one in {R}?",
        ),
        Question(
            "T_HP",
            MatrixTask(inverse_of(T_RH), T_RT, T_TP),
            points=2,
            library=True,
            hint="From the hand to the part by way of the robot's base: one pose is the wrong way.",
        ),
        Question(
            "camera_pose",
            MatrixTask(
                known("T_RP", lambda T_RP, T_CP: T_RP),
                inverse_of(known("T_CP", lambda T_RP, T_CP: T_CP)),
            ),
            points=3,
            examples=[(pose(1), pose(2)), (pose(3), pose(4))],
            inputs=lambda rng: [(any_pose(rng), any_pose(rng)) for _ in range(3)],
            library=True,
            hint="RP and CP share their last letter. Which of them do you turn round?",
        ),
    ]


def pose(seed):
    """A pose to try with, always the same."""
    return any_pose(np.random.default_rng(seed))


def any_pose(rng):
    """Any pose."""
    a, b, c = rng.uniform(-3, 3, 3)
    return rp2t(rotz(a) @ rotx(b) @ rotz(c), rng.uniform(-1, 1, 3).round(3))


def pictures(given):
    """A robot's base, a table with a part on it, a hand above."""
    T_RT, T_TP, T_RH = (np.array(given[name]) for name in ("T_RT", "T_TP", "T_RH"))
    T_RP = T_RT @ T_TP
    foot = cuboid(0.25, 0.25, 0.1, name="foot", color="#9aa5b1")
    table = cuboid(0.7, 0.5, 0.04, name="table", color="#d8c3a5", opacity=0.7)
    table.move(T_RT @ rp2t(np.eye(3), (0.15, -0.05, -0.04)))
    height = T_TP[2, 3]  # {P} is on top of the part, which stands on the table
    part = cuboid(0.12, 0.08, height, name="part", color="#8fb7d9", opacity=0.7)
    part.move(T_RP @ rp2t(np.eye(3), (0, 0, -height)))
    hand = cone(0.05, 0.12, name="hand", color="#9aa5b1", opacity=0.8)
    hand.move(T_RH @ rp2t(np.eye(3), (0, 0, -0.06)))
    scene = [foot, table, part, hand]
    frames = {"R": np.eye(4), "T": T_RT, "P": T_RP, "H": T_RH}
    return {
        "cell": [*scene, *(csys(T, name=n, size=0.28) for n, T in frames.items())],
        "no frames": scene,
        "hand": [*scene, csys(name="R", size=0.28), csys(T_RH, name="H", size=0.28)],
    }
