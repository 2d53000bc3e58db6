"""Panel and robot: two ways, one message, no echo, no leak."""

import gc
import math
import time
import weakref

import ipywidgets
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from numpy import pi

from dhlab import Panel, View, animate, dh, models, robot, robot_complex, side_by_side
from dhlab.errors import InputError

Q0 = np.r_[0, -pi, 0, pi / 2, pi / 2, pi / 2, pi, -pi / 8, pi / 2, 0, 0, np.zeros(16)]
QT = np.r_[
    [0, -pi / 2, 0, pi, pi / 2, pi / 2, pi, 0, pi / 8, pi / 8, pi / 8],
    np.tile([0, -pi / 16, -pi / 8, -pi / 8], 4),
]


def open_widgets():
    """Number of widgets that ipywidgets keeps."""
    gc.collect()
    return len(ipywidgets.widgets.widget._instances)


def shown(panel):
    """Values of a panel's sliders in rad or m."""
    return np.array([s.reading.meant(s.value) for s in panel.sliders])


def titles(panel):
    return [group.title.description for group in panel._open().groups]


# ---- what is there ----


def test_the_limb_has_27_sliders_in_6_groups_in_the_order_of_the_paper(limb):
    groups = Panel(limb)._open().groups
    assert [(g.component.name, len(g.sliders)) for g in groups] == [
        ("arm", 7), ("thumb", 4), ("index", 4), ("middle", 4), ("ring", 4), ("little", 4),
    ]  # fmt: skip


def test_groups_carry_names_and_colours_of_the_components(limb):
    for group in Panel(limb)._open().groups:
        red, green, blue = (round(255 * c) for c in group.component.color)
        color = f"#{red:02x}{green:02x}{blue:02x}"
        assert group.title.description == group.component.name
        assert group.sliders[0].style.handle_color == color
        assert color in group.box.layout.border_left


def test_sliders_are_in_degrees_between_the_limits(limb):
    panel = Panel(limb)
    for slider, (lower, upper), q in zip(panel.sliders, limb.limits, limb.q, strict=True):
        assert (slider.min, slider.max) == pytest.approx(np.degrees((lower, upper)))
        assert slider.value == np.degrees(q)
        assert slider.continuous_update is False


def test_prismatic_joints_are_in_millimetres_or_metres_and_say_when_they_have_no_limits(scara):
    panel = Panel(scara)
    assert [s.reading.unit for s in panel.sliders] == ["°", "mm", "mm"]
    assert panel.sliders[1].value == 100
    (group,) = panel._open().groups
    (note,) = [w.value for w in group.rows.children if isinstance(w, ipywidgets.Label)]
    assert note == "d₃ has no limits: its slider goes from −500 to 500 mm"


def test_a_simple_robot_has_one_group_and_part_of_a_limb_its_own(limb):
    assert titles(Panel(robot([dh(0, 0, 0, 0)], "r", name="one"))) == ["one"]
    hand = limb.attached[0]
    panel = Panel(hand)
    assert len(panel.sliders) == hand.n == 20
    panel.sliders[0].value = -45
    assert limb.q[7] == -pi / 4


def test_a_panel_of_something_else_is_refused():
    with pytest.raises(InputError, match=r"a panel needs a robot, got 3"):
        Panel(3)


def test_a_panel_reads_as_its_groups(limb):
    groups = "arm (7), thumb (4), index (4), middle (4), ring (4), little (4)"
    assert repr(Panel(limb)) == f"Panel of 'arm': {groups}"


# ---- both ways ----


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=25)
@given(seed=st.integers(0, 2**32 - 1))
def test_the_sliders_always_show_the_robot(limb, seed):
    panel = Panel(limb)
    generator = np.random.default_rng(seed)
    for _ in range(5):
        limb.q = generator.uniform(*limb.limits.T)
        assert [s.value for s in panel.sliders] == np.degrees(limb.q).tolist()


def test_a_slider_moves_its_joint_and_no_other_by_a_bit(limb):
    limb.q = np.random.default_rng(3).uniform(*limb.limits.T)
    before = limb.q
    panel = Panel(limb)
    panel.sliders[12].value = -33.3
    assert limb.q[12] == np.radians(-33.3)
    assert np.array_equal(np.delete(limb.q, 12), np.delete(before, 12))


