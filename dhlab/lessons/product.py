"""The product of matrices that a lesson builds up, one factor a step."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from dhlab.kinematics.transforms import inverse
from dhlab.lessons.moves import MoveTo, Slide, State, Turn, frame_of
from dhlab.lessons.step import Step
from dhlab.scene.placed import Placed

Factor = dict[str, Any]


class Product:
    """The pose of one csys in the world, as the product of the moves that brought it there.

    A move about own axes is a factor on the right, any other one on the left. The plain data of a
    product has `of`, the name of the handle; `relative`, the pose in the world of the frame that
    the product is seen from, or None for the world; its `factors`, and which of them was `added`.

    Parameters
    ----------
    of : Csys or block
    start : ndarray, shape (4, 4)
        Where it stands at first: a factor of its own, unless it is the world's.
    """

    def __init__(self, of: Placed, start: NDArray[np.float64]) -> None:
        self.of = of
        self.factors: list[Factor] = []
        if not np.allclose(start, np.eye(4), rtol=0, atol=1e-12):
            self.factors.append(_factor("T_0", start))

    def after(self, step: Step, state: State) -> dict[str, Any] | None:
        """Take in a step that begins in `state`; return the product as plain data."""
        move = next((move for move in step.moves if move.what is self.of), None)
        added = None
        if isinstance(move, MoveTo):
            self.factors = [_factor(f"T_{{{self.of.name}}}", move.pose)]
            added = 0
        elif isinstance(move, Turn | Slide):
            frame = frame_of(move, state)
            if frame is None:
                self.factors.append(_factor(move.latex, move.motion))
                added = len(self.factors) - 1
            else:
                self.factors.insert(0, _factor(move.latex, frame @ move.motion @ inverse(frame)))
                added = 0
        if not self.factors:
            return None
        return {
            "label": rf"T_{{{self.of.name}}}",
            "of": self.of.name,
            "relative": None,
            "factors": list(self.factors),
            "added": added,
        }


def value_of(factors: Sequence[Factor]) -> NDArray[np.float64]:
    """Multiply factors, shape (4, 4)."""
    product = np.eye(4)
    for factor in factors:
        product = product @ np.array(factor["matrix"])
    return product


def _factor(latex: str, matrix: NDArray[np.float64]) -> Factor:
    return {"latex": latex, "matrix": matrix.tolist()}
