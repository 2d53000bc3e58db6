"""What a class's results say together: the spread of marks, of right answers, of mistakes."""

import re
import statistics
from collections import defaultdict
from dataclasses import dataclass
from itertools import pairwise

from dhlab.diagnosis.verdict import WHEN
from dhlab.grading.grades import number
from dhlab.grading.judge import Judged
from dhlab.grading.results import ClassResults, Row

NOTHING = ("missing", "stub")
MOST_BARS = 13


@dataclass(frozen=True)
class Bar:
    """How many students have so many points."""

    label: str
    count: int


@dataclass(frozen=True)
class Answers:
    """How the class answered a question.

    Attributes
    ----------
    name : str
    right, wrong, nothing, failed : int
        Students with the right answer, with a wrong one, with none, and those whose code raised an
        error, took too long, or gave something that is no answer.
    """

    name: str
    right: int
    wrong: int
    nothing: int
    failed: int


@dataclass(frozen=True)
class Misconception:
    """What explains some students' answers to a question exactly.

    Attributes
    ----------
    keys : tuple of str
        One mistake; or several, made together or explaining the answer equally well: the text
        says which.
    text : str
        In words.
    question : str
    students : tuple of str
        Whose answers it explains.
    """

    keys: tuple[str, ...]
    text: str
    question: str
    students: tuple[str, ...]


def marked_rows(results: ClassResults) -> list[Row]:
    """Return the rows of the students whose notebook was marked."""
    return [row for row in results.rows if row.questions]


def mean_and_median(results: ClassResults) -> tuple[float, float] | None:
    """Return mean and median of the points of those marked; none if nobody was."""
    points = [row.points for row in marked_rows(results)]
    return (statistics.fmean(points), statistics.median(points)) if points else None


def spread(results: ClassResults) -> list[Bar]:
    """Count the students marked by points: a bar for each whole number, or for equal ranges."""
    points, top = [row.points for row in marked_rows(results)], results.out_of
    whole = all(p == round(p) for p in (*points, top))
    if whole and top < MOST_BARS:
        return [Bar(number(k), points.count(k)) for k in range(round(top) + 1)]
    edges = [top * k / 10 for k in range(11)]
    place = [min(int(10 * p / top), 9) for p in points]
    ranges = pairwise(edges)
    return [Bar(f"{number(a)}–{number(b)}", place.count(k)) for k, (a, b) in enumerate(ranges)]


def answers(results: ClassResults) -> list[Answers]:
    """Count right and other answers, question by question, over those marked."""
    found = []
    for column in results.columns:
        asked = _judged(results, column.name)
        right = sum(judged.right for judged in asked)
        wrong = sum(judged.reason == "wrong" for judged in asked)
        nothing = sum(judged.reason in NOTHING for judged in asked)
        rest = len(asked) - right - wrong - nothing
        found.append(Answers(column.name, right, wrong, nothing, rest))
    return found


def misconceptions(results: ClassResults) -> list[Misconception]:
    """Collect the mistakes that were diagnosed, the most frequent first."""
    who: dict[tuple[str, tuple[str, ...], str], list[str]] = defaultdict(list)
    for row in results.rows:
        for judged in row.questions:
            if judged.mistakes:
                who[judged.name, judged.mistakes, _cause(judged)].append(row.student)
    found = [
        Misconception(keys, text, name, tuple(students))
        for (name, keys, text), students in who.items()
    ]
    order = [column.name for column in results.columns]
    return sorted(found, key=lambda m: (-len(m.students), _place(order, m.question), m.keys))


def _judged(results: ClassResults, name: str) -> list[Judged]:
    return [judged for row in results.rows for judged in row.questions if judged.name == name]


def _place(order: list[str], name: str) -> int:
    return order.index(name) if name in order else len(order)


def _cause(judged: Judged) -> str:
    """Take what explains an answer out of what the student was told; else the mistakes' keys."""
    found = re.search(rf"{re.escape(WHEN)}(.+?)\.(?= |$)", judged.text)
    return found[1] if found else ", ".join(key.replace("-", " ") for key in judged.mistakes)
