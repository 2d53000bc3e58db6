"""Marking a class, from what was handed in to the files of results."""

import hashlib
import platform
import secrets
from collections import deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from functools import partial
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

import numpy as np

from dhlab.errors import InputError
from dhlab.grading.asked import Ask
from dhlab.grading.batch import Job, Marker, mark_class, prepared
from dhlab.grading.entries import handed_in
from dhlab.grading.executors import Workers, dask_workers, local_workers
from dhlab.grading.exercise import CHECKS, Exercise, load_exercise, title_of
from dhlab.grading.grades import add_grade, write_grades
from dhlab.grading.journal import Journal, earlier_rows
from dhlab.grading.named import told_of_doubles
from dhlab.grading.reports import GRADES, write_reports
from dhlab.grading.results import ClassResults, Column, Row, Run
from dhlab.grading.roster import read_people
from dhlab.grading.runner import run_cells
from dhlab.grading.sandbox import Sandbox
from dhlab.grading.submissions import Submission, find_submissions

Told = Callable[[int, int, int], None]
"""Hears how many submissions are done, how many there are, and how many were marked before."""


TRIAL: tuple[tuple[str, ...], tuple[Ask, ...], dict[str, Any]] = (("x = 1",), (Ask("x"),), {})
"""What is run before anybody is marked, to see whether the sandbox works."""


@dataclass(frozen=True)
class Order:
    """What is to be marked, and how.

    Attributes
    ----------
    exercise : Path
        Its folder.
    source : Path
        What was handed in: a folder, an archive, or a notebook.
    out : Path
        Where the results go.
    seed : int, optional
        The hidden cases are drawn from it; without one, that of the last run in `out`, or else a
        fresh one.
    course : str
        With a student's name it gives their own numbers; that of the exercise's notebook if it is
        not given.
    people : Path, optional
        The list of students.
    workers : int, optional
    dask : str
        Address of a Dask scheduler; empty for processes of this machine.
    sandbox : {'bwrap', 'none'}
    """

    exercise: Path
    source: Path
    out: Path
    seed: int | None = None
    course: str = ""
    people: Path | None = None
    workers: int | None = None
    dask: str = ""
    sandbox: Sandbox = "bwrap"


def grade(order: Order, told: Told = lambda *_: None) -> ClassResults:
    """Mark a class and write its results.

    A run that was interrupted goes on where it was. What was marked before is not marked again, as
    long as exercise, course, seed, sandbox, versions and the notebook itself are the same.

    Parameters
    ----------
    order : Order
    told : callable
        Hears of the progress.

    Returns
    -------
    results : ClassResults

    Raises
    ------
    DhlabError
        Something is wrong with the exercise, the folders, the list of students or the sandbox;
        or `out` holds the marks of something else. Nothing was written then.
    """
    exercise = load_exercise(order.exercise)
    order = replace(order, course=order.course or exercise.course)
    columns = _columns(exercise, order.course)
    people = read_people(order.people) if order.people else ()
    if order.out.resolve() == order.source.resolve():
        raise InputError(f"the results cannot go into {str(order.source)!r} itself; name a folder")
    before, earlier = earlier_rows(order.out)
    run = _run(order, exercise, before)
    kept = {row.student: row for row in earlier if before == run and not row.failed}
    with _workers(order) as workers, handed_in(order.source, skip=order.out) as entries:
        workers.everywhere(partial(run_cells, *TRIAL, sandbox=order.sandbox))
        submissions = find_submissions(entries, exercise.name, _others(order.exercise), people)
        if not submissions:
            raise InputError(f"there is no submission in {str(order.source)!r}")
        _refuse_to_replace(order.out, before, run, earlier, submissions)
        mark = Marker(exercise, run.seed, order.course, order.sandbox)
        plan = _Plan(ClassResults(run, columns, ()), submissions, kept)
        with Journal(order.out, run, kept.values()) as journal:
            results = _marked(plan, mark, workers, journal, order.out, told)
            write_reports(order.out, results, earlier)
            journal.done()
    return results


