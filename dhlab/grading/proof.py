"""The proof that an exercise does what it should, before students get it."""

import re
import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from dhlab.errors import DhlabError
from dhlab.grading.asked import NoValue
from dhlab.grading.check import packed
from dhlab.grading.exercise import Exercise, load_exercise
from dhlab.grading.judge import Judged, judge
from dhlab.grading.question import Question
from dhlab.grading.source import Cell, answers, assigned, blanked, read_cells, with_checks
from dhlab.grading.trial import Namespace, check_of, for_student, run_cell, run_cells
from dhlab.grading.tried import values_of

SOURCE, WRONG = "exercise.py", "wrong.py"
STUDENTS = ("Ada Lovelace", "Grace Hopper", "Emmy Noether")
ENOUGH = 5
HEADER = re.compile(r"^(\w+): +(.*\S)$")


@dataclass(frozen=True)
class Wrong:
    """A typical wrong answer: code that defines it, and what is to be said of it.

    Attributes
    ----------
    name : str
        Of the question.
    meant : str
        The key of a mistake, or words of the text.
    cell : Cell
    """

    name: str
    meant: str
    cell: Cell


class Source:
    """The texts of one exercise, read.

    Parameters
    ----------
    folder : Path
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.exercise = load_exercise(folder)
        self.solved = with_checks(read_cells(folder / SOURCE), packed(self.exercise))
        self.wrong = read_wrong(folder / WRONG)
        self.names = [q.name for q in self.exercise.questions(self.exercise.numbers(""))]
        self.released = [blanked(cell, self.names) for cell in self.solved]

    @property
    def students(self) -> tuple[str, ...]:
        """Whose numbers it is tried with; the first is nobody, as in the released notebook."""
        return ("", *STUDENTS) if self.exercise.is_personal else ("",)


def prove(source: Source) -> None:
    """Refuse an exercise whose notebook would not do what it should.

    Raises
    ------
    DhlabError
        An answer is left in the notebook for students; this, blank, does not run to its end or
        gets a point; an answer fails its own checks; a wrong answer passes, or is not diagnosed
        as it is meant to be; there are too few wrong ones.
    """
    no_answer_left(source)
    blank_gets_nothing(source)
    for student in source.students:
        solution_passes(source, student)
    if len(source.wrong) < ENOUGH:
        raise DhlabError(
            f"{source.folder / WRONG}: {len(source.wrong)} wrong answers; {ENOUGH} are needed"
        )
    for wrong in source.wrong:
        for student in source.students[-2:]:
            wrong_is_explained(source, wrong, student)


def no_answer_left(source: Source) -> None:
    """Refuse a notebook for students that still holds a line of an answer."""
    shown = [" ".join(cell.source.split()) for cell in source.released]
    for cell in source.solved:
        for row, line in answers(cell):
            if any(line in text for text in shown):
                raise DhlabError(f"{cell.where(row)}: this line of an answer is also given away")


def blank_gets_nothing(source: Source) -> None:
    """Refuse a blank notebook that raises, gets a point or does not find its stubs."""
    names = run_cells([*source.released, *source.released])  # twice over, as students do
    for judged in judged_all(source, names, 0):
        if judged.points or judged.reason != "stub":
            raise DhlabError(
                f"{source.folder / SOURCE}: the blank answer to {judged.name!r} is "
                f"{judged.reason!r} ({judged.points:g} points): {judged.text}"
            )


def solution_passes(source: Source, student: str) -> None:
    """Refuse an answer that fails its own checks."""
    names = run_cells(for_student(source.solved, student))
    for seed in range(3):
        for judged in judged_all(source, names, seed):
            if not judged.right:
                raise DhlabError(
                    f"{_place(source, judged.name)}: the answer to {judged.name!r} fails its own "
                    f"checks{_whose(student)}: {judged.text}"
                )


def wrong_is_explained(source: Source, wrong: Wrong, student: str) -> None:
    """Refuse a wrong answer that passes, or whose diagnosis is not the one meant."""
    if wrong.name not in source.names:
        there = ", ".join(source.names)
        raise DhlabError(f"{wrong.cell.where()}: no question {wrong.name!r}; there are {there}")

    def instead(cell: Cell, names: Namespace) -> None:
        if wrong.name in assigned(cell):
            run_cell(wrong.cell, names)

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # degrees for radians warn, and so they should
        names = run_cells(for_student(source.solved, student), instead)
    question = next(q for q in asked(source, names) if q.name == wrong.name)
    for seed in (None, 0):
        judged = judged_one(source.exercise, question, names, seed)
        found = wrong.meant in judged.mistakes or wrong.meant.lower() in judged.text.lower()
        if judged.points or not found:
            said = ", ".join(judged.mistakes) or "no mistake by name"
            raise DhlabError(
                f"{wrong.cell.where()}: {wrong.meant!r} was meant for {wrong.name!r}, but it gets "
                f"{judged.points:g} points and {said}{_whose(student)}: {judged.text}"
            )


def judged_all(source: Source, names: Namespace, seed: int | None) -> list[Judged]:
    """Judge what cells defined, question by question."""
    return [judged_one(source.exercise, q, names, seed) for q in asked(source, names)]


def judged_one(
    exercise: Exercise, question: Question, names: Namespace, seed: int | None
) -> Judged:
    """Judge what cells defined for one question; with a seed also by further cases."""
    rng = None if seed is None else np.random.default_rng(seed)
    cases = question.cases() if rng is None else exercise.cases(question, rng)
    if question.name not in names:
        return judge(question, [(case, NoValue("missing", "")) for case in cases])
    return judge(question, values_of(question, names[question.name], cases))


def asked(source: Source, names: Namespace) -> Sequence[Question]:
    """Questions with the numbers that the cells asked for."""
    return check_of(names, str(source.folder / SOURCE)).questions


def read_wrong(path: Path) -> list[Wrong]:
    """Read the wrong answers: cells headed ``# %% name: mistake``, the first may be a text.

    Raises
    ------
    DhlabError
        There is no such file, or a code cell has no such header.
    """
    out = []
    for cell in read_cells(path):
        if cell.kind == "code" and cell.source.strip():
            header = HEADER.match(cell.title)
            if header is None:
                raise DhlabError(
                    f"{path}, line {cell.line - 1}: a wrong answer begins with '# %% name: mistake'"
                )
            out.append(Wrong(header[1], header[2], cell))
    return out


def _place(source: Source, name: str) -> str:
    found = next((cell for cell in source.solved if name in assigned(cell)), None)
    return str(source.folder / SOURCE) if found is None else found.where()


def _whose(student: str) -> str:
    return f" with the numbers of {student!r}" if student else ""
