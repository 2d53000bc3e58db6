"""A class on an executor: every submission comes to one row."""

import os
import pickle
import time
from concurrent.futures import BrokenExecutor, Future, ThreadPoolExecutor

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhlab.grading.batch import Job, Marker, mark_class, prepared
from dhlab.grading.entries import Entry
from dhlab.grading.executors import local_workers
from dhlab.grading.exercise import exercise_from_text
from dhlab.grading.mark import Marked
from dhlab.grading.named import Named
from dhlab.grading.results import Row
from dhlab.grading.submissions import Submission
from tests.grading.classroom import CHECKS, notebook

TURNS = exercise_from_text(CHECKS, "01_turns")
pytestmark = pytest.mark.skipif(os.name != "posix", reason="answers are marked on Linux or macOS")


def submission(student, content=b"{}", **options):
    """What a student handed in."""
    entry = Entry((f"{student}.ipynb",), content=lambda: content)
    return Submission(student, (student,), f"{student}.ipynb", entry=entry, **options)


def job(student):
    """A submission that was read."""
    return Job(submission(student), Named(student), (f"who = {student!r}",), "ff", ("Odd.",))


def marked(name, points=1.0):
    """What marking gives."""
    return Marked(name, (), points, 1, "graded", "", (), (), 0.0, (), 1)


def mark(name, cells):
    """Mark by name: some raise."""
    if name.startswith("bad"):
        raise ZeroDivisionError("an error\nof marking")
    return marked(name)


class Broken:
    """An executor that breaks when a certain student's work is under way."""

    def __init__(self, worst):
        self.worst, self.is_broken, self.pool = worst, False, ThreadPoolExecutor(1)

    def submit(self, function, name, cells):
        if self.is_broken:
            raise BrokenExecutor
        future = Future()
        self.pool.submit(self.run, future, function, name, cells)
        return future

    def run(self, future, function, name, cells):
        self.is_broken |= name.startswith(self.worst)
        if self.is_broken:
            future.set_exception(BrokenExecutor())
            return
        try:
            future.set_result(function(name, cells))
        except ZeroDivisionError as error:
            future.set_exception(error)

    def shutdown(self, wait=True):
        self.pool.shutdown(wait)


def rows_of(students, executors, window=4):
    """Student -> row."""
    rows = list(mark_class(map(job, students), mark, executors, window))
    assert sorted(row.student for row in rows) == sorted(students)
    return {row.student: row for row in rows}


def test_each_job_gives_a_row():
    rows = rows_of([f"s{k}" for k in range(20)], lambda: ThreadPoolExecutor(3))
    assert all((row.points, row.odd, row.sha256) == (1, ("Odd.",), "ff") for row in rows.values())


def test_a_marking_that_fails_is_told_to_the_instructor_and_costs_nobody_else():
    rows = rows_of(["s1", "bad", "s2"], lambda: ThreadPoolExecutor(1))
    assert (rows["s1"].status, rows["s2"].status) == ("graded", "graded")
    bad = rows["bad"]
    assert (bad.status, bad.failed) == ("unreadable", "ZeroDivisionError: an error of marking")
    assert "ZeroDivision" not in bad.reason


def test_no_more_is_taken_than_is_under_way():
    under_way, most = [], 0

    def jobs():
        for k in range(30):
            under_way.append(k)
            yield job(f"s{k}")

    for _ in mark_class(jobs(), mark, lambda: ThreadPoolExecutor(2), 5):
        most = max(most, len(under_way))
        under_way.pop()
    assert most <= 6


@pytest.mark.parametrize("window", [1, 2, 7])
@pytest.mark.parametrize("place", [0, 4, 9])
def test_who_ends_the_worker_fails_alone(place, window):
    students = [f"s{k}" for k in range(10)]
    students[place] = "worst"
    rows = rows_of(students, lambda: Broken("worst"), window)
    assert [name for name, row in rows.items() if row.failed] == ["worst"]
    assert rows["worst"].failed == "it ended the program that marks it"


@given(st.lists(st.sampled_from(["good", "bad", "worst"]), max_size=12), st.integers(1, 6))
def test_every_student_has_one_row_whatever_happens(kinds, window):
    students = [f"{kind}{k}" for k, kind in enumerate(kinds)]
    rows = rows_of(students, lambda: Broken("worst"), window)
    assert {name for name, row in rows.items() if row.failed} == {
        name for name in students if not name.startswith("good")
    }


def test_an_executor_that_never_works_gives_rows_too():
    rows = rows_of(["a", "b", "c"], lambda: Broken(""))
    assert all(row.failed for row in rows.values())


def test_leaving_early_marks_nobody_more():
    begun = []

    def slow(name, cells):
        begun.append(name)
        time.sleep(0.05)
        return marked(name)

    rows = mark_class(map(job, "abcdef"), slow, lambda: ThreadPoolExecutor(1), 6)
    next(rows)
    rows.close()
    assert len(begun) <= 3


DEADLY = """
import os
from dhlab.grading import Question
from dhlab.diagnosis import MatrixTask, turn

def numbers(rng):
    return {"x": float(rng.random())}

def questions(given):
    if given["x"] > 0.9:
        os._exit(3)
    return [Question("R", MatrixTask(turn("z", 0.3), size=3))]
"""


def test_in_processes_who_ends_the_worker_fails_alone():
    exercise = exercise_from_text(DEADLY, "deadly")
    names = [f"s{k}" for k in range(40)]
    worst = next(name for name in names if exercise.numbers(name)["x"] > 0.9)
    good = [name for name in names if exercise.numbers(name)["x"] <= 0.9][:4]
    students = [*good[:2], worst, *good[2:]]
    marker = Marker(exercise, 1, "", "none")
    workers = local_workers(2)
    rows = {
        row.student: row
        for row in mark_class(map(job, students), marker, workers.executors, workers.window)
    }
    assert {name for name, row in rows.items() if row.failed} == {worst}
    assert all(rows[name].questions[0].reason == "missing" for name in good)


def test_what_was_not_handed_in_has_its_row():
    missing = Submission("x", ("x",), status="missing", reason="No notebook.", notes=("Odd.",))
    row = prepared(missing, TURNS, 3)
    assert isinstance(row, Row)
    assert (row.status, row.reason, row.out_of, row.odd) == (
        "missing",
        "No notebook.",
        3,
        ("Odd.",),
    )


def test_what_cannot_be_read_has_its_row():
    row = prepared(submission("ada", b""), TURNS, 3)
    assert (row.status, row.reason) == ("unreadable", "'ada.ipynb' is empty.")
    assert (row.where, row.points) == ("ada.ipynb", 0)


def test_what_can_be_read_is_a_job():
    content = notebook("a = 1").encode()
    read = prepared(submission("ada", content, notes=("Odd.",)), TURNS, 3)
    assert (read.cells, read.named, read.odd) == (("a = 1",), Named("ada"), ("Odd.",))


def test_the_marker_can_be_sent_elsewhere():
    marker = Marker(exercise_from_text(CHECKS, "01_turns"), 1, "robots", "none")
    again = pickle.loads(pickle.dumps(marker))
    assert again.exercise.text == CHECKS
    assert again("ada", ("x = 1",)).questions[0].reason == "missing"
