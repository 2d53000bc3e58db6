"""Results as a file, and back."""

import json
from dataclasses import replace

import pytest

from dhlab.errors import DhlabError
from dhlab.grading.mark import Marked
from dhlab.grading.results import Row, read_results, row_from, row_of, write_results, write_whole
from tests.grading.made import CLASS, HOSTILE, RUN, results


def test_results_come_back_as_they_were(tmp_path):
    write_results(tmp_path / "results.json", CLASS)
    assert read_results(tmp_path / "results.json") == (RUN, list(CLASS.rows))


def test_the_file_says_seed_versions_digests_and_every_student(tmp_path):
    write_results(tmp_path / "results.json", CLASS)
    document = json.loads((tmp_path / "results.json").read_text("utf-8"))
    assert (document["seed"], document["versions"]) == (17, {"dhlab": "0.1.0"})
    assert [s["student"] for s in document["students"]] == [r.student for r in CLASS.rows]
    assert all("sha256" in student for student in document["students"])


def test_hostile_names_are_kept_as_they_are(tmp_path):
    write_results(tmp_path / "results.json", results(HOSTILE))
    _, (row,) = read_results(tmp_path / "results.json")
    assert row == HOSTILE


def test_a_row_has_everything_that_marking_says():
    marked = Marked(
        "Ada", (), 1, 3, "partly graded", "Why.", ("Note",), (2,), 0.1, ("numpy",), 5, {"f": []}
    )
    row = replace(row_of(marked, "a1", "ff"), odd=("Latin-1.",), whose="Those of Ada.")
    assert (row.student, row.name, row.status, row.reason) == ("a1", "Ada", "partly graded", "Why.")
    assert row.all_notes == ("Latin-1.", "Those of Ada.", "Note")
    assert row.details == {
        "left_out": [2],
        "seconds": 0.1,
        "imports": ["numpy"],
        "seed": 5,
        "cases": {"f": []},
    }
    assert row_from(json.loads(json.dumps(row.as_json()))) == row


@pytest.mark.parametrize(
    "text", ["", "[]", "{}", '{"students": [{}]}', '{"exercise": "x"', "\x00", "null"]
)
def test_a_file_that_is_not_ours_is_told(tmp_path, text):
    (tmp_path / "results.json").write_text(text)
    with pytest.raises(DhlabError, match=r"is not a file of results \(.*\); move it away"):
        read_results(tmp_path / "results.json")


def test_points_follow_the_columns():
    assert [CLASS.points_of(row) for row in CLASS.rows][:2] == [[2, 1], [0, 1]]
    assert CLASS.points_of(Row("x", "x", "missing", "", 0, 3)) == [0, 0]
    assert CLASS.out_of == 3


def test_a_file_is_replaced_whole(tmp_path):
    write_whole(tmp_path / "a.txt", "one")
    write_whole(tmp_path / "a.txt", "two\n")
    assert [p.name for p in tmp_path.iterdir()] == ["a.txt"]
    assert (tmp_path / "a.txt").read_bytes() == b"two\n"
