"""The table of misconceptions: each is asked for in a lesson of a notebook, and resolved."""

import json
import re
from pathlib import Path

import pytest

from dhlab.lessons import course

NOTEBOOKS = Path(__file__).parents[1] / "notebooks"
TABLE = (NOTEBOOKS / "misconceptions.md").read_text("utf-8")
ROWS = [
    [cell.strip() for cell in line.strip("|").split("|")]
    for line in TABLE.splitlines()
    if re.match(r"\| \d+ \|", line)
]
WANTED = [*range(1, 21), 23, 24]


def place(text):
    """Code of the notebook, the lesson, and its step, of a place in the table."""
    number, name, title = text.split(" / ")
    (path,) = NOTEBOOKS.glob(f"{number}_*.ipynb")
    cells = json.loads(path.read_text("utf-8"))["cells"]
    code = "".join("".join(cell["source"]) + "\n" for cell in cells if cell["cell_type"] == "code")
    lesson = course.LESSONS[name]()
    (step,) = [step for step in lesson.steps if step.title == title]
    return code, name, lesson, step


def test_every_misconception_is_met_once():
    assert [int(row[0]) for row in ROWS] == WANTED
    assert len({row[1] for row in ROWS}) == len(ROWS)


@pytest.mark.parametrize("row", ROWS, ids=[row[0] for row in ROWS])
def test_it_is_asked_before_it_is_shown_and_then_resolved(row):
    code, name, lesson, provoking = place(row[2])
    assert f"course.{name}(" in code, "the notebook shows the lesson"
    assert provoking.question is not None
    later_code, later_name, later_lesson, resolving = place(row[3])
    assert f"course.{later_name}(" in later_code
    assert resolving.text
    if later_name == name:
        titles = [step.title for step in lesson.steps]
        assert titles.index(resolving.title) >= titles.index(provoking.title)
    else:
        assert later_lesson.steps


def test_every_lesson_of_the_course_is_shown_in_a_notebook():
    code = "".join(path.read_text("utf-8") for path in NOTEBOOKS.glob("*.ipynb"))
    assert [name for name in course.LESSONS if f"course.{name}(" not in code] == []
