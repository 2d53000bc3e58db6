"""Marking a class on any executor of `concurrent.futures`: every submission comes to one outcome.

Only text goes out to the executor (the exercise's, and that of the cells), so that its workers may
be other processes or other machines. What a submission does to its worker, up to ending it, costs
nobody else their result.
"""

from collections import deque
from collections.abc import Callable, Generator, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Executor, Future, wait
from dataclasses import dataclass, replace
from itertools import islice
from typing import TypeAlias

from dhlab.errors import InputError
from dhlab.grading.exercise import Exercise
from dhlab.grading.mark import Marked, mark_cells
from dhlab.grading.named import Named, named, other_exercise, told_of_other
from dhlab.grading.plain import one_line
from dhlab.grading.results import Row, row_of
from dhlab.grading.sandbox import Sandbox, SandboxError
from dhlab.grading.submissions import Submission


@dataclass(frozen=True)
class Marker:
    """Marks one submission, wherever it is sent."""

    exercise: Exercise
    seed: int
    course: str
    sandbox: Sandbox

    def __call__(self, name: str, cells: tuple[str, ...]) -> Marked:
        """Mark the cells of a student."""
        return mark_cells(
            self.exercise, name, cells, seed=self.seed, course=self.course, sandbox=self.sandbox
        )


Mark: TypeAlias = Callable[[str, tuple[str, ...]], Marked]


@dataclass(frozen=True)
class Job:
    """A submission that was read and is to be marked.

    Attributes
    ----------
    submission : Submission
    named : Named
        Whose numbers it is marked with.
    cells : tuple of str
    sha256 : str
    odd : tuple of str
    exercise, other : str
        Which exercise it is marked for, and that which its checks belong to, if it is another one.
    """

    submission: Submission
    named: Named
    cells: tuple[str, ...]
    sha256: str
    odd: tuple[str, ...]
    exercise: str = ""
    other: str = ""

    def told(self, row: Row) -> Row:
        """Return the row of this job with what is known of the notebook beside its marks."""
        where, whose = self.submission.where, self.named
        return replace(row, where=where, odd=self.odd, typed=whose.typed, whose=whose.whose)


def prepared(submission: Submission, exercise: Exercise, out_of: float) -> Job | Row:
    """Read a submission to an exercise; one that cannot be read has its row already."""
    plain = (submission.student, submission.names[0])
    if submission.status:
        return Row(*plain, submission.status, submission.reason, 0, out_of, odd=submission.notes)
    try:
        sha256, notebook = submission.read()
    except InputError as error:
        where, odd = submission.where, submission.notes
        return Row(*plain, "unreadable", str(error), 0, out_of, odd=odd, where=where)
    odd = (*submission.notes, *notebook.notes)
    whose = Named(submission.names[0])
    if exercise.is_personal:
        whose = named(submission, notebook.cells)
    other = other_exercise(notebook.cells, exercise.name)
    return Job(submission, whose, notebook.cells, sha256, odd, exercise.name, other)


def mark_class(
    jobs: Iterable[Job], mark: Mark, executors: Callable[[], Executor], window: int
) -> Iterator[Row]:
    """Mark many submissions; each gives its row as soon as it is known.

    Parameters
    ----------
    jobs : iterable of Job
        Taken one by one, so that no more of them are in memory than are under way.
    mark : callable
        From a name and cells to what marking gives; sent to the executor.
    executors : callable
        Makes an executor; called again if one breaks.
    window : int
        How many submissions are under way at a time.

    Yields
    ------
    row : Row
        One for each job, in the order in which they end.
    """
    waiting, suspects = iter(jobs), deque[Job]()
    lost: list[Job] | None = None
    while lost is None or lost:
        executor = executors()
        try:
            lost = yield from _until_broken(waiting, suspects, _Sender(executor, mark), window)
        finally:
            executor.shutdown()
        if len(lost) == 1:
            yield _failed(lost[0], "it ended the program that marks it")
        else:
            suspects.extend(lost)


@dataclass(frozen=True)
class _Sender:
    """Sends jobs to an executor; one that is broken says so in the future, as it always may."""

    executor: Executor
    mark: Mark

    def __call__(self, job: Job) -> Future[Marked]:
        try:
            return self.executor.submit(self.mark, job.named.name, job.cells)
        except BrokenExecutor as error:
            future: Future[Marked] = Future()
            future.set_exception(error)
            return future


def _until_broken(
    waiting: Iterator[Job], suspects: deque[Job], send: _Sender, window: int
) -> Generator[Row, None, list[Job]]:
    """Mark until all is done or the executor is broken; return the jobs that were under way then.

    Which of them broke it is not known: they are suspects, and the next time each is under way
    alone.
    """
    while suspects:
        job = suspects.popleft()
        row = _outcome(send(job), job)
        if row is None:
            return [job]
        yield row
    flying: dict[Future[Marked], Job] = {}
    lost: list[Job] = []
    try:
        while True:
            room = 0 if lost else window - len(flying)
            flying |= {send(job): job for job in islice(waiting, room)}
            if not flying:
                return lost
            for future in wait(flying, return_when=FIRST_COMPLETED).done:
                job = flying.pop(future)
                row = _outcome(future, job)
                if row is None:
                    lost.append(job)
                else:
                    yield row
    finally:  # nobody waits for the rest
        for future in flying:
            future.cancel()


def _outcome(future: Future[Marked], job: Job) -> Row | None:
    """Row of a job that has ended; none if its executor was broken meanwhile."""
    try:
        marked = future.result()
    except BrokenExecutor:
        return None
    except SandboxError:
        raise  # then nobody can be marked
    except Exception as error:
        return _failed(job, f"{type(error).__name__}: {error}")
    row = row_of(marked, job.submission.student, job.sha256)
    return job.told(told_of_other(row, job.other, job.exercise) if job.other else row)


def _failed(job: Job, why: str) -> Row:
    """Row of a submission that was read, and whose marking failed."""
    row = Row(
        student=job.submission.student,
        name=job.named.name,
        status="unreadable",
        reason="It could not be marked, which is no fault of the student's; mark it by hand.",
        points=0,
        out_of=0,
        sha256=job.sha256,
        failed=one_line(why, 300),
    )
    return job.told(row)
