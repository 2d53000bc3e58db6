"""Assigning frames: common normals, parallel axes, several right tables, frames in the air."""

from __future__ import annotations

import numpy as np

from dhlab.kinematics.dh import deg, dh
from dhlab.kinematics.transforms import rotx, rotz, rp2t, transl
from dhlab.lessons.lesson import Lesson
from dhlab.lessons.moves import configure, move_to, slide, turn
from dhlab.lessons.step import Choice, Place, Step
from dhlab.scene.block import Block
from dhlab.scene.blocks import cylinder, polyline
from dhlab.scene.csys import csys
from dhlab.scene.robots import robot

GREY = "#7f7f8c"


def pin(name: str, T: np.ndarray, length: float = 1.4, below: float = 0.5) -> Block:
    """Make a joint axis to look at: a grey pin along z of a pose."""
    return cylinder(0.035, length, name=name, color=GREY, opacity=0.75).move(
        T @ transl((0, 0, -below))
    )


def common_normal() -> Lesson:
    """Make a lesson: x lies along the common normal, not along the link."""
    second = rp2t(rotx(90 * deg), (1.0, 0, 0.8))
    axes = [pin("axis 1", np.eye(4)), pin("axis 2", second)]
    link = polyline(
        [(0, 0, 0.2), (0.3, -0.5, 0.5), (1.0, -0.5, 0.8)],
        name="link",
        color="#0072b2",
        line_width=5,
    )
    F = csys(transl((0, 0, -0.2)), name="F", size=0.6)
    return Lesson(
        "Along the common normal",
        [
            Step(
                "Which way will x point?",
                "The link is bent like a swan's neck. The two axes do not care: there is one "
                "shortest line that meets both at right angles, their common normal. $\\{F\\}$ "
                "slides up axis 1 to its foot.",
                slide(F, (0, 0, 1.0)),
                question=Choice(
                    "The blue link joins axis 1 to axis 2. Along what does $x$ lie?",
                    ["along the link", "along the common normal of the two axes"],
                    answer=1,
                    because="The table knows axes, no metal. $a$ is the distance of the axes.",
                ),
            ),
            Step(
                "Across, along the common normal",
                "Along $x$ by the length of the common normal, $a = 1$ m: shorter than the link.",
                slide(F, (1, 0, 0), label="a"),
            ),
            Step(
                "And turn z into axis 2",
                "The twist turns about that same normal. Where two axes *meet*, $a = 0$ and the "
                "normal has no length: $x$ is then at right angles to both, $\\pm z_1 \\times "
                "z_2$, and either sign will do.",
                turn(F, "x", 90 * deg, label="α"),
            ),
        ],
        handles=[*axes, link],
        keep=3,
        product=F,
    )


def parallel_axes(first: float = 0.5) -> Lesson:
    """Make a lesson: between parallel axes the offset is free.

    Parameters
    ----------
    first : float [m]
        Where frame 2 stands at first.
    """
    axes = [
        pin("axis 1", np.eye(4)),
        pin("axis 2", transl((1, 0, 0))),
        pin("axis 3", rp2t(rotx(90 * deg), (2.0, 0, 1.2))),
    ]
    two = csys(transl((1, 0, first)), name="2", size=0.5)
    three = csys(rp2t(rotx(90 * deg), (2.0, 0, 1.2)), name="3", size=0.5, opacity=0.5)
    one = csys(name="1", size=0.5, opacity=0.5)
    rest = 1.2 - first
    return Lesson(
        "A number that is free",
        [
            Step(
                "Slide frame 2 along its axis",
                "Axes 1 and 2 are parallel: they have not one common normal but as many as you "
                "like. Frame 2 may stand at any height. What $d_2$ loses, the next one gains: "
                f"$d_2 + d_3'$ stays {first:.4g} + {rest:.4g} = 1.2 m.",
                slide(two, (0, 0, 0.5), label="d"),
                question=Choice(
                    "Axes 1 and 2 are parallel. Does the hardware fix $d_2$, the height of frame "
                    "2 on its axis?",
                    ["yes: measure it on the drawing", "no: it can be chosen"],
                    answer=1,
                    because="Parallel axes have infinitely many common normals.",
                ),
            ),
            Step(
                "Choose the simplest",
                "Most take $d_2 = 0$: one zero more in the table. But a table with another "
                "number there is just as right, if the next row fits.",
                move_to(two, (1, 0, 0)),
            ),
        ],
        handles=[*axes, one, three],
        keep=1,
        product=two,
    )


