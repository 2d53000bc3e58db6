import re
from dataclasses import FrozenInstanceError

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhlab.errors import DegreesWarning, InputError, LimitError
from dhlab.kinematics.chain import Chain
from dhlab.kinematics.dh import deg, dh, link_transform
from dhlab.kinematics.transforms import inverse, rotz, rp2t
from tests.kinematics.strategies import chains, configurations, conventions, poses

close = {"rtol": 0, "atol": 1e-10}
inf = np.inf
SCARA = Chain(
    [dh(0, 0, 0.4, 0), dh(0, 0.3, 0, 90 * deg), dh(180 * deg, 0.2, 0.1, 0)],
    "rrp",
    grasper=(0, 0, 0.05),
    limits=[(-2, 2), (-inf, 1.6), (0, 0.25)],
)


@st.composite
def moved_chains(draw, steps=None):
    chain = draw(chains())
    return chain, draw(configurations(chain.n, steps))


@given(moved_chains())
def test_the_frames_are_the_products_of_the_links(moved):
    chain, q = moved
    T = chain.base
    for i, frame in enumerate(chain.frames(q)):
        variable = q[i] + chain.offset[i]
        field = "theta" if chain.joints[i] == "r" else "d"
        T = T @ link_transform(chain.rows[i]._replace(**{field: variable}), chain.convention)
        np.testing.assert_allclose(frame, T, **close)
    np.testing.assert_allclose(chain.tip(q), T @ chain.grasper, **close)


@given(moved_chains())
def test_at_home_the_table_says_it_all(moved):
    chain = moved[0].replace(offset=np.zeros(moved[0].n))
    T = chain.base
    for row, frame in zip(chain.rows, chain.frames(chain.home), strict=True):
        T = T @ link_transform(row, chain.convention)
        np.testing.assert_allclose(frame, T, **close)


@given(moved_chains())
def test_an_offset_is_added_to_the_variable(moved):
    chain, q = moved
    plain = chain.replace(offset=np.zeros(chain.n))
    np.testing.assert_allclose(chain.frames(q), plain.frames(q + chain.offset), **close)


@given(moved_chains(steps=3))
def test_many_configurations_at_once_are_each_one_alone(moved):
    chain, q = moved
    alone = np.array([chain.frames(one) for one in q])
    np.testing.assert_allclose(chain.frames(q), alone, **close)
    np.testing.assert_allclose(chain.tip(q), [chain.tip(one) for one in q], **close)
    np.testing.assert_array_equal(chain.frames(q[None])[0], chain.frames(q))


@given(moved_chains(), poses)
def test_another_base_moves_all_frames_by_the_same(moved, motion):
    chain, q = moved
    rebased = chain.replace(base=motion @ chain.base)
    np.testing.assert_allclose(rebased.frames(q), motion @ chain.frames(q), **close)
    np.testing.assert_allclose(rebased.tip(q), motion @ chain.tip(q), **close)


@given(moved_chains())
def test_every_frame_stays_rigid(moved):
    chain, q = moved
    R = chain.frames(q)[:, :3, :3]
    np.testing.assert_allclose(
        R @ np.swapaxes(R, -1, -2), np.tile(np.eye(3), (len(R), 1, 1)), **close
    )
    np.testing.assert_allclose(np.linalg.det(R), 1, **close)


@given(moved_chains(), st.data())
def test_a_joint_moves_the_frames_from_its_own_on_about_or_along_one_line(moved, data):
    chain, q = moved
    if chain.n == 0:
        return
    i = data.draw(st.integers(0, chain.n - 1))
    other = q.copy()
    other[i] += 0.7
    before, after = chain.frames(q), chain.frames(other)
    np.testing.assert_allclose(after[:i], before[:i], **close)
    motions = after[i:] @ np.array([inverse(T) for T in before[i:]])
    np.testing.assert_allclose(motions, np.tile(motions[0], (len(motions), 1, 1)), atol=1e-9)
    slides = np.allclose(motions[0][:3, :3], np.eye(3))
    assert slides == (chain.joints[i] == "p")


@given(moved_chains())
def test_both_conventions_move_the_grasper_alike(moved):
    chain, q = moved
    for same in (chain.to_standard(), chain.to_modified()):
        np.testing.assert_allclose(same.tip(q), chain.tip(q), **close)
        np.testing.assert_array_equal(same.home, chain.home)
        np.testing.assert_array_equal(same.limits, chain.limits)
        assert same.joints == chain.joints
    assert chain.to_standard().convention == "standard"
    assert chain.to_modified().convention == "modified"


