"""Whatever comes for an answer, there is a verdict: no error, and none of the expected numbers."""

import datetime
import re
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from dhlab import diagnosis as d
from dhlab.kinematics.angles import rpy2r
from dhlab.kinematics.chain import Chain
from dhlab.kinematics.dh import link_transform
from dhlab.kinematics.mechanism import Branch, Mechanism
from dhlab.kinematics.transforms import rp2t

ANGLES = (0.6137, -0.4519, 0.8273)
POSE = rp2t(rpy2r(*ANGLES), (0.3719, -0.5471, 0.7853))
CHAIN = Chain(
    [(0.6137, 0.3719, 0.5471, 0), (-0.4519, 0.4177, 0.2291, 0)], "rp", grasper=(0.1373, 0, 0)
)
TREE = Mechanism([Branch("a", CHAIN), Branch("a/b", CHAIN, 0, 1), Branch("a/c", CHAIN, 0, 2)])
TIMES = np.linspace(0.5, 2, 4)
TASKS = {
    "rotation": (d.MatrixTask(d.turn("z", lambda x: x), d.turn("x", 0.6137), size=3), (0.3719,)),
    "pose": (d.MatrixTask(d.given("T", POSE), d.turn("x", 0.6137)), ()),
    "point": (d.PointTask(d.given("T", POSE), point=(0.1373, 0.2291, 0.4177)), ()),
    "direction": (d.PointTask(d.given("T", POSE), point=(0.13, 0.22, 0.41), direction=True), ()),
    "rpy": (d.AnglesTask(POSE), ()),
    "euler": (d.AnglesTask(POSE, "euler"), ()),
    "link": (d.LinkTask(), (0.6137, 0.3719, 0.5471, 0.8273)),
    "forward": (d.ForwardTask(CHAIN), ((0.3173, 0.7919),)),
    "table": (d.TableTask(CHAIN), ()),
    "free table": (d.TableTask(CHAIN, base_free=True, tool_free=True), ()),
    "robot": (d.RobotTask(CHAIN, limits=True, q=[0.3173, 0.7919]), ()),
    "tree": (d.RobotTask(TREE, zero_free=False), ()),
    "arrangement": (d.ArrangementTask({"A": POSE, "B": POSE}, {"B": "A"}), ()),
    **{
        f"trajectory {answer}": (
            d.TrajectoryTask((0.3719, 0.1373), 0.8273, 0.5, 2, answer=answer, at=TIMES),
            (),
        )
        for answer in ("q", "motion", "coefficients")
    },
}
tasks = pytest.mark.parametrize("name", TASKS)


class Awkward:
    """An object that answers every question with an error."""

    def __array__(self, *_, **__):
        raise RuntimeError("no")

    def __len__(self):
        raise RuntimeError("no")

    def __iter__(self):
        raise RuntimeError("no")

    def __eq__(self, other):
        raise RuntimeError("no")

    __hash__ = None


deep = []
for _ in range(3000):
    deep = [deep]
BAD = (7, "x", [], [None, None], [np.nan] * 2, Awkward(), [[1, 2], [3]], [1e300] * 2, {"a": 1})
ODD = [
    *(None, True, "", "eye(4)", b"1", 1j, float("nan"), float("inf"), -1e308, 10**400, -0.0),
    *([], [[]], {}, set(), (), [None], ["1", "2", "3"], [[1, 2], [3]], deep),
    *(Awkward(), [Awkward()], lambda x: x, int, np, iter([1, 2]), range(3)),
    *(np.eye(3), np.eye(4), np.eye(4).tolist(), np.zeros((4, 4)), np.ones(3), np.zeros((0, 4))),
    *(np.full((4, 4), np.nan), np.full((3, 3), 1e300), np.full((2, 4), 1e11), np.eye(3) * 1j),
    *(np.zeros((2, 4)), np.ones((2, 4), bool), np.zeros(4, "M8[s]"), np.array(["a"] * 3)),
    *(np.array([1, "a", None], object), np.ma.masked_all((3, 3)), np.zeros((1000, 1000))),
    *(Decimal(1), Fraction(1, 3), [Fraction(1, 3)] * 3, datetime.date(2020, 1, 1)),
    *([np.eye(4), np.eye(3)], ([1, 2], [3, 4], [5, 6])),
    *({"rows": rows} for rows in (None, [], np.zeros((2, 4)), np.zeros((3, 4)))),
    *({"rows": np.zeros((2, 4)), key: value} for key in ("joints", "convention") for value in BAD),
    *({"rows": np.zeros((2, 4)), key: value} for key in ("base", "grasper") for value in BAD),
    *({"components": value} for value in (None, [], [1, 2, 3], [{}] * 3, {"a": 1}, "abc")),
    *({"A": value, "B": value} for value in (None, "x", np.eye(3), np.zeros((4, 4)), Awkward())),
]
PARTS = [{"name": name, "rows": CHAIN.rows, "q": [0, 0]} for name in "abc"]
ODD_ROBOTS = [
    *({"rows": CHAIN.rows, "limits": CHAIN.limits, "q": value} for value in BAD),
    *({"rows": CHAIN.rows, "limits": value} for value in BAD),
    *({"components": PARTS, "frames": value} for value in (*BAD, {1: 2}, {"b/grasper": 3})),
    *({"components": [{**p, "q": value} for p in PARTS], "frames": {}} for value in BAD),
]
numbers = st.one_of(
    st.none(), st.booleans(), st.integers(), st.floats(), st.text(max_size=3), st.complex_numbers()
)
anything = st.recursive(
    numbers,
    lambda inner: st.one_of(
        st.lists(inner, max_size=4),
        st.dictionaries(
            st.sampled_from(["rows", "joints", "base", "components", "frames", "A", "B", "q"]),
            inner,
        ),
    ),
    max_leaves=12,
)


