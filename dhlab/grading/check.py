"""The check cell of a notebook: right or wrong at once, and why."""

import base64
import json
import re
import zlib
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from dhlab.errors import DhlabError, InputError
from dhlab.grading.exercise import Exercise, Given, exercise_from_text, load_exercise
from dhlab.grading.judge import judge
from dhlab.grading.question import Question
from dhlab.grading.said import Said
from dhlab.grading.tried import call_text, drawn_or_said, right_alone, values_of
from dhlab.scene.handle import Handle

NO_NUMBERS = "Run the cell with `given = check.numbers(STUDENT)` first: it makes your own numbers."
NOBODY = "STUDENT is still empty: write your name there, so that the numbers are yours."
FIRST = 400
"""Characters of packed checks, a multiple of 4, among which the name of the exercise is."""
MORE = "When it is marked, further cases are tried."


class NotRight(DhlabError, AssertionError):
    """An answer is not right; only a check that was told to raise raises it."""


class Check:
    """The checks of one exercise, as a notebook has them; made by `checks`.

    Parameters
    ----------
    exercise : Exercise
    course : str
        Part of the seed of each student's own numbers.
    raises : bool
        Whether a wrong answer raises.
    """

    def __init__(self, exercise: Exercise, course: str = "", raises: bool = False) -> None:
        self._exercise = exercise
        self._course = course
        self._raises = raises
        self._given: Given | None = None if exercise.is_personal else {}
        self._is_nobody = False

    @property
    def questions(self) -> tuple[Question, ...]:
        """The questions, with the numbers asked for last."""
        if self._given is None:
            raise InputError(NO_NUMBERS.replace("`", ""))
        return self._exercise.questions(self._given)

    def numbers(self, student: str) -> Given:
        """Return the student's own numbers, and check with them from now on.

        Parameters
        ----------
        student : str

        Raises
        ------
        InputError
            The student is no text.
        """
        if not isinstance(student, str):
            raise InputError(f'STUDENT must be text such as "Ada Lovelace", got {student!r}')
        self._is_nobody = not student.strip()
        self._given = self._exercise.numbers(student, self._course)
        return dict(self._given)

    def __call__(
        self, name: str, answer: Any, *, raises: bool | None = None, seed: int | None = None
    ) -> Said:
        """Say whether an answer is right, and if it is not, what it suggests.

        Parameters
        ----------
        name : str
            Of the question.
        answer : object
            The function or the value itself.
        raises : bool, optional
            Whether to raise if it is not right, for graders that go by exceptions; as `checks`
            was told if not given.
        seed : int, optional
            Try the further cases of the question too, drawn from this seed, as marking does.

        Returns
        -------
        said : Said
            A cell that ends in it shows it.

        Raises
        ------
        NotRight
            The answer is not right, and `raises` is true.
        """
        said = self._said(name, answer, seed)
        if not said.right and (self._raises if raises is None else raises):
            raise NotRight(repr(said))
        return said

    def show(self, drawing: Callable[..., Any], *answers: Any) -> Any:
        """Draw answers, or say why there is nothing to draw yet; it never raises.

        Parameters
        ----------
        drawing : callable
            From the answers to what the cell shows.
        *answers : objects
        """
        return drawn_or_said(drawing, answers)

    def picture(self, name: str) -> tuple[Handle, ...]:
        """Return what a picture of the exercise shows, to be added to a view.

        Parameters
        ----------
        name : str

        Raises
        ------
        InputError
            There is no such picture, or there are no numbers yet.
        """
        if self._given is None:
            raise InputError(NO_NUMBERS.replace("`", ""))
        return self._exercise.picture(name, self._given)

    def __repr__(self) -> str:
        return f"the checks of exercise {self._exercise.name!r}"

    def _said(self, name: str, answer: Any, seed: int | None) -> Said:
        if self._given is None:
            return Said(None, f"{name}: not checked", NO_NUMBERS)
        questions = {q.name: q for q in self.questions}
        if name not in questions:
            there = ", ".join(questions)
            return Said(None, f"there is no question {name!r}", f"The questions are: {there}.")
        said = self._of(questions[name], answer, seed)
        return replace(said, note=f"{said.note} {NOBODY}".strip()) if self._is_nobody else said

    def _of(self, question: Question, answer: Any, seed: int | None) -> Said:
        further = seed is not None and question.inputs is not None
        asked = question.cases()
        if further:
            asked = self._exercise.cases(question, np.random.default_rng(seed))
        cases = values_of(question, answer, asked)
        judged = judge(question, cases)
        if judged.reason == "stub":
            return Said(None, f"{question.name}: still to be written", judged.text)
        head = f"{question.name}: {'right' if judged.right else 'not right yet'}"
        shown = cases[: len(question.examples)] if question.is_function else []
        tried = [(call_text(question.name, a), right_alone(question, a, v)) for a, v in shown]
        note = MORE if judged.right and question.inputs and not further else ""
        return Said(judged.right, head, judged.text.removeprefix("Right.").strip(), tried, note)


