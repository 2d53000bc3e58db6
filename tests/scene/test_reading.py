"""Units, spans and labels of joint variables."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy import inf, pi

from dhlab.scene.reading import joint_label, reading

angles = st.floats(-10, 10)
kinds = st.sampled_from(["r", "p"])


@st.composite
def intervals(draw):
    """Limits that are as wide as a joint's, or one-sided, or none."""
    lower = draw(st.just(-inf) | angles)
    upper = draw(
        st.just(inf) | st.floats(0.01, 10).map(lambda d: (0 if lower == -inf else lower) + d)
    )
    return lower, upper


@given(kinds, intervals(), st.floats(0, 1))
def test_what_is_shown_and_read_back_is_the_same_value(kind, limits, way):
    r = reading(kind, limits, 0.5, (0.0,))
    value = r.span[0] + way * (r.span[1] - r.span[0])
    assert r.meant(r.shown(value)) == pytest.approx(value, abs=1.01e-6)


@given(kinds, intervals())
def test_a_value_near_a_limit_is_the_limit_bit_for_bit(kind, limits):
    r = reading(kind, limits, 0.5, (0.0,))
    for limit in limits:
        if np.isfinite(limit):
            assert r.meant(r.shown(limit)) == limit
            assert r.meant(r.shown(limit + 9e-7)) == limit
            assert r.meant(r.shown(limit - 9e-7)) == limit


@given(kinds, intervals(), st.floats(-100, 100))
def test_no_value_read_is_outside_the_limits(kind, limits, shown):
    r = reading(kind, limits, 0.5, (0.0,))
    assert limits[0] <= r.meant(shown) <= limits[1]


@given(kinds, intervals(), st.floats(0.01, 5), st.floats(0, 1))
def test_a_span_meets_the_limits_and_holds_the_values(kind, limits, reach, way):
    lower, upper = max(limits[0], -20), min(limits[1], 20)
    value = lower + way * (upper - lower)
    r = reading(kind, limits, reach, (value,))
    for end, limit in zip(r.span, limits, strict=True):
        assert np.isfinite(end)
        assert not np.isfinite(limit) or end == limit
    assert r.span[0] <= value <= r.span[1]


@given(intervals())
def test_a_slider_can_stop_at_zero_and_shows_its_values_rightly(limits):
    r = reading("r", limits, 0.5, (0.0,))
    steps = r.shown(r.span[0]) / r.step
    nearest = abs(steps - round(steps)) * r.step
    assert nearest <= 0.5 * r.step + 1e-9
    assert r.step <= 0.1


@pytest.mark.parametrize(
    ("kind", "limits", "unit", "step"),
    [
        ("r", (-pi / 2, pi / 2), "°", 0.1),
        ("r", (-pi / 16, pi), "°", 0.05),
        ("r", (-1, 1), "°", 0.01),
        ("p", (0, 0.25), "mm", 0.1),
        ("p", (0, 2), "m", 0.001),
        ("p", (-1.5, 0.1), "m", 0.001),
    ],
)
def test_the_unit_suits_the_span_and_the_step_meets_zero(kind, limits, unit, step):
    r = reading(kind, limits, 0.5, (0.0,))
    assert (r.unit, r.step) == (unit, pytest.approx(step))


@pytest.mark.parametrize(
    ("limits", "reach", "value", "span"),
    [
        ((-inf, inf), 0.3, 0.0, (-0.5, 0.5)),
        ((-inf, inf), 0.3, 3.0, (-4, 4)),
        ((0.1, inf), 0.3, 0.1, (0.1, 1.1)),
        ((-inf, 0.1), 0.3, 0.1, (-0.9, 0.1)),
    ],
)
def test_a_joint_without_limits_is_given_a_span(limits, reach, value, span):
    r = reading("p", limits, reach, (value,))
    assert r.span == pytest.approx(span)
    assert not r.bounded


def test_a_joint_that_cannot_move_has_a_slider_all_the_same():
    r = reading("r", (1.0, 1.0), 0.5, (1.0,))
    assert r.span[0] < r.span[1]
    assert r.meant(r.shown(r.span[1])) == 1.0


@pytest.mark.parametrize(
    ("limits", "ends"),
    [
        ((-pi / 9, 0), ("−20", "0")),
        ((-pi / 16, inf), ("−11.25", "∞")),
        ((-0.0, 1), ("0", "57.296")),
    ],
)
def test_ends_are_written_short_and_without_minus_zero(limits, ends):
    assert reading("r", limits, 0.5, (0.0,)).ends() == ends


def test_labels_are_those_of_the_tables():
    assert [joint_label(k, i) for k, i in (("r", 1), ("p", 23))] == ["θ₁", "d₂₃"]