@dataclass(frozen=True)
class _Plan:
    """What is to be marked, and what is known already."""

    empty: ClassResults
    submissions: Sequence[Submission]
    kept: Mapping[str, Row]

    def rows(self, mark: Marker, workers: Workers) -> Iterator[tuple[Row, bool]]:
        """Mark what is not known; give each row, and whether it was known."""
        ready: deque[tuple[Row, bool]] = deque()
        jobs = self._jobs(mark.exercise, ready)
        for row in mark_class(jobs, mark, workers.executors, workers.window):
            while ready:
                yield ready.popleft()
            yield row, False
        yield from ready

    def _jobs(self, exercise: Exercise, ready: deque[tuple[Row, bool]]) -> Iterator[Job]:
        for submission in self.submissions:
            job = prepared(submission, exercise, self.empty.out_of)
            if isinstance(job, Row):
                ready.append((job, False))
                continue
            known = self.kept.get(submission.student)
            if known is not None and (known.sha256, known.name) == (job.sha256, job.named.name):
                ready.append((job.told(known), True))
            else:
                yield job


def _marked(
    plan: _Plan, mark: Marker, workers: Workers, journal: Journal, out: Path, told: Told
) -> ClassResults:
    """Mark, and write down each row when it is known."""
    path = out / GRADES
    write_grades(path, plan.empty)
    rows: list[Row] = []
    known = 0
    for row, is_known in plan.rows(mark, workers):
        rows.append(row)
        known += is_known
        if not is_known:
            journal.add(row)
        add_grade(path, plan.empty, row)
        told(len(rows), len(plan.submissions), known)
    place = {s.student: k for k, s in enumerate(plan.submissions)}
    rows.sort(key=lambda row: place[row.student])
    finished = datetime.now(UTC).isoformat(timespec="seconds")
    return replace(plan.empty, rows=tuple(told_of_doubles(rows)), finished=finished)


def _run(order: Order, exercise: Exercise, before: Run | None) -> Run:
    """Say what the marks depend on; an earlier run's seed goes on where none is asked for."""
    seed = order.seed
    if seed is None and before is not None:
        same = (before.exercise, before.course) == (exercise.name, order.course)
        seed = before.seed if same else None
    if seed is None:
        seed = secrets.randbelow(2**32)
    parts = "\n".join((exercise.text, *exercise.tools))
    digest = hashlib.sha256(parts.encode()).hexdigest()
    versions = {"dhlab": _version(), "numpy": np.__version__, "python": platform.python_version()}
    told = str(order.source.resolve()), title_of(order.exercise)
    return Run(exercise.name, digest, order.course, seed, order.sandbox, versions, *told)


def _refuse_to_replace(
    out: Path, before: Run | None, run: Run, earlier: Sequence[Row], now: Sequence[Submission]
) -> None:
    """Refuse to put marks in the place of others: of another exercise, of other submissions.

    What was handed in may have moved or been packed meanwhile, if all of it is there.
    """
    if before is None or (before.exercise, before.source) == (run.exercise, run.source):
        return
    here = {submission.student: submission for submission in now}
    lost = [row for row in earlier if row.where and not _is_still(here.get(row.student), row)]
    if before.exercise != run.exercise or (before.source and lost):
        source = f" for {before.source!r}" if before.source else ""
        raise InputError(
            f"{str(out)!r} holds the marks of {before.exercise!r}{source}; those of "
            f"{run.exercise!r} for {run.source!r} would take their place: name another --out"
        )


def _is_still(submission: Submission | None, row: Row) -> bool:
    """Whether what a row was made from is handed in unchanged."""
    if submission is None:
        return False
    try:
        return submission.read()[0] == row.sha256
    except InputError:
        return not row.sha256


def _columns(exercise: Exercise, course: str) -> tuple[Column, ...]:
    """Try the exercise once, so that its errors are told before anybody is marked."""
    questions = exercise.questions(exercise.numbers("", course))
    for question in questions:
        exercise.cases(question, np.random.default_rng(0))
    return tuple(Column(question.name, float(question.points)) for question in questions)


def _workers(order: Order) -> AbstractContextManager[Workers]:
    if order.dask:
        return dask_workers(order.dask)
    return nullcontext(local_workers(order.workers))


def _others(folder: Path) -> list[str]:
    """Names of the exercises beside this one: what is named as they are is not for this one."""
    beside = folder.resolve().parent
    return sorted(path.parent.name for path in beside.glob(f"*/{CHECKS}"))


def _version() -> str:
    try:
        return version("dhlab")
    except PackageNotFoundError:
        return "not installed"
