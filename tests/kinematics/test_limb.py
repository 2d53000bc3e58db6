"""The limb of the paper against numbers that were worked out with 50 digits."""

import json
from pathlib import Path

import numpy as np
import pytest

from dhlab.kinematics.poly3 import trj_poly3
from tests.kinematics.limb import ARM, CHAINS, LIMB

GOLDEN = json.loads((Path(__file__).parents[1] / "data" / "limb_golden.json").read_text("utf-8"))
WITHIN = {"rtol": 0, "atol": GOLDEN["tolerance"]}
NAMES = dict(zip(GOLDEN["order"], ["arm", *CHAINS], strict=True))
CONFIGURATIONS = {c["name"]: c for c in GOLDEN["configurations"]}


def golden_frames(configuration):
    """Every frame by its name in the mechanism."""
    for key, name in NAMES.items():
        frames = configuration["frames"][key]
        for i, T in enumerate(frames["joints"], start=1):
            yield f"{name}/{i}", T
        if key != "arm":
            yield f"{name}/grasper", frames["tip"]


def test_the_limb_has_27_variables_and_32_frames():
    assert LIMB.n == 27
    assert LIMB.names == tuple(name for name, _ in golden_frames(CONFIGURATIONS["initial"]))
    assert len(LIMB.names) == 32


@pytest.mark.parametrize("configuration", CONFIGURATIONS.values(), ids=CONFIGURATIONS)
def test_every_frame_of_the_limb_is_where_it_should_be(configuration):
    frames = LIMB.frames(configuration["q"])
    for name, T in golden_frames(configuration):
        np.testing.assert_allclose(frames[name], T, **WITHIN, err_msg=name)


def test_every_frame_of_many_configurations_is_where_it_should_be():
    frames = LIMB.frames([c["q"] for c in CONFIGURATIONS.values()])
    for step, configuration in enumerate(CONFIGURATIONS.values()):
        for name, T in golden_frames(configuration):
            np.testing.assert_allclose(frames[name][step], T, **WITHIN, err_msg=name)


@pytest.mark.parametrize("configuration", CONFIGURATIONS.values(), ids=CONFIGURATIONS)
def test_the_chains_alone_agree(configuration):
    q, frames = np.array(configuration["q"]), configuration["frames"]
    np.testing.assert_allclose(ARM.frames(q[:7]), frames["arm"]["joints"], **WITHIN)
    hand = ARM.tip(q[:7])
    for number, (key, chain) in enumerate(zip(GOLDEN["order"][1:], CHAINS.values(), strict=True)):
        own = q[7 + 4 * number : 11 + 4 * number]
        np.testing.assert_allclose(hand @ chain.base, frames[key]["base"], **WITHIN)
        np.testing.assert_allclose(hand @ chain.frames(own), frames[key]["joints"], **WITHIN)
        np.testing.assert_allclose(hand @ chain.tip(own), frames[key]["tip"], **WITHIN)


def test_the_home_of_the_tables_is_the_initial_configuration():
    home = np.concatenate([branch.chain.home for branch in LIMB.branches])
    np.testing.assert_allclose(home, CONFIGURATIONS["initial"]["q"], **WITHIN)


def test_the_initial_configuration_bends_the_elbow_by_a_right_angle():
    frames = LIMB.frames(CONFIGURATIONS["initial"]["q"])
    np.testing.assert_allclose(frames["arm/4"][:3, 3], (0, 0, -0.25), atol=1e-12)
    np.testing.assert_allclose(frames["arm/7"][:3, 3], (0, -0.25, -0.25), atol=1e-12)
    np.testing.assert_allclose(frames["arm/7"][:3, 2], (0, 0, 1), atol=1e-12)


def test_negative_angles_curl_the_index_to_the_palm():
    tip = CHAINS["arm/hand/index"].tip([0, -np.pi / 2, -np.pi / 2, -np.pi / 2])
    np.testing.assert_allclose(tip[:3, 3], (0.065, 0.022, -0.025), atol=1e-12)


def test_the_planner_of_the_paper_gives_the_papers_numbers():
    golden = GOLDEN["trj_poly3"]
    q, v, a, t, c = trj_poly3(golden["t"], golden["q0"], golden["qt"])
    for name, value in {"q": q.T, "v": v.T, "a": a.T, "c": c}.items():
        np.testing.assert_allclose(value, golden[name], **WITHIN, err_msg=name)
    np.testing.assert_array_equal(t, golden["t"])
