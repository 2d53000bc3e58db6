"""`dhlab grade`: a class marked with one command."""

import argparse
import sys
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from dhlab.cli.commands import Commands, add_command
from dhlab.cli.progress import Progress

if TYPE_CHECKING:
    from dhlab.grading.results import ClassResults

GRADE = """\
Mark a class: run each student's notebook in a sandbox, ask it for values, judge them, and write
grades, feedback and a page for the instructor.

SUBMISSIONS is a folder of notebooks, nbgrader's submitted/STUDENT/EXERCISE/, a folder for each
student, or the zip archive of a learning platform (Moodle, Canvas, Brightspace, Blackboard).
Each student gets one row, whatever they handed in. An interrupted run goes on with the same
command; only what has changed is marked again.\
"""
EPILOG = """\
the list of students (FILE):
  one name a line, or a heading and a row for each student, parted by commas, semicolons or tabs:
    an id    student_id, id, username, login, login_id, sis_login_id, sis_user_id, id_number,
             email, email_address
    a name   name, full_name, student, student_name; or first_name and last_name
  Who handed in nothing is missing. Students' own numbers come from the name in the notebook; where
  the list has another full name for a submission, from the list, and the status is "second look".

what is written to RESULTS (refused if it would take the place of other marks):
  grades.csv               a row for each student
  class.html               how the class did, and which mistakes it made
  feedback/STUDENT.md      what a student may read
  gradescope/STUDENT.json  the same for Gradescope
  results.json             everything, with the seed of the hidden cases\
"""
BY_NOTEBOOK = (
    "with the numbers of the name in the notebook, not that of the submission: a list with both, "
    "--students, joins them"
)
MOST_TOLD = 10


def add_grade(commands: Commands) -> None:
    """Add `dhlab grade`."""
    short = "mark a class's notebooks"
    grade = add_command(commands, "grade", short, GRADE, run_grade, EPILOG)
    grade.add_argument("exercise", type=Path, metavar="EXERCISE", help="folder of the exercise")
    grade.add_argument("submissions", type=Path, metavar="SUBMISSIONS", help="what was handed in")
    grade.add_argument("--out", required=True, type=Path, metavar="RESULTS", help="a folder")
    grade.add_argument(
        "--seed", type=_whole, metavar="N", help="of the hidden cases (default: a fresh one)"
    )
    grade.add_argument(
        "--course",
        default="",
        metavar="NAME",
        help="for students' own numbers (default: that of the exercise's notebook)",
    )
    grade.add_argument("--students", type=Path, metavar="FILE", help="list of the class, see below")
    grade.add_argument(
        "--workers", type=_positive, metavar="N", help="processes (default: one per processor)"
    )
    grade.add_argument(
        "--dask", default="", metavar="ADDRESS", help="mark on the workers of this Dask scheduler"
    )
    grade.add_argument(
        "--sandbox",
        choices=("bwrap", "none"),
        default="bwrap",
        help="none: run the students' code unprotected, with all that you may do yourself",
    )


def run_grade(options: argparse.Namespace) -> int:
    """Mark a class and say what came of it."""
    from dhlab.grading.grade import Order, grade

    order = Order(
        exercise=options.exercise.expanduser(),
        source=options.submissions.expanduser(),
        out=options.out.expanduser(),
        seed=options.seed,
        course=options.course,
        people=options.students,
        workers=options.workers,
        dask=options.dask,
        sandbox=options.sandbox,
    )
    try:
        results = grade(order, Progress(sys.stderr))
    except KeyboardInterrupt:
        print("\ndhlab: interrupted; the same command goes on from here", file=sys.stderr)
        return 130
    for line in summary(results, order.out):
        print(line)
    return 0


def summary(results: "ClassResults", out: Path) -> Iterator[str]:
    """Say in lines what came of a class.

    Parameters
    ----------
    results : ClassResults
    out : Path
        Where the results lie.
    """
    from dhlab.grading.figures import answers, mean_and_median, misconceptions
    from dhlab.grading.grades import number
    from dhlab.grading.named import doubles
    from dhlab.grading.plain import one_line
    from dhlab.grading.results import STATUSES

    often = Counter(row.status for row in results.rows)
    parts = ", ".join(f"{often[status]} {status}" for status in STATUSES if often[status])
    yield f"{results.run.exercise}: {len(results.rows)} students, {parts}"
    averages = mean_and_median(results)
    if averages is not None:
        mean, median = (number(round(value, 2)) for value in averages)
        yield f"  points: mean {mean}, median {median} of {number(results.out_of)}"
    for found in answers(results):
        asked = found.right + found.wrong + found.nothing + found.failed
        yield f"  {found.name}: {found.right} of {asked} right"
    for one in misconceptions(results)[:MOST_TOLD]:
        yield f"  {len(one.students)} x {one.question}: {one_line(one.text)}"
    for group in doubles(results.rows):
        who = ", ".join(one_line(row.student, 60) for row in group[:MOST_TOLD])
        yield f"  {len(group)} submissions name {one_line(group[0].typed, 60)!r}: {who}"
    by_notebook = sum(bool(row.whose) for row in results.rows)
    if by_notebook:
        yield f"  {by_notebook} {BY_NOTEBOOK}"
    odd = [row for row in results.rows if row.status in ("second look", "unreadable", "missing")]
    for row in odd[:MOST_TOLD]:
        yield f"  {row.status}: {one_line(row.student)}: {one_line(f'{row.reason} {row.failed}')}"
    if len(odd) > MOST_TOLD:
        yield f"  ... and {len(odd) - MOST_TOLD} more"
    yield f"dhlab: wrote {out / 'class.html'}, and grades and feedback beside it"


def _whole(text: str) -> int:
    if not (text.isdecimal() and text.isascii() and len(text) < 20):
        raise argparse.ArgumentTypeError(f"a seed is a whole number from 0, got {text!r}")
    return int(text)


def _positive(text: str) -> int:
    if not (text.isdecimal() and text.isascii() and 0 < int(text) < 1000):
        raise argparse.ArgumentTypeError(f"workers are a number from 1 to 999, got {text!r}")
    return int(text)
