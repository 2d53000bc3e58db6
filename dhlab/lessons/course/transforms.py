"""Homogeneous transforms: names that cancel, inverses, detours."""

from __future__ import annotations

from dhlab.kinematics.dh import deg
from dhlab.kinematics.transforms import inverse, rotz, rp2t
from dhlab.lessons.course.frames import OTHER, point
from dhlab.lessons.lesson import Lesson
from dhlab.lessons.moves import move_to, slide, turn
from dhlab.lessons.step import Choice, Step
from dhlab.scene.csys import csys

T_AB = rp2t(rotz(60 * deg), (1.4, 0.4, 0))
T_AC = rp2t(rotz(-30 * deg), (0.4, 1.6, 0.3))


def from_a_to_b() -> Lesson:
    """Make a lesson: T_AB moves A onto B, and takes points told in B to A."""
    A, B, F = csys(name="A"), csys(T_AB, name="B"), csys(name="F", size=0.7)
    P = point("P", (T_AB @ (0.7, 0.5, 0, 1))[:3])
    Q = point("Q", T_AB[:3, 3], OTHER)
    return Lesson(
        "What T_AB does",
        [
            Step(
                "It moves A onto B",
                "$T_{AB}$ is the pose of $\\{B\\}$ in $\\{A\\}$. As a motion: slide to the origin "
                "of $\\{B\\}$ ...",
                slide(F, T_AB[:3, 3], label="p"),
            ),
            Step(
                "... and turns it",
                "... and turn: $T_{AB}$ brings the frame $\\{A\\}$ onto $\\{B\\}$.",
                turn(F, "z", 60 * deg),
            ),
            Step(
                "It tells points of B in A",
                "Now read it as a translation of words: $p_A = T_{AB}\\, p_B$. The point $P$ is "
                "$(0.7, 0.5, 0)$ for $\\{B\\}$, and $T_{AB}$ says what $\\{A\\}$ calls it. The "
                "inner names cancel: $_{A}T_{B}\\;p_{B}$. $Q$ walks the numbers that $\\{B\\}$ "
                "knows, and is there.",
                slide(Q, (0.7, 0.5, 0), along=B),
                question=Choice(
                    "You know $P$ in $\\{B\\}$ and want it in $\\{A\\}$. $T_{AB}$ is the pose of "
                    "$\\{B\\}$ in $\\{A\\}$. Which product?",
                    ["$p_A = T_{AB}\\, p_B$", "$p_A = T_{AB}^{-1}\\, p_B$"],
                    answer=0,
                    because="The names next to each other must agree: $AB \\cdot B$ leaves $A$.",
                ),
            ),
            Step(
                "The way back",
                "The inverse moves $\\{B\\}$ onto $\\{A\\}$, seen from $\\{B\\}$: $T_{BA} = "
                "T_{AB}^{-1}$. It is *not* the negative shift alone: the shift has to be turned "
                "too, $-R^T p$.",
                move_to(F, (0, 0, 0)),
            ),
        ],
        handles=[A, B, P],
        keep=1,
        product=F,
    )


def detour() -> Lesson:
    """Make a lesson: a pose by way of a third frame."""
    A, B, C = csys(name="A"), csys(T_AB, name="B"), csys(T_AC, name="C")
    F = csys(T_AB, name="F", size=0.6)
    T_BA = inverse(T_AB)
    return Lesson(
        "The detour through a third frame",
        [
            Step(
                "Which product is T_BC?",
                "A camera in $\\{A\\}$ has measured both: $T_{AB}$ and $T_{AC}$. How does "
                "$\\{C\\}$ stand in $\\{B\\}$? Go from $\\{B\\}$ back to $\\{A\\}$ first: that is "
                "$T_{BA} = T_{AB}^{-1}$.",
                move_to(F, T_AB @ T_BA),
                question=Choice(
                    "$T_{AB}$ and $T_{AC}$ are known. What is $T_{BC}$, the pose of $\\{C\\}$ in "
                    "$\\{B\\}$?",
                    [
                        "$T_{AB}\\, T_{AC}$",
                        "$T_{AB}^{-1}\\, T_{AC}$",
                        "$T_{AC}\\, T_{AB}^{-1}$",
                    ],
                    answer=1,
                    because="$T_{BC} = T_{BA}\\, T_{AC}$: the inner names cancel. And $T_{BA}$ is "
                    "the inverse of $T_{AB}$.",
                ),
            ),
            Step(
                "And on to C",
                "From $\\{A\\}$ on to $\\{C\\}$ with $T_{AC}$. Together: $T_{BC} = T_{AB}^{-1}\\, "
                "T_{AC}$.",
                move_to(F, T_AC),
            ),
        ],
        handles=[A, B, C],
        keep=1,
        product=F,
    )
