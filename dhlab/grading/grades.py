"""`grades.csv`: a row per student, with nbgrader's names for the columns that it has too."""

import csv
import io
from pathlib import Path

from dhlab.grading.plain import spreadsheet
from dhlab.grading.results import ClassResults, Column, Row, write_whole

BEFORE = ("assignment", "student_id", "score", "max_score")
AFTER = ("status", "reason", "notes")


def heading(columns: tuple[Column, ...]) -> list[str]:
    """Return the names of the columns; a question that is named as another column is marked so.

    Examples
    --------
    >>> heading((Column("dh_link", 2), Column("score", 1)))[4:6]
    ['dh_link', 'score (question)']
    """
    taken = {*BEFORE, *AFTER}
    asked = [c.name + " (question)" if c.name in taken else c.name for c in columns]
    return [*BEFORE, *asked, *AFTER]


def cells(results: ClassResults, row: Row) -> list[str]:
    """Return a student's row, as texts."""
    return [
        spreadsheet(results.run.exercise),
        spreadsheet(row.student),
        number(row.points),
        number(results.out_of),
        *(number(points) for points in results.points_of(row)),
        row.status,
        spreadsheet(row.reason),
        spreadsheet(" ".join(row.all_notes)),
    ]


def write_grades(path: Path, results: ClassResults) -> None:
    """Write the rows of all students."""
    lines = [heading(results.columns), *(cells(results, row) for row in results.rows)]
    write_whole(path, "".join(_line(texts) for texts in lines))


def add_grade(path: Path, results: ClassResults, row: Row) -> None:
    """Add one student's row to a file that was begun."""
    with path.open("a", encoding="utf-8", newline="") as file:
        file.write(_line(cells(results, row)))


def number(value: float) -> str:
    """Return points as they are written by hand.

    Examples
    --------
    >>> number(2.0), number(0.1 + 0.2)
    ('2', '0.3')
    """
    return f"{round(value, 6):.12g}"


def _line(texts: list[str]) -> str:
    line = io.StringIO()
    csv.writer(line, lineterminator="\n").writerow(texts)
    return line.getvalue()