def judge_all(name, values):
    """Sentences for answers, none of which can be right."""
    task, inputs = TASKS[name]
    for value in values:
        verdict = task.judge([(inputs, value)])
        assert not verdict.right
        assert re.fullmatch(r"[A-Za-z].*[.?]", verdict.text, re.DOTALL), verdict.text


@tasks
def test_an_odd_answer_gets_a_sentence(name):
    judge_all(name, ODD)


@pytest.mark.parametrize("name", ["robot", "tree"])
def test_an_odd_robot_gets_a_sentence(name):
    judge_all(name, ODD_ROBOTS)


@tasks
@settings(max_examples=25)
@given(value=anything)
@example(value=[[0.0, 0.0, 0.0, 0.0]] * 2)
def test_any_answer_gets_a_verdict(name, value):
    task, inputs = TASKS[name]
    verdict = task.judge([(inputs, value), (inputs, value)])
    assert isinstance(verdict.right, bool)
    assert isinstance(verdict.text, str)


@tasks
def test_no_case_is_nothing_to_judge(name):
    verdict = TASKS[name][0].judge([])
    assert not verdict.right
    assert verdict.text == "There is no answer to judge."


WANTED = {
    "rotation": TASKS["rotation"][0].reference(0.3719),
    "pose": TASKS["pose"][0].reference(),
    "point": TASKS["point"][0].reference(),
    "direction": TASKS["direction"][0].reference(),
    "rpy": np.array(ANGLES),
    "link": link_transform(TASKS["link"][1]),
    "forward": CHAIN.tip(TASKS["forward"][1][0]),
    "table": np.array(CHAIN.rows),
    "free table": np.array(CHAIN.rows),
    "trajectory q": TASKS["trajectory q"][0].reference(),
    "trajectory coefficients": TASKS["trajectory coefficients"][0].reference(),
    "arrangement": TASKS["arrangement"][0].reference()["B"],
}


def spoilt(value):
    """Answers that are wrong in one number or in all."""
    yield from (np.zeros_like(value), -value, 2 * value, 1000 * value, value[::-1])
    yield np.random.default_rng(1).uniform(-1, 1, value.shape)
    for index in np.ndindex(value.shape):
        for change in (lambda x: 0, lambda x: -x, lambda x: x + 0.1234):
            out = value.copy()
            out[index] = change(out[index])
            yield out
    if value.shape == (4, 4):
        for kept in (slice(0, 3), slice(3, 4)):
            out = np.eye(4)
            out[:3, kept] = value[:3, kept]
            yield out


@pytest.mark.parametrize("name", WANTED)
def test_no_message_tells_a_number_that_is_asked_for(name):
    task, inputs = TASKS[name]
    value, told_in_mm = WANTED[name], name not in ("rotation", "rpy")
    lengths = value[:3, 3] if value.shape == (4, 4) else value
    secret = np.abs([*value.ravel(), *(1000 * lengths.ravel() if told_in_mm else ())])
    if name in ("rpy", "table", "free table"):
        secret = np.append(secret, np.degrees(np.abs(value)))
    secret = secret[np.abs(secret % 1) > 1e-3]
    for answer in spoilt(WANTED[name]):
        came = {"A": POSE, "B": answer} if name == "arrangement" else answer
        text = task.judge([(inputs, came)]).text
        for told in map(float, re.findall(r"\d+\.?\d*(?:e[+-]?\d+)?", text)):
            assert np.abs(secret - told).min() > 0.004 * told, text
