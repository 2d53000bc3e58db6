"""One question of an exercise: what is asked, of which answer, and how many points it is worth."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias, get_args

import numpy as np

from dhlab.arrays import as_number
from dhlab.diagnosis.verdict import Task
from dhlab.errors import InputError
from dhlab.grading.asked import Kind
from dhlab.grading.inside.plain import NotPlain, from_json, to_json

Arguments: TypeAlias = tuple[Any, ...]
KINDS: tuple[str, ...] = get_args(Kind)


@dataclass(frozen=True, eq=False)
class Question:
    """A question: the name of the student's function or variable, and the task behind it.

    Parameters
    ----------
    name : str
        Of the function or variable that the student writes.
    task : Task
        Of `dhlab.diagnosis`: what was asked, and so what is right and what the mistakes give.
    points : float
        All of them or none are given.
    examples : sequence of tuples
        Arguments of the cases that the student sees; the default stands for a plain value.
        They are numbers, text, arrays, lists and mappings; a list of numbers comes as an array.
    inputs : callable, optional
        From a random generator to further arguments, drawn anew when it is marked. They must hold
        the special cases too: zeros, right angles, negative lengths.
    kind : {'values', 'robot', 'csys', 'scene'}
        What the answer is: numbers, or something of dhlab's that is judged by its numbers.
    hint : str
        What is said as long as nothing is there.
    library : bool
        Whether an answer of plain values may use all of dhlab, and not only what the notebook
        imports and what computes. Others always have it. Where a robot, a csys or a scene is asked
        for too, the cells then run once instead of twice when they are marked; leave it off where
        a function of dhlab is the answer.

    Examples
    --------
    >>> from dhlab.diagnosis import MatrixTask, turn
    >>> task = MatrixTask(turn("z", lambda angle: angle), size=3)
    >>> question = Question("rot_z", task, examples=[(0.3,), (1.2,)])
    >>> question.is_function, question.cases()
    (True, ((0.3,), (1.2,)))
    >>> Question("rot z", task)
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: 'rot z' cannot be the name of a function or variable
    """

    name: str
    task: Task
    points: float = 1
    examples: Sequence[Arguments] = ((),)
    inputs: Callable[[np.random.Generator], Sequence[Arguments]] | None = None
    kind: Kind = "values"
    hint: str = ""
    library: bool = False

    def __post_init__(self) -> None:
        if not (isinstance(self.name, str) and self.name.isidentifier()):
            raise InputError(f"{self.name!r} cannot be the name of a function or variable")
        where = f"question {self.name!r}"
        as_number(self.points, f"{where}: points", minimum=0)
        if self.kind not in KINDS:
            raise InputError(f"{where}: no kind {self.kind!r}; use {', '.join(KINDS)}")
        if not callable(getattr(self.task, "judge", None)):
            raise InputError(f"{where}: the task must be one of dhlab.diagnosis, got {self.task!r}")
        object.__setattr__(self, "examples", _checked(self.examples, f"{where}: examples"))
        if not self.examples:
            raise InputError(f"{where}: there must be an example")
        if self.inputs is not None and not self.is_function:
            raise InputError(f"{where}: only a function has further inputs; give it an example")

    @property
    def is_function(self) -> bool:
        """Whether a function is asked for, and not a plain value."""
        return any(self.examples)

    def cases(self, rng: np.random.Generator | None = None) -> tuple[Arguments, ...]:
        """Arguments that an answer is tried with: the examples, then those drawn.

        Parameters
        ----------
        rng : Generator, optional
            Draws further cases; without it there are only the examples.
        """
        if rng is None or self.inputs is None:
            return tuple(self.examples)
        drawn = _checked(self.inputs(rng), f"question {self.name!r}: inputs")
        return (*self.examples, *drawn)


def _checked(cases: Sequence[Arguments], what: str) -> tuple[Arguments, ...]:
    """Arguments as a function gets them, wherever it is tried: lists of numbers are arrays.

    What is no tuple is refused (a lone number in brackets is none), and what is not plain.
    """
    wrong = next((case for case in cases if not isinstance(case, tuple)), None)
    if wrong is not None:
        raise InputError(
            f"{what} must be tuples of arguments such as (0.3,) or (0.3, 0.5), got {wrong!r}"
        )
    try:
        return tuple(tuple(from_json(to_json(a)) for a in case) for case in cases)
    except NotPlain as refusal:
        raise InputError(f"{what} must be made of numbers and text, got {refusal.text}") from None
