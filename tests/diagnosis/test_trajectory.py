"""Motions by a polynomial: samples, functions, coefficients."""

import numpy as np
import pytest

from dhlab.diagnosis import TrajectoryTask
from dhlab.diagnosis.motion import evaluate_motions, motion_slips
from dhlab.errors import InputError
from dhlab.kinematics.poly3 import trj_poly3
from dhlab.kinematics.trajectory import Trajectory

ANSWERS = ["q", "v", "a", "motion", "coefficients"]
answers = pytest.mark.parametrize("answer", ANSWERS)
degrees = pytest.mark.parametrize("degree", [3, 5])


def random_task(rng, answer, degree, n=2):
    start = float(rng.choice([0, 0.5, 2]))
    end = start + rng.uniform(1.2, 3)
    return TrajectoryTask(
        *rng.uniform(-1, 1, (2, n)),
        start,
        end,
        v0=rng.uniform(-1, 1, n) * rng.integers(2),
        vt=rng.uniform(-1, 1, n) * rng.integers(2),
        degree=degree,
        answer=answer,
        at=np.linspace(start, end, 7),
    )


@answers
def test_the_planner_of_the_paper_is_right(answer, tally):
    rng = np.random.default_rng(3)
    for _ in range(20):
        start = float(rng.choice([0, 1.5]))
        t, q0, qt = start + np.linspace(0, 2, 9), *rng.uniform(-1, 1, (2, 3))
        q, v, a, _, c = trj_poly3(t, q0, qt)
        came = {"q": q, "v": v, "a": a, "motion": (q, v, a, t, c), "coefficients": c}[answer]
        task = TrajectoryTask(q0, qt, start, start + 2, answer=answer, at=t)
        tally.judge(task, [((), came)])
        verdict = task.judge([((), [x.T for x in came] if answer == "motion" else came.T)])
        assert [m.key for m in verdict.mistakes] == ["transposed"]
    tally.check(share=0)


def test_a_function_of_time_and_ends_is_right(tally):
    task = TrajectoryTask(
        lambda t, q0, qt: q0, lambda t, q0, qt: qt, 1, 3, vt=0.5, degree=5, answer="v"
    )
    rng = np.random.default_rng(4)
    for n in (1, 2):
        for t in (1.2, np.array([1.1, 2.9])):
            q0, qt = rng.uniform(-1, 1, (2, n))
            v = Trajectory.quintic([1, 3], q0, qt, vt=0.5).sample(t).v
            tally.judge(task, [((t, q0, qt), v)])
            if n == 1:
                tally.judge(task, [((t, float(q0[0]), float(qt[0])), v[..., 0])])
    tally.check(share=0)


@answers
@degrees
@pytest.mark.parametrize("made", [1, 2])
def test_mistakes_in_motions_are_named(answer, degree, made, tally):
    rng = np.random.default_rng(made)
    for _ in range(100 // made):
        task = random_task(rng, answer, degree)
        model = task._model(())
        slips = motion_slips(model)
        chosen = [slips[k] for k in sorted(rng.choice(len(slips), made, replace=False))]
        for slip in chosen:
            model = slip.change(model)
        tally.judge(task, [((), evaluate_motions([model])[0])], {s.mistake.key for s in chosen})
    tally.check()


def test_what_is_first_wrong_is_said():
    t = np.linspace(0, 1, 4)
    task = TrajectoryTask([0, 0], [1, 2], 0, 1, at=t, answer="motion")
    q, v, a = task.reference()
    v = v + np.array([[0, 0], [0, 0.123], [0, 0.4], [0, 0.1]])
    assert task.judge([((), (q, v, a))]).text == (
        "The velocity of joint 2 is off from instant 2 on, of 4 instants."
    )
    line = TrajectoryTask(0, 1, 0, 1, answer="coefficients")
    assert line.judge([((), [-2, 3, 0.5, 0])]).text == "The coefficient of t^1 is not right."


@pytest.mark.parametrize(
    ("value", "sentence"),
    [
        (None, "Position, velocity and acceleration are asked for"),
        ((1, 2), "Position, velocity and acceleration are asked for"),
        (([0] * 4, [0] * 3, [0] * 4), r"The velocity has shape \(3,\); shape \(4,\)"),
        (("a", "b", "c"), "The position is text"),
        (7.0, "Position, velocity and acceleration are asked for"),
    ],
)
def test_what_is_no_motion_gets_a_sentence(value, sentence):
    task = TrajectoryTask(0, 1, 0, 1, at=np.linspace(0, 1, 4), answer="motion")
    with pytest.raises(ValueError, match=sentence):
        raise ValueError(task.judge([((), value)]).text)


@pytest.mark.parametrize(
    ("what", "sentence"),
    [
        ({"degree": 4}, "degree must be 3 or 5, got 4"),
        ({"answer": "p"}, "no answer 'p'; use one of 'q', 'v'"),
        ({"counted": "later"}, "no time 'later'; use 'from 0' or 'from start'"),
    ],
)
def test_what_cannot_be_asked_gets_an_error(what, sentence):
    with pytest.raises(InputError, match=sentence):
        TrajectoryTask(0, 1, 0, 1, **what)


def test_the_end_comes_after_the_start():
    with pytest.raises(InputError, match="end must come after start 2 s, got 1"):
        TrajectoryTask(0, 1, 2, 1, at=1.5).judge([((), 0)])
