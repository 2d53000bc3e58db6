"""How a joint variable reads beside a slider: its unit, its span, its steps, its name."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import degrees, floor, isfinite, isinf, log10, pi, radians
from typing import Literal

from dhlab.scene.component import Component

SNAP = 1e-6
"""A value that comes back from the page this near to a limit [rad or m] is the limit."""

SHORTEST_REACH = 0.1
"""Length [m] that a prismatic joint without limits is given at least."""

SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")


@dataclass(frozen=True)
class Reading:
    """One joint variable as a panel shows it.

    Attributes
    ----------
    kind : {'r', 'p'}
    limits : tuple of 2 floats [rad or m]
        Lower and upper limit, infinite where there is none.
    span : tuple of 2 floats [rad or m]
        The slider's ends: the limits, and a span made up where there is none.
    """

    kind: Literal["r", "p"]
    limits: tuple[float, float]
    span: tuple[float, float]

    @property
    def unit(self) -> str:
        """``'°'``, ``'mm'`` or, for what reaches a metre and more, ``'m'``."""
        if self.kind == "r":
            return "°"
        return "mm" if max(map(abs, self.span)) < 1 else "m"

    @property
    def decimals(self) -> int:
        """Digits behind the point of a shown value."""
        return 3 if self.unit == "m" else 1

    @property
    def step(self) -> float:
        """Distance of the values that a slider can be dragged to, in `unit`.

        A slider counts its steps from its lower end: they are made small enough to meet zero.
        """
        step = 10.0**-self.decimals
        lower = abs(self.shown(self.span[0]))
        fitting = (s for s in (step, step / 2) if abs(lower / s - round(lower / s)) < 1e-6)
        return next(fitting, step / 10)

    @property
    def bounded(self) -> bool:
        """Whether both limits are there."""
        return not any(map(isinf, self.limits))

    def shown(self, value: float) -> float:
        """Convert from [rad or m] to `unit`."""
        if self.kind == "r":
            return degrees(value)
        return value * 1000 if self.unit == "mm" else value

    def meant(self, shown: float) -> float:
        """Convert from `unit` to [rad or m]: a limit where it comes within 1e-6 of one."""
        value = round(shown, 9)
        if self.kind == "r":
            value = radians(value)
        elif self.unit == "mm":
            value /= 1000
        near = (limit for limit in self.limits if abs(value - limit) <= SNAP)
        return next(near, min(max(value, self.limits[0]), self.limits[1]))

    def ends(self, of: tuple[float, float] | None = None) -> tuple[str, str]:
        """Write the limits in `unit`, short.

        Parameters
        ----------
        of : tuple of 2 floats [rad or m], optional
            What to write in place of the limits.

        Returns
        -------
        lower, upper : str

        Examples
        --------
        >>> Reading("r", (-pi / 2, float("inf")), (-pi / 2, pi)).ends()
        ('−90', '∞')
        """
        lower, upper = (_short(self.shown(end)) for end in (of or self.limits))
        return lower, upper


def reading(
    kind: Literal["r", "p"], limits: Sequence[float], reach: float, values: Sequence[float]
) -> Reading:
    """Choose the span of a slider.

    Parameters
    ----------
    kind : {'r', 'p'}
    limits : sequence of 2 floats [rad or m]
        Infinite where there is none.
    reach : float [m]
        A length of the robot, above 0: a prismatic joint without limits is given as much to
        either side.
    values : sequence of float [rad or m]
        What the span must hold: the home value, the present one.

    Returns
    -------
    Reading
    """
    lower, upper = float(limits[0]), float(limits[1])
    size = pi if kind == "r" else _round_up(reach)
    if isfinite(lower) and isfinite(upper):
        span = (lower, max(upper, lower + SNAP))
    elif isfinite(lower):
        span = (lower, lower + _grown(2 * size, max(values) - lower))
    elif isfinite(upper):
        span = (upper - _grown(2 * size, upper - min(values)), upper)
    else:
        size = _grown(size, max(map(abs, values)))
        span = (-size, size)
    return Reading(kind, (lower, upper), span)


def component_readings(component: Component) -> tuple[Reading, ...]:
    """Return how each variable of a component reads, at its present configuration."""
    chain = component.chain
    reach = max([SHORTEST_REACH, *(abs(x) for row in chain.rows for x in (row.a, row.d))])
    joints = zip(chain.kinds, chain.limits, component.q, chain.home, strict=True)
    return tuple(
        reading(kind, limits, reach, (float(q), float(home))) for kind, limits, q, home in joints
    )


def joint_label(kind: Literal["r", "p"], number: int) -> str:
    """Name a joint variable as the tables do.

    Examples
    --------
    >>> joint_label("r", 1), joint_label("p", 12)
    ('θ₁', 'd₁₂')
    """
    return ("θ" if kind == "r" else "d") + str(number).translate(SUBSCRIPTS)


def _short(shown: float) -> str:
    if isinf(shown):
        return "−∞" if shown < 0 else "∞"
    return f"{shown:z.3f}".rstrip("0").rstrip(".").replace("-", "−")


def _grown(size: float, needed: float) -> float:
    """Double `size` until it is enough: a slider that follows a turning joint seldom grows."""
    while size < needed:
        size *= 2
    return size


def _round_up(length: float) -> float:
    """Return the next of 1, 2, 5, 10, 20, ... times a power of ten."""
    power = 10.0 ** floor(log10(length))
    return next(k * power for k in (1, 2, 5, 10) if k * power >= length * (1 - 1e-9))
