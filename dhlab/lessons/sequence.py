"""The same words twice: a sequence of turns and slides about moving and about fixed axes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from dhlab.arrays import as_number, as_vector
from dhlab.errors import InputError
from dhlab.kinematics.transforms import transl
from dhlab.lessons.lesson import Lesson
from dhlab.lessons.moves import AXES, Slide, Turn, slide, turn
from dhlab.lessons.step import Question, Step
from dhlab.scene.csys import Csys

Word: TypeAlias = tuple[str, float] | ArrayLike

PALE = 0.3


def sequence_lesson(
    words: Sequence[Word],
    *,
    questions: Sequence[Question | None] = (),
    title: str = "The same words, moving and fixed axes",
    apart: float = 3.0,
) -> Lesson:
    """Make a lesson of one sequence in both readings, side by side.

    Two coordinate systems start alike. {M} takes each word about its own, moving axes; {F} takes
    the same word about the fixed axes {0} that it started from. A turn about a moving axis is a
    factor on the right of the product, one about a fixed axis on the left.

    Parameters
    ----------
    words : sequence of (axis, angle) or of array_like, shape (3,)
        A turn: 'x', 'y' or 'z', and an angle [rad]. A slide: its vector [m].
    questions : sequence of Choice, Place or None
        Asked before the words, one each.
    title : str
    apart : float [m]
        Between the two.

    Returns
    -------
    lesson : Lesson
        Its handles are {M}, {F} and the pale {0} of each.

    Raises
    ------
    InputError
        A word that is neither a turn nor a slide.

    Examples
    --------
    >>> from dhlab import deg
    >>> lesson = sequence_lesson([("z", 90 * deg), ("x", 90 * deg)])
    >>> lesson.go(2).steps[1].title
    'Turn by 90° about x'
    >>> M, F, *_ = lesson.handles
    >>> np.allclose(M.pose[:3, :3], F.pose[:3, :3])
    False

    References
    ----------
    Craig, Introduction to Robotics, section 2.8.
    """
    half = as_number(apart, "apart", above=0) / 2
    moving, fixed = Csys("M"), Csys("F")
    zeros = [Csys("0"), Csys("0'")]
    for csys, zero, x in ((moving, zeros[0], -half), (fixed, zeros[1], half)):
        csys.set(pose=transl((x, 0, 0)))
        zero.set(pose=transl((x, 0, 0)), opacity=PALE, labels=False, size=0.7)
    asked = [*questions, *(len(words) * [None])]
    steps, factors = [], []
    for k, word in enumerate(words, start=1):
        own, other, said = _both(word, k, moving, fixed, zeros[1])
        factors.append(own.latex)
        steps.append(Step(said, _text(said, factors), own, other, question=asked[k - 1]))
    steps.append(Step("What came out", _end(factors)))
    return Lesson(title, steps, handles=[moving, fixed, *zeros], keep=1, product=moving)


def _both(
    word: Any, k: int, moving: Csys, fixed: Csys, zero: Csys
) -> tuple[Turn | Slide, Turn | Slide, str]:
    """Return a word as a move of either csys, and as it is said."""
    if isinstance(word, tuple) and len(word) == 2 and isinstance(word[0], str):
        axis, angle = word
        if axis not in AXES:
            raise InputError(f"word {k}: no axis {axis!r}; use 'x', 'y' or 'z'")
        said = f"Turn by {np.degrees(as_number(angle, f'angle of word {k}')):.4g}° about {axis}"
        return turn(moving, axis, angle), turn(fixed, axis, angle, about=zero), said
    try:
        vector = as_vector(word, f"word {k}")
    except InputError as error:
        raise InputError(
            f"word {k} must be an axis with an angle, ('z', 90 * deg), or a vector, got {word!r}"
        ) from error
    said = f"Slide by ({', '.join(f'{x:.4g}' for x in vector)})"
    return slide(moving, vector), slide(fixed, vector, along=zero), said


def _text(said: str, factors: Sequence[str]) -> str:
    return (
        f"**{said}.** $\\{{M\\}}$ does it with its own axes, wherever they are by now: the new "
        "factor goes to the right,\n\n"
        f"$$T_{{0M}} = {' '.join(factors)}$$\n\n"
        "$\\{F\\}$ does it with the axes it started from: the new factor goes to the left,\n\n"
        f"$$T_{{0F}} = {' '.join(reversed(factors))}$$"
    )


def _end(factors: Sequence[str]) -> str:
    return (
        "The same words, two readings, two results. Read the product of $\\{M\\}$ backwards, "
        "and you have the words for fixed axes that lead to the same place:\n\n"
        f"$$T_{{0M}} = {' '.join(factors)}$$\n\n"
        "From left to right: about moving axes. From right to left: about fixed axes."
    )
