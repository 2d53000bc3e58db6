"""`dhlab exercise build` and `new`, as an instructor types them."""

import shutil
from pathlib import Path

import pytest

from dhlab.cli import main

EXERCISES = Path(__file__).parents[2] / "exercises"


def test_build_tells_what_it_wrote_and_new_copies(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(["exercise", "new", "exercises/41_mine"]) == 0
    said = capsys.readouterr().out
    assert "exercises/41_mine is a copy of 01_rotation_matrices. Change in it\n" in said
    assert "five new ones are needed\nand then: dhlab exercise build exercises/41_mine\n" in said
    assert main(["exercise", "build"]) == 0
    assert "41_mine.ipynb written (3 questions" in capsys.readouterr().out
    assert main(["exercise", "build", "exercises/41_mine"]) == 0
    assert "41_mine.ipynb up to date" in capsys.readouterr().out
    assert main(["exercise", "new", "exercises/41_mine"]) == 2
    assert "exists already" in capsys.readouterr().err


def test_build_goes_on_after_a_refused_exercise_and_fails_at_the_end(tmp_path, capsys):
    for name in ("01_bad", "02_good"):
        shutil.copytree(EXERCISES / "01_rotation_matrices", tmp_path / name)
    (tmp_path / "01_bad" / "checks.py").write_text("def questions(given):\n    return 1 / 0\n")
    assert main(["exercise", "build", str(tmp_path)]) == 2
    said = capsys.readouterr()
    assert "01_bad is refused" in said.out
    assert "checks.py, line 2: ZeroDivisionError" in said.out
    assert "02_good.ipynb written" in said.out
    assert "1 of the exercises cannot be released yet" in said.err


def test_build_tells_every_problem_on_a_line_and_the_name_of_the_folder_it_is_in(
    tmp_path, capsys, monkeypatch
):
    folder = tmp_path / "01_bad"
    shutil.copytree(EXERCISES / "01_rotation_matrices", folder)
    text = (folder / "exercise.py").read_text("utf-8")
    (folder / "exercise.py").write_text(text.replace("**Points.** 6", "**Points.** 7"), "utf-8")
    monkeypatch.chdir(folder)
    assert main(["exercise", "build", "."]) == 2
    said = capsys.readouterr().out
    assert said.startswith("dhlab: 01_bad is refused: exercise.py, line 7: the text says 7 points")
    (folder / "wrong.py").write_text("# %% [markdown]\n# Nothing yet.\n")
    assert main(["exercise", "build", "."]) == 2
    said = capsys.readouterr().out.splitlines()
    assert [line.partition(":")[0] for line in said] == [
        "dhlab",
        "  exercise.py, line 7",
        "  wrong.py",
    ]


@pytest.mark.parametrize("name", ["bad name", "a.b", "café?", "x'y"])
def test_a_name_that_no_notebook_should_have_is_refused(tmp_path, capsys, name):
    assert main(["exercise", "new", str(tmp_path / "mine" / name)]) == 2
    said = capsys.readouterr().err
    assert "cannot be an exercise" in said
    assert "letters, digits, '_' and '-', such as 12_my_arm" in said
    assert not (tmp_path / "mine").exists()


def test_help_says_how_a_wrong_answer_names_its_diagnosis(capsys):
    with pytest.raises(SystemExit, match="0"):
        main(["exercise", "--help"])
    said = capsys.readouterr().out
    assert "# %% rot_z: sign-1" in said
    assert "the key of a mistake or some words of what the" in said


def test_a_folder_without_exercises_is_told_in_a_sentence(tmp_path, capsys):
    assert main(["exercise", "build", str(tmp_path)]) == 2
    assert "no exercise lies in" in capsys.readouterr().err