@given(moved_chains())
def test_there_and_back_between_the_conventions_gives_the_same_frames(moved):
    chain, q = moved
    back = {
        "modified": lambda: chain.to_standard().to_modified(),
        "standard": lambda: chain.to_modified().to_standard(),
    }[chain.convention]()
    assert [row[2:] for row in back.rows] == [row[2:] for row in chain.rows]
    if chain.convention == "modified":
        np.testing.assert_allclose(back.frames(q), chain.frames(q), **close)
    else:
        np.testing.assert_allclose(back.frames(q)[:-1], chain.frames(q)[:-1], **close)


def test_the_same_table_read_in_the_other_convention_is_another_arm():
    q = SCARA.home
    assert not np.allclose(SCARA.replace(convention="standard").tip(q), SCARA.tip(q))


@given(st.lists(st.floats(-9, 9), min_size=3, max_size=3))
def test_clipping_gives_the_nearest_configuration_within_the_limits(q):
    clipped = SCARA.clip(q)
    np.testing.assert_array_equal(SCARA.check(clipped), clipped)
    np.testing.assert_array_equal(SCARA.clip(clipped), clipped)
    for x, nearest, (lower, upper) in zip(q, clipped, SCARA.limits, strict=True):
        assert nearest == min(max(x, lower), upper)


@pytest.mark.parametrize(
    ("q", "text"),
    [
        ((3, 0, 0), "joint 1 of 'arm': 3.0000 rad (171.9 deg) is outside [-2.0000, 2.0000]"),
        ((0, 2, 0.1), "joint 2 of 'arm': 2.0000 rad (114.6 deg) is outside [-inf, 1.6000]"),
        ((0, 0, -0.1), "joint 3 of 'arm': -0.1000 m is outside [0.0000, 0.2500]"),
        ((0, 0, 0.25 + 2e-9), "joint 3 of 'arm': 0.250000002 m is outside [0.000000000, 0.2500"),
    ],
)
def test_outside_the_limits_is_an_error_with_joint_value_and_interval(q, text):
    with pytest.raises(LimitError, match=f"^{re.escape(text)}"):
        SCARA.check(q, "arm")
    with pytest.raises(LimitError, match=f"^{re.escape(text)}"):
        SCARA.check([SCARA.home, SCARA.clip(q), q], "arm")


def test_a_value_a_hair_outside_is_put_on_its_limit():
    on = SCARA.check([2 + 9e-10, 0, -9e-10])
    np.testing.assert_array_equal(on, (2, 0, 0))
    np.testing.assert_array_equal(SCARA.check([2 + 9e-7, 0, 0], tolerance=1e-6), (2, 0, 0))


@given(st.lists(st.floats(-1.5, 1.5), min_size=2, max_size=2))
def test_a_configuration_within_the_limits_stays_bit_for_bit(q):
    np.testing.assert_array_equal(SCARA.check([*q, 0.1]), [*q, 0.1])


@pytest.mark.parametrize("chain", [SCARA, SCARA.to_standard()])
def test_changing_a_row_gives_a_chain_with_that_row_alone_changed(chain):
    other = chain.replace(2, a=0.5, theta=0.1)
    assert other.rows[1] == chain.rows[1]._replace(a=0.5, theta=0.1)
    assert (other.rows[0], other.rows[2]) == (chain.rows[0], chain.rows[2])
    assert chain.replace(2, a=chain.rows[1].a).rows == chain.rows
    assert other.convention == chain.convention
    np.testing.assert_array_equal(other.limits, chain.limits)
    np.testing.assert_array_equal(other.base, chain.base)


def test_a_chain_with_another_base_keeps_the_rest():
    other = SCARA.replace(base=rp2t(rotz(1), (1, 2, 3)), limits=None)
    assert other.rows == SCARA.rows
    assert other.home[1] == 90 * deg
    assert np.isinf(other.limits).all()


def test_a_changed_row_in_degrees_warns():
    with pytest.warns(DegreesWarning, match="if 90 deg is meant"):
        SCARA.replace(1, alpha=90)


def test_a_chain_never_changes():
    with pytest.raises(FrozenInstanceError):
        SCARA.base = np.eye(4)
    for array in (SCARA.base, SCARA.grasper, SCARA.limits, SCARA.offset, SCARA.home):
        with pytest.raises(ValueError, match="read-only"):
            array[...] = 0


