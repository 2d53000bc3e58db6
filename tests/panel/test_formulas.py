"""Formulas between the cells of a page."""

from pathlib import Path

import nbformat
import pytest
from nbconvert.filters.markdown import markdown2html

from dhlab.panel.formulas import PIECE, with_formulas

ROOT = Path(__file__).parents[2]
NOTEBOOKS = sorted(ROOT.glob("notebooks/*.ipynb")) + sorted(ROOT.glob("exercises/*/*.ipynb"))


@pytest.mark.parametrize(
    "kept",
    [
        "`$x$`",
        "``a `$x$` b``",
        "```\n$x$ and $y$\n```",
        "~~~ text\n$x$\n~~~",
        "5 $ and 6 $",
        r"\$x\$",
        "costs $5 or $6",
        r"$\nosuch{x}$",
    ],
)
def test_code_prices_and_what_cannot_be_written_stay(kept):
    assert with_formulas(kept) == kept


@pytest.mark.parametrize(
    ("text", "written"),
    [
        ("# A $x$ title", '<math display="inline"><mrow><mi>x</mi></mrow></math> title'),
        ("$a*b*c$ and *this*", "<mo>*</mo><mi>b</mi><mo>*</mo>"),
        ("$x$ and `$y$`", "<code>$y$</code>"),
        ("| $|x|$ | b |\n|---|---|\n| 1 | 2 |", '<mo stretchy="false">|</mo><mi>x</mi>'),
        ("$$x_1$$", '<math display="block">'),
        ("$a < b$", "<mo>&lt;</mo>"),
    ],
)
def test_formulas_survive_markdown(text, written):
    assert written in markdown2html(with_formulas(text))


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_no_formula_of_the_course_needs_a_renderer(path):
    for cell in nbformat.read(path, as_version=4).cells:
        if cell.cell_type == "markdown":
            left = PIECE.finditer(with_formulas(cell.source))
            assert not [found[0] for found in left if found["code"] is None]
