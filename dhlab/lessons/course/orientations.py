"""Three numbers for an orientation, and where they break."""

from __future__ import annotations

import numpy as np

from dhlab.kinematics.dh import deg
from dhlab.kinematics.transforms import transl
from dhlab.lessons.lesson import Lesson
from dhlab.lessons.moves import turn
from dhlab.lessons.step import Choice, Step
from dhlab.scene.csys import csys


def three_conventions(
    first: float = 90 * deg, second: float = 60 * deg, third: float = 90 * deg
) -> Lesson:
    """Make a lesson: the same three numbers in three conventions.

    Parameters
    ----------
    first, second, third : float [rad]
        The three numbers.
    """
    places = {name: transl((x, 0, 0)) for name, x in (("R", -2.2), ("Y", 0.0), ("E", 2.2))}
    R, Y, E = (csys(T, name=name) for name, T in places.items())
    zeros = [
        csys(T, name=f"0{n}", size=0.6, opacity=0.3, labels=False)
        for n, T in zip("abc", places.values(), strict=True)
    ]
    numbers = ", ".join(f"{np.degrees(x):.4g}^\\circ" for x in (first, second, third))
    return Lesson(
        "The same three numbers",
        [
            Step(
                "The first number",
                f"Three frames get the numbers $({numbers})$. $\\{{R\\}}$ reads *roll, pitch, "
                "yaw about fixed x, y, z*; $\\{Y\\}$ reads *turns about its own x, y, z*; "
                "$\\{E\\}$ reads *Euler angles about its own z, y, z*.",
                turn(R, "x", first, about=zeros[0]),
                turn(Y, "x", first),
                turn(E, "z", first),
            ),
            Step(
                "The second number",
                "$\\{R\\}$ turns about the $y$ that stands still, $\\{Y\\}$ and $\\{E\\}$ about "
                "the $y$ that has turned with them.",
                turn(R, "y", second, about=zeros[0]),
                turn(Y, "y", second),
                turn(E, "y", second),
                question=Choice(
                    f"All three are given the same numbers $({numbers})$. Will they end in the "
                    "same orientation?",
                    ["yes: three angles are an orientation", "no: it depends on the convention"],
                    answer=1,
                    because="There are 12 sequences of axes, each about fixed or moving axes: 24 "
                    "conventions.",
                ),
            ),
            Step(
                "The third number",
                "Three orientations from one set of numbers:\n\n"
                "$$\\{R\\}: R_z R_y R_x \\qquad \\{Y\\}: R_x R_y R_z \\qquad "
                "\\{E\\}: R_z R_y R_z$$\n\nThree numbers are an orientation only together with "
                "the name of their convention.",
                turn(R, "z", third, about=zeros[0]),
                turn(Y, "z", third),
                turn(E, "z", third),
            ),
        ],
        handles=zeros,
        keep=1,
        product=R,
    )


def gimbal_lock(pitch: float = 90 * deg) -> Lesson:
    """Make a lesson: at a pitch of 90 degrees roll and yaw are one and the same turn.

    Parameters
    ----------
    pitch : float [rad]
    """
    left, right = transl((-1.4, 0, 0)), transl((1.4, 0, 0))
    B, C = csys(left, name="B"), csys(right, name="C")
    zeros = [
        csys(left, name="0", size=0.6, opacity=0.3, labels=False),
        csys(right, name="0'", size=0.6, opacity=0.3, labels=False),
    ]
    told = f"{np.degrees(pitch):.4g}^\\circ"
    return Lesson(
        "Where roll, pitch, yaw break",
        [
            Step(
                "Pitch",
                f"Both frames pitch by ${told}$: their $x$ points straight down, along the axis "
                "that yaw turns about.",
                turn(B, "y", pitch, about=zeros[0]),
                turn(C, "y", pitch, about=zeros[1]),
            ),
            Step(
                "Roll here, yaw there",
                "$\\{B\\}$ rolls about its own $x$ by $40^\\circ$, $\\{C\\}$ yaws about the fixed "
                "$z$ by $-40^\\circ$. They stand alike: with $x$ and $z$ on one line, roll and "
                "yaw are the same turn, and one direction of turning is lost. It is the *numbers* "
                "that break here; the frame can still turn as it likes.",
                turn(B, "x", 40 * deg),
                turn(C, "z", -40 * deg, about=zeros[1]),
                question=Choice(
                    "$\\{B\\}$ now rolls by $40^\\circ$ about its own $x$, $\\{C\\}$ yaws by "
                    "$-40^\\circ$ about the fixed $z$. How will they stand?",
                    ["differently", "alike"],
                    answer=1,
                    because="$x_B$ points down: turning about it, or backwards about the axis "
                    "that points up, is the same.",
                ),
            ),
        ],
        handles=zeros,
        keep=1,
        product=B,
    )
