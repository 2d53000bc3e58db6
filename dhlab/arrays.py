"""The one door for input: every array that enters dhlab is checked here, once.

Each function takes a value and the words that name it in an error (`what`, such as
``"q of 'arm'"``), and gives a read-only float64 array or raises `InputError`: which thing, what
came, what was wanted. Behind the door nothing is checked again.
"""

import re
from collections.abc import Sequence
from types import EllipsisType
from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dhlab.errors import InputError

RIGID_TOLERANCE = 1e-6

Shape: TypeAlias = tuple[int | EllipsisType | None, ...]


def read_only(a: ArrayLike) -> NDArray[np.float64]:
    """Give `a` as a float64 array that nobody can write to; the caller's own array stays as it is.

    Examples
    --------
    >>> p = read_only([1, 2, 3])
    >>> p[0] = 9
    Traceback (most recent call last):
    ...
    ValueError: assignment destination is read-only
    """
    if isinstance(a, np.ndarray) and not a.flags.writeable and a.flags.owndata and a.dtype == float:
        return a
    own = np.array(a, dtype=np.float64)
    own.flags.writeable = False
    return own


def as_array(value: ArrayLike, shape: Shape, what: str) -> NDArray[np.float64]:
    """Finite numbers of a given shape: None is any length, `...` in front any axes before.

    Examples
    --------
    >>> as_array([1, 2], (3,), "the origin")
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: the origin must have shape (3,), got (2,)
    >>> as_array([[1, 2, np.nan]], (None, 3), "the points")
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: the points must be finite, got nan at [0, 2]
    """
    a = _numbers(value, what)
    _check_shape(a, shape, what)
    if np.count_nonzero(np.isfinite(a)) < a.size:
        index = np.argwhere(~np.isfinite(a))[0]
        where = f" at {index.tolist()}" if a.ndim else ""
        raise InputError(f"{what} must be finite, got {a[tuple(index)]}{where}")
    return read_only(a)


def as_vector(value: ArrayLike, what: str, length: int = 3) -> NDArray[np.float64]:
    """Vector, shape (length,)."""
    return as_array(value, (length,), what)


def as_points(value: ArrayLike, what: str, dimension: int = 3) -> NDArray[np.float64]:
    """Points in rows, shape (m, dimension)."""
    return as_array(value, (None, dimension), what)


def as_rotation(value: ArrayLike, what: str, leading: Shape = ()) -> NDArray[np.float64]:
    """Rotation matrix, shape (3, 3), or an array of them: shape (*leading, 3, 3).

    Examples
    --------
    >>> as_rotation([[1, 0, 0], [0, 2, 0], [0, 0, 1]], "R")
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: R is not a rotation: its y axis has length 2, it must have length 1
    """
    R = as_array(value, (*leading, 3, 3), what)
    _check_rotations(R, what)
    return R


def as_pose(value: ArrayLike, what: str, leading: Shape = ()) -> NDArray[np.float64]:
    """Pose, shape (4, 4): rotation, origin and the row 0 0 0 1; or shape (*leading, 4, 4).

    Examples
    --------
    >>> as_pose(np.diag([1, 1, -1, 1]), "pose of 'cube'")
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: pose of 'cube' is not a rotation but a reflection: its determinant \
is -1, its axes are left-handed
    """
    T = as_array(value, (*leading, 4, 4), what)
    _check_last_rows(T, what)
    _check_rotations(T[..., :3, :3], what)
    return T


def as_poses(value: ArrayLike, what: str) -> NDArray[np.float64]:
    """One pose per step, shape (steps, 4, 4)."""
    return as_pose(value, what, leading=(None,))


