"""Two conventions: one table, two readings; shifted subscripts; the order of columns."""

from __future__ import annotations

from dhlab.kinematics.dh import deg
from dhlab.kinematics.transforms import transl
from dhlab.lessons.lesson import Lesson
from dhlab.lessons.moves import Move, slide, turn
from dhlab.lessons.step import Choice, Step
from dhlab.scene.csys import Csys, csys

ROW = (90 * deg, 0.8, 0.5, 40 * deg)


def modified_moves(F: Csys, alpha: float, a: float, d: float, theta: float) -> list[Move]:
    """Moves of a row in the modified convention, in order."""
    return [
        turn(F, "x", alpha, label="α"),
        slide(F, (a, 0, 0), label="a"),
        turn(F, "z", theta, label="θ"),
        slide(F, (0, 0, d), label="d"),
    ]


def standard_moves(F: Csys, alpha: float, a: float, d: float, theta: float) -> list[Move]:
    """Moves of a row in the standard convention, in order."""
    return [
        turn(F, "z", theta, label="θ"),
        slide(F, (0, 0, d), label="d"),
        slide(F, (a, 0, 0), label="a"),
        turn(F, "x", alpha, label="α"),
    ]


def one_table_two_readings(
    alpha: float = ROW[0], a: float = ROW[1], d: float = ROW[2], theta: float = ROW[3]
) -> Lesson:
    """Make a lesson: the same four numbers in either convention.

    Parameters
    ----------
    alpha, theta : float [rad]
    a, d : float [m]
        One row.
    """
    left, right = transl((-1.3, 0, 0)), transl((1.3, 0, 0))
    M, S = csys(left, name="M", size=0.7), csys(right, name="S", size=0.7)
    zeros = [
        csys(left, name="0", size=0.5, opacity=0.3, labels=False),
        csys(right, name="0'", size=0.5, opacity=0.3, labels=False),
    ]
    row = (alpha, a, d, theta)
    pairs = list(zip(modified_moves(M, *row), standard_moves(S, *row), strict=True))
    question = Choice(
        "$\\{M\\}$ reads the row in the modified convention, $\\{S\\}$ in the standard one. The "
        "numbers are the same. Will they end alike?",
        ["yes: the same numbers", "only if $\\alpha$ and $a$, or $\\theta$ and $d$, are 0"],
        answer=1,
        because="$R_x D_x R_z D_z$ is not $R_z D_z D_x R_x$: order matters.",
    )
    texts = [
        (
            "The first number",
            "Modified begins with the link: twist. Standard begins with the joint: angle.",
        ),
        ("The second number", "Modified: length, along $x$. Standard: offset, along $z$."),
        (
            "The third number",
            "Modified: angle, about the joint's $z$. Standard: length, along "
            "the $x$ that has turned.",
        ),
        (
            "The fourth number",
            "Modified: offset. Standard: twist. One row, two frames:\n\n"
            "$$\\text{modified } R_x(\\alpha) D_x(a) R_z(\\theta) D_z(d) \\qquad \\text{standard } "
            "R_z(\\theta) D_z(d) D_x(a) R_x(\\alpha)$$\n\nA table without the name of its "
            "convention is half a table.",
        ),
    ]
    steps = [
        Step(title, text, *pair, question=question if k == 3 else None)
        for k, ((title, text), pair) in enumerate(zip(texts, pairs, strict=True))
    ]
    return Lesson("One row, two readings", steps, handles=zeros, keep=3, product=M)


def whose_link() -> Lesson:
    """Make a lesson: in the modified convention alpha and a belong to the link before."""
    F, G = csys(name="F", size=0.7), csys(transl((0, -1.8, 0)), name="G", size=0.7)
    zeros = [
        csys(name="0", size=0.5, opacity=0.3, labels=False),
        csys(transl((0, -1.8, 0)), name="0'", size=0.5, opacity=0.3, labels=False),
    ]
    return Lesson(
        "Whose link is it?",
        [
            Step(
                "Row 1",
                "A modified row $i$ holds $\\alpha_{i-1}, a_{i-1}$ of the link *before* and "
                "$\\theta_i, d_i$ of the joint. Row 1: link 0 has no length, joint 1 turns by "
                "$40^\\circ$. $\\{G\\}$ has taken the length of link 1, 0.9 m, into row 1.",
                turn(F, "z", 40 * deg, label="θ₁"),
                slide(G, (0.9, 0, 0), label="a₁?"),
            ),
            Step(
                "Row 2, first half",
                "Link 1 comes with row 2, *after* joint 1 has turned: $\\{F\\}$ slides along the "
                "turned $x_1$. $\\{G\\}$ slid before it turned: its elbow does not move with "
                "joint 1 at all.",
                slide(F, (0.9, 0, 0), label="a₁"),
                turn(G, "z", 40 * deg, label="θ₁"),
                question=Choice(
                    "Link 1 lies between joints 1 and 2, and is 0.9 m long. In which row of a "
                    "*modified* table does the 0.9 stand?",
                    ["row 1", "row 2"],
                    answer=1,
                    because="Row 2 holds $a_1$: its subscript is $i-1$. In a standard table it "
                    "would be row 1, behind the joint.",
                ),
            ),
        ],
        handles=zeros,
        keep=2,
        product=F,
    )


def column_order() -> Lesson:
    """Make a lesson: the columns of a table have no order that everybody keeps."""
    left, right = transl((-1.0, 0, 0)), transl((1.0, 0, 0))
    F, G = csys(left, name="F", size=0.6), csys(right, name="G", size=0.6)
    zeros = [
        csys(left, name="0", size=0.5, opacity=0.3, labels=False),
        csys(right, name="0'", size=0.5, opacity=0.3, labels=False),
    ]
    right_row = modified_moves(F, 0.5, 0.9, 0.3, 0.7)
    wrong_row = modified_moves(G, 0.7, 0.3, 0.9, 0.5)
    question = Choice(
        "A row reads 0.5, 0.9, 0.3, 0.7. Which column is which?",
        ["$\\alpha, a, d, \\theta$: always", "it depends on the book and the program"],
        answer=1,
        because="dhlab and the paper write `dh(alpha, a, d, theta)`, others $\\theta, d, a, "
        "\\alpha$ or $a, \\alpha, d, \\theta$. Read the heads of the columns.",
    )
    steps = [
        Step(
            "x, by the first two",
            "$\\{F\\}$ reads $\\alpha, a, d, \\theta$; $\\{G\\}$ reads "
            "the same row as $\\theta, d, a, \\alpha$.",
            right_row[0],
            wrong_row[0],
        ),
        Step(
            "x, the length",
            "Lengths and angles look alike in a table: nothing warns.",
            right_row[1],
            wrong_row[1],
        ),
        Step(
            "z, the angle",
            "Two different mechanisms grow out of one row of numbers.",
            right_row[2],
            wrong_row[2],
            question=question,
        ),
        Step(
            "z, the offset",
            "Check a column with a joint that you know: a length that comes "
            "out as an angle is the first sign.",
            right_row[3],
            wrong_row[3],
        ),
    ]
    return Lesson("Which column is which?", steps, handles=zeros, keep=3, product=F)
