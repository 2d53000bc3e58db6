"""Checks of exercise 12: what stands before and behind a table, and the zeros of the joints."""

import numpy as np

from dhlab import Chain, arrow, csys, cuboid, cylinder, deg, dh, robot, roty, rotz, rp2t, transl
from dhlab.diagnosis import MatrixTask, RobotTask, slide, turn
from dhlab.grading import Question

UPPER, FORE, COLUMN = 0.45, 0.4, 0.3
UP = np.array([0, 0, 0.05])


def numbers(rng):
    """Where the arm stands, how it is turned, and its tool."""
    return {
        "x": float(rng.choice([0.4, 0.5, 0.58, 0.68])),
        "y": float(rng.choice([-0.45, -0.3, 0.2, 0.35])),
        "bench": float(rng.choice([0.55, 0.6, 0.65, 0.7])),
        "turn": int(rng.choice([80, -75, 105, -105])),
        "tool": float(rng.choice([0.12, 0.14, 0.16])),
        "tilt": int(rng.choice([25, 35, 55])),
    }


def questions(given):
    """The questions, for a student's place and tool."""
    return [
        Question(
            "base",
            MatrixTask(slide(place(given)), turn("z", given["turn"] * deg), size=4),
            points=2,
            kind="csys",
            hint="rp2t(R, p): where are the axes of {0}, told in {W}, and where is its origin?",
        ),
        Question(
            "tool",
            MatrixTask(
                slide((FORE, 0, 0)),
                turn("y", given["tilt"] * deg),
                slide((given["tool"], 0, 0)),
                size=4,
            ),
            points=2,
            kind="csys",
            hint="Three factors, in the order of the words: along the forearm, the turn, the tool.",
        ),
        Question(
            "arm",
            RobotTask(chain(given), zero_free=False),
            points=4,
            kind="robot",
            hint="robot(rows, 'rrr', base=..., grasper=..., offset=...): the rows stay the same.",
        ),
    ]


def place(given):
    """Origin of {0} in {W}."""
    return given["x"], given["y"], given["bench"]


def chain(given):
    """The arm on its bench, with its tool; its zeros are those of the data sheet."""
    rows = [dh(0, 0, COLUMN, 0), dh(-90 * deg, 0, 0, 0), dh(0, UPPER, 0, 0)]
    grasper = (
        transl((FORE, 0, 0))
        @ rp2t(roty(given["tilt"] * deg), (0, 0, 0))
        @ transl((given["tool"], 0, 0))
    )
    base = rp2t(rotz(given["turn"] * deg), place(given))
    return Chain(rows, "rrr", base=base, grasper=grasper, offset=(0, -90 * deg, 90 * deg))


def pictures(given):
    """The arm on its bench; and its last link alone, with the tool."""
    c = chain(given)
    x, y, height = place(given)
    bench = cuboid(0.3, 0.3, height, name="bench", color="#c9b28f", opacity=0.35).move((x, y, 0))
    to_the_tip, to_the_tool = (
        robot(
            c.rows, c.joints, base=c.base, grasper=grasper, offset=c.offset, name="arm",
            opacity=0.45, radius=0.03, grasper_size=0,
        )
        for grasper in (c.grasper, (FORE, 0, 0))
    )  # fmt: skip
    forearm = robot(
        [dh(0, 0, 0, 0)], "r", grasper=(FORE, 0, 0), name="forearm", opacity=0.4, radius=0.02,
        grasper_size=0,
    )  # fmt: skip
    mount, tip = transl((FORE, 0, 0)), c.grasper[:3, 3]
    tilted = rp2t(roty((given["tilt"] + 90) * deg), (FORE, 0, 0))
    rod, held = (
        cylinder(radius, given["tool"], name="tool", color="#4a5058", opacity=0.6).move(pose)
        for radius, pose in ((0.008, tilted), (0.015, c.frames(c.home)[-1] @ tilted))
    )
    lengths = [
        arrow(p + UP, q + UP, f"{length:.2g} m", heads="both", head=0.02, name=name)
        for name, length, p, q in (
            ("forearm's length", FORE, np.zeros(3), mount[:3, 3]),
            ("tool's length", given["tool"], mount[:3, 3], tip),
        )
    ]
    return {
        "bench": [csys(name="W", size=0.25), bench, to_the_tool, held],
        "whole": [csys(name="W", size=0.25), bench, to_the_tip],
        "link": [csys(name="3", size=0.12), forearm, rod, *lengths],
    }
