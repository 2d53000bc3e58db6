import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhlab.errors import InputError
from dhlab.kinematics import plan
from dhlab.kinematics.chain import Chain
from dhlab.kinematics.mechanism import Branch, Mechanism
from tests.kinematics.limb import LIMB
from tests.kinematics.strategies import configurations, mechanisms, poses

close = {"rtol": 0, "atol": 1e-10}
FINGER = Chain([(0, 0, 0, 0), (0, 0.3, 0, 0)], "rr", grasper=(0.2, 0, 0))


def chain_by_chain(mechanism, q):
    """All frames by the chains alone: what the mechanism must give, only slowly."""
    taken = {(branch.parent, branch.at) for branch in mechanism.branches}
    places, frames = [], {}
    for number, (name, chain, parent, at) in enumerate(mechanism.branches):
        carrier = places[parent][at] if parent >= 0 else np.eye(4)
        own = q[mechanism.slices[number]]
        poses = carrier @ chain.frames(own)
        places.append([carrier @ chain.base, *poses])
        frames |= {f"{name}/{i}": T for i, T in enumerate(poses, start=1)}
        if chain.n and (number, chain.n) not in taken:
            frames[f"{name}/grasper"] = carrier @ chain.tip(own)
    return frames


@st.composite
def moved_mechanisms(draw, steps=None):
    mechanism = draw(mechanisms())
    return mechanism, draw(configurations(mechanism.n, steps))


@given(moved_mechanisms())
def test_the_frames_of_a_tree_are_those_of_its_chains(moved):
    mechanism, q = moved
    frames, wanted = mechanism.frames(q), chain_by_chain(mechanism, q)
    assert tuple(frames) == mechanism.names == tuple(wanted)
    for name, T in frames.items():
        np.testing.assert_allclose(T, wanted[name], **close, err_msg=name)


@given(moved_mechanisms(steps=3))
def test_many_configurations_at_once_are_each_one_alone(moved):
    mechanism, q = moved
    frames = mechanism.frames(q)
    assert tuple(frames) == mechanism.names
    for step, one in enumerate(q):
        for name, T in mechanism.frames(one).items():
            np.testing.assert_allclose(frames[name][step], T, **close, err_msg=name)


@given(moved_mechanisms(), poses)
def test_moving_the_roots_moves_every_frame_by_the_same(moved, motion):
    mechanism, q = moved
    rebased = Mechanism(
        [
            b._replace(chain=b.chain.replace(base=motion @ b.chain.base)) if b.parent < 0 else b
            for b in mechanism.branches
        ]
    )
    frames = mechanism.frames(q)
    for name, T in rebased.frames(q).items():
        np.testing.assert_allclose(T, motion @ frames[name], **close)


@pytest.mark.parametrize("steps", [0, 1, plan.CHUNK - 1, plan.CHUNK, plan.CHUNK + 1])
def test_any_number_of_configurations_will_do(steps):
    q = np.random.default_rng(1).uniform(-np.pi, np.pi, (steps, 27))
    tip = LIMB.frames(q)["arm/hand/little/grasper"]
    assert tip.shape == (steps, 4, 4)
    for step in {0, steps - 1} if steps else set():
        alone = LIMB.frames(q[step])["arm/hand/little/grasper"]
        np.testing.assert_allclose(tip[step], alone, rtol=0, atol=1e-12)


def test_configurations_may_have_any_leading_axes():
    q = np.random.default_rng(1).uniform(-np.pi, np.pi, (2, 3, 27))
    frames = LIMB.frames(q)
    assert frames["arm/7"].shape == (2, 3, 4, 4)
    np.testing.assert_allclose(frames["arm/7"][1, 2], LIMB.frames(q[1, 2])["arm/7"], atol=1e-12)