def as_placement(
    value: ArrayLike, what: str, current: NDArray[np.float64] | None = None
) -> NDArray[np.float64]:
    """Pose from an origin alone (3-vector), a pose, or, where there is `current`, a rotation.

    What is not given stays as in `current`: an origin keeps its orientation, a rotation its
    origin. Without `current` an origin stands with the axes of its parent.

    Examples
    --------
    >>> as_placement((1, 2, 3), "base of 'arm'")[:3, 3]
    array([1., 2., 3.])
    """
    given = _numbers(value, what)
    if given.shape == (4, 4):
        return as_pose(given, what)
    T = np.array(np.eye(4) if current is None else current)
    if given.shape in {(3,), (3, 1)}:
        T[:3, 3] = as_vector(given.reshape(3), what)
    elif given.shape == (3, 3) and current is not None:
        T[:3, :3] = as_rotation(given, what)
    else:
        choices = "a 3-vector or a 4x4 pose"
        if current is not None:
            choices = "a 3-vector, a 4x4 pose or a 3x3 rotation"
        raise InputError(f"{what} must be {choices}, got shape {given.shape}")
    return read_only(T)


def as_config(value: ArrayLike, n: int, what: str) -> NDArray[np.float64]:
    """One configuration, shape (n,) [rad or m]."""
    return as_array(value, (n,), what)


def as_configs(value: ArrayLike, n: int, what: str) -> NDArray[np.float64]:
    """One configuration per step, shape (steps, n) [rad or m]."""
    return as_array(value, (None, n), what)


def as_limits(value: ArrayLike | None, n: int, what: str) -> NDArray[np.float64]:
    """Lower and upper limit of each joint, shape (n, 2) [rad or m]; None is no limits at all.

    Examples
    --------
    >>> as_limits([(-1, 1), (0, np.inf)], 2, "limits of 'arm'")
    array([[-1.,  1.],
           [ 0., inf]])
    >>> as_limits([(-1, 1), (2, 0)], 2, "limits of 'arm'")
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: limits of 'arm', joint 2: the lower limit 2 is above the upper limit 0
    """
    if value is None:
        return read_only(np.tile([-np.inf, np.inf], (n, 1)))
    a = _numbers(value, what)
    if a.shape != (n, 2):
        raise InputError(
            f"{what} must have shape ({n}, 2), a row (lower, upper) per joint, got {a.shape}"
        )
    for joint, (lower, upper) in enumerate(a, start=1):
        if np.isnan(lower) or np.isnan(upper) or lower == np.inf or upper == -np.inf:
            raise InputError(f"{what}, joint {joint}: no number lies in [{lower:g}, {upper:g}]")
        if lower > upper:
            ends = f"the lower limit {lower:g} is above the upper limit {upper:g}"
            raise InputError(f"{what}, joint {joint}: {ends}")
    return read_only(a)


def as_color(value: str | Sequence[float], what: str) -> tuple[float, float, float]:
    """Red, green and blue as floats in 0..1, from three such floats or from "#rrggbb".

    Examples
    --------
    >>> as_color("#ff8000", "color of 'arm'")
    (1.0, 0.5019607843137255, 0.0)
    >>> as_color((255, 0, 0), "color of 'arm'")
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: color of 'arm' must be three numbers in 0..1 or '#rrggbb', \
got (255, 0, 0)
    """
    refusal = InputError(f"{what} must be three numbers in 0..1 or '#rrggbb', got {value!r}")
    if isinstance(value, str):
        if not re.fullmatch("#[0-9a-fA-F]{6}", value):
            raise refusal
        red, green, blue = bytes.fromhex(value[1:])
        return red / 255, green / 255, blue / 255
    a = _numbers(value, what)
    if a.shape != (3,) or not ((a >= 0) & (a <= 1)).all():
        raise refusal
    return float(a[0]), float(a[1]), float(a[2])


