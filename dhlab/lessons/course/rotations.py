"""What a rotation matrix says."""

from __future__ import annotations

import numpy as np

from dhlab.kinematics.dh import deg
from dhlab.kinematics.transforms import rotx, rp2t
from dhlab.lessons.course.frames import point
from dhlab.lessons.lesson import Lesson
from dhlab.lessons.moves import turn
from dhlab.lessons.step import Choice, Step
from dhlab.scene.csys import csys


def columns_are_axes(angle: float = 30 * deg) -> Lesson:
    """Make a lesson: the columns of R_AB are the axes of B, told in A.

    Parameters
    ----------
    angle : float [rad]
        Of the turn about z.
    """
    A, B = csys(name="A", opacity=0.45), csys(name="B")
    told = f"{np.degrees(angle):.4g}^\\circ"
    return Lesson(
        "Columns are axes",
        [
            Step(
                "Turn B about z",
                "The first column of $R_{AB}$ is $x_B$ as $\\{A\\}$ sees it, the second $y_B$, the "
                f"third $z_B$. With $\\theta = {told}$:\n\n"
                "$$R_{AB} = \\begin{pmatrix} \\cos\\theta & -\\sin\\theta & 0 \\\\ "
                "\\sin\\theta & \\cos\\theta & 0 \\\\ 0 & 0 & 1 \\end{pmatrix}$$\n\n"
                "Look along $y_A$: how far has $x_B$ come there? That is $\\sin\\theta$, and it "
                "stands in the first column, second row.",
                turn(B, "z", angle),
                question=Choice(
                    f"$\\{{B\\}}$ turns by ${told}$ about $z$. Which numbers say where the axis "
                    "$x_B$ points to, seen from $\\{A\\}$?",
                    ["the first row of $R_{AB}$", "the first column of $R_{AB}$"],
                    answer=1,
                    because="$R_{AB}$ times $(1, 0, 0)$ is the first column, and $(1, 0, 0)$ is "
                    "$x_B$ in its own frame.",
                ),
            ),
            Step(
                "And the rows?",
                "The rows are the axes of $\\{A\\}$ as $\\{B\\}$ sees them. Rows and columns "
                "exchanged, that is the transpose, is the view from the other frame: "
                "$R_{BA} = R_{AB}^T = R_{AB}^{-1}$.",
            ),
            Step(
                "Back again",
                "Turning by the same angle the other way undoes it: the product of the two is the "
                "identity.",
                turn(B, "z", -angle),
            ),
        ],
        handles=[A],
        keep=1,
        product=B,
    )


def which_way_round() -> Lesson:
    """Make a lesson: the sign of a turn is the right hand's, from whichever side one looks."""
    A = csys(rp2t(rotx(90 * deg), (0, 0, 0)), name="A", size=1.2, opacity=0.45)
    B = csys(rp2t(rotx(90 * deg), (0, 0, 0)), name="B")
    P = point("P", (0.9, 0, 0))
    return Lesson(
        "Which way round is positive?",
        [
            Step(
                "An axis that points away",
                "The camera looks from the side that $z_A$ points *to*: from its front a positive "
                "turn is counter-clockwise. Go around with the mouse and look along the axis from "
                "behind: the same turn is clockwise. So *clockwise* is a word for the clock's own "
                "side. The right hand is not: thumb along the axis, and the fingers curl the "
                "positive way, from wherever one looks.",
                turn(B, "z", 60 * deg),
                turn(P, "z", 60 * deg, about=A),
                question=Choice(
                    "$\\{B\\}$ and the point $P$ turn by $+60^\\circ$ about $z_A$. Somebody stands "
                    "*behind* the frame and looks along $z_A$, so that the axis points away from "
                    "them. Which way does $P$ go for them?",
                    ["counter-clockwise: positive always is", "clockwise"],
                    answer=1,
                    because="Thumb along the axis, away from you: the fingers of the right hand "
                    "curl clockwise.",
                ),
            ),
            Step(
                "A negative turn",
                "A minus sign turns the hand around: $-90^\\circ$ about $z$ is $+90^\\circ$ about "
                "$-z$.",
                turn(B, "z", -90 * deg),
                turn(P, "z", -90 * deg, about=A),
            ),
        ],
        handles=[A],
        keep=1,
        product=B,
    )
