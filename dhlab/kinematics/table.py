"""Numbers, angles, poses and tables to read, as text and as HTML."""

from collections.abc import Sequence
from math import isfinite, pi

import numpy as np
from numpy.typing import NDArray

from dhlab.kinematics.angles import r2rpy


def number_text(x: float) -> str:
    """Up to four decimals, without the zeros at the end and without minus zero.

    Examples
    --------
    >>> number_text(0.25), number_text(-0.00001)
    ('0.25', '0')
    """
    text = f"{x:z.4f}"
    return text.rstrip("0").rstrip(".")


def angle_text(x: float) -> str:
    """Angle [rad] as a fraction of pi where it is a plain one, else as a number.

    Examples
    --------
    >>> angle_text(-np.pi / 16), angle_text(5 * np.pi / 4), angle_text(0.3)
    ('-pi/16', '5pi/4', '0.3')
    """
    from fractions import Fraction

    part = Fraction(x / pi).limit_denominator(36) if isfinite(x) else 0
    if part == 0 or abs(part * pi - x) > 1e-12:
        return number_text(x)
    times = {1: "", -1: "-"}.get(part.numerator, str(part.numerator))
    return f"{times}pi" + (f"/{part.denominator}" if part.denominator > 1 else "")


def place_text(T: NDArray[np.float64]) -> str:
    """Origin of a pose [m], and its roll, pitch and yaw [rad] where it is turned.

    Examples
    --------
    >>> T = np.eye(4)
    >>> T[:3, 3] = 0.1, 0, 2
    >>> place_text(T)
    'origin (0.1, 0, 2)'
    """
    text = f"origin ({', '.join(map(number_text, T[:3, 3]))})"
    if np.array_equal(T[:3, :3], np.eye(3)):
        return text
    return f"{text}, roll, pitch, yaw ({', '.join(map(angle_text, r2rpy(T[:3, :3])))})"


def text_table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    """Lines of a table, its columns as wide as need be.

    Examples
    --------
    >>> text_table(["i", "alpha_i"], [["1", "pi/2"]])
    ['i  alpha_i', '1  pi/2']
    """
    widths = [max(map(len, column)) for column in zip(head, *rows, strict=True)]
    lines = (
        "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True))
        for row in [head, *rows]
    )
    return [line.rstrip() for line in lines]


def html_table(
    title: str, head: Sequence[str], rows: Sequence[Sequence[str]], notes: Sequence[str]
) -> str:
    """HTML of a table with Greek letters and lowered indices.

    Examples
    --------
    >>> html_table("Table", ["theta_i"], [["pi/2"]], [])
    '<table><caption>Table</caption><tr><th>θ<sub>i</sub></th></tr><tr><td>π/2</td></tr></table>'
    """
    from html import escape

    lines = [_html_row(head, "th"), *(_html_row(row, "td") for row in rows)]
    below = "".join(f"<br>{escape(note)}" for note in notes)
    return f"<table><caption>{escape(title)}</caption>{''.join(lines)}</table>{below}"


def _html_row(cells: Sequence[str], tag: str) -> str:
    return f"<tr>{''.join(f'<{tag}>{_html_cell(cell)}</{tag}>' for cell in cells)}</tr>"


def _html_cell(cell: str) -> str:
    for word, letter in (("alpha", "α"), ("theta", "θ"), ("pi", "π"), ("-", "−")):
        cell = cell.replace(word, letter)
    name, lowered, rest = cell.partition("_")
    if not lowered:
        return cell
    index, _, rest = rest.partition(" ")
    return f"{name}<sub>{index.strip('{}')}</sub> {rest}".rstrip()
