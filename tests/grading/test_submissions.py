"""One submission per student, whatever was handed in."""

import json
import zipfile

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dhlab.errors import InputError
from dhlab.grading.entries import Entry, handed_in
from dhlab.grading.roster import people_from
from dhlab.grading.submissions import find_submissions

EXERCISE, OTHERS = "07_dh_link", ["01_turns", "07_dh_link", "08_tables"]
NOTEBOOK = json.dumps({"cells": [{"cell_type": "code", "source": "a = 1"}]})


def written(folder, paths):
    """Write a notebook at each path; a path that ends in a slash is a folder."""
    for path in paths:
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).mkdir() if path.endswith("/") else (folder / path).write_text(NOTEBOOK)
    return folder


def zipped(folder, paths):
    """Pack a notebook at each path."""
    with zipfile.ZipFile(folder / "class.zip", "w") as archive:
        for path in paths:
            archive.writestr(path, "" if path.endswith("/") else NOTEBOOK)
    return folder / "class.zip"


def found(source, people="", others=OTHERS):
    """Student -> what is said of their submission: its path, or status and reason."""
    with handed_in(source) as entries:
        listed = people_from(people) if people else ()
        submissions = find_submissions(entries, EXERCISE, others, listed)
    assert len({s.student for s in submissions}) == len(submissions)
    return {s.student: s.where if not s.status else f"{s.status}: {s.reason}" for s in submissions}


SIDE_BY_SIDE = ["ada.ipynb", "bob_07_dh_link.ipynb", "07_dh_link-Eve.ipynb"]
NBGRADER = [f"{name}/07_dh_link/07_dh_link.ipynb" for name in ("ada", "bob", "Eve")]
FOLDERS = ["ada/x.ipynb", "bob/07_dh_link.ipynb", "Eve/deep/er/y.ipynb"]
MOODLE = [
    f"{name}_{k}_assignsubmission_file_/x.ipynb" for k, name in enumerate(("ada", "bob", "Eve"))
]
MOODLE_FLAT = [path.replace("/", "") for path in MOODLE]
CANVAS = ["ada_1_11_x.ipynb", "bob_LATE_2_12_07_dh_link.ipynb", "Eve_3_13_x-1.ipynb"]
MIXED = ["ada.ipynb", "bob/07_dh_link/any.ipynb", "Eve/x.ipynb"]
ARRANGEMENTS = [SIDE_BY_SIDE, NBGRADER, FOLDERS, MOODLE, MOODLE_FLAT, CANVAS, MIXED]


@pytest.mark.parametrize("write", [written, zipped])
@pytest.mark.parametrize("paths", ARRANGEMENTS)
def test_every_arrangement_gives_a_notebook_per_student(tmp_path, write, paths):
    assert found(write(tmp_path, paths)) == dict(zip(("ada", "bob", "Eve"), paths, strict=True))


@pytest.mark.parametrize("top", ["submitted/", ""])
def test_a_course_s_folder_is_looked_into(tmp_path, top):
    written(tmp_path, [top + path for path in NBGRADER])
    if top:
        written(tmp_path, ["source/07_dh_link/07_dh_link.ipynb", "gradebook.ipynb"])
    assert set(found(tmp_path)) == {"ada", "bob", "Eve"}


def test_other_exercises_of_a_student_are_not_looked_at(tmp_path):
    paths = ["ada/07_dh_link/x.ipynb", "ada/08_tables/x.ipynb", "bob/08_tables/x.ipynb"]
    paths += ["eve/07_dh_link.ipynb", "eve/01_turns.ipynb", "kurt/01_turns.ipynb"]
    assert found(written(tmp_path, paths)) == {
        "ada": "ada/07_dh_link/x.ipynb",
        "bob": "missing: No notebook was handed in.",
        "eve": "eve/07_dh_link.ipynb",
        "kurt": "missing: No notebook was handed in.",
    }


def test_side_by_side_other_exercises_are_not_looked_at(tmp_path):
    written(tmp_path, ["ada_07_dh_link.ipynb", "ada_08_tables.ipynb", "bob_08_tables.ipynb"])
    assert found(tmp_path) == {"ada": "ada_07_dh_link.ipynb"}


def test_an_empty_folder_is_a_student_without_a_notebook(tmp_path):
    assert found(written(tmp_path, ["ada/", "bob/07_dh_link/"])) == {
        "ada": "missing: No notebook was handed in.",
        "bob": "missing: No notebook was handed in.",
    }


@pytest.mark.parametrize(
    "paths",
    [
        ["ada/07_dh_link.ipynb", "ada/07_dh_link-Copy1.ipynb"],
        ["ada/07_dh_link/07_dh_link.ipynb", "ada/07_dh_link/scratch.ipynb"],
        ["ada.ipynb", "ada_07_dh_link.ipynb"],
        ["ada.ipynb", "ada (1).ipynb"],
        ["ada.ipynb", "Ada.ipynb"],
        ["ada.ipynb", "ada/x.ipynb"],
        ["ada_1_11_x.ipynb", "ada_1_12_y.ipynb"],
    ],
)
def test_of_two_notebooks_none_is_guessed(tmp_path, paths):
    (said,) = found(zipped(tmp_path, paths)).values()
    assert said.startswith("unreadable: There are 2 notebooks: ")
    assert said.endswith(" Which one is meant? Leave that one.")
    assert all(repr(path) in said for path in paths)