def test_a_slider_at_its_end_is_the_limit_bit_for_bit(limb):
    panel = Panel(limb)
    for end in ("min", "max"):
        for slider in panel.sliders:
            slider.value = getattr(slider, end)
        assert np.array_equal(limb.q, limb.limits[:, 0 if end == "min" else 1])


def test_one_change_of_the_robot_is_one_message_and_none_comes_back(page, limb):
    time.sleep(0.05)
    page.forget()
    limb.q = Q0
    assert [data["method"] for _, data in page.told] == ["update"]
    assert page.told[0][1]["buffer_paths"] == [["values"]]
    assert not page.told[0][1]["state"]
    assert sum(len(b) for c in page._comms for _, bs in c.sent for b in bs) == 8 * 29
    assert page.values[2] == np.degrees(Q0).tolist()
    assert np.array_equal(limb.q, Q0)


def test_a_motion_ends_bit_for_bit_where_it_was_planned(page, limb):
    animate(np.linspace(0, 5, 51), {limb: lambda t: Q0 + t / 5 * (QT - Q0)})
    assert np.array_equal(limb.q, Q0 + 1.0 * (QT - Q0))
    page.panel.flush()
    assert page.values[2] == [s.value for s in page.panel.sliders] == np.degrees(limb.q).tolist()
    clocks = page.link.clocks
    assert len(clocks) == 27
    assert set(clocks) == {limb.components[0].curves[0].clock.key}
    limb.q = Q0
    page.panel.flush()
    assert set(page.link.clocks) == {""}


def test_ten_thousand_changes_are_few_messages_and_the_last_one_counts(page, limb):
    way = np.linspace(Q0, QT, 10_000)
    page.forget()
    began = time.perf_counter()
    for q in way:
        limb.q = q
    took = time.perf_counter() - began
    time.sleep(0.1)
    assert page.values[2] == np.degrees(QT).tolist()
    assert len(page.told) < 5 + 70 * (took + 0.1)


def test_observers_of_a_slider_hear_of_the_robot_and_do_not_move_it(page, limb):
    heard = []
    page.panel.sliders[0].observe(lambda change: heard.append(change.new), "value")
    before = limb.q
    limb.components[0].q = limb.components[0].clip(before[:7] + 0.1)
    page.panel.flush()
    assert heard == [np.degrees(limb.q[0])]
    assert not page.panel._moves.history.can_undo


def test_two_panels_of_one_robot_follow_each_other(limb):
    a, b = Panel(limb), Panel(limb)
    b.sliders[0].value = 12
    assert a.sliders[0].value == pytest.approx(12)


@pytest.mark.parametrize("shift", [0, 0.012345])
def test_looking_at_a_typed_value_moves_nothing(page, limb, shift):
    limb.q = limb.clip(limb.home + shift)
    before = limb.q
    for index, slider in enumerate(page.panel.sliders):
        for rounded in (math.floor(10 * slider.value + 0.5), math.ceil(10 * slider.value - 0.5)):
            page.release(index, rounded / 10)
    assert np.array_equal(limb.q, before)


def test_a_typed_value_moves_its_joint(page, limb):
    for value in (12.5, 12.45, 12.3):
        page.release(0, value)
        assert limb.q[0] == np.radians(value)


def test_a_drag_moves_the_robot_and_is_answered(page, limb):
    for number, value in enumerate((1.0, 2.0, 3.0), start=1):
        page.drag(number, 1, 0, value)
    page.release(0, 3.0)
    page.panel.flush()
    assert limb.q[0] == np.radians(3)
    assert page.values[1] == 3


def test_the_page_is_told_nothing_that_it_knows(page, limb):
    page.panel.flush()
    page.forget()
    limb.look = "stick"
    page.panel.flush()
    assert page.told == []


def test_a_drag_that_changes_nothing_is_answered_too(page, limb):
    page.drag(7, 1, 0, np.degrees(limb.q[0]))
    page.panel.flush()
    assert page.values[1] == 7


def test_a_value_from_the_page_near_a_limit_is_the_limit(page, limb):
    page.drag(1, 1, 0, float(np.degrees(np.float32(pi / 2 - 5e-7))))
    assert limb.q[0] == limb.limits[0, 1]


