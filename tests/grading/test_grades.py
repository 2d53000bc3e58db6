"""`grades.csv`."""

import csv
from dataclasses import replace

from dhlab.grading.grades import add_grade, heading, number, write_grades
from dhlab.grading.results import Column
from tests.grading.made import ADA, CLASS, HOSTILE, results


def read(path):
    """Rows of a CSV file."""
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def test_each_student_has_a_row_with_nbgrader_s_names(tmp_path):
    write_grades(tmp_path / "grades.csv", CLASS)
    ada, bob, eve, kurt, lost = read(tmp_path / "grades.csv")
    assert ada == {
        "assignment": "07_dh_link", "student_id": "Ada Lovelace", "score": "3", "max_score": "3",
        "dh_link": "2", "T": "1", "status": "graded", "reason": "", "notes": "",
    }  # fmt: skip
    assert (bob["score"], bob["notes"]) == ("1", "It tried to write a file.")
    assert (eve["dh_link"], eve["T"]) == ("0", "0")
    assert (kurt["status"], kurt["reason"]) == ("partly graded", "Cell 3 was left out.")
    assert (lost["score"], lost["status"]) == ("0", "missing")


def test_rows_added_one_by_one_are_the_same(tmp_path):
    write_grades(tmp_path / "whole.csv", CLASS)
    write_grades(tmp_path / "added.csv", results())
    for row in CLASS.rows:
        add_grade(tmp_path / "added.csv", CLASS, row)
    assert (tmp_path / "added.csv").read_bytes() == (tmp_path / "whole.csv").read_bytes()


def test_no_cell_is_a_formula_and_no_row_is_broken(tmp_path):
    odd = replace(ADA, student='=1+1,"\n@SUM(A1)', notes=("-2", "+3"))
    write_grades(tmp_path / "grades.csv", results(HOSTILE, odd))
    first, second = read(tmp_path / "grades.csv")
    assert first["reason"].startswith("'=HYPERLINK")
    assert second["student_id"] == "'=1+1,\" @SUM(A1)"
    assert second["notes"] == "'-2 +3"


def test_a_question_may_be_named_as_any_column():
    names = heading((Column("score", 1), Column("status", 1), Column("dh_link", 1)))
    assert len(set(names)) == len(names)
    assert "dh_link" in names


def test_points_are_written_as_by_hand():
    assert [number(p) for p in (0, 2.0, 0.5, 1 / 3, 1e6)] == [
        "0",
        "2",
        "0.5",
        "0.333333",
        "1000000",
    ]
