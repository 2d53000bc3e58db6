"""What a student reads, here and in Gradescope."""

import json
import re
from dataclasses import replace

import pytest
from markdown_it import MarkdownIt

from dhlab.grading.feedback import feedback
from dhlab.grading.gradescope import gradescope
from tests.grading.made import ADA, BOB, CLASS, HOSTILE, KURT, LOST, results, wrong


def test_feedback_says_points_and_why():
    text = feedback(CLASS, BOB)
    assert text.startswith("# One link\n\n**Bob**: 1 of 3 points\n")
    assert "## dh\\_link: not yet right, 0 of 2\n\nSeen. This is exactly what" in text
    assert "## T: right, 1 of 1\n\nRight.\n" in text
    assert text.endswith("## Notes\n\n- It tried to write a file.\n")


def test_feedback_has_the_name_of_an_exercise_without_a_title():
    untitled = replace(CLASS, run=replace(CLASS.run, title=""))
    assert feedback(untitled, BOB).startswith("# 07\\_dh\\_link\n")


def test_feedback_calls_an_answer_that_is_not_there_empty_or_missing():
    text = feedback(CLASS, KURT)
    assert "## dh\\_link: empty, 0 of 2\n\nNothing is there yet." in text
    gone = replace(KURT, questions=(wrong("T", 1, "There is no `T`.", reason="missing"),))
    assert "## T: missing, 0 of 1" in feedback(CLASS, gone)
    assert "## T: not yet right, 0 of 1" in text


@pytest.mark.parametrize("row", [KURT, LOST])
def test_feedback_says_what_kept_it_from_being_marked(row):
    assert row.reason in feedback(CLASS, row)


def test_feedback_has_no_live_html_and_no_links():
    html = MarkdownIt("gfm-like", {"html": True, "linkify": False}).render(
        feedback(results(HOSTILE), HOSTILE)
    )
    assert set(re.findall(r"</?(\w+)", html)) == {"h1", "h2", "p", "strong", "ul", "li"}
    assert "\u202e" not in html
    raw = feedback(results(HOSTILE), HOSTILE)
    assert "<" not in raw
    assert "://" not in raw


def test_what_is_for_the_instructor_is_not_in_feedback():
    row = replace(ADA, details={"cases": {"dh_link": [{"value": 0.123456}]}}, failed="secret")
    for report in (feedback, gradescope):
        assert "0.123456" not in report(CLASS, row)
        assert "secret" not in report(CLASS, row)


def test_gradescope_has_a_test_per_question():
    document = json.loads(gradescope(CLASS, BOB))
    assert document["score"] == 1
    assert [t["name"] for t in document["tests"]] == ["dh_link", "T"]
    assert [t["score"] for t in document["tests"]] == [0, 1]
    assert [t["max_score"] for t in document["tests"]] == [2, 1]
    assert [t["status"] for t in document["tests"]] == ["failed", "passed"]
    assert document["output"] == "It tried to write a file."


@pytest.mark.parametrize("row", CLASS.rows)
def test_gradescope_s_points_add_up(row):
    document = json.loads(gradescope(CLASS, row))
    assert sum(test["score"] for test in document["tests"]) == document["score"] == row.points
    assert sum(test["max_score"] for test in document["tests"]) == 3


def test_gradescope_is_told_to_show_text_as_text():
    document = json.loads(gradescope(results(HOSTILE), HOSTILE))
    formats = {document[key] for key in document if key.endswith("_format")}
    assert formats == {"text"}
    assert not any(test.get("output_format", "text") != "text" for test in document["tests"])
