"""Results of a made-up class, for what is written from them."""

from dhlab.grading.judge import Judged
from dhlab.grading.results import ClassResults, Column, Row, Run

WHY = "This is exactly what you get when "
RUN = Run("07_dh_link", "ab" * 32, "robots", 17, "bwrap", {"dhlab": "0.1.0"}, title="One link")
COLUMNS = (Column("dh_link", 2.0), Column("T", 1.0))


def right(name, points):
    """A right answer."""
    return Judged(name, points, points, True, "right", "Right.")


def wrong(name, points, text="It is 0.2 m off.", mistakes=(), reason="wrong"):
    """Another answer."""
    return Judged(name, 0, points, False, reason, text, mistakes)


def row(student, *questions, status="graded", **options):
    """A student's row."""
    points = sum(judged.points for judged in questions)
    options = {"reason": "", "where": f"{student}.ipynb", "sha256": "00"} | options
    return Row(student, student, status, points=points, out_of=3, questions=questions, **options)


def results(*rows):
    """A class of these students."""
    return ClassResults(RUN, COLUMNS, rows, "2026-11-03T16:05:12+00:00")


ADA = row("Ada Lovelace", right("dh_link", 2), right("T", 1))
BOB = row(
    "Bob",
    wrong("dh_link", 2, f"Seen. {WHY}either a is left out, or d is. Which?", ("a", "d")),
    right("T", 1),
    notes=("It tried to write a file.",),
)
EVE = row(
    "Eve",
    wrong("dh_link", 2, f"Seen. {WHY}either a is left out, or d is. Which?", ("a", "d")),
    wrong("T", 1, f"Seen. {WHY}the order is reversed. Which is first?", ("reversed-order",)),
)
KURT = row(
    "Kurt",
    wrong("dh_link", 2, "Nothing is there yet.", reason="stub"),
    wrong("T", 1, "ZeroDivisionError", reason="raised"),
    status="partly graded",
    reason="Cell 3 was left out.",
)
LOST = row("Lost", status="missing", reason="No notebook was handed in.")
CLASS = results(ADA, BOB, EVE, KURT, LOST)
HOSTILE = row(
    "<script>document.title='owned'</script>",
    wrong("dh_link", 2, "<img src=x onerror=document.title='owned'> ![x](http://e.example/x.png)"),
    wrong("T", 1, f"{WHY}<b>it</b> is so. ?", ("</style><script>",)),
    status="partly graded",
    reason='=HYPERLINK("http://e.example")',
    notes=("<svg onload=document.title='owned'>", "a\u202eb"),
)
