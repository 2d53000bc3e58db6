"""Points, frames and the right-hand rule."""

from __future__ import annotations

from numpy.typing import ArrayLike

from dhlab.kinematics.dh import deg
from dhlab.kinematics.transforms import rotz, rp2t
from dhlab.lessons.lesson import Lesson
from dhlab.lessons.moves import slide, turn
from dhlab.lessons.step import Choice, Place, Step
from dhlab.scene.block import Block
from dhlab.scene.blocks import sphere
from dhlab.scene.csys import Csys, csys

POINT = "#d55e00"
OTHER = "#0072b2"


def point(name: str, at: ArrayLike, color: str = POINT) -> Block:
    """Make a point that can be seen: a small sphere.

    Examples
    --------
    >>> point("P", (1, 2, 3)).pose[:3, 3]
    array([1., 2., 3.])
    """
    return sphere(0.055, name=name, color=color, edges=False).move(at)


def two_frames() -> tuple[Csys, Csys]:
    """Make frame {A}, and {B} that stands at (1, 0, 0) in {A} and is turned by 90 degrees."""
    return csys(name="A"), csys(rp2t(rotz(90 * deg), (1, 0, 0)), name="B", size=0.8)


def one_point_two_frames() -> Lesson:
    """Make a lesson: one point has other coordinates in another frame."""
    A, B = two_frames()
    P, Q = point("P", (0, 0, 0)), point("Q", (1, 0, 0), OTHER)
    return Lesson(
        "One point, two frames",
        [
            Step(
                "Walk 1 along x of A",
                "The coordinates of a point are an instruction: so far along $x$, so far along "
                "$y$, so far along $z$. $P$ begins in the origin of $\\{A\\}$ and walks 1 m along "
                "$x_A$.",
                slide(P, (1, 0, 0), along=A),
            ),
            Step(
                "Then 1 along y of A",
                "1 m along $y_A$. In $\\{A\\}$ the point $P$ is $(1, 1, 0)$.",
                slide(P, (0, 1, 0), along=A),
            ),
            Step(
                "The same point from B",
                "$Q$ begins in the origin of $\\{B\\}$. It needs 1 m along $x_B$ and is there: in "
                "$\\{B\\}$ the same point is $(1, 0, 0)$. The point has not moved. What changed "
                "is the frame that it is told from.",
                slide(Q, (1, 0, 0), along=B),
                question=Choice(
                    "$P$ is $(1, 1, 0)$ in $\\{A\\}$. What are the coordinates of this point in "
                    "$\\{B\\}$?",
                    ["$(1, 1, 0)$", "$(0, 1, 0)$", "$(1, 0, 0)$"],
                    answer=2,
                    because="Coordinates belong to a point *and* a frame. Walk from the origin of "
                    "$\\{B\\}$ along the axes of $\\{B\\}$.",
                ),
            ),
            Step(
                "Never without its frame",
                "So we write the frame with the numbers: $p_A = (1, 1, 0)$ and $p_B = (1, 0, 0)$. "
                "A bare $(1, 1, 0)$ says nothing until you know whose it is.",
            ),
        ],
        handles=[A, B],
        keep=1,
    )


def place_a_frame() -> Lesson:
    """Make a lesson: put a frame where its pose says."""
    A, B = csys(name="A"), csys(name="B", size=0.8)
    return Lesson(
        "Put B where it belongs",
        [
            Step(
                "Where will B be?",
                "First the origin: 1 m along $x_A$ and 0.5 m along $z_A$. The axes did not turn, "
                "so $x_B$ is still parallel to $x_A$.",
                slide(B, (1, 0, 0.5), along=A),
                question=Place(
                    "$\\{B\\}$ slides to $(1, 0, 0.5)$ in $\\{A\\}$. Put the pale frame where it "
                    "will be.",
                    B,
                ),
            ),
            Step(
                "And after the turn?",
                "Thumb along $z_B$, and the fingers curl the way of a positive turn: $x_B$ goes "
                "to where $y_B$ was.",
                turn(B, "z", 90 * deg),
                question=Place(
                    "Now $\\{B\\}$ turns by $+90^\\circ$ about its own $z_B$. Put the pale frame "
                    "as it will stand.",
                    B,
                ),
            ),
        ],
        handles=[A],
        keep=1,
    )


def right_hand() -> Lesson:
    """Make a lesson: x and y fix z, by the right hand."""
    A = csys(name="A")
    B = csys(name="B", size=0.8).move((1.6, 0, 0))
    return Lesson(
        "The right hand",
        [
            Step(
                "Lay B down",
                "Fingers of the *right* hand from $x$ to $y$: the thumb is $z$. As $\\{B\\}$ turns "
                "about $x_B$, its $y_B$ rises, and $z_B$ must follow.",
                turn(B, "x", 90 * deg),
                question=Choice(
                    "$\\{B\\}$ turns until $y_B$ points up, where $z_A$ points. $x_B$ stays. "
                    "Where does $z_B$ point then?",
                    ["along $+y_A$", "along $-y_A$", "either will do"],
                    answer=1,
                    because="Right hand: fingers from $x$ to $y$, the thumb is $z$. Two axes leave "
                    "no choice for the third.",
                ),
            ),
            Step(
                "No turn makes it left-handed",
                "Turn $\\{B\\}$ as you like: it stays right-handed. The mirror image of a frame "
                "cannot be reached by turning, and dhlab takes no matrix of that kind for a pose.",
                turn(B, (1, 1, 1), 240 * deg),
            ),
        ],
        handles=[A],
        keep=1,
    )
