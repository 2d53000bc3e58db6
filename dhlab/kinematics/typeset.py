"""Poses, rotations and vectors as a textbook prints them."""

import re
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dhlab.arrays import as_array
from dhlab.errors import InputError

EXACT = (
    (0.5, r"\tfrac{1}{2}"),
    (np.sqrt(2) / 2, r"\tfrac{\sqrt{2}}{2}"),
    (np.sqrt(3) / 2, r"\tfrac{\sqrt{3}}{2}"),
)
"""Sines and cosines that have a name of their own."""

EXACT_WITHIN = 1e-9


@dataclass(frozen=True, eq=False, repr=False)
class Typeset:
    """A matrix to be read: text in a terminal, a formula in a notebook; made by `typeset`.

    Attributes
    ----------
    values : ndarray, shape (n,) or (m, n)
    name : str or None
    """

    values: NDArray[np.float64]
    name: str | None = None

    def __repr__(self) -> str:
        rows = [[f"{x:z.4f}" for x in row] for row in np.atleast_2d(self.values)]
        width = max(len(text) for row in rows for text in row)
        lines = [" ".join(text.rjust(width) for text in row) for row in rows]
        head = f"{self.name} = " if self.name else ""
        indent = " " * len(head)
        return "\n".join((head if k == 0 else indent) + f"[{line}]" for k, line in enumerate(lines))

    def _repr_latex_(self) -> str:
        return f"${self.latex}$"

    @property
    def latex(self) -> str:
        """The formula, without dollar signs."""
        column = self.values.ndim == 1
        rows = self.values[:, None] if column else self.values
        body = r" \\ ".join(" & ".join(map(number_latex, row)) for row in rows)
        matrix = rf"\begin{{bmatrix}} {body} \end{{bmatrix}}"
        return f"{symbol_latex(self.name)} = {matrix}" if self.name else matrix


def typeset(values: ArrayLike, name: str | None = None) -> Typeset:
    r"""Show a pose, a rotation, a vector or a table of numbers as a textbook prints it.

    Parameters
    ----------
    values : array_like, shape (n,) or (m, n)
    name : str, optional
        Written in front: ``"T_AB"``; what follows the underscore is a subscript.

    Returns
    -------
    text : Typeset
        Four decimals and no minus zero as text; in a notebook a formula, in which 0, 1, halves
        and the sines of 45 and 60 degrees are exact.

    Raises
    ------
    InputError
        The values are no finite numbers, or have more than two dimensions.

    Examples
    --------
    >>> typeset([[0, -1], [1, -1e-17]], "R")
    R = [ 0.0000 -1.0000]
        [ 1.0000  0.0000]
    >>> typeset([np.sqrt(0.5), 2.5], "p_A").latex
    'p_{A} = \\begin{bmatrix} \\tfrac{\\sqrt{2}}{2} \\\\ 2.5 \\end{bmatrix}'
    """
    what = "what is to be typeset" if name is None else name
    array = as_array(values, (...,), what)
    if array.ndim not in (1, 2) or array.size == 0:
        raise InputError(f"{what} must have shape (n,) or (m, n), got {array.shape}")
    return Typeset(array, name)


def number_latex(x: float) -> str:
    r"""Write a number: exact where it has a name, else with up to four decimals.

    Examples
    --------
    >>> number_latex(-0.5), number_latex(1e-17), number_latex(0.12345)
    ('-\\tfrac{1}{2}', '0', '0.1235')
    """
    sign = "-" if x < 0 else ""
    for value, latex in EXACT:
        if abs(abs(x) - value) < EXACT_WITHIN:
            return sign + latex
    text = f"{x:z.4f}".rstrip("0").rstrip(".")
    return text or "0"


def symbol_latex(name: str) -> str:
    """Write a name as a symbol: what follows its first underscore is a subscript.

    Examples
    --------
    >>> symbol_latex("T_AB"), symbol_latex("q")
    ('T_{AB}', 'q')
    """
    head, _, tail = name.partition("_")
    return f"{head}_{{{re.sub(r'[{}]', '', tail)}}}" if tail else head
