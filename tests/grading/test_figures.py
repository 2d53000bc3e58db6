"""What a class's results say together."""

from dataclasses import replace

import pytest

from dhlab.grading.figures import Answers, Bar, answers, mean_and_median, misconceptions, spread
from dhlab.grading.results import Column
from tests.grading.made import ADA, BOB, CLASS, COLUMNS, EVE, LOST, results, row, wrong


def test_marks_are_counted_over_those_marked():
    assert spread(CLASS) == [Bar("0", 2), Bar("1", 1), Bar("2", 0), Bar("3", 1)]
    assert mean_and_median(CLASS) == (1.0, 0.5)


def test_many_or_broken_points_come_in_ranges():
    many = replace(CLASS, columns=(Column("dh_link", 30.0), *COLUMNS[1:]))
    bars = spread(many)
    assert (bars[0].label, bars[-1].label, len(bars)) == ("0–3.1", "27.9–31", 10)
    assert sum(bar.count for bar in bars) == 4
    half = replace(CLASS, rows=(replace(ADA, points=2.5),))
    assert sum(bar.count for bar in spread(half)) == 1
    assert spread(replace(half, rows=(replace(ADA, points=3),)))[-1].count == 1


def test_an_exercise_without_points_can_be_counted():
    nothing = replace(CLASS, columns=(Column("dh_link", 0.0),), rows=(replace(ADA, points=0),))
    assert spread(nothing) == [Bar("0", 1)]


def test_answers_are_counted_by_kind():
    assert answers(CLASS) == [Answers("dh_link", 1, 2, 1, 0), Answers("T", 2, 1, 0, 1)]


def test_mistakes_are_counted_with_who_made_them():
    first, second = misconceptions(CLASS)
    assert (first.text, first.question) == ("either a is left out, or d is", "dh_link")
    assert (first.keys, first.students) == (("a", "d"), ("Bob", "Eve"))
    assert (second.text, second.students) == ("the order is reversed", ("Eve",))


def test_a_mistake_without_words_has_its_name():
    odd = row("x", wrong("T", 1, "Wrong.", ("reversed-order", "degrees")))
    assert misconceptions(results(odd))[0].text == "reversed order, degrees"


@pytest.mark.parametrize("rows", [(), (LOST,)])
def test_a_class_of_which_nobody_was_marked_has_figures(rows):
    empty = results(*rows)
    assert mean_and_median(empty) is None
    assert sum(bar.count for bar in spread(empty)) == 0
    assert answers(empty) == [Answers("dh_link", 0, 0, 0, 0), Answers("T", 0, 0, 0, 0)]
    assert misconceptions(empty) == []


def test_an_answer_counts_once_in_each_question():
    for found in answers(results(ADA, BOB, EVE)):
        assert found.right + found.wrong + found.nothing + found.failed == 3
