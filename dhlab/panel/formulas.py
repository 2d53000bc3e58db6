"""Formulas in the text cells of a notebook as MathML, so that a page needs no network for them."""

import re

from dhlab.view.prose import MATHML, formula

PIECE = re.compile(
    r"""
      (?P<code> ^(?P<fence>`{3,}|~{3,}) .*? (?:^(?P=fence)|\Z)    # a block of code
              | (?P<tick>`+) .+? (?P=tick) (?!`)                  # a piece of it
              | \\.                                               # whatever stands for itself
      )
    | \$\$ (?P<display> [^$]+ ) \$\$
    | \$ (?P<inline> (?!\s) [^$\n]+? (?<!\s) ) \$ (?!\d)
    """,
    re.VERBOSE | re.MULTILINE | re.DOTALL,
)
MARKS = str.maketrans({mark: f"&#{ord(mark)};" for mark in "*_`[]|~\\"})
"""What Markdown would read in the text of a formula."""


def with_formulas(text: str) -> str:
    r"""Return Markdown with MathML in the place of its formulas.

    Parameters
    ----------
    text : str
        Markdown; formulas between single or double dollars. Those that cannot be written as MathML
        stay as they are.

    Returns
    -------
    markdown : str

    Examples
    --------
    >>> with_formulas("About `$z$` and 5 $.")
    'About `$z$` and 5 $.'
    >>> "<math" in with_formulas(r"About $\alpha_1$.")
    True
    """
    return PIECE.sub(_written, text)


def _written(found: re.Match[str]) -> str:
    if found["code"] is not None:
        return found[0]
    display = found["display"] is not None
    source = found["display"] if display else found["inline"]
    mathml = formula(source.strip(), display)
    if not mathml.startswith("<math") or "\\" in mathml:  # an unknown command stays in the text
        return found[0]
    plain = mathml.replace(f' xmlns="{MATHML}"', "", 1)  # in HTML it has no name space
    return re.sub(r">[^<>]+<", lambda part: part[0].translate(MARKS), plain)
