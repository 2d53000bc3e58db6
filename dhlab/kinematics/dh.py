"""One row of a Denavit-Hartenberg table: a link and a joint, in one of two conventions.

In the *modified* convention (Craig) row i holds the twist `alpha` and the length `a` of link
i-1, and the offset `d` and the angle `theta` of joint i; frame {i} stands on the axis of joint i.
In the *standard* convention all four belong to link i, and frame {i} stands at its far end.
"""

import warnings
from collections.abc import Iterable, Sequence
from math import degrees, pi
from typing import Literal, NamedTuple, TypeAlias, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dhlab.arrays import as_array, as_number
from dhlab.errors import DegreesWarning, InputError
from dhlab.kinematics.transforms import pose_of, rotx, rotz

Convention: TypeAlias = Literal["modified", "standard"]
JointKind: TypeAlias = Literal["r", "p"]

deg = pi / 180
"""One degree in radians: ``90 * deg``."""


class DHRow(NamedTuple):
    """One row of a Denavit-Hartenberg table; make it by `dh`.

    Attributes
    ----------
    alpha, a : float [rad], [m]
        Twist and length of the link.
    d, theta : float [m], [rad]
        Offset and angle of the joint; one of them is its variable, and its value here is home.
    """

    alpha: float
    a: float
    d: float
    theta: float


def dh(alpha: float, a: float, d: float, theta: float) -> DHRow:
    """One row of a Denavit-Hartenberg table.

    In the modified convention, the default of every table, `alpha` and `a` belong to the link
    *before* the joint: row i is alpha_{i-1}, a_{i-1}, d_i, theta_i.

    Parameters
    ----------
    alpha, a : float [rad], [m]
        Twist and length of the link.
    d, theta : float [m], [rad]
        Offset and angle of the joint.

    Returns
    -------
    row : DHRow

    Warns
    -----
    DegreesWarning
        If `alpha` or `theta` is more than a full turn, as angles in degrees are.

    Examples
    --------
    >>> dh(alpha=90 * deg, a=0.3, d=0, theta=0)
    DHRow(alpha=1.5707963267948966, a=0.3, d=0.0, theta=0.0)
    >>> dh(0, "0.3", 0, 0)
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: a of a table row must be made of numbers, got '0.3'

    References
    ----------
    Craig, Introduction to Robotics, section 3.4.
    """
    values = {"alpha": alpha, "a": a, "d": d, "theta": theta}
    row = DHRow(**{k: as_number(value, f"{k} of a table row") for k, value in values.items()})
    for name, angle in (("alpha", row.alpha), ("theta", row.theta)):
        if abs(angle) > 2 * pi + 1e-9:
            warnings.warn(
                f"{name} of a table row is {angle:g} rad, which is {degrees(angle):.0f} deg; "
                f"if {angle:g} deg is meant, write {angle:g} * deg",
                DegreesWarning,
                stacklevel=2,
            )
    return row


def link_transform(row: ArrayLike, convention: Convention = "modified") -> NDArray[np.float64]:
    r"""Pose of frame {i} in frame {i-1} by one row of the table, all four numbers as they stand.

    .. math::
        T &= R_x(\alpha)\, D_x(a)\, R_z(\theta)\, D_z(d) \quad\text{(modified)} \\
        T &= R_z(\theta)\, D_z(d)\, R_x(\alpha)\, D_x(a) \quad\text{(standard)}

    Parameters
    ----------
    row : array_like, shape (..., 4)
        alpha [rad], a [m], d [m], theta [rad].
    convention : {'modified', 'standard'}

    Returns
    -------
    T : ndarray, shape (..., 4, 4)

    Examples
    --------
    >>> link_transform(dh(90 * deg, 2, 3, 0))[:3, 3].round(6)
    array([ 2., -3.,  0.])
    >>> link_transform(dh(90 * deg, 2, 3, 0), "standard")[:3, 3].round(6)
    array([2., 0., 3.])

    References
    ----------
    Craig, Introduction to Robotics, eq. 3.6.
    """
    alpha, a, d, theta = np.moveaxis(as_array(row, (..., 4), "row"), -1, 0)
    link, joint = _about_x(alpha, a), _about_z(theta, d)
    return link @ joint if as_convention(convention) == "modified" else joint @ link


def as_convention(name: Convention) -> Convention:
    """Name of a convention, checked.

    Examples
    --------
    >>> as_convention("craig")
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: no convention 'craig'; use 'modified' or 'standard'
    """
    if name not in get_args(Convention):
        raise InputError(f"no convention {name!r}; use 'modified' or 'standard'")
    return name


