"""An exercise is proved before its notebook is written, and what is wrong is told with its line."""

import json
import re

import pytest

from dhlab.errors import DhlabError
from dhlab.grading.build import begin, build, exercises_in, notebook_path
from dhlab.grading.check import packed
from dhlab.grading.exercise import load_exercise


def refused(folder):
    """What is said when an exercise is refused; then nothing was written."""
    with pytest.raises(DhlabError) as error:
        build(folder)
    assert not notebook_path(folder).exists()
    return str(error.value)


def cells_of(path):
    """Sources of the cells by their ids."""
    cells = json.loads(path.read_text("utf-8"))["cells"]
    return {cell["id"]: "".join(cell["source"]) for cell in cells}


def test_a_good_exercise_becomes_a_notebook_with_stubs_and_its_checks_inside(folder):
    built = build(folder)
    assert (built.changed, built.questions, built.wrong) == (True, 2, 5)
    cells = cells_of(built.notebook)
    assert cells["rot-z"].endswith("\n    raise NotImplementedError")
    assert "R = ..." in cells.values()
    assert packed(load_exercise(folder)) in cells["checks"]
    assert not re.search("SOLUTION|np.cos|first", built.notebook.read_text("utf-8"))


def test_building_twice_gives_the_same_notebook_and_writes_it_once(folder):
    first = build(folder)
    text = first.notebook.read_bytes()
    assert not build(folder).changed
    first.notebook.unlink()
    assert build(folder).notebook.read_bytes() == text


def test_the_cell_with_the_checks_is_folded_away(folder):
    cells = json.loads(build(folder).notebook.read_text("utf-8"))["cells"]
    hidden = [c["id"] for c in cells if c["metadata"].get("jupyter") == {"source_hidden": True}]
    assert hidden == ["checks"]


def test_an_exercise_is_made_by_copying_a_folder_and_changing_it(folder, tmp_path):
    new = begin(tmp_path / "more" / "02_steeper", folder)
    text = (new / "exercise.py").read_text("utf-8")
    assert not notebook_path(new).exists()
    (new / "exercise.py").write_text(text.replace("rot_z(0.7)", "rot_z(0.9)"), "utf-8")
    assert "the answer to 'R' fails its own checks" in refused(new)
    text = (new / "checks.py").read_text("utf-8")
    (new / "checks.py").write_text(text.replace('turn("z", 0.7)', 'turn("z", 0.9)'), "utf-8")
    (new / "wrong.py").write_text(
        (new / "wrong.py").read_text("utf-8").replace("rotz(0.7) @", "rotz(0.9) @"), "utf-8"
    )
    assert build(new).notebook.name == "02_steeper.ipynb"
    assert exercises_in([tmp_path / "more", folder]) == [new, folder]


def test_a_copy_never_overwrites_and_needs_an_exercise(folder, tmp_path):
    with pytest.raises(DhlabError, match="exists already; name a new folder"):
        begin(folder, folder)
    with pytest.raises(DhlabError, match="is no exercise: there is no exercise"):
        begin(tmp_path / "new", tmp_path)
    with pytest.raises(DhlabError, match="no exercise lies in"):
        exercises_in([tmp_path / "nowhere"])


def test_an_answer_that_fails_its_own_checks_is_refused_with_its_line(folder, edit):
    edit("exercise.py", "[[c, -s, 0], [s, c, 0]", "[[c, s, 0], [-s, c, 0]")
    said = refused(folder)
    assert "exercise.py, line 17: the answer to 'rot_z' fails its own checks" in said
    assert "the wrong way round" in said


def test_a_blank_notebook_that_gets_a_point_is_refused(folder, edit):
    edit("exercise.py", "### BEGIN SOLUTION\nfirst", "R = rotx(given['angle']) @ rotz(0.7)\nfirst")
    edit("exercise.py", "rot_z(0.7)\n### END SOLUTION", "rotz(0.7)")
    assert "the blank answer to 'R' is 'right' (1 points)" in refused(folder)


def test_a_blank_notebook_that_raises_is_refused_with_its_line(folder, edit):
    edit("exercise.py", "check.show(yours, R)", "yours(R)")
    said = refused(folder)
    assert re.search(r"exercise\.py, line \d+: the cell that begins here raised InputError", said)


def test_a_line_of_an_answer_that_is_also_given_away_is_refused(folder, edit):
    edit("exercise.py", "# # Turns", "# # Turns\n# `c, s = np.cos(angle), np.sin(angle)`")
    assert "line 20: this line of an answer is also given away" in refused(folder)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("rotz(-angle)", "rotz(angle)", "line 2: 'sign-1' was meant for 'rot_z', but it gets 2"),
        ("# %% rot_z: sign-1", "# %% rot_z: axis-1-y", "0 points and sign-1, inverse"),
        ("# %% rot_z: sign-1", "# %% rot_y: sign-1", "no question 'rot_y'; there are rot_z, R"),
        ("# %% rot_z: sign-1", "# %% sign-1", "begins with '# %% name: mistake'"),
        ("R = rotz(0.7)", "R = rotz(seven)", "wrong.py, line 11: the cell that begins here raised"),
        ("rotz(-angle)", "rotz(-angle", "wrong.py, line 2: '(' was never closed"),
        ('# %% R: shape (3,)\nR = [given["angle"], 0, 0.7]\n', "", "4 wrong answers; 5 are need"),
    ],
)
def test_wrong_answers_that_do_not_prove_what_they_should_are_refused(folder, edit, old, new, said):
    edit("wrong.py", old, new)
    assert said in refused(folder)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("    ### END SOLUTION\n", "", "line 18: a solution begins that does not end in its cell"),
        ("    ### BEGIN SOLUTION\n", "", "line 20: a solution ends that has not begun"),
        ("    c, s", "    ### BEGIN SOLUTION\n    c, s", "line 19: a solution begins inside"),
        ("    ### BEGIN", "    x = 0 ### BEGIN", "line 18: a marker must be a line of its own"),
        ("checks(course", "checks('eNq', course", "line 10: checks() gets its text from the build"),
        ("check = checks", "check = dict", "no cell calls checks()"),
        ("# %% title [markdown]\n", "", "line 1: the text must begin with a cell"),
        ("def rot_z(angle):", "def rot_z(angle:", "exercise.py, line 17: "),
    ],
)
def test_a_source_that_cannot_be_read_is_refused_with_its_line(folder, edit, old, new, said):
    edit("exercise.py", old, new)
    assert said in refused(folder)


@pytest.mark.parametrize("name", ["exercise.py", "checks.py", "wrong.py"])
def test_a_file_that_is_missing_or_not_in_utf8_is_named(folder, name):
    text = (folder / name).read_bytes()
    (folder / name).write_bytes(text + b"# \xff\n")
    assert f"{name} is not written in UTF-8" in refused(folder)
    (folder / name).unlink()
    assert f"there is no {name} in it" in refused(folder)
