"""Lessons: any order of visits, live equals fresh, what is drawn when, predictions."""

import json

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dhlab import InputError, View, csys, cube, deg, inverse, models, rotz, rp2t, transl
from dhlab.kinematics.angles import angvec2r
from dhlab.lessons import Choice, Lesson, Place, Step, configure, move_to, slide, turn
from dhlab.lessons.product import value_of
from dhlab.view.recording import RecordingBackend

AXES = st.sampled_from("xyz")
ANGLES = st.floats(-6, 6).map(lambda x: round(x, 3))
FRAMES = st.sampled_from([None, "world", "A"])


def vector_strategy():
    return st.tuples(*3 * [st.floats(-2, 2).map(lambda x: round(x, 2))])


@st.composite
def lessons(draw):
    """Lessons of random turns and slides of a csys and a block, and of an arm."""
    A, B, brick = csys((1, 0, 0), name="A"), csys(name="B"), cube(0.3, name="brick")
    arm = models.scara()
    steps = []
    for k in range(draw(st.integers(1, 5))):
        moves = []
        for what in (B, brick):
            frame = draw(FRAMES)
            frame = A if frame == "A" else frame
            match draw(st.integers(0, 3)):
                case 0:
                    moves.append(turn(what, draw(AXES), draw(ANGLES), about=frame))
                case 1:
                    moves.append(slide(what, draw(vector_strategy()), along=frame))
                case 2:
                    pose = rp2t(rotz(draw(ANGLES)), draw(vector_strategy()))
                    moves.append(move_to(what, pose))
        if draw(st.booleans()):
            moves.append(configure(arm, arm.clip([draw(ANGLES) for _ in range(arm.n)])))
        steps.append(Step(f"step {k}", "", *moves))
    return Lesson("random", steps, handles=[A, B, brick, arm])


def scene_of(lesson):
    """What a fresh view of a lesson draws."""
    nodes = {}
    for handle in lesson.handles:
        nodes |= handle.describe()
    return nodes


def still(nodes):
    """Pose, value and place in time of all nodes: what differs between two steps."""
    return {
        path: (node.matrix.tobytes(), node.value, node.curve and node.curve.rest.time)
        for path, node in nodes.items()
    }


@settings(max_examples=40, deadline=None)
@given(lesson=lessons(), visits=st.lists(st.integers(0, 5), min_size=1, max_size=6))
def test_any_order_of_visits_gives_the_same_picture(lesson, visits):
    count = len(lesson.steps)
    straight = [still(scene_of(lesson.go(k))) for k in range(count + 1)]
    for k in (k % (count + 1) for k in visits):
        assert still(scene_of(lesson.go(k))) == straight[k]


@settings(max_examples=25, deadline=None)
@given(lesson=lessons(), visits=st.lists(st.integers(0, 5), min_size=1, max_size=6))
def test_a_live_view_equals_a_fresh_one_at_every_step(lesson, visits):
    backend = RecordingBackend()
    live = View("live", backend=backend).add(*lesson.handles)
    live.flush()
    for k in (k % (len(lesson.steps) + 1) for k in visits):
        lesson.go(k)
        live.flush()
        fresh = RecordingBackend()
        View("fresh", backend=fresh).add(*lesson.handles).flush()
        assert backend.nodes.keys() == fresh.nodes.keys()
        for path, node in fresh.nodes.items():
            old = backend.nodes[path]
            assert np.array_equal(node.matrix, old.matrix)
            assert node.span == old.span
            assert (node.curve is None) == (old.curve is None)
            if node.curve is not None:
                assert node.curve.moves_like(old.curve)
                assert node.curve.rest == old.curve.rest


def test_a_turn_about_own_axes_is_a_factor_on_the_right():
    T = rp2t(rotz(0.7), (1, 2, 3))
    B = csys(T, name="B")
    Lesson("own", [Step("turn", "", turn(B, "x", 0.4))]).go(1)
    assert np.allclose(B.pose, T @ rp2t(angvec2r(0.4, [1, 0, 0]), (0, 0, 0)), atol=1e-12)


def test_a_turn_about_the_world_s_axes_is_a_factor_on_the_left():
    T = rp2t(rotz(0.7), (1, 2, 3))
    B = csys(T, name="B")
    Lesson("fixed", [Step("turn", "", turn(B, "x", 0.4, about="world"))]).go(1)
    assert np.allclose(B.pose, rp2t(angvec2r(0.4, [1, 0, 0]), (0, 0, 0)) @ T, atol=1e-12)