# ---- buttons and history ----


def test_home_zero_and_random_keep_to_the_limits(limb):
    panel = Panel(limb, seed=5)
    panel.zero()
    lower, upper = limb.limits.T
    allowed = (lower <= 0) & (upper >= 0)
    assert np.array_equal(limb.q, np.where(allowed, 0, limb.home))
    panel.random()
    assert (limb.q >= lower).all()
    assert (limb.q <= upper).all()
    panel.home()
    assert np.array_equal(limb.q, limb.home)


def test_a_random_configuration_comes_again_with_its_seed():
    first, second = models.upper_limb(), models.upper_limb()
    Panel(first, seed=5).random()
    Panel(second, seed=5).random()
    assert np.array_equal(first.q, second.q)


def test_a_drag_is_undone_at_once_and_done_again(page, limb):
    start = limb.q
    for number, value in enumerate(np.linspace(0, 40, 9), start=1):
        page.drag(number, 1, 0, value)
    page.release(0, 41.0)
    page.drag(10, 0, 0, 41.0)
    end = limb.q
    page.panel.undo()
    assert np.array_equal(limb.q, start)
    page.panel.undo()
    assert np.array_equal(limb.q, start)
    page.panel.redo()
    assert np.array_equal(limb.q, end)


def test_two_drags_are_undone_one_after_the_other(page, limb):
    start = limb.q
    page.drag(1, 1, 0, 10.0)
    page.drag(2, 2, 0, 20.0)
    page.drag(3, 3, 1, -100.0)
    page.panel.undo()
    assert limb.q[:2] == pytest.approx([np.radians(20), start[1]])
    page.panel.undo()
    assert limb.q[0] == np.radians(10)
    page.panel.undo()
    assert np.array_equal(limb.q, start)


def test_a_drag_is_one_move_also_when_the_slider_tells_before_the_hand(page, limb):
    start = limb.q
    page.release(0, 10.0)
    page.drag(1, 1, 0, 10.0)
    page.release(0, 20.0)
    page.drag(2, 1, 0, 30.0)
    page.drag(3, 0, 0, 30.0)
    page.panel.undo()
    assert np.array_equal(limb.q, start)


def test_a_drag_after_typing_is_a_move_of_its_own(page, limb):
    page.release(0, 10.0)
    page.drag(1, 1, 0, 11.0)
    page.panel.undo()
    assert limb.q[0] == np.radians(10)


def test_typing_after_a_drag_is_a_move_of_its_own(page, limb):
    page.drag(1, 1, 0, 10.0)
    page.release(0, 10.0)
    page.drag(2, 0, 0, 10.0)
    page.release(0, 30.0)
    page.panel.undo()
    assert limb.q[0] == np.radians(10)


@pytest.mark.parametrize("move", ["code", "undo"])
def test_a_hand_that_lets_go_late_leaves_what_has_moved_the_robot_since(page, limb, move):
    start = limb.q
    page.drag(1, 1, 0, 10.0)
    if move == "code":
        limb.q = start
    else:
        page.panel.undo()
    page.drag(2, 0, 0, 10.0)
    page.panel.flush()
    assert np.array_equal(limb.q, start)
    assert page.values[1] == 2


def test_a_hand_that_lets_go_elsewhere_than_it_last_told_moves_the_robot_there(page, limb):
    page.drag(1, 1, 0, 10.0)
    page.drag(3, 0, 0, 20.0)
    assert limb.q[0] == np.radians(20)


def test_undo_passes_over_what_code_did(page, limb):
    page.release(0, 10.0)
    limb.q = Q0
    page.release(0, 30.0)
    page.panel.undo()
    assert np.array_equal(limb.q, Q0)


def test_buttons_do_what_the_methods_do_and_tell_when_they_can(page, limb):
    buttons = page.panel._open().buttons
    assert buttons["undo"].disabled
    buttons["random"].click()
    page.panel.flush()
    assert not buttons["undo"].disabled
    assert buttons["redo"].disabled
    buttons["undo"].click()
    page.panel.flush()
    assert np.array_equal(limb.q, limb.home)
    assert buttons["undo"].disabled
    assert not buttons["redo"].disabled


