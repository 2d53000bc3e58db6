"""Products of turns and slides: matrices, and functions that return one."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from dhlab.arrays import as_placement, as_vector
from dhlab.diagnosis.values import Floats, inverted
from dhlab.errors import InputError
from dhlab.kinematics.angles import angvec2r

After: TypeAlias = Callable[[Floats], Floats]
Kind: TypeAlias = Literal["turn", "slide", "given"]


@dataclass(frozen=True, eq=False)
class Factor:
    """One factor of a recipe; made by `turn`, `slide`, `given` and `inverse_of`."""

    kind: Kind
    axis: str | tuple[float, ...]
    value: Any
    name: str = ""
    inverse: bool = False

    def at(self, inputs: Sequence[Any]) -> "Move":
        """Put the inputs of a case in."""
        value = self.value(*inputs) if callable(self.value) else self.value
        if self.kind == "turn":
            return Move("turn", self.axis, float(value), np.zeros(3))
        if self.kind == "slide":
            return Move("slide", self.axis, 0.0, as_vector(value, "vector of a slide"))
        T = as_placement(value, self.name, np.eye(4))
        return Move("given", "", 0.0, np.zeros(3), self.name, T, self.inverse)


@dataclass(frozen=True, eq=False)
class Move:
    """A factor in numbers.

    `flawed` is a change of the finished factor: what went wrong within it.
    """

    kind: Kind
    axis: str | tuple[float, ...]
    angle: float
    vector: Floats
    name: str = ""
    pose: Floats | None = None
    inverse: bool = False
    flawed: After | None = None

    @cached_property
    def matrix(self) -> Floats:
        """Pose, shape (4, 4)."""
        return self.flawed(self.sound) if self.flawed else self.sound

    @property
    def sound(self) -> Floats:
        """Pose without the flaw."""
        if self.pose is not None:
            return inverted(self.pose) if self.inverse else self.pose
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
        if axis not in ("x", "y", "z"):
            raise InputError(f"no axis {axis!r}; use 'x', 'y', 'z' or a 3-vector")
        return Factor("turn", axis, angle)
    return Factor("turn", tuple(as_vector(axis, "axis of a turn").tolist()), angle)


def slide(vector: ArrayLike | Callable[..., ArrayLike]) -> Factor:
    """Translation: a factor of a recipe.

    Parameters
    ----------
    vector : array_like, shape (3,), or callable [m]
        Numbers, or one function of all inputs that gives the three: ``lambda p: p``.

    Examples
    --------
    >>> from dhlab.diagnosis import MatrixTask, turn
    >>> from dhlab.kinematics.transforms import rotz, rp2t
    >>> lift = MatrixTask(slide(lambda h, pan: (0, 0, h)), turn("z", lambda h, pan: pan))
    >>> lift.judge([((0.4, 0.3), rp2t(rotz(0.3), (0, 0, 0.4)))]).right
    True
    """
    return Factor("slide", "", vector)


def given(name: str, pose: ArrayLike | Callable[..., ArrayLike]) -> Factor:
    """Pose or rotation that the task gives: a factor of a recipe.

    Parameters
    ----------
    name : str
        What the task calls it: "T_AB".
    pose : array_like, shape (4, 4) or (3, 3), or callable
        Numbers, or what gives them from the inputs: ``lambda T_AB, T_CB: T_AB``.

    Examples
    --------
    >>> from dhlab.diagnosis import MatrixTask
    >>> from dhlab.kinematics.transforms import inverse, rotx, rp2t
    >>> AB, CB = rp2t(rotx(0.3), (1, 0, 0)), rp2t(rotx(0.5), (0, 2, 0))
    >>> detour = MatrixTask(given("T_AB", AB), inverse_of(given("T_CB", CB)))
    >>> detour.judge([((), AB @ inverse(CB))]).right
    True
    >>> print(detour.judge([((), AB @ CB)]).mistakes[0].text)
    This is exactly what you get when T_CB is used as it is, where its inverse is needed.
    """
    return Factor(
        "given", "", pose if callable(pose) else as_placement(pose, name, np.eye(4)), name
    )


def inverse_of(factor: Factor) -> Factor:
    """Inverse of a given pose: a factor of a recipe.

    Parameters
    ----------
    factor : Factor
        Made by `given`.

    Raises
    ------
    InputError
        If the factor is a turn or a slide.
    """
    if factor.kind != "given":
        raise InputError(f"only a given pose can be inverted, got a {factor.kind}")
    return replace(factor, inverse=not factor.inverse)


@dataclass(frozen=True, eq=False)
class Product:
    """A product of moves in numbers, and what was done to it afterwards."""

    moves: tuple[Move, ...]
    after: tuple[After, ...] = ()

    def then(self, change: After) -> "Product":
        """Do something to the finished matrix."""
        return replace(self, after=(*self.after, change))

    def changed(self, k: int, **what: Any) -> "Product":
        """Product with one move changed."""
        moves = list(self.moves)
        moves[k] = replace(moves[k], **what)
        return replace(self, moves=tuple(moves))


def evaluate_products(products: Sequence[Product]) -> list[Floats]:
    """Poses of many products at once, each (4, 4)."""
    out: list[Floats] = [np.eye(4)] * len(products)
    lengths: dict[int, list[int]] = {}
    for k, product in enumerate(products):
        lengths.setdefault(len(product.moves), []).append(k)
    for n, members in lengths.items():
        factors = np.array([[m.matrix for m in products[k].moves] for k in members])
        T = np.broadcast_to(np.eye(4), (len(members), 4, 4))
        for i in range(n):
            T = T @ factors[:, i]
        for k, pose in zip(members, T, strict=True):
            for change in products[k].after:
                pose = change(pose)
            out[k] = pose
    return out
