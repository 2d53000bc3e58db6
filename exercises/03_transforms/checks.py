"""Checks of exercise 3: homogeneous transforms and their inverses."""

import numpy as np

from dhlab import csys, cuboid, deg, polyline, rotx, rotz, rp2t, sphere
from dhlab.diagnosis import MatrixTask, PointTask, inverse_of, slide, turn
from dhlab.diagnosis import given as known
from dhlab.grading import Question

POSES = [
    rp2t(rotz(0.7) @ rotx(0.4), (0.5, -0.2, 0.9)),
    rp2t(rotx(-1.1) @ rotz(2.0), (-0.3, 0.8, 0.1)),
]
POINTS = [(0.4, 0.1, 0.3), (-0.2, 0.6, 0.5)]


def numbers(rng):
    """Where the box stands: metres and degrees."""
    return {
        "x": int(rng.integers(6, 13)) / 10,
        "y": int(rng.integers(4, 10)) / 10,
        "z": int(rng.integers(2, 6)) / 10,
        "angle": int(rng.choice([20, 25, 35, 55, 65])),
    }


def questions(given):
    """The questions, for a student's box."""
    return [
        Question(
            "T_AB",
            MatrixTask(slide(corner(given)), turn("z", given["angle"] * deg), about="moving"),
            points=2,
            hint="The upper left 3x3 is the rotation, the last column the origin of {B}.",
        ),
        Question(
            "to_A",
            PointTask(known("T_AB", lambda T_AB, p_B: T_AB), point=lambda T_AB, p_B: p_B),
            points=2,
            examples=list(zip(POSES, map(np.array, POINTS), strict=True)),
            inputs=lambda rng: [(pose(rng), rng.uniform(-1, 1, 3)) for _ in range(3)],
            hint="A point needs a fourth number, 1, so that the shift takes part.",
        ),
        Question(
            "inverse_pose",
            MatrixTask(inverse_of(known("T_AB", lambda T_AB: T_AB))),
            points=3,
            examples=[(T,) for T in POSES],
            inputs=lambda rng: [(np.eye(4),), (rp2t(np.eye(3), (1, 2, 3)),), (pose(rng),)],
            hint="Where does {B} see the origin of {A}, in its own axes?",
        ),
    ]


def pose(rng):
    """Any pose."""
    a, b, c = rng.uniform(-3, 3, 3)
    return rp2t(rotz(a) @ rotx(b) @ rotz(c), rng.uniform(-1, 1, 3))


def corner(given):
    """Origin of {B}."""
    return given["x"], given["y"], given["z"]


def pictures(given):
    """A box on a table, with the way to its corner."""
    x, y, z = corner(given)
    T = rp2t(rotz(given["angle"] * deg), (x, y, z))
    box = cuboid(0.5, 0.3, 0.2, name="box", color="#8fb7d9", opacity=0.5)
    box.move(T @ rp2t(np.eye(3), (0.25, 0.15, -0.2)))
    way = polyline([(0, 0, 0), (x, 0, 0), (x, y, 0), (x, y, z)], name="way", line_width=3)
    way.color = "#c05600"
    T_AB, p_B = POSES[0], POINTS[0]
    p_A = T_AB[:3, :3] @ p_B + T_AB[:3, 3]
    return {
        "box": [csys(name="A", size=0.5), csys(T, name="B", size=0.4), box, way],
        "point": [
            csys(name="A", size=0.5),
            csys(T_AB, name="B", size=0.5),
            sphere(0.03, name="P", color="#d55e00", edges=False).move(p_A),
        ],
    }
