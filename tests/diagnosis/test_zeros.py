"""Which zeros the motion of a tip settles, and which it leaves open."""

from math import pi

import numpy as np
import pytest

from dhlab.diagnosis.paths import Part, path
from dhlab.diagnosis.zeros import Zeros
from dhlab.kinematics.chain import Chain

PLAIN = (0, 0, 0, 0)


def way(rows, joints):
    chain = Chain(rows, joints, grasper=(0.1, 0.2, 0.3))
    return path([Part(chain, -1, 0, chain.base)], 0)


@pytest.mark.parametrize(
    ("rows", "joints", "open_directions"),
    [
        ([PLAIN, (pi / 2, 0.3, 0, 0)], "rr", []),
        ([PLAIN, PLAIN], "rr", [(1, -1)]),
        ([PLAIN, (0, 0.2, 0, 0)], "rr", []),
        ([PLAIN, (0, 0.2, 0, 0)], "pp", [(1, -1)]),
        ([PLAIN, (pi, 0.2, 0, 0)], "pp", [(1, 1)]),
        ([PLAIN, (pi / 2, 0, 0, 0), (-pi / 4, 0, 0, 0)], "ppp", [(1, 1, -np.sqrt(2))]),
        ([PLAIN, PLAIN, (0, 0.3, 0, 0)], "prp", [(1, 0, -1)]),
        ([PLAIN, (pi / 2, 0, 0, 0), (-pi / 2, 0, 0, 0)], "prp", []),
    ],
)
def test_joints_that_do_the_same_leave_their_zeros_open(rows, joints, open_directions):
    zeros = Zeros.of(len(rows)).on(way(rows, joints), np.zeros(len(rows)), False, False)
    assert zeros.free.shape == (len(rows), len(open_directions))
    for direction in open_directions:
        unit = np.array(direction) / np.linalg.norm(direction)
        np.testing.assert_allclose(zeros.free @ (zeros.free.T @ unit), unit, atol=1e-9)


def test_free_ends_leave_the_zeros_at_the_ends_open():
    rows = [PLAIN, (pi / 2, 0.3, 0, 0), (1, 0.2, 0, 0)]
    for base_free, tool_free, left in ((True, False, 1), (False, True, 1), (True, True, 2)):
        zeros = Zeros.of(3).on(way(rows, "rrr"), np.zeros(3), base_free, tool_free)
        assert zeros.free.shape[1] == left
        assert np.abs(zeros.free[1]).max() < 1e-9


def test_a_path_moves_alike_with_all_zeros_that_are_left():
    rng = np.random.default_rng(3)
    rows = [PLAIN, (0, 0.3, 0, 0), (pi / 2, 0, 0, 0), (-pi / 4, 0, 0.1, 0)]
    ways, offsets = way(rows, "prpp"), rng.uniform(-1, 1, 4)
    zeros = Zeros.of(4).on(ways, offsets, False, False)
    assert zeros.free.shape[1] > 0
    other = zeros.offsets + zeros.free @ rng.uniform(-1, 1, zeros.free.shape[1])
    q = rng.uniform(-2, 2, (5, 4))
    np.testing.assert_allclose(ways.tip(q + other), ways.tip(q + offsets), atol=1e-9)


def test_what_two_paths_settle_holds_for_both():
    shared = Chain([PLAIN, PLAIN], "rr")
    straight, across = Chain([PLAIN], "r"), Chain([(pi / 2, 0.2, 0, 0)], "r")
    parts = [Part(shared, -1, 0, np.eye(4))]
    parts += [Part(c, 0, 2, np.eye(4)) for c in (straight, across)]
    zeros = Zeros.of(4)
    zeros = zeros.on(path(parts, 1), np.array([0.5, 0.5 + 2 * pi, 0]), False, False)
    zeros = zeros.on(path(parts, 2), np.array([0.1, 0.6, 0.3]), False, False)
    o = zeros.offsets
    assert zeros.free.shape[1] == 1  # only how the first two share their turn
    assert np.exp(1j * (o[0] + o[1])) == pytest.approx(np.exp(0.7j))
    assert np.exp(1j * o.sum()) == pytest.approx(np.exp(1.3j))
    assert o[3] == pytest.approx(0.3)


def test_an_open_zero_can_be_chosen_and_a_settled_angle_differs_by_full_turns():
    zeros = Zeros.of(3).on(way([PLAIN, PLAIN, (pi / 2, 1, 0, 0)], "ppr"), np.zeros(3), False, False)
    chosen = zeros.at(0, 0.4, turning=False)
    np.testing.assert_allclose(chosen.offsets, (0.4, -0.4, 0), atol=1e-9)
    assert chosen.free.shape[1] == 0
    np.testing.assert_allclose(chosen.at(1, 7, turning=False).offsets, chosen.offsets)
    np.testing.assert_allclose(chosen.at(2, 6, turning=True).offsets, (0.4, -0.4, 2 * pi))


def test_settled_zeros_are_none_to_choose():
    zeros = Zeros.of(2, settled=True)
    assert zeros.free.shape == (2, 0)
    np.testing.assert_array_equal(zeros.at(0, 0.4, turning=False).offsets, 0)
