"""What a function is given: the same in the notebook's check and where it is marked."""

import numpy as np
import pytest

from dhlab.diagnosis import MatrixTask, turn
from dhlab.errors import InputError
from dhlab.grading.asked import Ask
from dhlab.grading.question import Question
from dhlab.grading.runner import run_cells
from dhlab.grading.tried import values_of

TASK = MatrixTask(turn("z", 0.3), size=3)
CELL = """
def told(*arguments):
    return [kind(a) for a in arguments]

def kind(a):
    if isinstance(a, dict):
        return {name: kind(item) for name, item in a.items()}
    inner = [kind(item) for item in a] if isinstance(a, (list, tuple)) else repr(a)
    return [type(a).__name__, inner]
"""
CASES = [
    (0.1 + 0.2, 3, True, None, "zyx"),
    ([0, 0, 1], ((1, 2), (3, 4)), np.float64(0.5), np.int64(4)),
    (["r", "p"], [[1, 2], [3]], {"q": (0.5, np.inf)}, np.eye(2, dtype=int)),
]


def test_a_function_gets_the_same_arguments_in_the_check_and_in_marking(sandbox):
    question = Question("told", TASK, examples=CASES[:1], inputs=lambda rng: CASES[1:])
    cases = question.cases(np.random.default_rng(0))
    names = {}
    exec(CELL, names)
    checked = [value for _, value in values_of(question, names["told"], cases)]
    marked = run_cells([CELL], [Ask("told", cases=cases)], {}, sandbox=sandbox).replies["told"]
    assert checked == list(marked)
    assert checked[1][0] == ["ndarray", "array([0., 0., 1.])"]


def test_arguments_that_cannot_be_given_when_marking_are_refused():
    with pytest.raises(InputError, match="'f': examples must be made of numbers and text, got a s"):
        Question("f", TASK, examples=[({1, 2},)])
    question = Question("f", TASK, examples=[(1,)], inputs=lambda rng: [(object(),)])
    with pytest.raises(InputError, match="'f': inputs must be made of numbers and text, got a obj"):
        question.cases(np.random.default_rng(0))
