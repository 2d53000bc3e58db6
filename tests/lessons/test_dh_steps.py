"""The travelling csys ends each joint in the robot's own frame, for any robot and convention."""

import json

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dhlab import dh_lesson, models, robot, robot_complex, rotz, rp2t
from dhlab.lessons.product import value_of

SEEDS = st.integers(0, 2**32 - 1)


def random_pose(rng):
    return rp2t(rotz(rng.uniform(-3, 3)), rng.uniform(-1, 1, 3))


def random_robot(rng, name, most=4):
    n = int(rng.integers(1, most))
    rows = rng.uniform(-2, 2, (n, 4)) * rng.integers(0, 2, (n, 4))
    return robot(
        rows,
        "".join(rng.choice(["r", "p"], n)),
        name=name,
        convention=str(rng.choice(["modified", "standard"])),
        base=random_pose(rng),
        grasper=random_pose(rng),
        offset=rng.uniform(-1, 1, n) * rng.integers(0, 2, n),
    )


def random_mechanism(seed):
    rng = np.random.default_rng(seed)
    top = random_robot(rng, "arm")
    if rng.random() < 0.5:
        top.connect(random_robot(rng, "hand"), at=int(rng.integers(0, top.n + 1)))
    if rng.random() < 0.5:
        top = robot_complex(top, random_robot(rng, "other"), name="pair", base=random_pose(rng))
    top.q = rng.uniform(-2, 2, top.n)
    return top


def ends_of_joints(lesson):
    """Number of the last step of each joint, in order."""
    joints = [(k, step.about.get("joint")) for k, step in enumerate(lesson.steps, start=1)]
    return [
        k
        for (k, joint), (_, later) in zip(joints, [*joints[1:], (0, None)], strict=True)
        if joint is not None and later != joint
    ]


@settings(max_examples=60, deadline=None)
@given(seed=SEEDS)
def test_the_last_csys_of_every_joint_is_the_robot_s_frame(seed):
    mechanism = random_mechanism(seed)
    frames = {name: T for name, T in mechanism.frames().items() if "grasper" not in name}
    lesson = dh_lesson(mechanism)
    traveller = lesson.product_of
    ends = ends_of_joints(lesson)
    assert len(ends) == mechanism.n == len(frames)
    for k, (name, T) in zip(ends, frames.items(), strict=True):
        assert np.abs(lesson.go(k).timeline.states[k][traveller] - T).max() < 1e-12, name


@settings(max_examples=30, deadline=None)
@given(seed=SEEDS)
def test_the_product_of_a_joint_leads_from_frame_to_frame(seed):
    lesson = dh_lesson(random_mechanism(seed))
    described = lesson.describe()["steps"]
    F = lesson.product_of
    for k in ends_of_joints(lesson):
        factors = described[k - 1]["product"]["factors"]
        start = lesson.timeline.states[k - 4][F]
        assert len(factors) == 4
        assert np.allclose(start @ value_of(factors), lesson.timeline.states[k][F], atol=1e-12)
    json.dumps(described, allow_nan=False)


@pytest.mark.parametrize(
    ("convention", "order"),
    [
        ("modified", ["twist", "length", "angle", "offset"]),
        ("standard", ["angle", "offset", "length", "twist"]),
    ],
)
def test_the_order_of_the_four_steps_is_the_convention_s(convention, order):
    arm = robot([(0.1, 0.2, 0.3, 0.4)], "r", convention=convention)
    titles = [step.title for step in dh_lesson(arm).steps]
    assert titles == ["Base", *(f"Joint 1: {name}" for name in order), "Grasper"]


def test_each_step_lights_up_its_number_in_the_table():
    arm = models.puma()
    for step in dh_lesson(arm).describe()["steps"]:
        if step.get("table"):
            table, parameter = step["table"], step["parameter"]
            assert ["alpha", "a", "d", "theta"][table["cell"]] == parameter
            assert table["row"] == step["joint"] - 1


def test_the_graspers_are_reached_too():
    limb = models.upper_limb()
    lesson = dh_lesson(limb)
    frames = limb.frames()
    F = lesson.product_of
    reached = [
        lesson.timeline.states[k][F]
        for k, step in enumerate(lesson.steps, start=1)
        if step.title.endswith("grasper")
    ]
    for name in ("thumb", "index", "middle", "ring", "little"):
        wanted = frames[f"arm/hand/{name}/grasper"]
        assert min(np.abs(T - wanted).max() for T in reached) < 1e-12
    assert len(lesson.steps) > 4 * 27
