"""`dhlab exercise build` and `new`, as an instructor types them."""

import shutil
from pathlib import Path

from dhlab.cli import main

EXERCISES = Path(__file__).parents[2] / "exercises"


def test_build_tells_what_it_wrote_and_new_copies(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(["exercise", "new", "exercises/41_mine"]) == 0
    assert "exercises/41_mine is a copy to be changed" in capsys.readouterr().out
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


def test_a_folder_without_exercises_is_told_in_a_sentence(tmp_path, capsys):
    assert main(["exercise", "build", str(tmp_path)]) == 2
    assert "no exercise lies in" in capsys.readouterr().err
