"""One step of a lesson: what it says, what it moves, what it asks first."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

from dhlab.arrays import as_number
from dhlab.errors import InputError
from dhlab.lessons.moves import Configure, Move, MoveTo, Slide, Turn, check_placed
from dhlab.scene.placed import Placed

STEP_SECONDS = 1.6
NOTE_SECONDS = 0.2


@dataclass(frozen=True)
class Choice:
    """A question with answers to choose from, asked before a step shows what happens.

    Parameters
    ----------
    text : str
        The question, in Markdown with LaTeX between dollars.
    choices : sequence of str
        Two or more.
    answer : int
        Place of the right one, from 0.
    because : str
        Said when it has been answered.

    Examples
    --------
    >>> Choice("Does the order matter?", ["yes", "no"], answer=0).choices
    ('yes', 'no')
    """

    text: str
    choices: Sequence[str]
    answer: int
    because: str = ""

    def __post_init__(self) -> None:
        choices = tuple(self.choices)
        if isinstance(self.choices, str) or len(choices) < 2 or len(set(choices)) < len(choices):
            raise InputError(f"a choice needs two or more different answers, got {self.choices!r}")
        if isinstance(self.answer, bool) or self.answer not in range(len(choices)):
            raise InputError(
                f"answer must be the place of the right one, 0 to {len(choices) - 1}, "
                f"got {self.answer!r}"
            )
        object.__setattr__(self, "choices", choices)


@dataclass(frozen=True, eq=False)
class Place:
    """A question answered with a csys: put it where `what` will be after the step.

    Parameters
    ----------
    text : str
        The question, in Markdown with LaTeX between dollars.
    what : Csys, Block or BlockComplex
        What the step moves.
    tolerance : (float [m], float [rad])
        How near counts as right.
    because : str
        Said when it has been answered.

    Examples
    --------
    >>> from dhlab import csys
    >>> Place("Where will it be?", csys(name="B")).tolerance
    (0.1, 0.2)
    """

    text: str
    what: Placed
    tolerance: tuple[float, float] = (0.1, 0.2)
    because: str = ""

    def __post_init__(self) -> None:
        check_placed(self.what, "place")
        near, turned = self.tolerance
        as_number(near, "tolerance of the origin", above=0)
        as_number(turned, "tolerance of the angle", above=0)


Question: TypeAlias = Choice | Place


@dataclass(frozen=True, eq=False, init=False)
class Step:
    """One step of a lesson.

    Parameters
    ----------
    title : str
    text : str
        The explanation, in Markdown with LaTeX between dollars; read when the step is there.
    *moves : Turn, Slide, MoveTo, Configure
        What happens at once; none for a step that only says something. One handle moves once.
    question : Choice or Place, optional
        Answered before the step is shown.
    seconds : float [s], optional
        How long the step plays at normal speed.
    about : mapping, optional
        More for a lesson bar to show, as plain data: the row of a table, for example.

    Examples
    --------
    >>> from dhlab import csys, deg
    >>> from dhlab.lessons import Choice, Step, turn
    >>> B = csys(name="B")
    >>> Step("A turn", "About its own axis.", turn(B, "z", 90 * deg)).words
    "'B' turns by 90° about its own z-axis."
    """

    title: str
    text: str
    moves: tuple[Move, ...]
    question: Question | None
    seconds: float
    about: dict[str, Any]

    def __init__(
        self,
        title: str,
        text: str = "",
        *moves: Move,
        question: Question | None = None,
        seconds: float | None = None,
        about: dict[str, Any] | None = None,
    ) -> None:
        for field, given in (("title", title), ("text", text)):
            if not isinstance(given, str):
                raise TypeError(f"the {field} of a step must be text, got {given!r}")
        for move in moves:
            if not isinstance(move, Turn | Slide | MoveTo | Configure):
                raise TypeError(
                    f"step {title!r} needs moves (turn, slide, move_to, configure), got {move!r}"
                )
        if question is not None and not isinstance(question, Choice | Place):
            raise TypeError(f"question of {title!r} must be a Choice or a Place, got {question!r}")
        _check_once(title, moves)
        usual = STEP_SECONDS if moves else NOTE_SECONDS
        length = as_number(usual if seconds is None else seconds, f"seconds of {title!r}", above=0)
        values: dict[str, Any] = {"title": title, "text": text, "moves": moves}
        values |= {"question": question, "seconds": length, "about": dict(about or {})}
        for name, value in values.items():
            object.__setattr__(self, name, value)

    @property
    def words(self) -> str:
        """What moves, and relative to which frame, in a sentence; empty if nothing moves."""
        return "; ".join(move.words for move in self.moves) + ("." if self.moves else "")


def _check_once(title: str, moves: Sequence[Move]) -> None:
    seen: set[object] = set()
    for move in moves:
        if move.what in seen:
            raise InputError(f"step {title!r} moves '{move.what.name}' twice; make it two steps")
        seen.add(move.what)
