"""One sequence of words in two readings."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dhlab import InputError, deg, inverse, rp2t, sequence_lesson, transl
from dhlab.kinematics.angles import angvec2r

WORDS = st.lists(
    st.one_of(
        st.tuples(st.sampled_from("xyz"), st.floats(-3, 3)),
        st.tuples(*3 * [st.floats(-2, 2)]),
    ),
    min_size=1,
    max_size=5,
)


def factor(word):
    if len(word) == 2:
        axis = np.eye(3)["xyz".index(word[0])]
        return rp2t(angvec2r(word[1], axis), np.zeros(3))
    return transl(word)


@settings(max_examples=60, deadline=None)
@given(words=WORDS)
def test_moving_axes_multiply_on_the_right_and_fixed_ones_on_the_left(words):
    lesson = sequence_lesson(words).go(len(words))
    moving, fixed, zero, other_zero = lesson.handles[:4]
    right = left = np.eye(4)
    for word in words:
        right = right @ factor(word)
        left = factor(word) @ left
    assert np.allclose(inverse(zero.pose) @ moving.pose, right, atol=1e-9)
    assert np.allclose(inverse(other_zero.pose) @ fixed.pose, left, atol=1e-9)


@settings(max_examples=30, deadline=None)
@given(words=WORDS)
def test_the_words_backwards_about_fixed_axes_lead_to_the_same_place(words):
    one = sequence_lesson(words).go(len(words)).handles
    other = sequence_lesson(words[::-1]).go(len(words)).handles
    assert np.allclose(
        inverse(one[2].pose) @ one[0].pose, inverse(other[3].pose) @ other[1].pose, atol=1e-9
    )


def test_a_word_that_is_none_is_refused():
    with pytest.raises(InputError, match="word 2: no axis 'w'; use 'x', 'y' or 'z'"):
        sequence_lesson([("x", 90 * deg), ("w", 1.0)])
    with pytest.raises(InputError, match="word 1 must be an axis with an angle"):
        sequence_lesson([(1, 2)])
