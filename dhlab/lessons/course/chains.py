"""From link to link: a chain by hand, and its zero pose."""

from __future__ import annotations

import numpy as np

from dhlab.kinematics.dh import deg, dh
from dhlab.kinematics.transforms import transl
from dhlab.lessons.lesson import Lesson
from dhlab.lessons.moves import configure, slide, turn
from dhlab.lessons.step import Choice, Step
from dhlab.scene.csys import csys
from dhlab.scene.robot import Robot
from dhlab.scene.robots import robot

UPPER, FORE = 1.0, 0.8
PALE = 0.35


def planar_arm(name: str = "arm", second: float = 0.0) -> Robot:
    """Make a planar arm of two links, 1.0 and 0.8 m long.

    Parameters
    ----------
    name : str
    second : float [rad]
        Offset of the second joint: what the link stands at when the variable is 0.

    Examples
    --------
    >>> planar_arm().frames([0, 0])["arm/grasper"][:3, 3].round(4)
    array([1.8, 0. , 0. ])
    """
    rows = [dh(0, 0, 0, 0), dh(0, UPPER, 0, 0)]
    return robot(rows, "rr", name=name, grasper=(FORE, 0, 0), offset=[0, second], radius=0.06)


def chain_by_hand(first: float = 40 * deg, second: float = 50 * deg) -> Lesson:
    """Make a lesson: a frame carried along a planar arm, turn by slide by turn.

    Parameters
    ----------
    first, second : float [rad]
        Angles of the joints.
    """
    arm = planar_arm().set(q=[first, second], opacity=PALE)
    A, F = csys(name="A", size=0.5, opacity=0.5), csys(name="F", size=0.45)
    told = [f"{np.degrees(x):.4g}^\\circ" for x in (first, second)]
    return Lesson(
        "A chain by hand",
        [
            Step(
                "Turn with joint 1",
                f"$\\{{F\\}}$ begins in the shoulder, as $\\{{A\\}}$ stands. Joint 1 turns it by "
                f"$\\theta_1 = {told[0]}$: now $x_F$ lies along the upper arm.",
                turn(F, "z", first, label=f"θ₁ = {np.degrees(first):.4g}°"),
            ),
            Step(
                "Slide along the upper arm",
                f"{UPPER} m along its own $x_F$, and $\\{{F\\}}$ is in the elbow.",
                slide(F, (UPPER, 0, 0), label=f"{UPPER} m"),
            ),
            Step(
                "Turn with joint 2",
                f"$\\theta_2 = {told[1]}$ is the angle *between* the links, not the angle of the "
                "forearm to the ground. Turning about the frame's own axis takes care of that.",
                turn(F, "z", second, label=f"θ₂ = {np.degrees(second):.4g}°"),
                question=Choice(
                    "The forearm's direction in $\\{A\\}$ is an angle from $x_A$. Which?",
                    ["$\\theta_2$", "$\\theta_1 + \\theta_2$", "$\\theta_1 - \\theta_2$"],
                    answer=1,
                    because="Joint 2 turns what joint 1 has turned already.",
                ),
            ),
            Step(
                "Slide along the forearm",
                "And $\\{F\\}$ is at the tip. The chain is the product of what was done, left "
                "to right:\n\n"
                "$$T = R_z(\\theta_1)\\, D_x(l_1)\\, R_z(\\theta_2)\\, D_x(l_2)$$",
                slide(F, (FORE, 0, 0), label=f"{FORE} m"),
            ),
        ],
        handles=[arm, A],
        keep=3,
        product=F,
    )


def zero_pose_is_a_choice() -> Lesson:
    """Make a lesson: the same arm with two zero poses, and how to go from one q to the other."""
    straight = planar_arm("straight").set(color="#0072b2")
    bent = planar_arm("bent", 90 * deg).set(color="#e69f00", base=transl((0, -1.4, 0)))
    pose = [30 * deg, 60 * deg]
    return Lesson(
        "Zero is a choice",
        [
            Step(
                "Both at zero",
                "Two makers built the same arm: the same links, the same joints. Both say "
                "$q = (0, 0)$. One calls the straight arm zero, the other the bent one.",
                configure(straight, [0, 0]),
                configure(bent, [0, 0]),
            ),
            Step(
                "The same shape, other numbers",
                "To stand like the straight one at $q_2 = 60^\\circ$, the bent one needs $q_2 = "
                "60^\\circ - 90^\\circ = -30^\\circ$. Its offset of $90^\\circ$ is added before "
                "the number goes into the table: $\\theta_2 = q_2 + 90^\\circ$.",
                configure(straight, pose),
                configure(bent, [pose[0], pose[1] - 90 * deg]),
                question=Choice(
                    "`straight` goes to $q = (30^\\circ, 60^\\circ)$. Which $q_2$ gives `bent` "
                    "the same shape?",
                    ["$60^\\circ$: they are the same arm", "$-30^\\circ$", "$150^\\circ$"],
                    answer=1,
                    because="$\\theta_2 = q_2 + 90^\\circ$ must be $60^\\circ$.",
                ),
            ),
            Step(
                "Whose zero?",
                "Zero is not a fact of the metal. It is a choice of whoever wrote the table: ask "
                "for the zero pose before you send numbers to an arm.",
            ),
        ],
        handles=[straight, bent],
    )
