"""Tasks whose answer is a matrix: a product of turns and slides, one link."""

from collections.abc import Sequence
from typing import Any, Literal, TypeVar, cast

from dhlab.diagnosis.after import origin_signs
from dhlab.diagnosis.product import Factor, Product, evaluate_products
from dhlab.diagnosis.product_slips import product_slips
from dhlab.diagnosis.seen import pose_seen
from dhlab.diagnosis.slips import NOTHING, Evaluate, Slip, judge_arrays
from dhlab.diagnosis.values import TOLERANCE, Floats, as_pose44, numbers
from dhlab.diagnosis.verdict import Case, Verdict
from dhlab.errors import InputError

M = TypeVar("M")


class MatrixTask:
    """A rotation or a pose that is a product of elementary factors.

    Parameters
    ----------
    *factors : Factor
        Made by `turn` and `slide`, in the order in which the task tells them.
    about : {'moving', 'fixed'}, optional
        About which axes the moves are told: 'moving' multiplies from left to right, 'fixed' from
        right to left. Without it the factors are the product as it is written.
    size : {3, 4}
        Rows of the matrix asked for: 4 also takes what 3 has.
    tolerance : float

    Examples
    --------
    >>> from dhlab.diagnosis import MatrixTask, turn
    >>> from dhlab.kinematics.transforms import rotx, rotz
    >>> task = MatrixTask(turn("z", 0.3), turn("x", 0.5), about="moving", size=3)
    >>> task.judge([((), rotz(0.3) @ rotx(0.5))]).right
    True
    >>> [m.key for m in task.judge([((), rotx(0.5) @ rotz(0.3))]).mistakes]
    ['fixed-moving']
    """

    def __init__(
        self,
        *factors: Factor,
        about: Literal["moving", "fixed"] | None = None,
        size: Literal[3, 4] = 4,
        tolerance: float = TOLERANCE,
    ) -> None:
        if not factors:
            raise InputError("a product needs at least one factor")
        if about not in (None, "moving", "fixed"):
            raise InputError(f"no axes {about!r}; use 'moving' or 'fixed'")
        if size not in (3, 4):
            raise InputError(f"size must be 3 or 4, got {size!r}")
        self.factors = factors[::-1] if about == "fixed" else factors
        self.about, self.size, self.tolerance = about, size, tolerance

    def reference(self, *inputs: Any) -> Floats:
        """What is right for these inputs, shape (size, size)."""
        return evaluate_products([self._model(inputs)])[0][: self.size, : self.size]

    def judge(self, cases: Sequence[Case]) -> Verdict:
        """Judge an answer by what came for several inputs."""
        if not cases:
            return NOTHING
        models = [self._model(inputs) for inputs, _ in cases]
        slips = product_slips(models[0].moves, self.about, self.size == 3)
        if self.size == 4:
            slips += [
                Slip(m, lambda p, change=change: p.then(change), alone=True)  # type: ignore[misc]
                for m, change in origin_signs()
            ]
        return judge_matrices(cases, models, slips, self.size, self.tolerance)

    def _model(self, inputs: Sequence[Any]) -> Product:
        return Product(tuple(f.at(inputs) for f in self.factors))


def judge_matrices(
    cases: Sequence[Case],
    models: Sequence[M],
    slips: Sequence[Slip[M]],
    size: int,
    tolerance: float,
    evaluate: Evaluate[M] | None = None,
) -> Verdict:
    """Judge matrices by models whose values are poses; without `evaluate` they are products."""

    def read(value: Any) -> Floats:
        return as_pose44(numbers(value, [(size, size)]))

    if evaluate is None:
        evaluate = cast(Evaluate[M], evaluate_products)
    return judge_arrays(cases, models, slips, evaluate, read, pose_seen, tolerance)
