"""The task of planning a motion by a polynomial."""

from collections.abc import Callable, Sequence
from typing import Any, Literal, TypeAlias, get_args

import numpy as np
from numpy.typing import ArrayLike

from dhlab.arrays import as_array, as_number, as_vector
from dhlab.diagnosis.motion import Answer, Motion, evaluate_motions, motion_slips
from dhlab.diagnosis.slips import NOTHING, judge_arrays
from dhlab.diagnosis.values import TOLERANCE, Floats, Unreadable, numbers
from dhlab.diagnosis.verdict import Case, Verdict, mistake
from dhlab.errors import InputError

Value: TypeAlias = ArrayLike | Callable[..., ArrayLike]
TRANSPOSED = mistake(
    "transposed",
    "rows and columns of the array are exchanged",
    "Which of instants and joints belong in rows?",
)


class TrajectoryTask:
    """A cubic or quintic from one configuration to another, as a function or in numbers.

    Each argument but `degree`, `answer` and `counted` is a number or array, or what gives it from
    the inputs of a case: ``lambda t, q0, qt: q0``.

    Parameters
    ----------
    q0, qt : float, array_like, shape (n,), or callable [rad or m]
        Configurations at the start and at the end.
    start, end : float or callable [s]
    v0, vt : float, array_like, shape (n,), or callable [rad/s or m/s]
        Velocities there.
    degree : {3, 5}
        Of the polynomial; accelerations of a quintic are 0 at both ends.
    answer : {'q', 'v', 'a', 'motion', 'coefficients'}
        What is asked for: configuration, velocity or acceleration at the instants, all three one
        behind the other, or the coefficients, the highest power first.
    at : float, array_like, shape (m,), or callable [s], optional
        Instants between start and end; without it they are the first input of a case.
    counted : {'from 0', 'from start'}
        Which time the coefficients are for; other answers do not depend on it.
    tolerance : float
        Of a coefficient: of what it gives at the end, where the motion is longer than 1 s.

    Examples
    --------
    >>> from dhlab.kinematics.poly3 import trj_poly3
    >>> t = np.linspace(1, 3, 5)
    >>> task = TrajectoryTask(0.2, 0.8, 1, 3, at=t)
    >>> task.judge([((), trj_poly3(t, [0.2], [0.8]).q.ravel())]).right
    True
    >>> line = 0.2 + 0.6 * (t - 1) / 2
    >>> [m.key for m in task.judge([((), line)]).mistakes]
    ['line']
    """

    def __init__(
        self,
        q0: Value,
        qt: Value,
        start: Value,
        end: Value,
        *,
        v0: Value = 0.0,
        vt: Value = 0.0,
        degree: Literal[3, 5] = 3,
        answer: Answer = "q",
        at: Value | None = None,
        counted: Literal["from 0", "from start"] = "from 0",
        tolerance: float = TOLERANCE,
    ) -> None:
        if degree not in (3, 5):
            raise InputError(f"degree must be 3 or 5, got {degree!r}")
        if answer not in get_args(Answer):
            choices = ", ".join(map(repr, get_args(Answer)))
            raise InputError(f"no answer {answer!r}; use one of {choices}")
        if counted not in ("from 0", "from start"):
            raise InputError(f"no time {counted!r}; use 'from 0' or 'from start'")
        self.degree, self.answer, self.counted = degree, answer, counted
        self.values = {"q0": q0, "qt": qt, "start": start, "end": end, "v0": v0, "vt": vt}
        self.at = at if at is not None else (lambda *inputs: inputs[0])
        self.tolerance = tolerance

    def reference(self, *inputs: Any) -> Floats:
        """What is right, shape (m, n), (3, m, n) for 'motion', (powers, n) for coefficients."""
        return evaluate_motions([self._model(inputs)])[0]

    def judge(self, cases: Sequence[Case]) -> Verdict:
        """Judge an answer by what came for several inputs."""
        if not cases:
            return NOTHING
        models = [self._model(inputs) for inputs, _ in cases]
        wanted = evaluate_motions(models)
        turned = [_turned(value, w) for (_, value), w in zip(cases, wanted, strict=True)]
        if all(value is not None for value in turned):
            cases = [(inputs, value) for (inputs, _), value in zip(cases, turned, strict=True)]
            verdict = self._judge(cases, models, wanted)
            seen = "The array has its instants or powers along columns."
            return Verdict(False, seen, (TRANSPOSED,)) if verdict.right else verdict
        return self._judge(cases, models, wanted)

    def _judge(
        self, cases: Sequence[Case], models: Sequence[Motion], wanted: Sequence[Floats]
    ) -> Verdict:
        asked = iter([(w.shape, m.weights) for w, m in zip(wanted, models, strict=True)])

        def read(value: Any) -> Floats:
            shape, weights = next(asked)
            return weights * _read(value, shape)

        def evaluate(motions: Sequence[Motion]) -> list[Floats]:
            made = zip(motions, evaluate_motions(motions), strict=True)
            return [m.weights * value for m, value in made]

        def seen(came: Floats, wanted: Floats) -> str:
            return _seen(came, wanted, self.answer, self.tolerance)

        slips = motion_slips(models[0])
        return judge_arrays(cases, models, slips, evaluate, read, seen, self.tolerance)

    def _model(self, inputs: Sequence[Any]) -> Motion:
        given = {k: v(*inputs) if callable(v) else v for k, v in self.values.items()}
        q0 = np.atleast_1d(as_array(given["q0"], (...,), "q0"))
        qt, v0, vt = (
            as_vector(np.broadcast_to(given[name], q0.shape), name, len(q0))
            for name in ("qt", "v0", "vt")
        )
        start, end = as_number(given["start"], "start"), as_number(given["end"], "end")
        if end <= start:
            raise InputError(f"end must come after start {start:g} s, got {end:g}")
        clock = start
        at, weights = np.zeros(1), np.ones((1, 1))
        if self.answer == "coefficients":
            clock = 0.0 if self.counted == "from 0" else start
            longest = max(1.0, abs(start - clock), abs(end - clock))
            weights = longest ** np.arange(self.degree, -1.0, -1)[:, None]
        else:
            instants = self.at(*inputs) if callable(self.at) else self.at
            at = np.atleast_1d(as_array(instants, (...,), "instants"))
        return Motion(
            q0=q0,
            qt=qt,
            v0=v0,
            vt=vt,
            start=start,
            duration=end - start,
            at=at,
            degree=self.degree,
            answer=self.answer,
            clock=clock,
            weights=weights,
        )