@pytest.mark.parametrize("turns", [0, 0.5, -0.5, 1, 1000])
def test_half_and_full_turns_are_as_exact_as_others(turns):
    q = np.full((2, 27), turns * 2 * np.pi)
    frames, alone = LIMB.frames(q), LIMB.frames(q[0])
    for name, T in frames.items():
        np.testing.assert_allclose(T[1], alone[name], rtol=0, atol=1e-12, err_msg=name)


def test_poses_are_read_only():
    for q in (np.zeros(27), np.zeros((2, 27))):
        for T in LIMB.frames(q).values():
            with pytest.raises(ValueError, match="read-only"):
                T[...] = 0


def test_later_frames_do_not_change_earlier_ones():
    first = LIMB.frames(np.zeros(27))["arm/7"]
    kept = first.copy()
    LIMB.frames(np.ones(27))
    np.testing.assert_array_equal(first, kept)


def test_a_branch_that_carries_something_at_its_last_frame_shows_no_grasper():
    def names(at):
        branches = [Branch("arm", FINGER), Branch("arm/tool", FINGER, parent=0, at=at)]
        return Mechanism(branches).names

    tool = ("arm/tool/1", "arm/tool/2", "arm/tool/grasper")
    assert names(2) == ("arm/1", "arm/2", *tool)
    for at in (0, 1):
        assert names(at) == ("arm/1", "arm/2", "arm/grasper", *tool)


def test_the_parents_grasper_does_not_move_what_is_attached():
    tool = Branch("arm/tool", FINGER, parent=0, at=2)
    short, long = (
        Mechanism([Branch("arm", FINGER.replace(grasper=(x, 0, 0))), tool]).frames([1, 2, 3, 4])
        for x in (0.1, 0.9)
    )
    np.testing.assert_array_equal(short["arm/tool/2"], long["arm/tool/2"])


def test_the_configuration_joins_those_of_the_branches():
    assert LIMB.slices[0] == slice(0, 7)
    assert LIMB.slices[1] == slice(7, 7)
    assert LIMB.slices[-1] == slice(23, 27)


def test_a_mechanism_without_joints_has_no_frames():
    still = Mechanism([Branch("base", Chain((), ""))])
    assert (still.n, still.names) == (0, ())
    assert still.frames([]) == still.frames(np.empty((5, 0))) == {}


def test_limits_are_not_looked_at():
    finger = FINGER.replace(limits=[(0, 1), (0, 1)])
    assert Mechanism([Branch("finger", finger)]).frames([5, 5])


@pytest.mark.parametrize(
    ("q", "text"),
    [
        (np.zeros(5), "q of 'arm' must have shape (27,), got (5,)"),
        (np.zeros((2, 5)), "q of 'arm' must have shape (..., 27), got (2, 5)"),
        ([np.nan] * 27, "q of 'arm' must be finite, got nan at [0]"),
        ("zero", "q of 'arm' must be made of numbers, got 'zero'"),
    ],
)
def test_what_is_no_configuration_is_told_why(q, text):
    with pytest.raises(InputError, match=f"^{re.escape(text)}$"):
        LIMB.frames(q)


@pytest.mark.parametrize(
    ("branches", "text"),
    [
        ([], "a mechanism needs at least one branch"),
        (
            [Branch("a", FINGER), Branch("a", FINGER)],
            "names of branches must differ, got ['a', 'a'",
        ),
        ([Branch("a", FINGER, parent=0)], "parent of 'a' must come before it in the branches"),
        ([Branch("a", FINGER, parent=-2)], "parent of 'a' must come before it in the branches"),
        (
            [Branch("a", FINGER), Branch("b", FINGER, 0, at=3)],
            "'b' is attached at frame 3; its parent has frames 0 to 2",
        ),
        ([Branch("a", FINGER, at=1)], "'a' is attached at frame 1; its parent has frames 0 to 0"),
    ],
)
def test_branches_that_make_no_tree_are_told_why(branches, text):
    with pytest.raises(InputError, match=f"^{re.escape(text)}"):
        Mechanism(branches)
