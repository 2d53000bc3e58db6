"""From a table as it came, an array or a mapping, to a chain."""

from collections.abc import Mapping
from typing import Any, Literal

import numpy as np

from dhlab.diagnosis.values import Floats, Unreadable, as_pose44, numbers
from dhlab.kinematics.chain import Chain
from dhlab.kinematics.dh import DHRow
from dhlab.kinematics.transforms import pose_of

LETTERS = {"r": "r", "p": "p", "d": "p"}


def read_chain(value: Any, like: Chain, zero_free: bool) -> Chain:
    """Read a table; what a mapping does not tell is as in the mechanism.

    Parameters
    ----------
    value : object
        Rows alpha, a, d, theta; or a mapping with `rows` and perhaps `joints`, `convention`,
        `base`, `grasper`, `offset`, as a robot has them.
    like : Chain
        The mechanism.
    zero_free : bool
        Whether joints may count from any zero; else an offset not told is the mechanism's.

    Raises
    ------
    Unreadable
        With a sentence for the student.
    """
    given: dict[Any, Any] = dict(value) if isinstance(value, Mapping) else {"rows": value}
    if "rows" not in given:
        raise Unreadable("A table is asked for by its rows: alpha, a, d and theta of each joint.")
    rows = numbers(given["rows"], [(-1, 4)], "the table")
    n = len(rows)
    joints = _joints(given.get("joints"), n)
    if joints is None:
        joints = like.joints if n == like.n else _as_many(like.joints, n)
    offset = given.get("offset")
    own = like.offset if not zero_free and n == like.n else np.zeros(n)
    return Chain(
        [DHRow(*row) for row in rows.tolist()],
        joints,
        _convention(given.get("convention"), like),
        _pose(given.get("base"), "the base", like.base),
        _pose(given.get("grasper"), "the grasper", like.grasper),
        offset=own if offset is None else numbers(offset, [(n,)], "the offset"),
    )


def _joints(value: Any, n: int) -> str | None:
    if value is None:
        return None
    letters = list(value) if isinstance(value, str | list | tuple) else [value]
    for i, letter in enumerate(letters):
        if not isinstance(letter, str) or letter not in LETTERS:
            raise Unreadable(f"The letter of joint {i + 1} is neither 'r' nor 'p'.")
    if len(letters) != n:
        raise Unreadable(f"The table has {n} rows, but there are {len(letters)} joint letters.")
    return "".join(LETTERS[letter] for letter in letters)


def _as_many(joints: str, n: int) -> str:
    return (joints + n * "r")[:n]


def _convention(value: Any, like: Chain) -> Literal["modified", "standard"]:
    if value is None:
        return like.convention
    if isinstance(value, str):
        for name in ("modified", "standard"):
            if value.strip().lower() == name:
                return "standard" if name == "standard" else "modified"
    raise Unreadable("The convention is neither 'modified' nor 'standard'.")


def _pose(value: Any, what: str, own: Floats) -> Floats:
    if value is None:
        return own
    a = numbers(value, [(3,), (4, 4)], what)
    if a.shape == (3,):
        return pose_of(np.eye(3), a)
    R, last = a[:3, :3], a[3]
    sound = np.allclose(R @ R.T, np.eye(3), atol=1e-5) and np.linalg.det(R) > 0
    if not sound or not np.allclose(last, (0, 0, 0, 1), atol=1e-9):
        raise Unreadable(f"{what.capitalize()} is no pose: is its rotation a rotation matrix?")
    return as_pose44(a)
