"""From whatever came to numbers, or to a sentence that says why they cannot be judged."""

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

Floats: TypeAlias = NDArray[np.float64]

HUGE = 1e12
"""Numbers beyond this are not compared any more: nothing in an exercise is as large."""

TOLERANCE = 1e-6


class Unreadable(Exception):
    """What came is no answer of the kind asked for; the text is a sentence for the student."""


def numbers(value: Any, shapes: Sequence[tuple[int, ...]], what: str = "the answer") -> Floats:
    """Array of finite numbers in one of the shapes (-1 is any length), or `Unreadable`.

    Examples
    --------
    >>> numbers([1, 2], [(3,)])
    Traceback (most recent call last):
    ...
    dhlab.diagnosis.values.Unreadable: The answer has shape (2,); shape (3,) is asked for.
    """
    head = what[0].upper() + what[1:]
    if value is None:
        raise Unreadable(f"{head} is None: is there a return at the end?")
    if isinstance(value, str | bytes):
        raise Unreadable(f"{head} is text; numbers are asked for.")
    try:
        a = np.asarray(value)
    except (ValueError, TypeError, OverflowError):
        raise Unreadable(f"{head} has rows of different lengths, so it is no array.") from None
    if a.dtype.kind not in "biuf":
        raise Unreadable(f"{head} is not made of numbers.")
    a = a.astype(np.float64)
    wanted = [s for s in shapes if _fits(a.shape, s)]
    if not wanted:
        names = " or ".join(_shape_text(s) for s in shapes)
        raise Unreadable(f"{head} has shape {a.shape}; shape {names} is asked for.")
    if np.isnan(a).any():
        raise Unreadable(f"{head} holds nan: something was divided 0 / 0, or a root is missing.")
    if np.isinf(a).any() or (np.abs(a) > HUGE).any():
        raise Unreadable(f"{head} holds an infinite or immense number: is something divided by 0?")
    return a


def close(a: Floats, b: Floats, tolerance: float = TOLERANCE) -> bool:
    """Whether two arrays of one shape hold the same numbers."""
    return a.shape == b.shape and bool((np.abs(a - b) <= tolerance * (1 + np.abs(b))).all())


def as_pose44(a: Floats) -> Floats:
    """Pose, shape (4, 4), from a rotation or a pose."""
    if a.shape == (4, 4):
        return a
    T = np.eye(4)
    T[:3, :3] = a
    return T


def _fits(shape: tuple[int, ...], wanted: tuple[int, ...]) -> bool:
    return len(shape) == len(wanted) and all(
        w in (-1, n) for n, w in zip(shape, wanted, strict=True)
    )


def _shape_text(shape: tuple[int, ...]) -> str:
    inner = ", ".join("any" if n < 0 else str(n) for n in shape)
    return f"({inner},)" if len(shape) == 1 else f"({inner})"