@given(conventions)
def test_a_chain_without_joints_is_its_base_and_grasper(convention):
    chain = Chain((), "", convention, base=(1, 2, 3), grasper=(0, 0, 1))
    assert chain.n == 0
    assert chain.frames([]).shape == (0, 4, 4)
    np.testing.assert_array_equal(chain.tip([])[:3, 3], (1, 2, 4))
    np.testing.assert_array_equal(chain.tip(np.empty((5, 0)))[:, 2, 3], [4] * 5)
    assert chain.check([]).shape == (0,)
    assert chain.to_standard().to_modified().n == 0


@pytest.mark.parametrize(
    ("changes", "text"),
    [
        ({"joints": "rr"}, "a table of 3 rows needs 3 joint letters, got 2"),
        ({"joints": "rrx"}, "joint 3: no joint type 'x'; use 'r' or 'p'"),
        ({"convention": "craig"}, "no convention 'craig'; use 'modified' or 'standard'"),
        ({"base": (1, 2)}, "base must be a 3-vector or a 4x4 pose, got shape (2,)"),
        ({"grasper": np.eye(3)}, "grasper must be a 3-vector or a 4x4 pose, got shape (3, 3)"),
        ({"limits": [(0, 1)]}, "limits must have shape (3, 2), a row (lower, upper) per joint"),
        ({"limits": [(0, 1), (1, 0), (0, 1)]}, "limits, joint 2: the lower limit 1 is above"),
        ({"offset": [0, 0]}, "offset must have shape (3,), got (2,)"),
        ({"rows": [(0, 0, 0)] * 3}, "row 1 of the table (alpha, a, d, theta) must have shape"),
        ({"radius": 1}, "a chain has no 'radius'; it has rows, joints, convention, base, grasper"),
    ],
)
def test_what_is_no_chain_is_told_why(changes, text):
    with pytest.raises(InputError, match=f"^{re.escape(text)}"):
        SCARA.replace(**changes)


@pytest.mark.parametrize(
    ("joint", "changes", "text"),
    [
        (2, {"length": 1}, "a row of the table has no 'length'; it has alpha, a, d, theta"),
        (0, {"a": 1}, "the table has rows 1 to 3, got 0"),
        (4, {"a": 1}, "the table has rows 1 to 3, got 4"),
        ("a", {"a": 1}, "the table has rows 1 to 3, got 'a'"),
        (1, {"a": np.nan}, "a of a table row must be finite, got nan"),
    ],
)
def test_a_row_that_cannot_be_changed_is_told_why(joint, changes, text):
    with pytest.raises(InputError, match=f"^{re.escape(text)}"):
        SCARA.replace(joint, **changes)


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: SCARA.frames([1, 2]), "q must have shape (3,), got (2,)"),
        (lambda: SCARA.tip([1, 2, np.nan]), "q must be finite, got nan at [2]"),
        (lambda: SCARA.check([1, 2], "arm"), "q of 'arm' must have shape (3,), got (2,)"),
    ],
)
def test_what_is_no_configuration_is_told_why(call, text):
    with pytest.raises(InputError, match=f"^{re.escape(text)}$"):
        call()


def test_a_chain_prints_its_table_and_its_convention():
    assert repr(SCARA) == (
        "Chain 'rrp', modified Denavit-Hartenberg (m, rad)\n"
        "i  alpha_{i-1}  a_{i-1}  d_i  theta_i  home  limits\n"
        "1  0            0        0.4  q_1      0     [-2, 2]\n"
        "2  0            0.3      0    q_2      pi/2  [-inf, 1.6]\n"
        "3  pi           0.2      q_3  0        0.1   [0, 0.25]\n"
        "grasper: origin (0, 0, 0.05)"
    )


def test_a_standard_table_has_standard_heads_and_offsets_are_printed():
    chain = Chain([(0, 0, 0, 0)] * 2, "rp", "standard", offset=(pi := np.pi, -0.5))
    head, first, second = repr(chain).splitlines()[1:]
    assert head.split() == ["i", "alpha_i", "a_i", "d_i", "theta_i", "home", "limits"]
    assert "q_1 + pi" in first
    assert "q_2 - 0.5" in second
    assert pi == chain.offset[0]


def test_in_a_notebook_the_table_is_html_with_the_same_cells():
    html = SCARA._repr_html_()
    assert html.startswith("<table><caption>modified Denavit-Hartenberg (m, rad)</caption>")
    assert "<th>α<sub>i−1</sub></th>" in html
    assert "<td>q<sub>2</sub></td><td>π/2</td>" in html
    assert html.count("<tr>") == 4


def test_a_turned_base_is_told():
    text = repr(SCARA.replace(base=rp2t(rotz(np.pi / 2), (0, 0, 1))))
    assert "base: origin (0, 0, 1), roll, pitch, yaw (0, 0, pi/2)" in text
