"""Every lesson of the course: it runs, asks before it shows, and what it says is true."""

import json
import re

import numpy as np
import pytest

from dhlab import Choice, Place, View, deg, inverse, transl
from dhlab.lessons import course
from dhlab.view.recording import RecordingBackend

NAMES = list(course.LESSONS)


@pytest.mark.parametrize("name", NAMES)
def test_a_lesson_can_be_visited_in_any_order_and_told_as_plain_data(name):
    lesson = course.LESSONS[name]()
    count = len(lesson.steps)
    for k in (*range(count + 1), *reversed(range(count + 1))):
        lesson.go(k)
    backend = RecordingBackend()
    View("v", backend=backend).add(*lesson.handles).flush()
    assert backend.nodes
    json.dumps(lesson.describe(), allow_nan=False)


@pytest.mark.parametrize("name", NAMES)
def test_texts_are_whole_and_their_formulas_closed(name):
    lesson = course.LESSONS[name]()
    for step in lesson.steps:
        texts = [step.title, step.text]
        if step.question is not None:
            texts += [step.question.text, step.question.because or "none"]
            texts += step.question.choices if isinstance(step.question, Choice) else []
        for text in texts:
            assert text
            assert len(re.findall(r"\$", text)) % 2 == 0, text
            assert text.count("{") == text.count("}"), text
        assert step.text.rstrip().endswith((".", "$$", "?")), step.text


@pytest.mark.parametrize("name", [n for n in NAMES if n not in ("right_hand", "sticks_or_bodies")])
def test_no_step_but_the_first_gives_away_its_successor(name):
    lesson = course.LESSONS[name]()
    asked = [step for step in lesson.steps if step.question is not None]
    assert asked, "a lesson asks for a prediction"
    for step in asked:
        assert step.moves, "what was predicted is then seen"


def test_a_point_is_1_0_0_in_b():
    lesson = course.one_point_two_frames().go(3)
    A, B, P, Q = (h for h in sorted(lesson.handles, key=lambda h: h.name))
    assert np.allclose(inverse(B.pose) @ P.pose[:, 3], (1, 0, 0, 1))
    assert np.allclose(inverse(A.pose) @ P.pose[:, 3], (1, 1, 0, 1))
    assert np.allclose(P.pose[:3, 3], Q.pose[:3, 3])


def test_z_of_b_points_along_minus_y():
    lesson = course.right_hand().go(1)
    B = next(h for h in lesson.handles if h.name == "B")
    assert np.allclose(B.pose[:3, 2], (0, -1, 0))
    assert np.allclose(B.pose[:3, 1], (0, 0, 1))


def test_the_two_orders_differ_and_are_undone():
    lesson = course.order_matters()
    B, C = (next(h for h in lesson.handles if h.name == name) for name in "BC")
    lesson.go(2)
    assert not np.allclose(B.pose[:3, :3], C.pose[:3, :3])
    lesson.go(3)
    assert not np.allclose(C.pose[:3, :3], np.eye(3))


def test_who_goes_up():
    lesson = course.moving_or_fixed()
    M, F = lesson.handles[:2]
    before = lesson.go(2).timeline.states
    lesson.go(3)
    rise = [lesson.timeline.states[3][h][2, 3] - before[2][h][2, 3] for h in (M, F)]
    assert np.allclose(rise, (0, 0.6), atol=1e-9)


def test_the_detour_ends_in_c():
    lesson = course.detour()
    F = lesson.product_of
    start, _, end = (state[F] for state in lesson.timeline.states)
    C = next(h for h in lesson.handles if h.name == "C")
    assert np.allclose(start @ (inverse(start) @ end), C.pose)


def test_roll_and_yaw_are_one_turn_when_the_pitch_is_90():
    lesson = course.gimbal_lock().go(2)
    B, C = (next(h for h in lesson.handles if h.name == name) for name in "BC")
    assert np.allclose(B.pose[:3, :3], C.pose[:3, :3], atol=1e-9)
    other = course.gimbal_lock(60 * deg).go(2)
    B, C = (next(h for h in other.handles if h.name == name) for name in "BC")
    assert not np.allclose(B.pose[:3, :3], C.pose[:3, :3], atol=1e-3)


def test_the_same_numbers_are_three_orientations():
    lesson = course.three_conventions().go(3)
    R, Y, E = (next(h for h in lesson.handles if h.name == n).pose[:3, :3] for n in "RYE")
    for one, other in ((R, Y), (Y, E), (R, E)):
        assert not np.allclose(one, other, atol=0.1)


