"""Order matters; fixed against moving axes."""

from __future__ import annotations

from dhlab.kinematics.dh import deg
from dhlab.kinematics.transforms import transl
from dhlab.lessons.lesson import Lesson
from dhlab.lessons.moves import turn
from dhlab.lessons.sequence import sequence_lesson
from dhlab.lessons.step import Choice, Place, Step
from dhlab.scene.csys import csys


def order_matters(first: float = 90 * deg, second: float = 90 * deg) -> Lesson:
    """Make a lesson: the same two turns in either order.

    Parameters
    ----------
    first : float [rad]
        Of the turn about z.
    second : float [rad]
        Of the turn about x.
    """
    left, right = transl((-1.4, 0, 0)), transl((1.4, 0, 0))
    B, C = csys(left, name="B"), csys(right, name="C")
    zeros = [csys(left, name="0", size=0.6, opacity=0.3, labels=False)]
    zeros.append(csys(right, name="0'", size=0.6, opacity=0.3, labels=False))
    return Lesson(
        "The same two turns, in either order",
        [
            Step(
                "The first turn of each",
                "$\\{B\\}$ begins with $z$, $\\{C\\}$ with $x$. Each turns about its own axis.",
                turn(B, "z", first),
                turn(C, "x", second),
            ),
            Step(
                "The second turn of each",
                "$\\{B\\}$ has turned $z$ then $x$, $\\{C\\}$ has turned $x$ then $z$:\n\n"
                "$$R_z R_x \\ne R_x R_z$$\n\nMatrices do not commute, because turns do not.",
                turn(B, "x", second),
                turn(C, "z", first),
                question=Choice(
                    "Now each makes the turn that the other one began with. Will they stand alike?",
                    ["yes: the same two turns", "no"],
                    answer=1,
                    because="The second turn goes by an axis that the first has already moved.",
                ),
            ),
            Step(
                "Back, in the reverse order",
                "To undo, take off the last one first: $(R_z R_x)^{-1} = R_x^{-1} R_z^{-1}$. Shoes "
                "and socks.",
                turn(B, "x", -second),
                turn(C, "z", -first),
            ),
        ],
        handles=zeros,
        keep=1,
        product=B,
    )


def moving_or_fixed(first: float = 90 * deg, second: float = 90 * deg) -> Lesson:
    """Make a lesson: one sentence, two readings.

    Parameters
    ----------
    first : float [rad]
        Of the turn about z.
    second : float [rad]
        Of the turn about x.
    """
    return sequence_lesson(
        [("z", first), ("x", second), (0.0, 0.0, 0.6)],
        questions=[
            None,
            Choice(
                "*Then turn about x*, says the sentence. $\\{M\\}$ takes its own $x_M$, $\\{F\\}$ "
                "the fixed $x_0$. To which side of the product $R_z$ does the factor $R_x$ go?",
                [
                    "to the right for both: it came later",
                    "to the right for $\\{M\\}$, to the left for $\\{F\\}$",
                    "to the left for both",
                ],
                answer=1,
                because="About a moving axis: $T R$. About a fixed axis: $R\\,T$.",
            ),
            Choice(
                "*Then slide 0.6 m along z.* Who goes up, along $z_0$?",
                ["both", "$\\{M\\}$", "$\\{F\\}$"],
                answer=2,
                because="$z_M$ has been laid down by the turn before; $z_0$ still points up.",
            ),
        ],
        title="One sentence, two readings",
    )


def predict_a_sequence() -> Lesson:
    """Make a lesson: put a frame where two turns will bring it."""
    A, B = csys(name="A", opacity=0.4), csys(name="B", size=0.9)
    question = Place(
        "Now $\\{B\\}$ turns by $90^\\circ$ about its *own* $z$, as it lies by now. Put the pale "
        "frame as it will stand.",
        B,
        tolerance=(0.15, 15 * deg),
    )
    return Lesson(
        "Two turns ahead",
        [
            Step(
                "Turn about y",
                "The first: $x_B$ goes down, $z_B$ comes to where $x_A$ points.",
                turn(B, "y", 90 * deg),
            ),
            Step(
                "Turn about the new z",
                "The second goes by $z_B$ as it lies now, along $x_A$: $R_y(90^\\circ)\\,"
                "R_z(90^\\circ)$.",
                turn(B, "z", 90 * deg),
                question=question,
            ),
        ],
        handles=[A],
        keep=1,
        product=B,
    )