def as_kinds(joints: Iterable[str], n: int) -> tuple[JointKind, ...]:
    """Kind of each of n joints, 'r' or 'p', from their letters ('d' is prismatic too).

    Examples
    --------
    >>> as_kinds("rd", 2)
    ('r', 'p')
    >>> as_kinds("rx", 2)
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: joint 2: no joint type 'x'; use 'r' or 'p'
    """
    if not isinstance(joints, Iterable):
        raise InputError(f"joints must be letters 'r' or 'p', one per joint, got {joints!r}")
    letters: dict[str, JointKind] = {"r": "r", "p": "p", "d": "p"}
    kinds: list[JointKind] = []
    for letter in joints:
        if not isinstance(letter, str) or letter not in letters:
            raise InputError(f"joint {len(kinds) + 1}: no joint type {letter!r}; use 'r' or 'p'")
        kinds.append(letters[letter])
    if len(kinds) != n:
        raise InputError(f"a table of {n} rows needs {n} joint letters, got {len(kinds)}")
    return tuple(kinds)


def as_rows(rows: Iterable[ArrayLike]) -> tuple[DHRow, ...]:
    """Rows of a table, from rows made by `dh` or from 4 numbers each."""
    if not isinstance(rows, Iterable):
        raise InputError(f"a table must be rows of alpha, a, d, theta, got {rows!r}")
    table = []
    for i, row in enumerate(rows, start=1):
        numbers = as_array(row, (4,), f"row {i} of the table (alpha, a, d, theta)").tolist()
        table.append(DHRow(*numbers) if isinstance(row, DHRow) else dh(*numbers))
    return tuple(table)


def joint_motion(kind: JointKind, variable: ArrayLike) -> NDArray[np.float64]:
    """Pose, shape (..., 4, 4), that the variable of a joint alone makes: along or about z.

    Examples
    --------
    >>> joint_motion("p", 0.2)[:3, 3]
    array([0. , 0. , 0.2])
    """
    variable = as_array(variable, (...,), "variable")
    return _about_z(variable, 0.0) if kind == "r" else _about_z(0.0, variable)


def link_constants(
    row: DHRow, kind: JointKind, convention: Convention
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    r"""What stands still before and behind the joint's motion, each a pose of shape (4, 4).

    ``link_transform(row) == before @ joint_motion(kind, variable) @ after`` where the variable is
    theta of a revolute, d of a prismatic joint. One of the two is always the identity.

    Examples
    --------
    >>> before, after = link_constants(dh(0, 0.3, 0.1, 0), "r", "modified")
    >>> before[:3, 3]
    array([0.3, 0. , 0.1])
    """
    link = _about_x(row.alpha, row.a)
    fixed = joint_motion("p", row.d) if kind == "r" else joint_motion("r", row.theta)
    if convention == "modified":
        return link @ fixed, np.eye(4)
    return np.eye(4), fixed @ link


def links_up(rows: Sequence[DHRow]) -> tuple[NDArray[np.float64], tuple[DHRow, ...]]:
    """Turn a modified table into a standard one: the link before all rows, and the rows.

    Examples
    --------
    >>> first, rows = links_up([dh(0, 0.1, 0, 0), dh(0, 0.2, 0, 0)])
    >>> first[:3, 3], [row.a for row in rows]
    (array([0.1, 0. , 0. ]), [0.2, 0.0])
    """
    links = [(row.alpha, row.a) for row in rows] + [(0.0, 0.0)]
    moved = zip(links[1:], rows, strict=True)
    return _about_x(*links[0]), tuple(DHRow(*link, row.d, row.theta) for link, row in moved)


def links_down(rows: Sequence[DHRow]) -> tuple[tuple[DHRow, ...], NDArray[np.float64]]:
    """Turn a standard table into a modified one: the rows, and the link behind them all."""
    links = [(0.0, 0.0)] + [(row.alpha, row.a) for row in rows]
    moved = zip(links[:-1], rows, strict=True)
    return tuple(DHRow(*link, row.d, row.theta) for link, row in moved), _about_x(*links[-1])


def _about_x(angle: ArrayLike, distance: ArrayLike) -> NDArray[np.float64]:
    """Turn about x and shift along x, shape (..., 4, 4)."""
    return pose_of(rotx(angle), np.multiply.outer(distance, (1.0, 0.0, 0.0)))


def _about_z(angle: ArrayLike, distance: ArrayLike) -> NDArray[np.float64]:
    """Turn about z and shift along z, shape (..., 4, 4)."""
    return pose_of(rotz(angle), np.multiply.outer(distance, (0.0, 0.0, 1.0)))
