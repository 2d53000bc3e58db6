"""What a robot remembers of its description is what it would say anew."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dhlab import LimitError, animate, cube, robot, robot_complex
from dhlab.scene.robot_nodes import robot_nodes
from dhlab.view import diff


def a_mechanism():
    """An arm of three joints, one of them prismatic, that carries two fingers."""
    arm = robot(
        [(0, 0, 0, 0), (0, 0.3, 0.1, 0), (1, 0.2, 0, 0)], "rpr", name="arm", limits=3 * [(-2, 2)]
    )
    finger = {"rows": [(0, 0, 0, 0), (0, 0.1, 0, 0)], "joints": "rr", "grasper": (0.1, 0, 0)}
    fingers = [robot(**finger, name=name, limits=2 * [(-1, 1)]) for name in ("one", "two")]
    return arm.connect(robot_complex(*fingers, name="hand"))


def fresh(r):
    """The nodes of a robot that nothing carries, worked out anew."""
    return robot_nodes(r, r.name)


def some_configuration(r, seed):
    return np.random.default_rng(seed).uniform(*r.limits.T)


CHANGES = {
    "configuration": lambda r, seed: r.set(q=some_configuration(r, seed)),
    "finger": lambda r, seed: r.components[1].set(q=some_configuration(r.components[1], seed)),
    "motion": lambda r, seed: animate([0.0, 1.0], {r: lambda t: t * some_configuration(r, seed)}),
    "base": lambda r, seed: r.set(base=(0, 0, seed)),
    "colour": lambda r, seed: r.components[1].set(color=(seed / 9, 0, 0)),
    "look": lambda r, seed: r.set(look=("stick", "solid", "user")[seed % 3]),
    "frames": lambda r, seed: r.set(show_csys=seed % 2 == 0),
    "hidden": lambda r, seed: r.attached[0].set(visible=seed % 2 == 0),
    "name": lambda r, seed: setattr(r.attached[0], "name", f"hand {seed}"),
    "limits": lambda r, seed: r.set(limits=r.limits + np.array([-seed, seed])),
    "table": lambda r, seed: r.set(chain=r.chain.replace(2, a=0.01 * seed)),
    "part": lambda r, seed: r.set_part(cube(0.1 + seed, name="part"), joint=1),
    "part's colour": lambda r, seed: r.children()[-1].set(color=(0, seed / 9, 0)),
    "tool": lambda r, seed: r.connect(
        robot([(0, 0, 0, 0)], "r", name=f"tool {len(r.attached)}", limits=[(-1, 1)]), at=seed % 4
    ),
}


@settings(max_examples=40)
@given(st.lists(st.tuples(st.sampled_from(sorted(CHANGES)), st.integers(0, 9)), max_size=8))
def test_after_any_changes_a_robot_describes_itself_as_if_for_the_first_time(changes):
    r = a_mechanism()
    r.describe()
    for what, seed in changes:
        CHANGES[what](r, seed)
        assert not diff(r.describe(), fresh(r))
        assert list(r.describe()) == list(fresh(r))
        assert list(r.frames()) == list(r.mechanism.names)


def test_a_description_stays_as_it_was_when_the_robot_moves_on():
    r = a_mechanism()
    before = r.describe()
    value = before["arm/1"].value
    r.q = some_configuration(r, 1)
    assert before["arm/1"].value == value


def test_only_joints_that_move_are_described_anew():
    r = a_mechanism()
    before = r.describe()
    r.q = r.q + 0.1 * (np.arange(7) == 2)
    after = r.describe()
    assert [path for path in after if after[path] is not before[path]] == ["arm/1/2/3"]


def test_a_renamed_robot_renames_its_frames():
    arm = robot([(0, 0, 0, 0)], "r", name="arm")
    arm.frames()
    arm.name = "leg"
    assert list(arm.frames()) == ["leg/1", "leg/grasper"]


def test_limits_of_a_mechanism_are_those_of_its_robots():
    r = a_mechanism()
    r.q = r.limits[:, 1] + 5e-10
    assert np.array_equal(r.q, r.limits[:, 1])
    too_far = np.array(r.limits[:, 0])
    too_far[4] -= 0.1
    with pytest.raises(LimitError) as alone:
        r.components[1].q = too_far[3:5]
    with pytest.raises(LimitError) as together:
        r.q = too_far
    assert str(together.value) == str(alone.value)
    assert np.array_equal(r.q, r.limits[:, 1])
