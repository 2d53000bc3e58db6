"""What a student predicted before a step was shown."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dhlab.arrays import as_config
from dhlab.errors import InputError
from dhlab.kinematics.angles import r2angvec
from dhlab.lessons.guess import pose_of_guess
from dhlab.lessons.step import Choice, Place

Record = dict[str, Any]


def judge_choice(question: Choice, value: Any) -> Record:
    """Judge an answer that was chosen.

    Parameters
    ----------
    question : Choice
    value : int
        Place of the answer, from 0.

    Returns
    -------
    record : dict
        Plain data.
    """
    if isinstance(value, bool) or not isinstance(value, int | np.integer):
        raise InputError(f"an answer is the place of a choice, a whole number, got {value!r}")
    if not 0 <= value < len(question.choices):
        raise InputError(f"there is no choice {value}; they are 0 to {len(question.choices) - 1}")
    chosen = int(value)
    return {
        "kind": "choice",
        "question": question.text,
        "predicted": chosen,
        "words": question.choices[chosen],
        "right": chosen == question.answer,
    }


def judge_place(question: Place, target: NDArray[np.float64], value: ArrayLike) -> Record:
    """Judge where a csys was put.

    Parameters
    ----------
    question : Place
    target : ndarray, shape (4, 4)
    value : array_like, shape (6,)
        x, y, z [m], yaw, pitch, roll [rad].

    Returns
    -------
    record : dict
        Plain data; `off` and `turned` say how far it was from the target [m, rad].
    """
    q = as_config(value, 6, "the six numbers of a place")
    pose = pose_of_guess(q)
    off = float(np.linalg.norm(pose[:3, 3] - target[:3, 3]))
    turned = abs(float(r2angvec(target[:3, :3].T @ pose[:3, :3])[0]))
    near, small = question.tolerance
    return {
        "kind": "place",
        "question": question.text,
        "predicted": q.tolist(),
        "words": f"{off:.3f} m and {np.degrees(turned):.1f}° away",
        "off": off,
        "turned": turned,
        "right": off <= near and turned <= small,
    }
