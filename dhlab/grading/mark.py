"""Marking one submission: its cells run in a sandbox, its answers are judged here, afterwards."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Literal, TypeAlias

import numpy as np

from dhlab.grading.asked import Ask
from dhlab.grading.cases import recorded
from dhlab.grading.exercise import Exercise, seed_of
from dhlab.grading.inside.plain import tidy
from dhlab.grading.judge import Judged, judge
from dhlab.grading.question import Question
from dhlab.grading.runner import Run, run_cells
from dhlab.grading.sandbox import Limits, Sandbox
from dhlab.grading.tried import examples_told

Status: TypeAlias = Literal["graded", "second look", "partly graded", "unreadable", "missing"]

IMPORTS = re.compile(
    r"(?:^|;)[ \t]*(?:from[ \t]+([\w.]+)[ \t]+import[ \t]*(?:\(([^)]{0,2000})\)|([\w \t.,*]+))"
    r"|import[ \t]+([\w \t.,]+))",
    re.MULTILINE,
)
PARTLY = re.compile(r"For \d+ of \d+ inputs it is ")
MOST_IMPORTS, LONGEST_CELL = 50, 100_000


@dataclass(frozen=True)
class Marked:
    """The marks of one submission, all of it plain data.

    Attributes
    ----------
    student : str
        Who is marked, whoever the notebook names.
    questions : tuple of Judged
    points, out_of : float
    status : {'graded', 'second look', 'partly graded', 'unreadable', 'missing'}
        'second look' if the notebook names another student than the one whose numbers it was
        compared with; 'partly graded' if cells had to be left out; the last two where there was
        nothing to run.
    reason : str
        A sentence where the status is not 'graded'.
    notes : tuple of str
        What was seen when the cells ran; it costs no points.
    left_out : tuple of int
        Cells that were left out, counted from 1.
    seconds : float
    imports : tuple of str
        What the text of the cells imports: "numpy", "dhlab.View".
    seed : int
        From which the further cases were drawn.
    cases : mapping of str to list of dict
        For each question what was asked and what came; never for a student's eyes.
    """

    student: str
    questions: tuple[Judged, ...]
    points: float
    out_of: float
    status: Status
    reason: str
    notes: tuple[str, ...]
    left_out: tuple[int, ...]
    seconds: float
    imports: tuple[str, ...]
    seed: int
    cases: Mapping[str, Sequence[Mapping[str, Any]]] = field(default_factory=dict, repr=False)


def mark_cells(
    exercise: Exercise,
    student: str,
    cells: Sequence[str],
    *,
    seed: int,
    course: str = "",
    sandbox: Sandbox = "bwrap",
    limits: Limits | None = None,
) -> Marked:
    """Mark the code cells of a submission.

    Parameters
    ----------
    exercise : Exercise
    student : str
        Whose submission it is: the numbers are this student's.
    cells : sequence of str
    seed : int
        Of the further cases: the same for all students of one marking.
    course : str
        As in the released notebook.
    sandbox : {'bwrap', 'none'}
        'none' runs the cells unprotected, as this user: for work that is trusted.
    limits : Limits, optional

    Returns
    -------
    marked : Marked

    Raises
    ------
    SandboxError
        The sandbox does not work here; nothing was run.
    DhlabError
        The exercise has an error; the message names the line.
    """
    given = exercise.numbers(student, course)
    questions = exercise.questions(given)
    asks = [_ask(exercise, question, seed) for question in questions]
    run = run_cells(cells, asks, given, tools=exercise.tools, sandbox=sandbox, limits=limits)
    judged = tuple(
        _judged(question, list(zip(ask.cases, run.replies[ask.name], strict=True)))
        for question, ask in zip(questions, asks, strict=True)
    )
    left_out = [f"cell {cell} was left out: {why}." for cell, why in run.left_out.items()]
    clash = _clash(run, exercise, student)
    return Marked(
        student=student,
        questions=judged,
        points=sum(j.points for j in judged),
        out_of=sum(j.out_of for j in judged),
        status="second look" if clash else "partly graded" if left_out else "graded",
        reason=" ".join([*left_out, *clash]),
        notes=run.notes,
        left_out=tuple(run.left_out),
        seconds=run.seconds,
        imports=imports_of(cells),
        seed=seed,
        cases={ask.name: recorded(ask, run.replies[ask.name]) for ask in asks},
    )


def imports_of(cells: Sequence[str]) -> tuple[str, ...]:
    """Names that the text of some cells imports, in order.

    Examples
    --------
    >>> imports_of(["import numpy as np, math", "from dhlab import View, deg as degree"])
    ('numpy', 'math', 'dhlab.View', 'dhlab.deg')
    """
    found: dict[str, None] = {}
    for cell in cells:
        for module, *lists in IMPORTS.findall(cell[:LONGEST_CELL]):
            words = [name.split() for name in "".join(lists).split(",")]
            names = [w[0] for w in words if w and re.fullmatch(r"[\w.*]+", w[0])]
            found |= {f"{module}.{name}" if module else name: None for name in names}
    return tuple(found)[:MOST_IMPORTS]


def _ask(exercise: Exercise, question: Question, seed: int) -> Ask:
    """Draw the cases of a question: the same for all students of one seed."""
    rng = np.random.default_rng([seed, seed_of("", question.name)])
    cases = exercise.cases(question, rng)
    return Ask(question.name, question.kind, cases, question.library)


def _judged(question: Question, cases: Sequence[tuple[tuple[Any, ...], Any]]) -> Judged:
    """Judge an answer; of one that is right for some inputs say which of those that are known."""
    judged = judge(question, cases)
    if PARTLY.search(judged.text) is None:
        return judged
    return replace(judged, text=f"{judged.text} {examples_told(question, cases)}")


def _clash(run: Run, exercise: Exercise, student: str) -> list[str]:
    """Say so where the notebook has the numbers of somebody else."""
    named = run.student
    if not exercise.is_personal or named is None or seed_of("", named) == seed_of("", student):
        return []
    who = f"'{named}'" if named.strip() else "nobody"
    return [
        f"the notebook names {who}; its answers were compared with those for '{tidy(student)}'."
    ]
