"""What anybody can see of a wrong answer, without a guess at the cause."""

from math import degrees

import numpy as np

from dhlab.diagnosis.values import Floats, as_pose44
from dhlab.kinematics.angles import r2angvec

SMALL = 2e-4
"""What rounding to four digits does is not spoken of."""

SKEW = 2e-3
"""A rotation matrix rounded to three digits is still one."""


def pose_seen(came: Floats, wanted: Floats, name: str = "the frame") -> str:
    """Sentence about a matrix, shape (3, 3) or (4, 4), that is not the one wanted.

    Examples
    --------
    >>> pose_seen(np.diag([1.0, 1, 2]), np.eye(3))
    'This is no rotation matrix: its z column is longer than 1. Only the number in row 3, column 3
    is not right.'
    """
    A, B = as_pose44(came), as_pose44(wanted)
    off = np.argwhere(np.abs(A - B) > SMALL * (1 + np.abs(B)))
    alone = ""
    if len(off) == 1 and off[0][1] < 3:
        row, column = off[0] + 1
        alone = f" Only the number in row {row}, column {column} is not right."
    return _pose_seen(A, B, name) + alone


def _pose_seen(A: Floats, B: Floats, name: str) -> str:
    if np.abs(A[3] - (0, 0, 0, 1)).max() > SMALL:
        return "The last row of a pose is 0, 0, 0, 1: here it is not."
    R = A[:3, :3]
    fault = _no_rotation(R)
    if fault:
        return fault
    angle, axis = r2angvec(_nearest(R @ B[:3, :3].T))
    subject = name[0].upper() + name[1:]
    apart = np.linalg.norm(A[:3, 3] - B[:3, 3]) > SMALL
    origin = _off(A[:3, 3], B[:3, 3])
    if angle <= SMALL:
        return f"{subject} is {origin if apart else 'off by less than can be seen'}."
    turned, own = degrees(angle), degrees(r2angvec(_nearest(B[:3, :3]))[0])
    size = "" if reveals(turned, own) else f"by {turned:.3g} degrees "
    away = f"{subject} is turned away from the wanted one {size}about {_axis_name(axis)}"
    return f"{away}; its origin is {origin}." if apart else f"{away}."


def point_seen(came: Floats, wanted: Floats) -> str:
    """Sentence about a point, shape (3,), that lies elsewhere.

    Examples
    --------
    >>> point_seen(np.array([0.2, 0, 0]), np.array([0.25, 0, 0]))
    'The point is 50 mm off, along x alone.'
    >>> point_seen(np.array([0.0, 0, 0]), np.array([0.25, 0, 0]))
    'The point is off, along x alone.'
    """
    return f"The point is {_off(came, wanted)}."


def direction_seen(came: Floats, wanted: Floats) -> str:
    """Sentence about a direction, shape (3,), that is another one.

    Examples
    --------
    >>> direction_seen(np.array([1.0, 1, 0]), np.array([1.0, 0, 0]))
    'The direction points 45 degrees away from the wanted one, and is too long.'
    """
    lengths = np.linalg.norm(came), np.linalg.norm(wanted)
    parts = []
    if min(lengths) > SMALL:
        angle = np.arctan2(np.linalg.norm(np.cross(came, wanted)), came @ wanted)
        if angle > SMALL:
            parts.append(f"points {degrees(angle):.3g} degrees away from the wanted one")
    if abs(lengths[0] - lengths[1]) > SMALL * (1 + lengths[1]):
        parts.append(f"is too {'long' if lengths[0] > lengths[1] else 'short'}")
    return f"The direction {', and '.join(parts) or 'is not the wanted one'}."


def rotation_seen(came: Floats, wanted: Floats, name: str) -> str:
    """Sentence about a rotation, shape (3, 3), whose angles are asked for: without any angle."""
    _, axis = r2angvec(_nearest(came @ wanted.T))
    return f"{name[0].upper()}{name[1:]} is turned away from the wanted one about \
{_axis_name(axis)}."


def reveals(shown: float, *wanted: float) -> bool:
    """Whether a number to be shown is one that is asked for, as far as its digits tell."""
    return any(abs(shown - abs(w)) <= 0.006 * abs(w) for w in wanted)


def distance(length: float) -> str:
    """Length to read.

    Examples
    --------
    >>> distance(0.0123), distance(2.5)
    ('12.3 mm', '2.5 m')
    """
    return f"{length * 1000:.3g} mm" if length < 1 else f"{length:.4g} m"


def _off(came: Floats, wanted: Floats) -> str:
    """How far off a point is, unless that tells where it belongs."""
    shift = came - wanted
    length = float(np.linalg.norm(shift))
    sizes = [*wanted.tolist(), float(np.linalg.norm(wanted))]
    size = "" if reveals(length, *sizes) else f"{distance(length)} "
    return f"{size}off, {_along(shift)}"


def _no_rotation(R: Floats) -> str:
    lengths = np.linalg.norm(R, axis=0)
    for k in range(3):
        if abs(lengths[k] - 1) > SKEW:
            than = "longer" if lengths[k] > 1 else "shorter"
            return f"This is no rotation matrix: its {'xyz'[k]} column is {than} than 1."
    gram = R.T @ R
    for i, j in ((0, 1), (0, 2), (1, 2)):
        if abs(gram[i, j]) > SKEW:
            return (
                f"This is no rotation matrix: the {'xyz'[i]} and the {'xyz'[j]} column are not "
                "perpendicular."
            )
    if np.linalg.det(R) < 0:
        return "This frame is left-handed: x cross y is not z but its opposite."
    return ""


def _nearest(R: Floats) -> Floats:
    u, _, vh = np.linalg.svd(R)
    out: Floats = u @ np.diag([1.0, 1.0, float(np.linalg.det(u @ vh))]) @ vh
    return out


def _axis_name(axis: Floats) -> str:
    k = int(np.abs(axis).argmax())
    if abs(axis[k]) > 1 - 1e-6:
        return f"the fixed {'xyz'[k]} axis"
    return "an axis that is none of x, y, z"


def _along(shift: Floats) -> str:
    k = int(np.abs(shift).argmax())
    if np.abs(np.delete(shift, k)).max() < SMALL * (1 + abs(shift[k])):
        return f"along {'xyz'[k]} alone"
    return f"most of it along {'xyz'[k]}"
