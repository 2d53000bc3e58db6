"""Explanations as HTML: formulas are drawn, and no text becomes a tag."""

from html.parser import HTMLParser

import pytest

from dhlab.lessons import course
from dhlab.view.prose import formula, phrase, prose

KNOWN = {"p", "em", "strong", "code", "pre", "ul", "ol", "li", "a", "span", "div", "br", "math"}


class Tags(HTMLParser):
    def __init__(self, html):
        super().__init__()
        self.tags, self.attributes = [], []
        self.feed(html)

    def handle_starttag(self, tag, attrs):
        self.tags.append(tag)
        self.attributes += [name for name, _ in attrs]


@pytest.mark.parametrize(
    "text",
    [
        "<script>alert(1)</script>",
        "<img src=x onerror=alert(1)>",
        "![picture](http://example.org/x.png)",
        "[link](javascript:alert(1))",
        r"$\text{<img/src=x/onerror=alert(1)>}$",
        r"$\text{</mtext><script>alert(1)</script>}$",
        r"$$\href{javascript:alert(1)}{x}$$",
        r'$\color{red" onclick="alert(1)}{x}$',
        r"$<script>$",
        r"$\frac{1}$ and $\nonsense{$",
    ],
)
def test_no_text_becomes_a_script_an_image_or_a_handler(text):
    for html in (prose(text), phrase(text), formula(text.strip("$"))):
        read = Tags(html)
        assert not {"script", "img", "iframe", "style"} & set(read.tags)
        assert not [name for name in read.attributes if name.startswith("on")]
        assert "javascript:" not in [name for name in read.attributes if name == "href"]
        assert all(tag in KNOWN or tag.startswith("m") for tag in read.tags)


def test_formulas_become_mathml_and_matrices_tables():
    html = prose(r"$$T_{AB} = \begin{pmatrix} 1 & 0 \\ 0 & 1 \end{pmatrix}$$")
    assert Tags(html).tags.count("mtd") == 4
    assert "<msub>" in formula(r"\alpha_{i-1}")


def test_every_formula_of_the_course_is_drawn():
    for make in course.LESSONS.values():
        lesson = make()
        for step in lesson.describe()["steps"]:
            texts = [step["text"]]
            if step["question"]:
                texts += [step["question"]["text"], step["question"]["because"]]
                texts += step["question"].get("choices", [])
            for text in texts:
                html = prose(text)
                assert "$" not in html, text
                assert "\\" not in html, text
            if step["product"]:
                for factor in step["product"]["factors"]:
                    assert formula(factor["latex"]).startswith("<math")