def as_number(
    value: object,
    what: str,
    *,
    minimum: float | None = None,
    above: float | None = None,
    maximum: float | None = None,
) -> float:
    """One finite number, at least `minimum`, more than `above`, at most `maximum`.

    Examples
    --------
    >>> as_number(0, "radius of 'arm'", above=0)
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: radius of 'arm' must be above 0, got 0
    """
    a = _numbers(value, what)
    if a.shape != ():
        raise InputError(f"{what} must be one number, got shape {a.shape}")
    number = float(as_array(a, (), what))
    if minimum is not None and number < minimum:
        raise InputError(f"{what} must be at least {minimum:g}, got {number:g}")
    if above is not None and number <= above:
        raise InputError(f"{what} must be above {above:g}, got {number:g}")
    if maximum is not None and number > maximum:
        raise InputError(f"{what} must be at most {maximum:g}, got {number:g}")
    return number


def as_name(value: object, what: str) -> str:
    """Name: text, not blank, without "/" (which joins names to paths)."""
    if not isinstance(value, str) or not value.strip() or "/" in value:
        raise InputError(f"{what} must be text, not empty and without '/', got {value!r}")
    return value


def _numbers(value: object, what: str) -> NDArray[np.float64]:
    """Whatever is a real number, or rows of them, as float64 of any shape."""
    try:
        raw = np.asarray(value)
    except ValueError:
        raise InputError(f"{what} must have rows of equal length, got {value!r}") from None
    if raw.dtype.kind not in "iuf":
        raise InputError(f"{what} must be made of numbers, got {value!r}")
    return raw.astype(np.float64, copy=False)


def _check_shape(a: NDArray[np.float64], shape: Shape, what: str) -> None:
    last = shape[1:] if shape[:1] == (...,) else shape
    before = a.ndim - len(last)
    fits = before == 0 or (before > 0 and last != shape)
    if fits and a.shape[before:] == last:
        return
    if not fits or any(w not in (None, n) for w, n in zip(last, a.shape[before:], strict=True)):
        wanted = ["..."] * (fits and before > 0) + ["m" if w is None else str(w) for w in last]
        text = ", ".join(wanted) + "," * (len(wanted) == 1)
        raise InputError(f"{what} must have shape ({text}), got {a.shape}")


def _check_last_rows(T: NDArray[np.float64], what: str) -> None:
    wrong = (np.abs(T[..., 3, :] - (0, 0, 0, 1)) > RIGID_TOLERANCE).any(axis=-1)
    if wrong.any():
        T, what = _first(T, wrong, what)
        row = ", ".join(f"{x:g}" for x in T[3])
        hint = " (is it transposed?)" if T[3, :3].any() and not T[:3, 3].any() else ""
        raise InputError(f"{what} has the last row [{row}], it must be [0, 0, 0, 1]{hint}")


def _check_rotations(R: NDArray[np.float64], what: str) -> None:
    excess = np.abs(np.swapaxes(R, -1, -2) @ R - np.eye(3))
    wrong = (excess > RIGID_TOLERANCE).any(axis=(-1, -2))
    if wrong.any():
        R, name = _first(R, wrong, what)
        raise InputError(f"{name} is not a rotation: {_why_not_orthonormal(R)}")
    mirrored = np.linalg.det(R) < 0
    if mirrored.any():
        _, name = _first(R, mirrored, what)
        raise InputError(
            f"{name} is not a rotation but a reflection: its determinant is -1, "
            "its axes are left-handed"
        )


def _why_not_orthonormal(R: NDArray[np.float64]) -> str:
    gram = R.T @ R
    i, j = np.unravel_index(np.abs(gram - np.eye(3)).argmax(), (3, 3))
    if i == j:
        return f"its {'xyz'[i]} axis has length {np.sqrt(gram[i, i]):.7g}, it must have length 1"
    axes = f"its {'xyz'[i]} and {'xyz'[j]} axes"
    return f"{axes} are not perpendicular, their scalar product is {gram[i, j]:.7g}"


def _first(a: NDArray[np.float64], wrong: ArrayLike, what: str) -> tuple[NDArray[np.float64], str]:
    """First wrong matrix of an array of them (or the only one), and its name."""
    index = tuple(np.argwhere(wrong)[0].tolist())
    return a[index], f"{what} {list(index)}" if index else what
