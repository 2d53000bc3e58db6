"""Lessons: coordinate systems, blocks and robots that move step by step, with words and questions.

A `Lesson` is a title and ordered steps. A `Step` has a title, an explanation (Markdown with LaTeX),
what moves and relative to which frame, and perhaps a question that is asked before it is shown::

    from dhlab import csys, deg
    from dhlab.lessons import Choice, Lesson, Step, slide, turn

    A, B = csys(name="A"), csys(name="B")
    lesson = Lesson("Turn, then slide", [
        Step("Turn", "$B$ turns about its own $z_B$.", turn(B, "z", 90 * deg)),
        Step("Slide", "It slides along the axis it has *now*.", slide(B, (1, 0, 0)),
             question=Choice("Where to?", ["along $x_A$", "along $y_A$"], answer=1)),
    ], handles=[A])

A cell that ends in ``lesson`` shows it. `Lesson.go` shows any step; a page goes through the steps
by itself, for all of them are sent ahead. `sequence_lesson` and `dh_lesson` make lessons from a
list of turns and slides and from the table of any robot.
"""

from dhlab.lessons.dh_steps import dh_lesson
from dhlab.lessons.lesson import Lesson
from dhlab.lessons.moves import (
    Configure,
    Move,
    MoveTo,
    Slide,
    Turn,
    configure,
    move_to,
    slide,
    turn,
)
from dhlab.lessons.sequence import sequence_lesson
from dhlab.lessons.step import Choice, Place, Step

__all__ = [
    "Choice",
    "Configure",
    "Lesson",
    "Move",
    "MoveTo",
    "Place",
    "Slide",
    "Step",
    "Turn",
    "configure",
    "dh_lesson",
    "move_to",
    "sequence_lesson",
    "slide",
    "turn",
]
