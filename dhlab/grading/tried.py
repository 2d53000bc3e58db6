"""A student's answer, tried: whatever it does, what comes is a value or the reason for none."""

import copy
import linecache
import traceback
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from dhlab.grading.asked import NoValue
from dhlab.grading.inside.plain import LINE, NotPlain, tidy
from dhlab.grading.judge import judge
from dhlab.grading.printed import labelled
from dhlab.grading.question import Arguments, Question
from dhlab.grading.said import Said
from dhlab.grading.values import from_json, no_value, to_json

NOTHING = Said(None, "Nothing to draw yet", "Write your answer above and run its cell first.")


def values_of(
    question: Question, answer: Any, cases: Sequence[Arguments] | None = None
) -> list[tuple[Arguments, Any]]:
    """Try an answer with the arguments of each case; by default with the examples.

    What comes goes the way that it goes when it is marked: as plain numbers and strings. What is
    printed meanwhile stands below the call that it comes from.
    """
    arguments = question.cases() if cases is None else cases
    found = []
    for k, case in enumerate(arguments):
        is_further = k >= len(question.examples)
        call = (
            f"{question.name} in a further case" if is_further else call_text(question.name, case)
        )
        with labelled(f"{call} prints:"):
            found.append((case, _plain(question, _value(question, answer, case))))
    return found


def right_alone(question: Question, arguments: Arguments, value: Any) -> bool:
    """Whether one case is right by itself."""
    return judge(question, [(arguments, value)]).right


def examples_told(question: Question, cases: Sequence[tuple[Arguments, Any]]) -> str:
    """Say which of the examples of an answer that is right for some inputs are right.

    Parameters
    ----------
    question : Question
    cases : sequence of (arguments, value)
        Those of the examples come first; nothing is said of the others.
    """
    calls: dict[bool, list[str]] = {True: [], False: []}
    for arguments, value in cases[: len(question.examples)]:
        is_right = right_alone(question, arguments, value)
        calls[is_right].append(f"`{call_text(question.name, arguments)}`")
    if not calls[False]:
        return "Those in the notebook are all right."
    if not calls[True]:
        return "Of those in the notebook none is right."
    right, wrong = (
        f"{' and '.join(some)} {'is' if len(some) == 1 else 'are'}" for some in calls.values()
    )
    return f"Of the inputs in the notebook, {right} right, {wrong} not."


def call_text(name: str, arguments: Arguments) -> str:
    """Return how a case is called.

    Examples
    --------
    >>> call_text("rot", (0.123456, "z", [1.0, 2]))
    "rot(0.1235, 'z', [1, 2])"
    >>> call_text("inverse_pose", (np.eye(4),))
    'inverse_pose(pose at [0, 0, 0])'
    """
    return f"{name}({', '.join(_brief(a) for a in arguments)})"


def drawn_or_said(drawing: Callable[..., Any], answers: Sequence[Any]) -> Any:
    """Return what draws the answers, or a sentence where that cannot be."""
    if any(answer is ... for answer in answers):
        return NOTHING
    try:
        return drawing(*answers)
    except NotImplementedError:
        return NOTHING
    except (Exception, SystemExit) as error:
        return Said(None, "This cannot be drawn yet", _told(error))


def _value(question: Question, answer: Any, arguments: Arguments) -> Any:
    if answer is ...:
        return NoValue("stub", "")
    if not question.is_function:
        return answer
    if not callable(answer):
        return NoValue("no function", "")
    try:
        value = answer(*copy.deepcopy(arguments))
    except NotImplementedError:
        return NoValue("stub", "")
    except (Exception, SystemExit) as error:
        return NoValue("raised", _told(error, answer))
    return NoValue("stub", "") if value is ... else value


def _plain(question: Question, value: Any) -> Any:
    if isinstance(value, NoValue):
        return value
    try:
        return from_json(to_json(value, question.kind))
    except NotPlain as refusal:
        return no_value(refusal.reason, refusal.text)
    except Exception as error:
        return NoValue("not numbers", _told(error))


def _told(error: BaseException, function: Any = None) -> str:
    """Return an error in one line; one of a student's function with the line it came from."""
    text = tidy(f"{type(error).__name__}: {error}".rstrip(": "))
    file = getattr(getattr(function, "__code__", None), "co_filename", None)
    frames = [f for f in traceback.extract_tb(error.__traceback__) if f.filename == file]
    if frames:
        line = linecache.getline(frames[-1].filename, frames[-1].lineno or 0).strip()
        text += f"{LINE}`{tidy(line)}`" if line else ""
    return text


def _brief(value: Any) -> str:
    if isinstance(value, float | np.floating):
        return f"{value:.4g}"
    if isinstance(value, np.ndarray) and value.shape == (4, 4):
        return f"pose at {_brief(value[:3, 3])}"
    if isinstance(value, np.ndarray):
        return _brief(value.tolist())
    if isinstance(value, list | tuple):
        return f"[{', '.join(_brief(v) for v in value)}]"
    return repr(value)
