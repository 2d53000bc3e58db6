"""Texts of others, made harmless."""

import csv
import io

import pytest
from hypothesis import given
from hypothesis import strategies as st
from markdown_it import MarkdownIt

from dhlab.grading.plain import file_name, markdown, one_line, spreadsheet

HOSTILE = [
    "<script>alert(1)</script>",
    "<img src=x onerror=alert(1)>",
    "[click](javascript:alert(1))",
    "![x](http://evil.example/x.png)",
    "http://evil.example www.evil.example a@evil.example",
    "# heading",
    "- item",
    "1. item",
    "1) item",
    "> quote",
    "```\ncode\n```",
    "a\n\n<b>b</b>",
    "|a|b|\n|-|-|",
    "&lt;b&gt; &amp; &#60;",
    "\\<b>",
    "===",
    "---",
    "a\u202eb\x00c\x1b[31m",
]


@pytest.mark.parametrize("text", HOSTILE)
def test_markdown_shows_a_text_as_it_stands(text):
    parser = MarkdownIt("gfm-like", {"html": True, "linkify": False})
    html = parser.render(f"{markdown(text)}\n")
    assert html.startswith("<p>")
    assert html.count("<") == 2
    shown = html[3:-5].replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", '"')
    assert shown.replace("&amp;", "&") == one_line(text)


@given(st.text())
def test_any_text_is_one_paragraph_of_markdown(text):
    html = MarkdownIt("commonmark").render(f"{markdown(text)}\n")
    assert html.count("<") in (0, 2)


@given(st.text())
def test_a_line_holds_nothing_that_is_not_seen(text):
    line = one_line(text)
    assert len(line.splitlines()) <= 1
    assert not set(line) & set("\x00\x1b\r\n\t\u202e\u2066")


def test_a_long_text_is_cut():
    assert one_line("x" * 5000, 10) == "xxxxxxx..."


@pytest.mark.parametrize("start", ["=", "+", "-", "@", "＝", " =", "\t=", "\n="])
def test_no_cell_is_a_formula(start):
    assert spreadsheet(f"{start}cmd|' /C calc'!A0").startswith("'")


@given(st.text())
def test_a_cell_comes_back_from_csv_as_one_line(text):
    line = io.StringIO()
    csv.writer(line).writerow([spreadsheet(text), "end"])
    ((cell, end),) = csv.reader(io.StringIO(line.getvalue()))
    assert (cell, end) == (spreadsheet(text), "end")


@pytest.mark.parametrize("name", ["Ada Lovelace", "al17", "Kurt Gödel", "李明", "Jo Lee (2)"])
def test_a_plain_name_is_its_own_file_name(name):
    assert file_name(name) == name


@pytest.mark.parametrize(
    "name",
    [
        *("", ".", "..", "../../etc/passwd", "a/b", "a\\b", "CON", "nul.txt", "C:x", "x" * 500),
        *("ü" * 200, "a\nb", "\u202ea", "<b>", " a", "a.", ".hidden", "-rf", "\udceb"),
    ],
)
def test_another_name_is_made_safe(name):
    safe = file_name(name)
    assert len(safe.encode()) < 200
    assert not set(safe) & set('/\\:*?"<>|\n\x00')
    assert not safe.startswith((".", "-"))
    assert file_name(safe) == safe or safe.startswith("_")


@given(st.lists(st.text(max_size=6), unique=True))
def test_no_two_students_share_a_file(names):
    assert len({file_name(name) for name in names}) == len(names)
