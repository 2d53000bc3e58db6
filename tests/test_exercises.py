"""Every exercise: blank, solved and wrong answers get the points and the words meant for them."""

from pathlib import Path

import nbformat
import pytest

from dhlab.grading.build import notebook_path, same
from dhlab.grading.grade import Order, grade
from dhlab.grading.mark import mark_cells
from dhlab.grading.promised import check_problems, given_away, point_problems
from dhlab.grading.proof import (
    ENOUGH,
    Source,
    blank_problems,
    failing,
    mistake_problems,
)
from dhlab.grading.source import notebook_text
from dhlab.grading.trial import check_of, for_student, run_cells

ROOT = Path(__file__).parents[1]
SOURCES = {path.parent.name: path.parent for path in sorted(ROOT.glob("exercises/*/exercise.py"))}


@pytest.fixture(scope="module")
def source(request):
    """The texts of one exercise."""
    return Source(SOURCES[request.param])


def for_each():
    """Run a test for each exercise, one after the other in one process."""
    return pytest.mark.parametrize("source", SOURCES, indirect=True)


@for_each()
def test_the_released_notebook_is_up_to_date(source):
    path = notebook_path(source.folder)
    assert same(path.read_text("utf-8"), notebook_text(source.released)), "dhlab exercise build"
    nbformat.validate(nbformat.read(path, as_version=4))


@for_each()
def test_a_blank_notebook_runs_to_its_end_and_gets_hints_and_no_points(source):
    assert not list(blank_problems(source))


@for_each()
def test_no_answer_is_given_away_and_the_text_tells_the_points_and_questions_there_are(source):
    assert not list(given_away(source.solved, source.released, source.questions))
    for problems in (check_problems, point_problems):
        assert not list(problems(source.released, source.questions))


@for_each()
def test_the_answers_get_all_points_with_anybodys_numbers(source):
    for student in (*source.students, "Ibn al-Haytham", "陳"):
        assert not list(failing(source, student))


@for_each()
def test_typical_wrong_answers_get_no_points_and_the_diagnosis_meant_for_them(source):
    assert len(source.wrong) >= ENOUGH
    assert {wrong.name for wrong in source.wrong} == set(source.names)
    for wrong in source.wrong:
        assert not list(mistake_problems(source, wrong))


@for_each()
def test_when_marked_the_blank_notebook_gets_nothing_and_the_answers_everything(source):
    def marked(cells):
        code = [cell.source for cell in for_student(cells, "Ada Lovelace") if cell.kind == "code"]
        return mark_cells(
            source.exercise, "Ada Lovelace", code, seed=1, course="dhlab", sandbox="none"
        )

    blank, solved = marked(source.released), marked(source.solved)
    assert (blank.points, blank.status, blank.notes) == (0, "graded", ())
    assert {judged.reason for judged in blank.questions} == {"stub"}
    assert (solved.points, solved.status, solved.reason) == (solved.out_of, "graded", "")
    assert solved.notes == ()


@for_each()
def test_the_points_of_the_title_are_those_of_the_questions(source):
    text = "\n".join(cell.source for cell in source.released)
    questions = check_of(run_cells(source.released), "").questions
    assert f"**Points.** {sum(q.points for q in questions):g}." in text
    assert all(question.hint for question in questions)


def test_a_class_is_marked_with_the_numbers_of_the_course_that_the_notebook_names(tmp_path):
    source = Source(SOURCES["02_sequences"])
    assert source.exercise.course == "dhlab"
    for student in ("ada", "grace"):
        cells = for_student(source.solved, student)
        (tmp_path / f"{student}.ipynb").write_text(notebook_text(cells), "utf-8")
    order = Order(source.folder, tmp_path, tmp_path / "results", sandbox="none", workers=1)
    results = grade(order)
    assert [(row.student, row.points) for row in results.rows] == [("ada", 7), ("grace", 7)]