def test_the_bent_arm_stands_like_the_straight_one():
    lesson = course.zero_pose_is_a_choice().go(2)
    straight, bent = lesson.handles
    shift = transl((0, -1.4, 0))
    tips = straight.frames()["straight/grasper"], bent.frames()["bent/grasper"]
    assert np.allclose(shift @ tips[0], tips[1], atol=1e-12)


def test_ben_renamed_reaches_what_ann_reaches():
    lesson = course.two_right_tables().go(3)
    ann, ben = lesson.handles
    tips = ann.frames()["Ann/grasper"], ben.frames()["Ben/grasper"]
    assert np.allclose(tips[0][:3, 3] + (0, -1.8, 0), tips[1][:3, 3], atol=1e-9)
    lesson.go(2)
    assert not np.allclose(
        ann.frames()["Ann/grasper"][:3, 3] + (0, -1.8, 0), ben.frames()["Ben/grasper"][:3, 3]
    )


def test_the_right_sign_lays_z_along_the_pin():
    lesson = course.sign_of_twist().go(2)
    by_name = {h.name: h for h in lesson.handles}
    along = by_name["next axis"].pose[:3, 2]
    assert np.allclose(by_name["plus"].pose[:3, 2], along)
    assert np.allclose(by_name["minus"].pose[:3, 2], -along)


def test_modified_and_standard_readings_differ_unless_half_a_row_is_zero():
    def gap(**row):
        lesson = course.one_table_two_readings(**row)
        k = len(lesson.steps)
        M, S = (next(h for h in lesson.handles if h.name == n) for n in "MS")
        state, start = lesson.timeline.states[k], lesson.timeline.states[0]
        return np.abs(inverse(start[M]) @ state[M] - inverse(start[S]) @ state[S]).max()

    assert gap() > 0.1
    assert gap(alpha=0.0, a=0.0) < 1e-12
    assert gap(d=0.0, theta=0.0) < 1e-12


def test_the_forearm_is_where_the_answer_says():
    lesson = course.offset_forgotten().go(2)
    right = lesson.handles[0]
    x = right.frames()["right/2"][:3, 0]
    assert np.allclose(x, (1, 0, 0), atol=1e-9)
    turns, rest = divmod(np.degrees(90), 360)
    assert (turns, round(rest, 1)) == (14, 116.6)


def test_base_rows_and_tool_lead_to_the_tip():
    lesson = course.base_and_tool().go(3)
    arm = next(h for h in lesson.handles if h.name == "arm")
    assert np.allclose(lesson.product_of.pose, arm.frames()["arm/grasper"], atol=1e-12)


def test_the_common_normal_s_frames_end_on_the_second_axis():
    for make, name in ((course.common_normal, "axis 2"), (course.frame_in_the_air, "axis 2")):
        lesson = make()
        lesson.go(len(lesson.steps))
        axis = next(h for h in lesson.handles if h.name == name).pose
        F = lesson.product_of.pose
        assert np.allclose(np.abs(F[:3, 2] @ axis[:3, 2]), 1, atol=1e-9)
        assert np.allclose(np.cross(axis[:3, 3] - F[:3, 3], axis[:3, 2]), 0, atol=1e-9)


def test_one_finger_bends_and_the_others_stay():
    lesson = course.branching()
    hand = lesson.handles[0]
    before, after = (hand.frames(lesson.timeline.states[k][hand]) for k in (3, 4))
    moved = {name.split("/")[1] for name in before if not np.allclose(before[name], after[name])}
    assert moved == {"index"}


def test_the_three_looks_reach_the_same_place():
    lesson = course.sticks_or_bodies().go(1)
    hands = [
        inverse(limb.world_pose) @ next(T for n, T in limb.frames().items() if n.endswith("/7"))
        for limb in lesson.handles
    ]
    for other in hands[1:]:
        assert np.allclose(hands[0], other, atol=1e-12)


def test_places_are_where_the_step_leads():
    for name in NAMES:
        lesson = course.LESSONS[name]()
        for k, step in enumerate(lesson.steps, start=1):
            if isinstance(step.question, Place):
                target = np.array(lesson.describe()["steps"][k - 1]["question"]["target"])
                assert np.allclose(lesson.go(k).timeline.states[k][step.question.what], target)