def test_a_move_by_another_frame_goes_by_where_that_frame_stands():
    A = csys(rp2t(rotz(90 * deg), (1, 0, 0)), name="A")
    B = csys(name="B")
    lesson = Lesson(
        "by another",
        [Step("A moves", "", slide(A, (1, 0, 0))), Step("B", "", slide(B, (1, 0, 0), along=A))],
    )
    lesson.go(2)
    assert np.allclose(A.pose[:3, 3], (1, 1, 0), atol=1e-12)
    assert np.allclose(B.pose[:3, 3], (0, 1, 0), atol=1e-12)
    lesson.go(0)
    turned = Lesson("turn", [Step("B about A", "", turn(B, "z", 180 * deg, about=A))]).go(1)
    assert turned.at == 1
    assert np.allclose(B.pose[:3, 3], (2, 0, 0), atol=1e-12)


@settings(max_examples=40, deadline=None)
@given(lesson=lessons())
def test_the_product_is_the_pose_at_every_step(lesson):
    described = lesson.describe()
    of = lesson.product_of
    for k, step in enumerate(described["steps"], start=1):
        lesson.go(k)
        if of is not None and step["product"] is not None:
            assert np.allclose(value_of(step["product"]["factors"]), of.pose, atol=1e-9)
    json.dumps(described, allow_nan=False)


@settings(max_examples=25, deadline=None)
@given(lesson=lessons())
def test_a_lesson_moves_without_jumps(lesson):
    for track in lesson.timeline.tracks:
        if track.samples.ndim == 3:
            R = track.samples[:, :3, :3]
            turned = np.einsum("kji,kjl->kil", R[:-1], R[1:])
            cosines = (np.trace(turned, axis1=1, axis2=2) - 1) / 2
            assert (cosines > np.cos(20 * deg)).all()
    times = lesson.clock.times
    assert (np.diff(times) > 0).all()
    assert set(lesson.clock.stops) <= set(times.tolist())


def test_ghost_arc_and_arrow_are_drawn_from_their_step_on():
    B = csys(name="B")
    lesson = Lesson(
        "marks",
        [Step("turn", "", turn(B, "z", 90 * deg)), Step("slide", "", slide(B, (1, 0, 0)))],
        keep=1,
    )
    nodes = lesson.handles[0].describe()
    t0, t1, t2 = lesson.clock.stops
    arc = nodes["B.lesson/1.way"]
    assert (arc.span.begin, arc.span.grown, arc.span.end) == (t0, t1, t2)
    assert nodes["B.lesson/2.way"].span.end == float("inf")
    ends = arc.shape.points
    assert np.allclose(np.linalg.norm(ends, axis=1).max(), 0.62, atol=0.01)
    ghost = nodes["B.lesson/2.ghost"]
    assert np.allclose(ghost.pose, rp2t(rotz(90 * deg), (0, 0, 0)), atol=1e-12)
    head = nodes["B.lesson/2.way.head"]
    tip = head.pose @ (0, 0, head.shape.bounds[1, 2], 1)
    assert np.allclose(tip[:3], (0, 1, 0), atol=1e-9)


def test_a_page_that_goes_on_by_itself_is_not_called_back():
    B = csys(name="B")
    lesson = Lesson("turns", [Step("turn", "", turn(B, "z", 1.0))])
    before = B.describe()["B"].curve.rest
    lesson.follow(1)
    rest = B.describe()["B"].curve.rest
    assert (lesson.at, rest.time, rest.turn) == (1, lesson.clock.stops[1], before.turn)
    assert lesson.go(0).at == 0
    assert B.describe()["B"].curve.rest.turn == before.turn + 1


def test_assigning_stops_a_handle_and_going_anywhere_takes_it_up_again():
    B = csys(name="B")
    lesson = Lesson("turns", [Step("turn", "", turn(B, "z", 1.0))]).go(1)
    B.pose = transl((5, 5, 5))
    assert B.describe()["B"].curve is None
    lesson.go(0)
    assert np.array_equal(B.pose, np.eye(4))
    assert B.describe()["B"].curve is not None


