"""Explanations as HTML: Markdown with LaTeX between dollars becomes HTML with MathML.

A page needs no renderer of its own then, and no network. What the text brings of HTML is shown as
text: nothing in it is read as a tag, a script or an image.
"""

import re
from collections.abc import Callable
from functools import cache
from html import escape
from typing import Any
from xml.etree import ElementTree

MATHML = "http://www.w3.org/1998/Math/MathML"
DRAWING = re.compile(
    "math|m(row|i|n|o|text|space|s|frac|sqrt|root|sub|sup|subsup|under|over|"
    "underover|table|tr|td|padded|phantom|style|multiscripts|enclose)"
)
SHAPING = {
    "accent",
    "accentunder",
    "columnalign",
    "columnlines",
    "columnspacing",
    "depth",
    "display",
    "displaystyle",
    "fence",
    "form",
    "height",
    "largeop",
    "linethickness",
    "lspace",
    "mathvariant",
    "maxsize",
    "minsize",
    "movablelimits",
    "notation",
    "rowlines",
    "rowspacing",
    "rspace",
    "scriptlevel",
    "separator",
    "stretchy",
    "symmetric",
    "voffset",
    "width",
}


@cache
def prose(text: str) -> str:
    r"""Return a text as HTML.

    Parameters
    ----------
    text : str
        Markdown; formulas between single or double dollars.

    Returns
    -------
    html : str

    Examples
    --------
    >>> prose("A *turn* by <b>90</b>.")
    '<p>A <em>turn</em> by &lt;b&gt;90&lt;/b&gt;.</p>\n'
    >>> "<math" in prose(r"About $\alpha$.")
    True
    """
    html: str = _reader()(text)
    return html


@cache
def phrase(text: str) -> str:
    """Return a short text as HTML without a paragraph around it.

    Examples
    --------
    >>> phrase("along *z*")
    'along <em>z</em>'
    """
    html = prose(text).strip()
    inner = html.removeprefix("<p>").removesuffix("</p>")
    return inner if "<p>" not in inner else html


@cache
def formula(latex: str, display: bool = False) -> str:
    r"""Return a formula as MathML; as its own source where it cannot be read.

    Examples
    --------
    >>> "&lt;" in formula(r"a < b")
    True
    """
    from latex2mathml.converter import convert

    try:
        return _cleaned(convert(latex, display="block" if display else "inline"))
    except Exception:  # of many kinds: whatever it stumbles over, the text is still to be read
        return f"<code>{escape(latex)}</code>"


def _cleaned(mathml: str) -> str:
    """Keep of MathML the elements that draw, and of these the attributes that shape.

    Raises
    ------
    ParseError
        It is no XML: a text in it was not escaped.
    """
    root = ElementTree.fromstring(mathml)
    for element in root.iter():
        element.tag = element.tag.removeprefix(f"{{{MATHML}}}")
        if not DRAWING.fullmatch(element.tag):
            raise ElementTree.ParseError(f"'{element.tag}' is no element of a formula")
        for name in [name for name in element.attrib if name not in SHAPING]:
            del element.attrib[name]
    root.set("xmlns", MATHML)
    return ElementTree.tostring(root, encoding="unicode")


@cache
def _reader() -> Callable[[str], str]:
    from markdown_it import MarkdownIt
    from mdit_py_plugins.dollarmath import dollarmath_plugin

    reader = MarkdownIt("commonmark", {"html": False}).enable("table").disable("image")
    reader.use(dollarmath_plugin, renderer=_render, allow_labels=False)

    def read(text: str) -> str:
        return str(reader.render(text))

    return read


def _render(latex: str, options: dict[str, Any]) -> str:
    return formula(latex.strip(), bool(options.get("display_mode")))
