"""Whatever can leave a sandbox is judged: it is wrong, nothing raises, and nothing takes long."""

import time
import warnings
from pathlib import Path

import numpy as np
import pytest

from dhlab.grading.exercise import load_exercise
from dhlab.grading.judge import judge
from dhlab.grading.values import from_json, to_json

EXERCISES = sorted(Path(__file__).parents[2].glob("exercises/*/checks.py"))
SHAPES = [(), (0,), (3,), (3, 3), (4, 4), (1, 4), (0, 4), (4, 4, 4), (2_000, 4), (0, 99_999)]
NUMBERS = [0.0, 1e308, 5e-324, 1e11, np.nan, -np.inf]
LONG = 20
"""Seconds of the processor that no answer may cost the marker; most cost some milliseconds."""


def table(n, seed=1):
    """A table of n rows."""
    return np.random.default_rng(seed).uniform(-2, 2, (n, 4))


def robot(n, **other):
    """What is read of a robot of n joints."""
    many = {"rows": table(n), "joints": "r" * min(n, 900), "convention": "modified"}
    ends = {"base": np.eye(4), "grasper": np.eye(4), "q": np.zeros(n), "frames": {}}
    lists = {"offset": np.zeros(n), "home": np.zeros(n), "limits": np.zeros((n, 2))}
    return {"name": "x", **many, **ends, **lists, **other}


def complex_robot(parts, n, **hung):
    """What is read of a robot of several."""
    part = robot(n) | {"on": -1, "at": 0, "stand": np.eye(4)} | hung
    return robot(n, components=[part] * parts)


ODD = {f"{s} of {x}": np.full(s, x) for s in SHAPES for x in NUMBERS}
ODD |= {f"table of {n}": table(n) for n in (2, 3, 4, 5, 6, 7, 12, 300)}
ODD |= {f"robot of {n}": robot(n) for n in (0, 1, 2, 3, 4, 5, 6, 7, 12, 900)}
ODD |= {f"{k} robots of {n}": complex_robot(k, n) for k in (0, 1, 5, 200) for n in (0, 1, 4)}
ODD |= {
    f"on {on} at {at}": complex_robot(5, 4, on=on, at=at)
    for on, at in ((0, 0), (4, 4), (-2, 0), (99, 0), (3, -1), (0.5, 0), ("x", 0), (2, 10**9))
}
ODD |= {
    "nothing": None,
    "a truth": True,
    "text": "x" * 1000,
    "texts": ["a"] * 1000,
    "no list": [],
    "no mapping": {},
    "many names": {str(k): np.eye(4) for k in range(5000)},
    "frames of nan": {name: np.full((4, 4), np.nan) for name in "RTPH"},
    "frames of text": dict.fromkeys("RTPH", "x"),
    "rows of nothing": robot(3, rows=None),
    "odd letters": robot(3, joints=[1, 2, 3]),
    "parts of text": robot(4, components="abc"),
    "parts of nothing": robot(4, components=[None, [], {"rows": 1}]),
    "three arrays": [np.ones((5, 4))] * 3,
}
PLAIN = {name: from_json(to_json(value)) for name, value in ODD.items()}


@pytest.mark.parametrize("path", EXERCISES, ids=lambda path: path.parent.name)
def test_no_odd_answer_is_right_or_stops_the_marker(path):
    exercise = load_exercise(path.parent)
    rng = np.random.default_rng(1)
    for question in exercise.questions(exercise.numbers("Ada")):
        cases = exercise.cases(question, rng)
        for name, value in PLAIN.items():
            began = time.process_time()
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                judged = judge(question, [(arguments, value) for arguments in cases])
            where = f"{question.name}: {name}"
            assert (judged.right, judged.points) == (False, 0), where
            assert judged.reason != "not judged", f"{where}: {judged.text}"
            assert time.process_time() - began < LONG, where
