"""The task of carrying a point or a direction from one frame to another."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from dhlab.arrays import as_vector
from dhlab.diagnosis.product import Factor, Product, evaluate_products
from dhlab.diagnosis.product_slips import product_slips
from dhlab.diagnosis.seen import direction_seen, point_seen
from dhlab.diagnosis.slips import NOTHING, Slip, judge_arrays
from dhlab.diagnosis.values import TOLERANCE, Floats, Unreadable, numbers
from dhlab.diagnosis.verdict import Case, Verdict, mistake
from dhlab.errors import InputError

Use: TypeAlias = Callable[[Floats, Floats], Floats]
ALSO = [(4,), (3, 1), (4, 1), (1, 3), (1, 4)]


class PointTask:
    """A point in another frame, ``p_A = T_AB @ p_B``; the pose is a product of factors.

    A point may come with its fourth number 1.

    Parameters
    ----------
    *factors : Factor
        Made by `turn`, `slide`, `given` and `inverse_of`: the product that stands before the point.
    point : array_like, shape (3,), or callable [m]
        What the product is applied to, or what gives it from the inputs.
    direction : bool
        Whether it is a direction, which is only rotated.
    tolerance : float

    Examples
    --------
    >>> import numpy as np
    >>> from dhlab.diagnosis import given
    >>> from dhlab.kinematics.transforms import inverse, rotz, rp2t
    >>> T_AB, p_B = rp2t(rotz(0.3), (1, 2, 0)), np.array([0.5, 0, 0.2])
    >>> task = PointTask(given("T_AB", T_AB), point=p_B)
    >>> task.judge([((), (T_AB @ [*p_B, 1]))]).right
    True
    >>> [m.key for m in task.judge([((), T_AB[:3, :3] @ p_B)]).mistakes]
    ['no-translation']
    """

    def __init__(
        self,
        *factors: Factor,
        point: ArrayLike | Callable[..., ArrayLike],
        direction: bool = False,
        tolerance: float = TOLERANCE,
    ) -> None:
        if not factors:
            raise InputError("a product needs at least one factor")
        self.factors, self.direction, self.tolerance = factors, direction, tolerance
        self.point = point if callable(point) else as_vector(point, "point")

    def reference(self, *inputs: Any) -> Floats:
        """What is right for these inputs, shape (3,)."""
        return evaluate_points([self._model(inputs)])[0]

    def judge(self, cases: Sequence[Case]) -> Verdict:
        """Judge an answer by what came for several inputs."""
        if not cases:
            return NOTHING
        models = [self._model(inputs) for inputs, _ in cases]
        slips = point_slips(models[0])
        seen = direction_seen if self.direction else point_seen
        return judge_arrays(cases, models, slips, evaluate_points, self._read, seen, self.tolerance)

    def _model(self, inputs: Sequence[Any]) -> "Carried":
        point = self.point(*inputs) if callable(self.point) else self.point
        product = Product(tuple(f.at(inputs) for f in self.factors))
        use = rotated if self.direction else moved
        return Carried(product, as_vector(point, "point"), use)

    def _read(self, value: Any) -> Floats:
        p = numbers(value, [(3,)], also=ALSO).ravel()
        last = 0 if self.direction else 1
        if len(p) == 4 and abs(p[3] - last) > self.tolerance:
            what = "direction" if self.direction else "point"
            raise Unreadable(f"The fourth number of a {what} is {last}: here it is not.")
        return p[:3]


@dataclass(frozen=True, eq=False)
class Carried:
    """A point, the product that carries it, and how it is used."""

    product: Product
    point: Floats
    use: Use
    scale: float = 1.0
    signs: Floats = field(default_factory=lambda: np.ones(3))


def evaluate_points(models: Sequence[Carried]) -> list[Floats]:
    """Points of several models, each (3,)."""
    poses = evaluate_products([m.product for m in models])
    return [m.scale * m.signs * m.use(T, m.point) for m, T in zip(models, poses, strict=True)]


def point_slips(model: Carried) -> list[Slip[Carried]]:
    """All slips for a point that is carried by such a product."""
    return [*_in_product(model.product), *_with_point(model.use is rotated)]


def moved(T: Floats, p: Floats) -> Floats:
    """Point rotated and shifted."""
    out: Floats = T[:3, :3] @ p + T[:3, 3]
    return out


def rotated(T: Floats, p: Floats) -> Floats:
    """Point rotated alone."""
    out: Floats = T[:3, :3] @ p
    return out


def shifted(T: Floats, p: Floats) -> Floats:
    """Point shifted alone."""
    return p + T[:3, 3]


def _in_product(product: Product) -> Iterator[Slip[Carried]]:
    for slip in product_slips(product.moves, None, rotation=False):
        if slip.mistake.key not in ("millimetres", "thousandth"):
            yield Slip(
                slip.mistake,
                lambda m, change=slip.change: replace(  # type: ignore[misc]
                    m, product=change(m.product)
                ),
                alone=slip.alone or slip.about == "hand",
                about=slip.about,
            )


def _with_point(direction: bool) -> Iterator[Slip[Carried]]:
    rule = "What does a pose do to a point first, and what then?"
    ways: list[tuple[str, str, str, Use]] = [
        ("unchanged", "the numbers are left as they are", rule, lambda T, p: p),
        (
            "row-vector",
            "the point is multiplied from the left, as a row: that rotates it the other way",
            "On which side of the matrix does a column of numbers stand?",
            lambda T, p: p @ T[:3, :3] + (0 if direction else T[:3, 3]),
        ),
    ]
    if direction:
        why = "Does a direction have a place, that a shift could change?"
        ways += [("translation", "the direction is shifted like a point", why, moved)]
    else:
        ways += [
            ("no-translation", "the point is rotated but not shifted", rule, rotated),
            (
                "no-rotation",
                "the point is shifted but not rotated",
                rule,
                lambda T, p: p + T[:3, 3],
            ),
            (
                "translation-subtracted",
                "the translation is subtracted instead of added",
                "From which origin to which does the vector point?",
                lambda T, p: T[:3, :3] @ p - T[:3, 3],
            ),
        ]
    for key, when, question, use in ways:
        yield Slip(
            mistake(key, when, question),
            lambda m, use=use: replace(m, use=use),  # type: ignore[misc]
        )
    for k, axis in enumerate("xyz"):
        yield Slip(
            mistake(f"sign-of-{axis}", f"the {axis} coordinate has the wrong sign", rule),
            lambda m, k=k: replace(  # type: ignore[misc]
                m, signs=np.where(np.arange(3) == k, -m.signs, m.signs)
            ),
        )
    unit = "In which unit are the lengths asked for?"
    for key, when, factor in (
        ("millimetres", "lengths are in millimetres", 1e3),
        ("thousandth", "lengths are divided by 1000", 1e-3),
    ):
        yield Slip(
            mistake(key, when, unit),
            lambda m, factor=factor: replace(m, scale=factor),  # type: ignore[misc]
        )
