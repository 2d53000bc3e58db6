"""Products of turns and slides: matrices, and functions that return one."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from dhlab.arrays import as_vector
from dhlab.diagnosis.values import Floats
from dhlab.errors import InputError
from dhlab.kinematics.angles import angvec2r

After: TypeAlias = Callable[[Floats], Floats]
AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}


@dataclass(frozen=True, eq=False)
class Factor:
    """One elementary factor of a recipe; made by `turn` and `slide`."""

    kind: Literal["turn", "slide"]
    axis: str | tuple[float, ...]
    value: Any

    def at(self, inputs: Sequence[Any]) -> "Move":
        """Put the inputs of a case in."""
        value = self.value(*inputs) if callable(self.value) else self.value
        if self.kind == "turn":
            return Move("turn", self.axis, float(value), np.zeros(3))
        return Move("slide", self.axis, 0.0, as_vector(value, "vector of a slide"))


@dataclass(frozen=True, eq=False)
class Move:
    """An elementary factor in numbers."""

    kind: Literal["turn", "slide"]
    axis: str | tuple[float, ...]
    angle: float
    vector: Floats

    def matrix(self) -> Floats:
        """Pose, shape (4, 4)."""
        T = np.eye(4)
        if self.kind == "slide":
            T[:3, 3] = self.vector
        elif isinstance(self.axis, str):
            i, j = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[self.axis]
            c, s = np.cos(self.angle), np.sin(self.angle)
            T[i, i], T[i, j], T[j, i], T[j, j] = c, -s, s, c
        else:
            T[:3, :3] = angvec2r(self.angle, self.axis)
        return T


def turn(axis: str | ArrayLike, angle: float | Callable[..., float]) -> Factor:
    """Rotation about an axis: a factor of a recipe.

    Parameters
    ----------
    axis : {'x', 'y', 'z'} or array_like, shape (3,)
    angle : float or callable [rad]
        A number, or what gives it from the inputs: ``lambda roll, pitch, yaw: pitch``.

    Examples
    --------
    >>> turn("w", 1)
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: no axis 'w'; use 'x', 'y', 'z' or a 3-vector
    """
    if isinstance(axis, str):
        if axis not in AXES:
            raise InputError(f"no axis {axis!r}; use 'x', 'y', 'z' or a 3-vector")
        return Factor("turn", axis, angle)
    return Factor("turn", tuple(as_vector(axis, "axis of a turn").tolist()), angle)


def slide(vector: ArrayLike | Callable[..., ArrayLike]) -> Factor:
    """Translation: a factor of a recipe.

    Parameters
    ----------
    vector : array_like, shape (3,), or callable [m]
        Numbers, or what gives them from the inputs: ``lambda p: p``.
    """
    return Factor("slide", "", vector)


@dataclass(frozen=True, eq=False)
class Product:
    """A product of moves in numbers, and what was done to it afterwards."""

    moves: tuple[Move, ...]
    after: tuple[After, ...] = ()

    def then(self, change: After) -> "Product":
        """Do something to the finished matrix."""
        return replace(self, after=(*self.after, change))

    def value(self) -> Floats:
        """Pose, shape (4, 4)."""
        T = np.eye(4)
        for move in self.moves:
            T = T @ move.matrix()
        for change in self.after:
            T = change(T)
        return T

    def changed(self, k: int, **what: Any) -> "Product":
        """Product with one move changed."""
        moves = list(self.moves)
        moves[k] = replace(moves[k], **what)
        return replace(self, moves=tuple(moves))
