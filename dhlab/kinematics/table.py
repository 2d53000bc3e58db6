"""A Denavit-Hartenberg table to read: as text and as HTML, with its convention named."""

from fractions import Fraction
from html import escape
from math import inf, isfinite, pi
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from dhlab.kinematics.transforms import r2rpy

if TYPE_CHECKING:
    from dhlab.kinematics.chain import Chain


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
    part = Fraction(x / pi).limit_denominator(36) if isfinite(x) else 0
    if part == 0 or abs(part * pi - x) > 1e-12:
        return number_text(x)
    times = {1: "", -1: "-"}.get(part.numerator, str(part.numerator))
    return f"{times}pi" + (f"/{part.denominator}" if part.denominator > 1 else "")


def table_text(chain: "Chain") -> str:
    """Text of a chain's table, a line for each row."""
    head, rows = _cells(chain)
    lines = [f"Chain '{chain.joints}', {chain.convention} Denavit-Hartenberg (m, rad)"]
    widths = [max(map(len, column)) for column in zip(head, *rows, strict=True)]
    for row in [head, *rows] if rows else []:
        line = "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True))
        lines.append(line.rstrip())
    return "\n".join(lines + _ends(chain))


def table_html(chain: "Chain") -> str:
    """HTML of a chain's table."""
    head, rows = _cells(chain)
    parts = [f"<caption>{chain.convention} Denavit-Hartenberg (m, rad)</caption>", _row(head, "th")]
    parts += [_row(row, "td") for row in rows]
    ends = "".join(f"<br>{escape(end)}" for end in _ends(chain))
    return f"<table>{''.join(parts)}</table>{ends}"


def _cells(chain: "Chain") -> tuple[list[str], list[list[str]]]:
    """Head and rows of the table; the variable of a joint stands in place of its home value."""
    link = "_{i-1}" if chain.convention == "modified" else "_i"
    head = ["i", f"alpha{link}", f"a{link}", "d_i", "theta_i", "home", "limits"]
    rows = []
    for i, (row, kind) in enumerate(zip(chain.rows, chain.kinds, strict=True)):
        show = angle_text if kind == "r" else number_text
        variable = f"q_{i + 1}"
        if chain.offset[i]:
            variable += f" {'-' if chain.offset[i] < 0 else '+'} {show(abs(chain.offset[i]))}"
        lower, upper = chain.limits[i]
        limits = f"[{show(lower)}, {show(upper)}]" if -inf < lower or upper < inf else "none"
        d, theta = number_text(row.d), angle_text(row.theta)
        d, theta = (d, variable) if kind == "r" else (variable, theta)
        cells = [str(i + 1), angle_text(row.alpha), number_text(row.a), d, theta]
        rows.append([*cells, show(chain.home[i]), limits])
    return head, rows


def _ends(chain: "Chain") -> list[str]:
    """Base and grasper, where they are not just the frame they stand in."""
    ends = (("base", chain.base), ("grasper", chain.grasper))
    return [f"{name}: {_place(T)}" for name, T in ends if not np.array_equal(T, np.eye(4))]


def _place(T: NDArray[np.float64]) -> str:
    text = f"origin ({', '.join(map(number_text, T[:3, 3]))})"
    if np.array_equal(T[:3, :3], np.eye(3)):
        return text
    return f"{text}, roll, pitch, yaw ({', '.join(map(angle_text, r2rpy(T[:3, :3])))})"


def _row(cells: list[str], tag: str) -> str:
    return f"<tr>{''.join(f'<{tag}>{_pretty(cell)}</{tag}>' for cell in cells)}</tr>"


def _pretty(cell: str) -> str:
    """HTML of a cell: Greek letters and lowered indices."""
    for word, letter in (("alpha", "α"), ("theta", "θ"), ("pi", "π"), ("-", "−")):
        cell = cell.replace(word, letter)
    name, index, rest = cell.partition("_")
    if not index:
        return cell
    index, _, rest = rest.partition(" ")
    return f"<i>{name}</i><sub>{index.strip('{}')}</sub> {rest}".rstrip()
