"""From whatever came to numbers, or to a sentence that says why they cannot be judged."""

import warnings
from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from dhlab.kinematics.transforms import pose_of

Floats: TypeAlias = NDArray[np.float64]

HUGE = 1e12
"""Numbers beyond this are not compared any more: nothing in an exercise is as large."""

TOLERANCE = 1e-4
"""An answer as near as this is right: numbers with four digits behind the point."""

EXACT = 1e-6
"""What a mistake gives must be as near as this to what came."""


class Unreadable(Exception):
    """What came is no answer of the kind asked for; the text is a sentence for the student."""


def numbers(
    value: Any,
    shapes: Sequence[tuple[int, ...]],
    what: str = "the answer",
    also: Sequence[tuple[int, ...]] = (),
) -> Floats:
    """Array of finite numbers in one of the shapes (-1 is any length), or `Unreadable`.

    The shapes that are `also` taken, such as a column for a point, are not spoken of.

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
    a = _array(value, head)
    if not any(_fits(a.shape, s) for s in (*shapes, *also)):
        names = " or ".join(_shape_text(s) for s in shapes)
        raise Unreadable(f"{head} has shape {a.shape}; shape {names} is asked for.")
    if np.isnan(a).any():
        raise Unreadable(f"{head} holds nan: something was divided 0 / 0, or a root is missing.")
    if np.isinf(a).any() or (np.abs(a) > HUGE).any():
        raise Unreadable(f"{head} holds an infinite or immense number: is something divided by 0?")
    return a


def _array(value: Any, head: str) -> Floats:
    """Array of whatever came: numpy asks the value itself, which may answer with any error."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            a = np.asarray(value)
    except ValueError:
        raise Unreadable(f"{head} has rows of different lengths, so it is no array.") from None
    except Exception:
        raise Unreadable(f"{head} is not made of numbers.") from None
    if a.dtype.kind not in "biuf":
        raise Unreadable(f"{head} is not made of numbers.")
    return a.astype(np.float64)


def close(a: Floats, b: Floats, tolerance: float = TOLERANCE) -> bool:
    """Whether two arrays of one shape hold the same numbers."""
    return a.shape == b.shape and bool((np.abs(a - b) <= tolerance * (1 + np.abs(b))).all())


def as_pose44(a: Floats) -> Floats:
    """Pose, shape (4, 4), from a rotation or a pose."""
    return a if a.shape == (4, 4) else pose_of(a, np.zeros(3))


def inverted(T: Floats) -> Floats:
    """Inverse of poses, shape (..., 4, 4)."""
    R = np.swapaxes(T[..., :3, :3], -1, -2)
    return pose_of(R, -(R @ T[..., :3, 3, None])[..., 0])


def _fits(shape: tuple[int, ...], wanted: tuple[int, ...]) -> bool:
    return len(shape) == len(wanted) and all(
        w in (-1, n) for n, w in zip(shape, wanted, strict=True)
    )


def _shape_text(shape: tuple[int, ...]) -> str:
    inner = ", ".join("any" if n < 0 else str(n) for n in shape)
    return f"({inner},)" if len(shape) == 1 else f"({inner})"