def test_one_step_is_a_small_message(monkeypatch):
    from dhlab.view.commands import diff
    from dhlab.view.wire import Wire

    B = csys(name="B")
    lesson = Lesson("turns", [Step(f"turn {k}", "", turn(B, "z", 1.0)) for k in range(20)])
    before = scene_of(lesson)
    wire = Wire({})
    wire.batch(diff({}, before))
    header, buffer = wire.batch(diff(before, scene_of(lesson.go(7))))
    assert len(json.dumps(header)) + len(buffer) < 400
    assert header["rests"] == {lesson.clock.key: [lesson.clock.stops[7], 1]}
    assert "curves" not in header


def test_a_choice_is_judged_and_kept(tmp_path):
    B = csys(name="B")
    question = Choice("Where?", ["here", "there"], answer=1, because="It moves.")
    lesson = Lesson("asks", [Step("slide", "", slide(B, (1, 0, 0)), question=question)])
    assert not lesson.answer(1, 0)["right"]
    assert lesson.answer(1, 1)["right"]
    kept = json.loads(lesson.save_answers(tmp_path / "answers.json").read_text("utf-8"))
    assert kept["lesson"] == "asks"
    assert [(a["step"], a["words"], a["right"]) for a in kept["answers"]] == [(1, "there", True)]


def test_a_place_is_compared_in_position_and_angle():
    B = csys(name="B")
    question = Place("Put it.", B, tolerance=(0.05, 5 * deg))
    step = Step("go", "", move_to(B, rp2t(rotz(30 * deg), (1, 0, 0))), question=question)
    lesson = Lesson("asks", [step])
    record = lesson.answer(1, (1, 0, 0.03, 33 * deg, 0, 0))
    assert record["right"]
    assert (round(record["off"], 9), round(record["turned"] / deg, 6)) == (0.03, 3.0)
    assert not lesson.answer(1, (1, 0, 0, 36 * deg, 0, 0))["right"]
    guess = lesson.handles[-1]
    q = np.array([0.3, -0.2, 0.7, 0.4, -0.3, 1.1])
    guess.q = q
    nodes = guess.describe()
    path, T = guess.name, np.eye(4)
    for letter in ("x", "y", "z", "yaw", "pitch", "roll"):
        path = f"{path}/{letter}"
        T = T @ nodes[path].matrix
    assert np.allclose(T, guess.pose, atol=1e-12)
    assert np.allclose(inverse(T) @ guess.pose, np.eye(4), atol=1e-12)


A, B = csys(name="A"), csys(name="B")


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Lesson("empty", []), "lesson 'empty' needs at least one step, got none"),
        (lambda: Lesson("x", ["turn"]), "lesson 'x': step 1 is a str, not a Step"),
        (
            lambda: Step("s", "", "turn"),
            r"step 's' needs moves \(turn, slide, move_to",
        ),
        (
            lambda: Step("s", "", turn(B, "z", 1), slide(B, (1, 0, 0))),
            "step 's' moves 'B' twice; make it two steps",
        ),
        (lambda: turn(B, "w", 1), "no axis 'w'; use 'x', 'y', 'z' or a vector"),
        (lambda: turn(B, (0, 0, 0), 1), "axis must not be the zero vector"),
        (lambda: turn(B, "z", 1, about="A"), "about must be a csys, a block, 'world' or None"),
        (lambda: turn(models.scara(), "z", 1), "not a Robot; use configure for a robot"),
        (lambda: configure(B, [1]), "configure moves a robot, not a Csys"),
        (lambda: Choice("?", ["one"], 0), "a choice needs two or more different answers"),
        (lambda: Choice("?", ["a", "b"], 2), "answer must be the place of the right one, 0 to 1"),
        (
            lambda: Lesson("x", [Step("s", "", slide(B, (1, 0, 0)), question=Place("?", A))]),
            "step 's' asks where 'A' will be, and moves it not",
        ),
        (
            lambda: Lesson("x", [Step("s")], handles=[csys(name="B"), B]),
            "two handles of a lesson are called 'B'; give them names",
        ),
        (lambda: Lesson("x", [Step("s")]).go(2), r"no step 2; it has 0 \(the start\) to 1"),
        (lambda: Lesson("x", [Step("s")]).answer(1, 0), "step 1 asks nothing; steps that do: none"),
    ],
)
def test_what_cannot_be_is_said(make, message):
    with pytest.raises((InputError, TypeError), match=message):
        make()
