"""The four numbers of a row: axes, signs, and which of them is the variable."""

from __future__ import annotations

from dhlab.kinematics.dh import deg, dh
from dhlab.kinematics.transforms import rotx, rp2t, transl
from dhlab.lessons.lesson import Lesson
from dhlab.lessons.moves import configure, slide, turn
from dhlab.lessons.step import Choice, Place, Step
from dhlab.scene.blocks import cylinder
from dhlab.scene.csys import csys
from dhlab.scene.robots import robot


def which_axis(
    alpha: float = 90 * deg, a: float = 1.0, theta: float = 60 * deg, d: float = 0.7
) -> Lesson:
    """Make a lesson: alpha and a go by x, theta and d by z.

    Parameters
    ----------
    alpha, theta : float [rad]
    a, d : float [m]
        One row of a table, modified convention.
    """
    A, F = csys(name="A", opacity=0.4), csys(name="F", size=0.8)
    return Lesson(
        "Which axis for which number?",
        [
            Step(
                "Twist",
                "$\\alpha$ turns about $x$. A twist changes where $z$ points, so it cannot be a "
                "turn about $z$.",
                turn(F, "x", alpha, label="α"),
                question=Choice(
                    "The twist $\\alpha_{i-1}$ says how the next joint axis, $z$, is tilted "
                    "against this one. About which axis is it measured?",
                    ["about $x$", "about $y$", "about $z$"],
                    answer=0,
                    because="$z$ is what the twist moves; it is measured about $x$, the common "
                    "normal of the two axes.",
                ),
            ),
            Step(
                "Length",
                "$a$ is measured along the same $x$: the length of the common normal. Twist and "
                "length make one screw about $x$.",
                slide(F, (a, 0, 0), label="a"),
                question=Choice(
                    "And the length $a_{i-1}$: along which axis of $\\{F\\}$ does it slide?",
                    ["along $x$", "along $z$: that is where the joint is"],
                    answer=0,
                    because="The shortest way from one axis to the next is their common normal, "
                    "and $x$ lies in it.",
                ),
            ),
            Step(
                "Angle",
                "$\\theta$ turns about $z$, the joint's own axis. For a revolute joint it is the "
                "variable.",
                turn(F, "z", theta, label="θ"),
            ),
            Step(
                "Offset",
                "$d$ slides along the same $z$. Angle and offset make one screw about $z$: a row "
                "is *screw about x, then screw about z*, and nothing ever goes by $y$.",
                slide(F, (0, 0, d), label="d"),
                question=Place(
                    f"The last of the four: $\\{{F\\}}$ slides by $d = {d:.4g}$ m. Put the pale "
                    "frame where it will stand.",
                    F,
                ),
            ),
        ],
        handles=[A],
        keep=3,
        product=F,
    )


def sign_of_twist(twist: float = 90 * deg) -> Lesson:
    """Make a lesson: a twist of the wrong sign misses the joint.

    Parameters
    ----------
    twist : float [rad]
    """
    tilted = rp2t(rotx(twist), (1.0, 0, 0))
    pin = cylinder(0.05, 1.2, name="next axis", color="#7f7f8c", opacity=0.6).move(
        tilted @ transl((0, 0, -0.2))
    )
    A = csys(name="A", opacity=0.4)
    plus, minus = csys(name="plus", size=0.7), csys(name="minus", size=0.7)
    return Lesson(
        "The sign of the twist",
        [
            Step(
                "Both slide to the next axis",
                "The grey pin is the axis of the next joint. It points the way its free end "
                "shows. Both frames go to its foot.",
                slide(plus, (1, 0, 0)),
                slide(minus, (1, 0, 0)),
            ),
            Step(
                "Turn, with either sign",
                "Right hand, thumb along $+x$: $z$ goes towards $-y$. `plus` has its $z$ along "
                "the pin, `minus` against it. With the wrong sign the joint turns the wrong way "
                "round, and every later row hangs off a flipped frame.",
                turn(plus, "x", twist),
                turn(minus, "x", -twist),
                question=Choice(
                    "$\\alpha = +90^\\circ$ or $-90^\\circ$: which turns $z$ into the direction "
                    "of the pin, foot to free end?",
                    ["$+90^\\circ$", "$-90^\\circ$", "either: an axis has no direction"],
                    answer=0,
                    because="Thumb of the right hand along $x$: the fingers curl from $y$ to $z$, "
                    "and carry $z$ to $-y$.",
                ),
            ),
        ],
        handles=[A, pin],
        keep=1,
        product=plus,
    )


def prismatic() -> Lesson:
    """Make a lesson: of a prismatic joint d is the variable and theta a constant."""
    rows = [dh(0, 0, 0.4, 0), dh(-90 * deg, 0, 0, 0), dh(90 * deg, 0, 0.3, 0)]
    limits = [(-180 * deg, 180 * deg), (-120 * deg, 120 * deg), (0.3, 0.9)]
    arm = robot(rows, "rrp", name="arm", limits=limits, radius=0.06, frame_size=0.25)
    arm.set(q=[0, 40 * deg, 0.3], show_csys=True)
    return Lesson(
        "A joint that slides",
        [
            Step(
                "Joint 1 turns",
                "Joints 1 and 2 are revolute: their variable is $\\theta$.",
                configure(arm, [50 * deg, 40 * deg, 0.3]),
            ),
            Step(
                "Joint 3 slides",
                "Joint 3 is prismatic: its variable is $d_3$, the slide along $z_3$, and "
                "$\\theta_3$ is a constant of the table. The letters of this arm are `rrp`. "
                "dhlab takes limits for it in metres.",
                configure(arm, [50 * deg, 40 * deg, 0.9]),
                question=Choice(
                    "The third joint is a telescope. Which number of its row moves?",
                    ["$\\theta_3$", "$d_3$", "$a_2$: the arm gets longer"],
                    answer=1,
                    because="It slides along its own joint axis, and along $z$ there is $d$.",
                ),
            ),
            Step(
                "And all of them",
                "Three numbers move this arm: two in radians, one in metres.",
                configure(arm, [-40 * deg, 70 * deg, 0.5]),
            ),
        ],
        handles=[arm],
    )