def checks(text: str | None = None, *, course: str = "", raises: bool = False) -> Check:
    """Make the check of a notebook: ``check("rot_z", rot_z)`` says if it is right, and why not.

    In a released notebook all checks of the exercise stand in the call itself, as compressed text,
    so that they need no file and no network.

    Graders that go by exceptions, such as nbgrader and otter, can use it too: a cell with
    ``check("rot_z", rot_z, raises=True)`` raises `NotRight`, an AssertionError with the same
    sentences, unless the answer is right; ``checks(..., raises=True)`` makes every check do so.
    With ``seed=7`` it also tries the further cases that the student does not see.

    Parameters
    ----------
    text : str, optional
        From `dhlab exercise build`; without it `checks.py` of the working folder is read, which
        is for those who write the exercise.
    course : str
        Part of the seed of each student's own numbers.
    raises : bool
        Whether wrong answers raise.

    Returns
    -------
    check : Check

    Raises
    ------
    DhlabError
        The text is damaged, or the checks have an error.

    Examples
    --------
    >>> from dhlab.grading.exercise import exercise_from_text
    >>> source = '''
    ... from dhlab.diagnosis import MatrixTask, turn
    ... from dhlab.grading import Question
    ... def questions(given):
    ...     return [Question("R", MatrixTask(turn("z", 0.3), size=3))]
    ... '''
    >>> check = checks(packed(exercise_from_text(source, "turns")))
    >>> from dhlab import rotz
    >>> check("R", rotz(0.3))
    ✓ R: right
    >>> check("R", rotz(-0.3), raises=True)
    Traceback (most recent call last):
    ...
    dhlab.grading.check.NotRight: ✗ R: not right yet
    The frame is turned away from the wanted one by 34.4 degrees about the fixed z axis. This is
    exactly what you get when
    either the turn about z goes the wrong way round, or the inverse (for a rotation: the transpose)
    is given. Point your right thumb along the axis: which way do the fingers curl? Which frame does
    the matrix describe, and in which frame are its columns written?
    """
    if text is None:
        return Check(load_exercise(Path()), course, raises)
    name, source = opened(text)
    return Check(exercise_from_text(source, name, f"checks of {name}"), course, raises)


def packed(exercise: Exercise) -> str:
    """Put an exercise into text that a notebook can hold."""
    content = json.dumps([exercise.name, exercise.text], ensure_ascii=False)
    return base64.b64encode(zlib.compress(content.encode("utf-8"), 9)).decode("ascii")


def name_in(text: str) -> str:
    """Return the name of the exercise in what `packed` gives; no more of it is unpacked.

    Parameters
    ----------
    text : str
        Whatever it is; where it holds no name, the name is empty.

    Examples
    --------
    >>> name_in(packed(exercise_from_text("questions = list", "turns"))), name_in("eNq")
    ('turns', '')
    """
    try:
        packed = base64.b64decode(text[:FIRST], validate=True)
        content = zlib.decompressobj().decompress(packed, FIRST).decode("utf-8", "replace")
    except (ValueError, zlib.error):
        return ""
    found = re.match(r"""\["([\w .+-]{1,80})", """, content)
    return found[1] if found else ""


def opened(text: str) -> tuple[str, str]:
    """Take name and `checks.py` of an exercise out of what `packed` gives.

    Raises
    ------
    DhlabError
        The text is damaged.
    """
    try:
        content = zlib.decompress(base64.b64decode(text, validate=True)).decode("utf-8")
        name, source = json.loads(content)
    except (ValueError, TypeError, zlib.error):
        raise DhlabError(
            "the text of the checks is damaged; copy that cell from a fresh copy of the notebook"
        ) from None
    return str(name), str(source)
