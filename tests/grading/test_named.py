"""What a notebook says of itself: whose it is, and of which exercise."""

import base64
import json
import tracemalloc
import zlib

import pytest

from dhlab.grading.check import packed
from dhlab.grading.exercise import exercise_from_text
from dhlab.grading.named import Named, doubles, named, other_exercise, told_of_doubles
from dhlab.grading.submissions import Submission
from tests.grading.classroom import CHECKS
from tests.grading.made import row

TURNS = packed(exercise_from_text(CHECKS, "01_turns"))
ADA = 'STUDENT = "Ada Lovelace"'


def of(*names, **options):
    """What somebody handed in who is known by these names."""
    return Submission(names[-1], names, **options)


@pytest.mark.parametrize(
    ("names", "cells", "name"),
    [
        (("lovelaceada",), [ADA], "Ada Lovelace"),
        (("Ada Lovelace", "a1"), ["STUDENT = 'a1'"], "a1"),
        (("Ada Lovelace",), ['STUDENT = ""', "x = 1"], "Ada Lovelace"),
        (("Ada Lovelace",), ['STUDENT = " "'], "Ada Lovelace"),
        (("ada",), ["x = 1"], "ada"),
        (("ada",), ['STUDENT = "Bob"\nSTUDENT = "ADA"  # me'], "ADA"),
    ],
)
@pytest.mark.parametrize("is_listed", [True, False])
def test_a_name_is_known_however_it_is_written(names, cells, name, is_listed):
    found = named(of(*names, is_listed=is_listed), cells)
    assert (found.name, found.whose) == (name, "")


@pytest.mark.parametrize("known", ["alovelace", "12345", "Charles Babbage"])
def test_without_a_list_the_numbers_are_those_of_the_name_in_the_notebook(known):
    found = named(of(known), [ADA])
    assert (found.name, found.typed) == ("Ada Lovelace", "Ada Lovelace")
    assert found.whose == (
        "The numbers are those of 'Ada Lovelace', whom the notebook names; the submission is that "
        f"of '{known}'."
    )


def test_a_full_name_of_the_list_goes_before_the_name_in_the_notebook():
    listed = of("Charles Babbage", "cb1", is_listed=True)
    assert named(listed, [ADA]) == Named("Charles Babbage", "Ada Lovelace")


def test_submissions_that_name_one_student_are_noted_and_nobody_else():
    names = {"al": "Ada Lovelace", "cb": "ada  lovelace", "eve": "Eve", "x": "", "y": ""}
    rows = [row(student, typed=typed) for student, typed in names.items()]
    told = told_of_doubles(rows)
    assert [one.odd for one in told[:2]] == [("2 submissions name 'Ada Lovelace'.",)] * 2
    assert told[2:] == rows[2:]
    assert [[one.student for one in group] for group in doubles(told)] == [["al", "cb"]]


def test_a_note_tells_no_student_who_the_others_are():
    told = told_of_doubles([row("al", typed="Ada"), row("cb", typed="Ada")])
    assert not any("al" in one.odd[0] or "cb" in one.odd[0] for one in told)


@pytest.mark.parametrize(
    ("cells", "other"),
    [
        ([f'check = checks("{TURNS}", course="robots")'], "01_turns"),
        ([f"check = checks( '{TURNS}')"], "01_turns"),
        ([f'# The checks\ncheck = checks(\n    "{TURNS}"\n)'], "01_turns"),
        (["check = checks()", 'checks("eNq")', 'checks("")', f'checks("{TURNS[8:]}")'], ""),
        ([], ""),
    ],
)
def test_the_checks_of_a_notebook_say_its_exercise(cells, other):
    assert other_exercise(cells, "02_others") == other
    assert other_exercise(cells, "01_Turns") == ""


def test_a_notebook_with_the_checks_of_both_is_one_of_this_exercise():
    others = packed(exercise_from_text(CHECKS, "02_others"))
    cells = [f'checks("{others}")', f'checks("{TURNS}")']
    assert other_exercise(cells, "01_turns") == other_exercise(cells, "02_others") == ""


def test_no_more_of_the_checks_is_unpacked_than_their_name():
    bomb = zlib.compress(json.dumps(["07_dh_link", "x" * 50_000_000]).encode(), 9)
    cut = base64.b64encode(bomb[:300]).decode() + "AAAA"
    tracemalloc.start()
    try:
        assert other_exercise([f'checks("{cut}")'], "01_turns") == "07_dh_link"
        assert tracemalloc.get_traced_memory()[1] < 1_000_000
    finally:
        tracemalloc.stop()


@pytest.mark.parametrize("name", ["<b>x</b>", "x" * 100, "a\nb", ""])
def test_a_name_that_no_exercise_has_is_none(name):
    text = base64.b64encode(zlib.compress(json.dumps([name, "x"]).encode())).decode()
    assert other_exercise([f'checks("{text}")'], "01_turns") == ""
