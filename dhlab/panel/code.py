"""A configuration as Python code that gives it back bit for bit."""

from collections.abc import Sequence
from fractions import Fraction
from math import pi

from dhlab.scene.component import Component

DEG = pi / 180
DENOMINATORS = 36


def config_code(components: Sequence[Component], name: str = "q") -> str:
    """Write the configuration of components as an assignment.

    Parameters
    ----------
    components : sequence of Component
    name : str
        What to assign to.

    Returns
    -------
    str
        Python code with the imports that it needs, one line a component.
    """
    rows = [[number_code(x) for x in component.q] for component in components]
    lines = [
        f"    {', '.join(numbers)},  # {component.name}"
        for component, numbers in zip(components, rows, strict=True)
    ]
    return "\n".join([*_imports(rows), f"{name} = [", *lines, "]"]) + "\n"


def number_code(x: float) -> str:
    """Write a number as a person would, where that is the same float: fractions of pi, degrees.

    Examples
    --------
    >>> [number_code(x) for x in (0.0, -pi, 3 * pi / 4, 12.5 * DEG, 0.25, 1 / 3)]
    ['0', '-pi', '3*pi/4', '12.5*deg', '0.25', '0.3333333333333333']
    """
    x = float(x)
    if x == 0:
        return "0"
    if len(repr(x)) <= 6:
        return repr(x)
    return _fraction_of_pi(x) or _degrees(x) or repr(x)


def _fraction_of_pi(x: float) -> str | None:
    ratio = Fraction(x / pi).limit_denominator(DENOMINATORS)
    p, q = ratio.numerator, ratio.denominator
    if p * pi / q != x:
        return None
    return {1: "pi", -1: "-pi"}.get(p, f"{p}*pi") + (f"/{q}" if q > 1 else "")


def _degrees(x: float) -> str | None:
    text = f"{x / DEG:.3f}".rstrip("0").rstrip(".")
    return f"{text}*deg" if float(text) * DEG == x else None


def _imports(rows: Sequence[Sequence[str]]) -> list[str]:
    text = " ".join(number for numbers in rows for number in numbers)
    lines = [("pi", "from numpy import pi"), ("*deg", "from dhlab import deg")]
    return [line for word, line in lines if word in text]
