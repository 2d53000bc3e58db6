"""From what came for a question to points and a sentence, in the notebook and when it is marked."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from dhlab.grading.asked import NoValue
from dhlab.grading.inside.plain import LINE
from dhlab.grading.question import Question

RIGHT, WRONG, UNJUDGED = "right", "wrong", "not judged"
CANNOT, ASK_INSTRUCTOR = "This answer could not be judged", "Please tell your instructor."
SENTENCES = {
    "missing": "There is no `{name}` in this notebook.",
    "no function": "`{name}` is a value: a function of this name is asked for.",
    "stub": "Nothing is there yet.",
    "raised": "`{name}` raised an error.",
    "too slow": "`{name}` took too long: is there a loop that never ends?",
    "too much memory": "`{name}` needed too much memory: does something grow in a loop?",
    "too large": "`{name}` is far too large: what shape is asked for?",
    "not numbers": "`{name}` is not made of numbers.",
    "ended": "`{name}` ended the whole program: is there an exit in it?",
}

NUMBER = re.compile(r"(?<!\w)[-+]?(?:\d[\d_]*\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")

HANDLES = {
    "robot": "a robot",
    "csys": "a coordinate system",
    "scene": "a view or a list of handles",
}


@dataclass(frozen=True)
class Judged:
    """What is said of the answer to one question.

    Attributes
    ----------
    name : str
        Of the question.
    points, out_of : float
    right : bool
    reason : str
        In a word: 'right', 'wrong', why there is no value ('missing', 'stub', 'raised', ...), or
        'not judged' where the exercise itself has an error.
    text : str
        For the student; never the numbers expected.
    mistakes : tuple of str
        Keys of the mistakes that explain the answer; of alternatives all of them.
    """

    name: str
    points: float
    out_of: float
    right: bool
    reason: str
    text: str
    mistakes: tuple[str, ...] = ()


def judge(question: Question, cases: Sequence[tuple[tuple[Any, ...], Any]]) -> Judged:
    """Judge the answer to a question; no value that comes makes it raise.

    Parameters
    ----------
    question : Question
    cases : sequence of (arguments, value)
        What came for each case: a plain value, or a `NoValue` that says why there is none.

    Returns
    -------
    judged : Judged

    Examples
    --------
    >>> from dhlab.diagnosis import MatrixTask, turn
    >>> from dhlab.kinematics.transforms import rotz
    >>> question = Question("R", MatrixTask(turn("z", 0.3), size=3), points=2)
    >>> judge(question, [((), rotz(0.3))])
    Judged(name='R', points=2, out_of=2, right=True, reason='right', text='Right.', mistakes=())
    >>> judge(question, [((), rotz(-0.3))]).mistakes
    ('sign-1', 'inverse')
    """
    for k, (_, value) in enumerate(cases):
        if isinstance(value, NoValue):
            is_further = k >= len(question.examples)
            return _zero(question, value.reason, _without_value(question, value, is_further))
    try:
        verdict = question.task.judge(cases)
    except Exception as error:
        what = f"{type(error).__name__}: {error}"[:200]
        return _zero(question, UNJUDGED, f"{CANNOT} ({what}). {ASK_INSTRUCTOR}")
    if verdict.right:
        text = f"Right. {verdict.text}".rstrip()
        return Judged(question.name, question.points, question.points, True, RIGHT, text)
    keys = tuple(dict.fromkeys(m.key for m in verdict.mistakes))
    return _zero(question, WRONG, verdict.text or "This is not what is asked for.", keys)


def _zero(question: Question, reason: str, text: str, mistakes: tuple[str, ...] = ()) -> Judged:
    return Judged(question.name, 0, question.points, False, reason, text, mistakes)


def _without_value(question: Question, nothing: NoValue, is_further: bool) -> str:
    """Say why there is no value; of a case that the student does not see without its numbers."""
    head = SENTENCES.get(nothing.reason, "There is no value of `{name}`.")
    if nothing.reason == "not numbers" and question.kind in HANDLES:
        head = f"`{{name}}` cannot be read: {HANDLES[question.kind]} is asked for."
    head = head.format(name=question.name)
    if nothing.reason == "stub":
        return f"{head} {question.hint}".rstrip()
    text, mark, line = nothing.text.partition(LINE)
    if is_further:
        text = NUMBER.sub("#", text)
    return f"{head} ({text}{mark}{line})" if nothing.text else head
