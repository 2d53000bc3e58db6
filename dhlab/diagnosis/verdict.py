"""What a judgement says: right or wrong, what is seen, and which mistake fits."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Protocol, TypeAlias

Case: TypeAlias = tuple[tuple[Any, ...], Any]
"""The arguments of one case (none for a plain value), and the answer that came for them."""

WHEN = "This is exactly what you get when "


@dataclass(frozen=True)
class Mistake:
    """A known misconception that gives exactly the values that came.

    Attributes
    ----------
    key : str
        A short name that stays: "reversed-order".
    text : str
        "This is exactly what you get when ...": one sentence.
    question : str
        What leads on.
    """

    key: str
    text: str
    question: str


@dataclass(frozen=True)
class Verdict:
    """What is said of an answer.

    Attributes
    ----------
    right : bool
    seen : str
        What anybody can see: a sentence. Of a right answer: which of several right choices it is,
        or nothing.
    mistakes : tuple of Mistake
        The mistakes that explain the values; none where nothing known fits.
    either : tuple of tuples of Mistake
        Where several explanations give the same values: each of them, one or two mistakes. Then
        only one of them was made, and `mistakes` holds those of all.

    Examples
    --------
    >>> no_inverse = mistake("inverse", "the inverse is given", "Which frame does it map from?")
    >>> print(Verdict(False, "The origin is 0.2 m off.", (no_inverse,)).text)
    The origin is 0.2 m off. This is exactly what you get when the inverse is given. Which frame
    does it map from?
    """

    right: bool
    seen: str
    mistakes: tuple[Mistake, ...] = ()
    either: tuple[tuple[Mistake, ...], ...] = ()

    @property
    def text(self) -> str:
        """Everything, for the student."""
        if not self.mistakes:
            return self.seen
        explanations = self.either or (self.mistakes,)
        causes = [" and ".join(_cause(m) for m in group) for group in explanations]
        head = WHEN + ("either " if len(causes) > 1 else "") + ", or ".join(causes) + "."
        questions = dict.fromkeys(m.question for m in self.mistakes)
        return " ".join([self.seen, head, *list(questions)[:2]])


class Task(Protocol):
    """What was asked, and so what is right and what the mistakes give."""

    def judge(self, cases: Sequence[Case]) -> Verdict:
        """Judge an answer by what came for several inputs."""


def mistake(key: str, when: str, question: str) -> Mistake:
    """Make a mistake from what completes "This is exactly what you get when ..."."""
    return Mistake(key, f"{WHEN}{when}.", question)


def _cause(m: Mistake) -> str:
    return m.text.removeprefix(WHEN).removesuffix(".")