def two_right_tables() -> Lesson:
    """Make a lesson: two students, two tables, one arm."""
    ann = robot(
        [dh(0, 0, 0.6, 0), dh(90 * deg, 0, 0, 0), dh(0, 0.8, 0, 0)],
        "rrr",
        name="Ann",
        grasper=(0.6, 0, 0),
        radius=0.06,
        color="#0072b2",
        show_csys=True,
        frame_size=0.3,
    )
    ben = robot(
        [dh(0, 0, 0.6, 0), dh(-90 * deg, 0, 0, 0), dh(0, 0.8, 0, 0)],
        "rrr",
        name="Ben",
        grasper=(0.6, 0, 0),
        radius=0.06,
        color="#e69f00",
        show_csys=True,
        frame_size=0.3,
        base=(0, -1.8, 0),
    )
    q = np.array([30, 40, -70]) * deg
    return Lesson(
        "Two right tables",
        [
            Step(
                "One arm, two tables",
                "Ann has $\\alpha_1 = +90^\\circ$, Ben $-90^\\circ$: their $z_2$ and $z_3$ point "
                "opposite ways along the same axes. Both tables were drawn from one arm.",
            ),
            Step(
                "The same numbers",
                "With the same $q$ they stand differently: Ben counts the angles of joints 2 and "
                "3 the other way round.",
                configure(ann, q),
                configure(ben, q),
                question=Choice(
                    "Ann's and Ben's tables differ. Who is right?",
                    ["Ann", "Ben", "both can be"],
                    answer=2,
                    because="Each may choose which way $z$ points along a joint axis.",
                ),
            ),
            Step(
                "Renamed",
                "With $q_2$ and $q_3$ of the other sign Ben's arm does all that Ann's does. Two "
                "tables are equally right if a renaming of the variables takes one into the "
                "other. So the checker of the exercises takes every right table.",
                configure(ben, q * (1, -1, -1)),
            ),
        ],
        handles=[ann, ben],
    )


def frame_in_the_air() -> Lesson:
    """Make a lesson: the origin of a frame need not lie on the metal."""
    T = rp2t(rotz(0), (0.9, 0, 0))
    axes = [
        pin("axis 1", np.eye(4), 1.0, 0.0),
        pin("axis 2", T @ rp2t(rotx(-90 * deg), (0, 0, 1.1)), 0.9, -0.5),
    ]
    link = polyline(
        [(0, 0, 0.5), (0, 0.9, 0.5), (0.9, 0.9, 1.1)], name="link", color="#0072b2", line_width=5
    )
    F = csys(name="F", size=0.5)
    return Lesson(
        "A frame in the air",
        [
            Step(
                "Up along axis 1",
                "Axis 2 is only a short pin at the far end of the blue link. But an axis is a "
                "line without end: the common normal leaves axis 1 at this height.",
                slide(F, (0, 0, 1.1), label="d"),
            ),
            Step(
                "Across to the line of axis 2",
                "Here is the foot of the common normal on axis 2: in the air, far from any metal. "
                "That is fine. Frames belong to axes.",
                slide(F, (0.9, 0, 0), label="a"),
                question=Place(
                    "$\\{F\\}$ slides along the common normal to axis 2. Put the pale frame there.",
                    F,
                ),
            ),
            Step(
                "Turned into axis 2",
                "And $z$ into the direction of the axis. The metal is where it was: ahead along "
                "$z$.",
                turn(F, "x", -90 * deg, label="α"),
            ),
        ],
        handles=[*axes, link],
        keep=3,
        product=F,
    )
