"""The instructor's page, as text; tests/browser has it in a browser."""

import re
from html.parser import HTMLParser

import pytest

from dhlab.grading.classpage import OPEN, class_page
from dhlab.grading.markup import Html, tag
from tests.grading.made import ADA, CLASS, HOSTILE, LOST, results, right, row, wrong

VOID = {"meta"}


class Reader(HTMLParser):
    """Elements and texts of a page; knows whether each element is closed."""

    def __init__(self):
        super().__init__()
        self.open, self.names, self.attributes, self.texts = [], [], [], []

    def handle_starttag(self, name, attributes):
        self.names.append(name)
        self.attributes += attributes
        if name not in VOID:
            self.open.append(name)

    def handle_endtag(self, name):
        assert self.open.pop() == name

    def handle_data(self, text):
        if text.strip() and "style" not in self.open:
            self.texts.append(text.strip())


def read(page):
    """Read a page to its end."""
    reader = Reader()
    reader.feed(page)
    reader.close()
    assert reader.open == []
    return reader


def test_the_page_says_marks_questions_mistakes_and_who():
    texts = " ".join(read(class_page(CLASS)).texts)
    for words in ("Spread of marks", "Question by question", "Misconceptions", "For a second look"):
        assert words in texts
    assert "either a is left out, or d is" in texts
    assert "No notebook was handed in." in texts
    assert "25% right" in texts
    for student in CLASS.rows:
        assert student.student in texts


def test_the_page_loads_nothing_and_runs_nothing():
    page = read(class_page(results(HOSTILE, ADA)))
    assert not {"script", "link", "img", "iframe", "object", "form"} & set(page.names)
    assert not [name for name, _ in page.attributes if name.startswith("on")]
    assert not [name for name, _ in page.attributes if name in ("src", "href", "action")]
    assert "url(" not in class_page(CLASS)
    assert ("content", "default-src 'none'; style-src 'unsafe-inline'") in page.attributes


def test_hostile_names_and_texts_are_texts():
    page = read(class_page(results(HOSTILE)))
    assert page.names.count("style") == 1
    assert HOSTILE.student in page.texts
    assert "\u202e" not in "".join(page.texts)


def test_every_picture_has_its_words():
    page = class_page(CLASS)
    for picture in re.findall(r'<[^>]*role="img"[^>]*>', page):
        assert re.search(r'aria-label="[^"]{10,}"', picture)
    assert '<html lang="en">' in page


@pytest.mark.parametrize("rows", [(), (LOST,), (ADA,)])
def test_a_class_of_any_size_has_a_page(rows):
    assert "None was diagnosed." in read(class_page(results(*rows))).texts


def test_an_id_beside_the_name_in_a_notebook_is_counted_and_another_name_is_looked_at():
    known = [row(s, right("T", 1), typed="Ada", whose="Those of Ada.") for s in ("al1", "Bob M")]
    texts = read(class_page(results(*known))).texts
    assert any(text.startswith("1 known by an id have the numbers of the name") for text in texts)
    assert texts.count("Those of Ada.") == 1
    alone = " ".join(read(class_page(results(known[0]))).texts)
    assert "1 known by an id" in alone
    assert "what was seen" not in alone


def test_a_long_list_of_names_opens_by_a_click():
    mistake = [wrong("dh_link", 2, "x", ("a",)), wrong("T", 1)]
    few = class_page(results(*(row(f"s{k}", *mistake) for k in range(OPEN))))
    many = class_page(results(*(row(f"s{k}", *mistake) for k in range(OPEN + 1))))
    assert f"{OPEN + 1} students</summary>" in many
    assert "students</summary>" not in few


def test_a_text_is_escaped_and_an_element_is_not():
    assert (
        tag("p", "<b>", tag("b", "&"), [Html("<i></i>")], None)
        == "<p>&lt;b&gt;<b>&amp;</b><i></i></p>"
    )
    assert tag("p", title='"><x', hidden=True, id=None) == '<p title="&quot;&gt;&lt;x" hidden></p>'
