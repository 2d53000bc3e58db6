"""The errors of dhlab: one family, and each error also is the built-in error it refines."""

from math import degrees
from typing import Literal


class DhlabError(Exception):
    """Base of all errors that dhlab raises on purpose."""


class InputError(DhlabError, ValueError):
    """A value that cannot be used: wrong shape, not finite, not a rotation, an unknown word."""


class AttachError(DhlabError, ValueError):
    """A part cannot be attached: it hangs somewhere already, or on itself."""


class LimitError(DhlabError, ValueError):
    """A joint variable lies outside its limits.

    Parameters
    ----------
    component : str
        Name of the simple robot that the joint belongs to.
    joint : int
        Number of the joint in it, from 1.
    value : float [rad or m]
        What was asked of the joint.
    interval : tuple of 2 floats [rad or m]
        What the joint allows: lower and upper limit.
    kind : {'r', 'p'}
        Revolute (rad) or prismatic (m).
    hint : str
        What to do, where there is more to say.

    Examples
    --------
    >>> raise LimitError("index", 1, 0.5, (-0.3491, 0.0))
    Traceback (most recent call last):
    ...
    dhlab.errors.LimitError: joint 1 of 'index': 0.5000 rad (28.6 deg) is outside [-0.3491, 0.0000]
    """

    def __init__(
        self,
        component: str,
        joint: int,
        value: float,
        interval: tuple[float, float],
        kind: Literal["r", "p"] = "r",
        hint: str = "",
    ) -> None:
        super().__init__(component, joint, value, interval, kind, hint)
        self.component = component
        self.joint = joint
        self.value = value
        self.interval = interval
        self.kind = kind
        self.hint = hint

    def __str__(self) -> str:
        """Where, what came, and what is allowed."""
        lower, upper = self.interval
        digits = _telling_digits(self.value, lower if self.value < lower else upper)
        value = f"{self.value:.{digits}f} m"
        if self.kind == "r":
            value = f"{self.value:.{digits}f} rad ({degrees(self.value):.1f} deg)"
        message = (
            f"joint {self.joint} of '{self.component}': {value} "
            f"is outside [{lower:z.{digits}f}, {upper:z.{digits}f}]"
        )
        return f"{message}; {self.hint}" if self.hint else message


class DegreesWarning(UserWarning):
    """An angle is so large that it looks like degrees; dhlab works in radians everywhere."""


def _telling_digits(value: float, bound: float) -> int:
    """Decimals that show two numbers as different: 4, or as many more as it takes."""
    return next((k for k in range(4, 17) if f"{value:.{k}f}" != f"{bound:.{k}f}"), 17)
