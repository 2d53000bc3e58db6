"""A configuration as code, and the history of what a user did."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from numpy import pi

import dhlab
from dhlab.panel.code import config_code, number_code
from dhlab.panel.history import History

numbers = (
    st.floats(allow_nan=False, allow_infinity=False, min_value=-1e6, max_value=1e6)
    | st.integers(-3600, 3600).map(lambda tenths: float(np.radians(tenths / 10)))
    | st.tuples(st.integers(-72, 72), st.integers(1, 36)).map(lambda f: f[0] * pi / f[1])
)


@given(numbers)
def test_the_code_of_a_number_gives_the_same_number(x):
    value = eval(number_code(x), {"pi": pi, "deg": dhlab.deg})
    assert value == x


@given(st.integers(-3600, 3600))
def test_what_a_slider_can_be_dragged_to_is_written_short(tenths):
    assert len(number_code(float(np.radians(tenths / 10)))) <= 10


def test_the_code_of_a_limb_gives_its_configuration_bit_for_bit(limb):
    limb.q = limb.clip(np.linspace(-3, 3, 27) / 7)
    names = {}
    text = config_code(limb.components)
    exec(text, names)
    assert np.array_equal(names["q"], limb.q)
    assert text.splitlines()[-1] == "]"
    assert [line.split("# ")[1] for line in text.splitlines() if "# " in line] == [
        component.name for component in limb.components
    ]


def test_the_code_of_the_initial_limb_reads_like_the_tables(limb):
    limb.q = limb.home
    assert config_code(limb.components).splitlines()[:4] == [
        "from numpy import pi",
        "q = [",
        "    0, -pi/2, 0, pi, 0, pi/2, pi,  # arm",
        "    -pi/8, pi/4, pi/4, pi/4,  # thumb",
    ]


configs = st.lists(st.integers(0, 99), min_size=1, max_size=30, unique=True)


@given(configs, st.data())
def test_undo_goes_back_along_the_way_and_redo_along_it_again(way, data):
    history = History()
    for before in way[:-1]:
        history.add(np.array([before]))
    steps = data.draw(st.integers(0, len(way) - 1))
    now = np.array([way[-1]])
    for _ in range(steps):
        now = history.undo(now)
    assert now == way[-1 - steps]
    for _ in range(steps):
        now = history.redo(now)
    assert now == way[-1]


def test_with_nothing_to_undo_or_redo_nothing_comes_back():
    history = History()
    assert history.undo(np.zeros(1)) is None
    assert history.redo(np.zeros(1)) is None
    assert not history.can_undo
    assert not history.can_redo


def test_a_new_move_forgets_what_was_undone():
    history = History()
    history.add(np.array([1]))
    history.undo(np.array([2]))
    history.add(np.array([3]))
    assert not history.can_redo


def test_the_history_keeps_the_newest_entries():
    history = History(length=2)
    for k in range(5):
        history.add(np.array([k]))
    assert [int(history.undo(np.array([9]))[0]) for _ in range(2)] == [4, 3]
    assert not history.can_undo