def test_two_students_of_one_name_are_two(tmp_path):
    paths = ["Jo Lee_1_assignsubmission_file_/x.ipynb", "Jo Lee_2_assignsubmission_file_/x.ipynb"]
    assert found(written(tmp_path, paths)) == {"Jo Lee (1)": paths[0], "Jo Lee (2)": paths[1]}


def test_a_renamed_notebook_is_found(tmp_path):
    paths = ["ada.ipynb.txt", "bob/answer.json", "eve/answer.ipynb", "eve/report.pdf"]
    assert found(written(tmp_path, paths)) == {"ada": paths[0], "bob": paths[1], "eve": paths[2]}


def test_files_that_are_no_notebooks_are_said(tmp_path):
    said = found(written(tmp_path, ["ada/a.pdf", "ada/b.docx"]))
    assert said == {
        "ada": "missing: No notebook was handed in, but 2 other files: 'ada/a.pdf', 'ada/b.docx'."
    }


def test_what_lies_beside_the_notebooks_is_no_student(tmp_path):
    written(tmp_path, ["ada.ipynb", "README.md", "grades.csv", "readme.txt", "Thumbs.db"])
    assert set(found(tmp_path)) == {"ada"}


def test_who_is_on_the_list_and_handed_in_nothing_is_missing(tmp_path):
    written(tmp_path, ["a1.ipynb", "Kurt Gödel_9_assignsubmission_file_/x.ipynb", "eve.ipynb"])
    people = "id,name\na1,Ada Lovelace\nk1,Kurt Gödel\nb1,Bob\n"
    assert found(tmp_path, people) == {
        "a1": "a1.ipynb",
        "b1": "missing: No notebook was handed in.",
        "eve": "eve.ipynb",
        "k1": "Kurt Gödel_9_assignsubmission_file_/x.ipynb",
    }


def test_who_is_not_on_the_list_is_marked_and_noted(tmp_path):
    written(tmp_path, ["ada.ipynb", "eve.ipynb"])
    with handed_in(tmp_path) as entries:
        ada, eve = find_submissions(entries, EXERCISE, people=people_from("name\nada\n"))
    assert (ada.notes, eve.notes) == ((), ("Not on the list of students.",))
    assert eve.where == "eve.ipynb"


def test_two_submissions_of_one_student_of_the_list_are_asked_about(tmp_path):
    written(tmp_path, ["a1.ipynb", "lovelaceada_5_6_x.ipynb"])
    said = found(tmp_path, "id,name\na1,Ada Lovelace\n")
    assert set(said) == {"a1"}
    assert "Which one is meant?" in said["a1"]


def test_two_students_of_one_name_on_the_list_are_told_by_number(tmp_path):
    written(tmp_path, ["leejo_1_8_x.ipynb", "leejo_2_9_x.ipynb"])
    said = found(tmp_path, "id,name\n1,Jo Lee\n2,Jo Lee\n")
    assert said == {"1": "leejo_1_8_x.ipynb", "2": "leejo_2_9_x.ipynb"}


def test_a_submission_is_read_with_its_digest(tmp_path):
    with handed_in(written(tmp_path, ["ada.ipynb"])) as entries:
        (ada,) = find_submissions(entries, EXERCISE)
        digest, notebook = ada.read()
    assert len(digest) == 64
    assert notebook.cells == ("a = 1",)


def test_what_cannot_be_read_is_a_sentence_with_the_file_s_name(tmp_path):
    (tmp_path / "ada.ipynb").write_text("")
    (tmp_path / "bob").symlink_to(tmp_path)
    with handed_in(tmp_path) as entries:
        ada, bob = find_submissions(entries, EXERCISE)
        with pytest.raises(InputError, match=r"^'ada\.ipynb' is empty\.$"):
            ada.read()
        with pytest.raises(
            InputError, match=r"^'bob' is a symbolic link, which is not followed\.$"
        ):
            bob.read()


names = st.sampled_from(
    [
        *("ada", "Ada", "ada.ipynb", "ADA.ipynb", "ada-Copy1.ipynb", "ada (1)", "ada (2).ipynb"),
        *("ada_1_2_x.ipynb", "ada_2_2_x.ipynb", "x.ipynb", "bob", "bob.pdf", " ", " .ipynb"),
        *("ada_1_assignsubmission_file_", "ada_2_assignsubmission_file_", "submitted"),
        *("07_dh_link", "07_dh_link.ipynb", "08_tables", "\u202e"),
    ]
)
paths = st.lists(names, min_size=1, max_size=4).map(tuple)


@settings(max_examples=300)
@given(
    st.lists(
        st.builds(Entry, paths, st.booleans(), st.sampled_from(["", "is a link"])), max_size=8
    ),
    st.sampled_from(["", "ada\nbob\n", "id,name\n1,ada\n2,ada\n3,x\n"]),
)
def test_every_student_has_one_submission_and_every_notebook_one_student(entries, people):
    listed = people_from(people) if people else ()
    submissions = find_submissions(entries, EXERCISE, OTHERS, listed)
    keys = [s.student.casefold() for s in submissions]
    assert len(set(keys)) == len(keys)
    assert {person.student for person in listed} <= {s.student for s in submissions}
    read = [id(s.entry) for s in submissions if s.entry is not None]
    assert len(set(read)) == len(read)
    assert all(s.status or s.where for s in submissions)
