"""`dhlab grade`."""

import os
import re
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from dhlab import cli
from dhlab.cli.grade import summary
from dhlab.grading.roster import FIRST, IDS, LAST, NAMES
from tests.grading.classroom import NAME, answered, write_exercise
from tests.grading.made import CLASS, HOSTILE, LOST, results, right, row

posix = pytest.mark.skipif(os.name != "posix", reason="answers are marked on Linux or macOS")


@pytest.fixture
def folder(tmp_path):
    """An exercise, and what three students handed in."""
    write_exercise(tmp_path)
    (tmp_path / "class").mkdir()
    for student, kind in (("ada", "right"), ("bob", "order")):
        (tmp_path / "class" / f"{student}.ipynb").write_text(answered(student, kind))
    (tmp_path / "class" / "eve.ipynb").write_bytes(b"")
    return tmp_path


def words(folder, *more):
    """Command line that marks the class of a folder."""
    exercise, source, out = folder / "exercises" / NAME, folder / "class", folder / "results"
    return ["grade", str(exercise), str(source), "--out", str(out), *more]


@posix
def test_a_class_is_marked_with_one_command(folder, capsys):
    options = ["--sandbox", "none", "--course", "robots", "--seed", "7", "--workers", "1"]
    assert cli.main(words(folder, *options)) == 0
    said = capsys.readouterr()
    assert said.out.splitlines() == [
        "01_turns: 3 students, 2 graded, 1 unreadable",
        "  points: mean 2.5, median 2.5 of 3",
        "  R_own: 1 of 2 right",
        "  rot_z: 2 of 2 right",
        "  1 x R_own: the factors are multiplied in the reverse order",
        "  unreadable: eve: 'eve.ipynb' is empty.",
        f"dhlab: wrote {folder / 'results' / 'class.html'}, and grades and feedback beside it",
    ]
    assert said.err == ""
    files = {path.name for path in (folder / "results").iterdir()}
    assert files == {"class.html", "feedback", "grades.csv", "gradescope", "results.json"}


@posix
def test_the_command_of_the_shell_does_the_same(folder):
    env = os.environ | {"PYTHONPATH": str(Path(__file__).parents[2])}
    command = [sys.executable, "-m", "dhlab", *words(folder, "--sandbox", "none")]
    done = subprocess.run(command, env=env, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("01_turns: 3 students, 2 graded, 1 unreadable\n")


def test_help_says_what_is_read_and_written(capsys):
    with pytest.raises(SystemExit, match="0"):
        cli.main(["grade", "--help"])
    text = capsys.readouterr().out
    for option in ("EXERCISE", "SUBMISSIONS", "--out RESULTS", "--seed N", "--course NAME"):
        assert option in text
    for option in ("--students FILE", "--workers N", "--dask ADDRESS", "--sandbox {bwrap,none}"):
        assert option in text
    for name in ("grades.csv", "class.html", "feedback/", "gradescope/", "results.json"):
        assert name in text


def test_help_names_every_column_of_a_list_of_students(capsys):
    with pytest.raises(SystemExit, match="0"):
        cli.main(["grade", "--help"])
    words = set(re.findall(r"\w+", capsys.readouterr().out))
    assert {*IDS, *NAMES, FIRST[0], LAST[0]} <= words


@pytest.mark.parametrize(
    ("more", "said"),
    [
        (["--seed", "-1"], "a seed is a whole number from 0, got '-1'"),
        (["--seed", "many"], "a seed is a whole number from 0, got 'many'"),
        (["--workers", "0"], "workers are a number from 1 to 999, got '0'"),
        (["--sandbox", "docker"], "invalid choice: 'docker'"),
    ],
)
def test_a_wrong_option_says_what_was_wanted(folder, capsys, more, said):
    with pytest.raises(SystemExit, match="2"):
        cli.main(words(folder, *more))
    assert said in capsys.readouterr().err


def test_the_results_must_be_named(folder, capsys):
    with pytest.raises(SystemExit, match="2"):
        cli.main(words(folder)[:3])
    assert "required: --out" in capsys.readouterr().err


def test_an_exercise_that_is_none_is_one_sentence(folder, capsys):
    arguments = words(folder)
    arguments[1] = str(folder)
    assert cli.main(arguments) == 2
    said = capsys.readouterr().err
    assert said == f"dhlab: {folder} is no exercise: there is no checks.py in it\n"
    assert not (folder / "results").exists()


def test_an_interruption_says_how_to_go_on(folder, capsys, monkeypatch):
    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr("dhlab.grading.grade.grade", interrupted)
    assert cli.main(words(folder)) == 130
    assert "the same command goes on from here" in capsys.readouterr().err


def test_the_summary_names_figures_mistakes_and_who_has_no_marks(tmp_path):
    lines = list(summary(CLASS, tmp_path))
    assert lines[:4] == [
        "07_dh_link: 5 students, 3 graded, 1 partly graded, 1 missing",
        "  points: mean 1, median 0.5 of 3",
        "  dh_link: 1 of 4 right",
        "  T: 2 of 4 right",
    ]
    assert "  2 x dh_link: either a is left out, or d is" in lines
    assert "  missing: Lost: No notebook was handed in." in lines


def test_the_summary_counts_whose_numbers_are_not_sure(tmp_path):
    rows = [
        row("al", right("T", 1), typed="Ada\x1b", whose="Those of Ada."),
        row("cb", right("T", 1), typed="Ada\x1b", whose="Those of Ada."),
        row("eve", right("T", 1), typed="Bob", status="second look", reason="Not hers."),
    ]
    lines = list(summary(results(*rows), tmp_path))
    assert lines[0] == "07_dh_link: 3 students, 2 graded, 1 second look"
    assert "  2 submissions name 'Ada\ufffd': al, cb" in lines
    assert "  second look: eve: Not hers." in lines
    assert any(line.startswith("  2 with the numbers of the name in the") for line in lines)


def test_a_long_summary_is_cut(tmp_path):
    lines = list(summary(results(*(replace(LOST, student=f"s{k}") for k in range(30))), tmp_path))
    assert "  ... and 20 more" in lines
    assert len(lines) < 20


def test_hostile_names_cannot_write_to_the_terminal(tmp_path):
    odd = replace(HOSTILE, student="\x1b]0;owned\x07\nx", status="unreadable")
    text = "\n".join(summary(results(odd), tmp_path))
    assert "\x1b" not in text
    assert "\x07" not in text
