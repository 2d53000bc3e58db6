"""The proof that an exercise does what it should, before students get it."""

import re
import warnings
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from dhlab.errors import DhlabError
from dhlab.grading.asked import NoValue
from dhlab.grading.check import packed
from dhlab.grading.exercise import Exercise, load_exercise
from dhlab.grading.judge import ASK_INSTRUCTOR, CANNOT, UNJUDGED, Judged, judge
from dhlab.grading.promised import (
    check_problems,
    checkers_in,
    checks_in,
    given_away,
    point_problems,
)
from dhlab.grading.question import Question
from dhlab.grading.source import Cell, assigned, blanked, read_cells, with_checks
from dhlab.grading.trial import Namespace, check_of, for_student, run_cell, run_cells
from dhlab.grading.tried import values_of

SOURCE, WRONG = "exercise.py", "wrong.py"
STUDENTS = ("Ada Lovelace", "Grace Hopper", "Emmy Noether")
ENOUGH, FEWEST_LETTERS = 5, 4
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
        self.questions = self.exercise.questions(self.exercise.numbers(""))
        self.names = [q.name for q in self.questions]
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
        The message has a line for each problem: the texts and the questions do not fit; an answer
        is left in the notebook for students; this, blank, does not run to its end or gets a point;
        an answer fails its own checks; a wrong answer passes, or is not diagnosed as it is meant
        to be; there are too few wrong ones. What would follow from a problem is not looked at.
    """
    asked_amiss = list(check_problems(source.released, source.questions))
    problems = [*asked_amiss, *given_away(source.solved, source.released, source.questions)]
    if not asked_amiss:
        problems += point_problems(source.released, source.questions)
    problems += wrong_problems(source)
    if not asked_amiss:
        running = [*blank_problems(source), *answer_problems(source)]
        if not running:
            known = [wrong for wrong in source.wrong if wrong.name in source.names]
            running = [said for wrong in known for said in mistake_problems(source, wrong)]
        problems += running
    if problems:
        raise DhlabError("\n".join(dict.fromkeys(problems)))


def wrong_problems(source: Source) -> Iterator[str]:
    """Say where the wrong answers are too few, or meant for no question."""
    if len(source.wrong) < ENOUGH:
        yield f"{source.folder / WRONG}: {len(source.wrong)} wrong answers; {ENOUGH} are needed"
    there = ", ".join(source.names)
    for wrong in source.wrong:
        if wrong.name not in source.names:
            yield f"{wrong.cell.where()}: no question {wrong.name!r}; there are {there}"


def blank_problems(source: Source) -> Iterator[str]:
    """Say where a blank notebook raises, gets a point or does not find its stubs."""
    try:
        names = run_cells([*source.released, *source.released])  # twice over, as students do
    except DhlabError as error:
        yield f"{error}, in the blank notebook{_unasked(source, error)}"
        return
    for judged in judged_all(source, names, 0):
        if judged.points or judged.reason != "stub":
            yield (
                f"{source.folder / SOURCE}: the blank answer to {judged.name!r} is "
                f"{judged.reason!r} ({judged.points:g} points): {judged.text}"
            )


def answer_problems(source: Source) -> Iterator[str]:
    """Say which answer fails its own checks; of each answer once."""
    found: set[str] = set()
    for student in source.students:
        for name, problem in failing(source, student):
            if name not in found:
                yield problem
            found.add(name)


def failing(source: Source, student: str) -> Iterator[tuple[str, str]]:
    """Yield the questions whose answers fail with a student's numbers, each with what is said."""
    try:
        names, seen = solved(source, student, source.names)
    except DhlabError as error:
        yield "", f"{error}{_whose(student)}"
        return
    for seed in range(3):
        for judged in (seen.get(j.name, j) for j in judged_all(source, names, seed)):
            if judged.reason == UNJUDGED:
                why = judged.text.removeprefix(CANNOT).removesuffix(ASK_INSTRUCTOR).strip(" .")
                where = f"{source.exercise.where}: the task of {judged.name!r}"
                yield judged.name, f"{where} cannot judge an answer {why}"
            elif not judged.right:
                yield (
                    judged.name,
                    f"{_place(source, judged.name)}: the answer to {judged.name!r} fails its own "
                    f"checks{_whose(student)}: {judged.text}",
                )


def solved(
    source: Source,
    student: str,
    wanted: Collection[str],
    after: Callable[[Cell, Namespace], None] | None = None,
) -> tuple[Namespace, dict[str, Judged]]:
    """Run the answers with a student's numbers; of the plain values wanted say how they are judged.

    As when it is marked, these count as their checks saw them last.
    """
    seen: dict[str, Judged] = {}
    checkers = checkers_in(source.solved)

    def look(cell: Cell, names: Namespace) -> None:
        if after is not None:
            after(cell, names)
        checked = {name for name, _ in checks_in(cell, checkers) if name in wanted}
        for question in asked(source, names) if checked else ():
            if question.name in checked and not question.is_function:
                seen[question.name] = judged_one(source.exercise, question, names, None)

    return run_cells(for_student(source.solved, student), look), seen


def mistake_problems(source: Source, wrong: Wrong) -> Iterator[str]:
    """Say where a wrong answer passes, or its diagnosis is not the one meant; once."""

    def instead(cell: Cell, names: Namespace) -> None:
        if wrong.name in assigned(cell):
            run_cell(wrong.cell, names)

    for student in source.students[-2:]:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # degrees for radians warn, and so they should
            try:
                names, seen = solved(source, student, [wrong.name], instead)
            except DhlabError as error:
                yield str(error)
                return
        question = next(q for q in asked(source, names) if q.name == wrong.name)
        for seed in (None, 0):
            judged = seen.get(wrong.name) or judged_one(source.exercise, question, names, seed)
            problem = _amiss(wrong, judged)
            if problem:
                yield f"{wrong.cell.where()}: {problem}{_whose(student)}: {judged.text}"
                return


def _amiss(wrong: Wrong, judged: Judged) -> str:
    """Say what of the judgement of a wrong answer is not as it was meant, if anything."""
    keys = ", ".join(judged.mistakes)
    is_key = wrong.meant in judged.mistakes
    if not judged.points and not is_key and len(wrong.meant) < FEWEST_LETTERS:
        return (
            f"{wrong.meant!r} says too little of what is meant for {wrong.name!r}; write the key "
            f"of a mistake{f' ({keys})' if keys else ''} or some words of this"
        )
    words = rf"(?<!\w){re.escape(wrong.meant)}"
    if not judged.points and (is_key or re.search(words, judged.text, re.IGNORECASE)):
        return ""
    return (
        f"{wrong.meant!r} was meant for {wrong.name!r}, but it gets {judged.points:g} points and "
        f"{keys or 'no mistake by name'}"
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


def _unasked(source: Source, error: DhlabError) -> str:
    """Say which name is missed because an answer gives it that no question asks for."""
    name = error.__cause__.name if isinstance(error.__cause__, NameError) else None
    if name is None or name in source.names or not any(name in assigned(c) for c in source.solved):
        return ""
    there = ", ".join(source.names)
    return f"; no question is called {name!r} (there are {there}), so nothing stands in its place"


def _whose(student: str) -> str:
    return f" with the numbers of {student!r}" if student else ""