def _turned(value: Any, wanted: Floats) -> Any:
    """Transpose of an array that has rows and columns exchanged; None of any other."""
    *_, m, n = wanted.shape
    if m == n or 1 in (m, n):
        return None
    parts = value[:3] if wanted.ndim == 3 and isinstance(value, list | tuple) else value
    try:
        a = numbers(parts, [(*wanted.shape[:-2], n, m)])
    except Unreadable:
        return None
    return np.swapaxes(a, -1, -2)


def _read(value: Any, shape: tuple[int, ...]) -> Floats:
    """Array of this shape, (m, n) or (3, m, n); one joint or instant needs no axis of its own."""
    if len(shape) == 3:
        if not isinstance(value, list | tuple | np.ndarray) or len(value) < 3:
            raise Unreadable("Position, velocity and acceleration are asked for, in this order.")
        names = ("the position", "the velocity", "the acceleration")
        parts = zip(value[:3], names, strict=True)
        return np.array([_rows(part, shape[1:], name) for part, name in parts])
    return _rows(value, shape, "the answer")


def _rows(value: Any, shape: tuple[int, ...], what: str) -> Floats:
    m, n = shape
    if 1 not in (m, n):
        return numbers(value, [(m, n)], what)
    also = [(m, n), (n, m), *([()] if m == n == 1 else [])]
    return numbers(value, [(m * n,)], what, also).reshape(m, n)


def _seen(came: Floats, wanted: Floats, answer: Answer, tolerance: float) -> str:
    """Say what is the first to be wrong: which of the three, which coefficient, which instant."""
    wrong = np.abs(came - wanted) > tolerance * (1 + np.abs(wanted))
    where, *index = np.argwhere(wrong if wrong.ndim == 3 else wrong[None])[0].tolist()
    m, n = came.shape[-2:]
    name = {"q": "position", "v": "velocity", "a": "acceleration"}.get(answer, "")
    if answer == "motion":
        name = ("position", "velocity", "acceleration")[where]
    joint = f" of joint {index[1] + 1}" if n > 1 else ""
    if answer == "coefficients":
        return f"The coefficient of t^{m - 1 - index[0]}{joint} is not right."
    if m == 1:
        return f"The {name}{joint} is not right."
    when = "from the first instant on" if index[0] == 0 else f"from instant {index[0] + 1} on"
    return f"The {name}{joint} is off {when}, of {m} instants."
