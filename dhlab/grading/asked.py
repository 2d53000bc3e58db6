"""What is asked of a student's code, and what is said where no value came."""

from dataclasses import dataclass
from typing import Any, Literal, TypeAlias

Kind: TypeAlias = Literal["values", "robot", "csys", "scene"]
"""How an answer is read: as plain values, or from the handles of dhlab."""

Reason: TypeAlias = Literal[
    "missing",
    "no function",
    "stub",
    "raised",
    "too slow",
    "too much memory",
    "too large",
    "not numbers",
    "ended",
]


@dataclass(frozen=True)
class NoValue:
    """No value came for a case.

    Attributes
    ----------
    reason : str
        "missing" (no such name), "no function" (a value in place of one), "stub" (untouched),
        "raised", "too slow", "too much memory", "too large", "not numbers", or "ended" (the
        process was gone).
    text : str
        What happened, at most 200 characters on one line without control characters and angle
        brackets: "ZeroDivisionError: division by zero".
    """

    reason: Reason
    text: str


@dataclass(frozen=True)
class Ask:
    """One question as the student's code sees it: a name and the arguments to try.

    Attributes
    ----------
    name : str
        Of the function or variable.
    kind : {'values', 'robot', 'csys', 'scene'}
    cases : tuple of tuples
        Arguments of each case; ``((),)`` for a plain value.
    library : bool
        Whether all of dhlab may be used for plain values too.
    """

    name: str
    kind: Kind = "values"
    cases: tuple[tuple[Any, ...], ...] = ((),)
    library: bool = False

    @property
    def has_library(self) -> bool:
        """Whether it is asked where all of dhlab is."""
        return self.library or self.kind != "values"
