from math import pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhlab.kinematics.table import angle_text, html_table, number_text, place_text, text_table
from dhlab.kinematics.transforms import rotx, rp2t


@pytest.mark.parametrize(
    ("x", "text"),
    [(0, "0"), (-0.0, "0"), (-1e-9, "0"), (10, "10"), (0.25, "0.25"), (1 / 3, "0.3333")],
)
def test_a_number_has_four_decimals_at_most_and_no_minus_zero(x, text):
    assert number_text(x) == text


@pytest.mark.parametrize(
    ("x", "text"),
    [
        (0, "0"),
        (pi, "pi"),
        (-pi, "-pi"),
        (pi / 2, "pi/2"),
        (-3 * pi / 4, "-3pi/4"),
        (1.5, "1.5"),
        (np.inf, "inf"),
        (-np.inf, "-inf"),
    ],
)
def test_an_angle_is_a_fraction_of_pi_where_it_is_one(x, text):
    assert angle_text(x) == text


@given(st.integers(-72, 72), st.integers(1, 36))
def test_a_fraction_of_pi_can_be_read_back(numerator, denominator):
    text = angle_text(numerator * pi / denominator)
    times, _, over = text.partition("/")
    times = times.removesuffix("pi")
    value = {"": 1, "-": -1}.get(times) or float(times)
    assert value * pi / float(over or 1) == pytest.approx(numerator * pi / denominator, abs=1e-12)


@given(st.floats(-10, 10))
def test_an_angle_is_told_as_near_as_its_decimals(x):
    text = angle_text(x)
    if "pi" not in text:
        assert float(text) == pytest.approx(x, abs=5.1e-5)


def test_a_place_is_its_origin_and_its_turn():
    assert place_text(rp2t(np.eye(3), (1, 0.5, -1e-9))) == "origin (1, 0.5, 0)"
    turned = place_text(rp2t(rotx(pi / 4), (0, 0, 0)))
    assert turned == "origin (0, 0, 0), roll, pitch, yaw (pi/4, 0, 0)"


def test_columns_are_as_wide_as_their_widest_cell():
    assert text_table(["i", "a"], [["10", "1"], ["2", "3"]]) == ["i   a", "10  1", "2   3"]


def test_what_could_be_read_as_html_is_kept_as_text():
    assert html_table("a < b", ["i"], [], ["c & d"]).endswith("</table><br>c &amp; d")
    assert "<caption>a &lt; b</caption>" in html_table("a < b", ["i"], [], [])


def test_words_become_letters_and_what_follows_an_underscore_an_index():
    html = html_table("", ["alpha_{i-1}", "q_1 - 0.5"], [["-pi/2", "2"]], [])
    assert "<th>α<sub>i−1</sub></th><th>q<sub>1</sub> − 0.5</th>" in html
    assert "<td>−π/2</td><td>2</td>" in html