def test_copy_sends_the_code_to_the_page(page):
    page.forget()
    page.panel._open().buttons["copy"].click()
    assert [d["content"] for _, d in page.told] == [{"text": page.panel.code}]


# ---- a robot that becomes another ----


def test_a_robot_that_is_attached_gets_a_group():
    arm = robot([dh(0, 0, 0, 0)], "r", name="arm")
    panel = Panel(arm)
    assert titles(panel) == ["arm"]
    arm.connect(robot([dh(0, 0.1, 0, 0)], "r", name="finger"))
    assert titles(panel) == ["arm", "finger"]
    panel.sliders[1].value = 5
    assert arm.q[1] == np.radians(5)


@pytest.mark.parametrize(
    "change",
    [
        lambda r: r.set(limits=[(-1, 1)]),
        lambda r: setattr(r, "name", "other"),
        lambda r: setattr(r, "color", "#123456"),
        lambda r: setattr(r, "chain", r.chain.replace(offset=[0.5])),
    ],
)
def test_a_change_of_what_a_group_shows_is_a_new_group(change):
    arm = robot([dh(0, 0, 0, 0)], "r", name="arm")
    panel = Panel(arm)
    box, slider = panel.widget, panel.sliders[0]
    arm.chain = arm.chain.replace(1, a=0.3)
    assert panel.sliders[0] is slider
    change(arm)
    assert panel.sliders[0] is not slider
    assert panel.widget is box
    count = open_widgets()
    arm.color = "#654321"
    panel.flush()
    assert open_widgets() == count


def test_a_group_stays_folded_when_it_is_made_anew(limb):
    panel = Panel(limb)
    group = panel._open().groups[1]
    group.title.value = False
    assert group.rows.layout.display == "none"
    limb.color = "#123456"
    panel.flush()
    assert [g.folded for g in panel._open().groups] == [False, True, False, False, False, False]


def test_a_joint_without_limits_that_turns_on_gets_a_longer_slider_now_and_then():
    arm = robot([dh(0, 0, 0, 0)], "r", name="arm")
    panel = Panel(arm)
    sliders = set()
    for turn in np.linspace(0, 100, 300):
        arm.q = [turn]
        sliders.add(panel.sliders[0])
        assert panel.sliders[0].value == pytest.approx(np.degrees(turn))
    assert len(sliders) < 8


def test_a_complex_without_joints_has_an_empty_panel():
    r = robot_complex(robot([], "", name="post"), name="nothing")
    panel = Panel(r)
    assert panel.sliders == ()
    panel.home()
    panel.random()
    assert repr(panel) == "Panel of 'nothing': no joints"


# ---- what it leaves behind ----


def test_a_panel_that_goes_closes_its_widgets(comms, limb):
    before = open_widgets()
    panel = Panel(limb)
    panel.widget  # noqa: B018
    assert open_widgets() > before
    gone = weakref.ref(panel)
    del panel
    gc.collect()
    assert gone() is None
    assert open_widgets() == before
    assert all(comm.is_closed for comm in comms)


def test_fifty_panels_cost_what_one_costs(limb):
    panel = Panel(limb)
    panel.widget  # noqa: B018
    count = open_widgets()
    for _ in range(50):
        panel = Panel(limb)
        panel.widget  # noqa: B018
    assert open_widgets() == count
    limb.q = Q0
    assert panel.sliders[0].value == 0


def test_a_panel_can_be_closed_twice_and_opened_again(comms, limb):
    before = open_widgets()
    panel = Panel(limb)
    panel.close()
    panel.sliders[0].value = 10
    panel.close()
    panel.close()
    assert open_widgets() == before
    limb.q = Q0
    assert np.array_equal(shown(panel), Q0)
    panel.undo()
    assert np.array_equal(limb.q, limb.home)


def test_a_view_and_a_panel_go_side_by_side(limb):
    beside = side_by_side(View("limb").add(limb), Panel(limb))
    assert repr(beside).startswith("View('limb': arm) beside Panel of 'arm'")
    with pytest.raises(InputError, match="needs a view and a panel, got a Robot and a Panel"):
        side_by_side(limb, beside.panel)
