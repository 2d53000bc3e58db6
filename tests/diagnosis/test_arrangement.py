"""Coordinate systems in a scene."""

import numpy as np
import pytest

from dhlab import View, csys
from dhlab.diagnosis import ArrangementTask, MatrixTask, slide, turn
from dhlab.diagnosis.arrangement import Placed, arrangement_slips, evaluate_placed
from dhlab.errors import InputError
from dhlab.kinematics.angles import rpy2r
from dhlab.kinematics.transforms import inverse, rotx, rotz, rp2t, transl

PARENTS = {"B": "A", "C": "B"}


def random_task(rng):
    def pose():
        return rp2t(rpy2r(*rng.uniform(-2, 2, 3)), rng.uniform(-1, 1, 3))

    moves = MatrixTask(turn("z", rng.uniform(0.2, 2)), slide(rng.uniform(-1, 1, 3)))
    return ArrangementTask({"A": pose(), "B": moves, "C": pose(), "D": pose()}, PARENTS)


def placed_wrongly(task, rng, name):
    """An arrangement with a mistake in one frame, those that hang on it carried along or not."""
    wanted = task.reference()
    parent = wanted.get(PARENTS.get(name), np.eye(4))
    model = Placed(task._products(())[name], parent, wanted, wanted)
    slips = arrangement_slips(model, name, PARENTS.get(name), list(task.frames))
    slip = slips[rng.integers(len(slips))]
    drawn = wanted | {name: evaluate_placed([slip.change(model)])[0]}
    if rng.integers(2):
        for child in "BC":
            if PARENTS[child] == name or (name == "A" and child == "C"):
                in_parent = np.linalg.inv(wanted[PARENTS[child]]) @ wanted[child]
                drawn[child] = drawn[PARENTS[child]] @ in_parent
    return drawn, slip.mistake.key


def test_a_frame_out_of_place_is_named_with_its_mistake(tally):
    rng = np.random.default_rng(1)
    for _ in range(300):
        task = random_task(rng)
        tally.judge(task, [((), task.reference() | {"E": np.eye(4)})])
        name = "ABCD"[rng.integers(4)]
        drawn, key = placed_wrongly(task, rng, name)
        verdict = tally.judge(task, [((), drawn)], {key})
        assert verdict.right or name in verdict.text
    tally.check()


def test_two_frames_out_of_place_are_both_named(keys):
    frames = {"A": rp2t(rotx(0.4), (1, 0, 0)), "B": rp2t(rotx(1), (0, 2, 0))}
    task = ArrangementTask(frames, {"B": "A"})
    verdict = task.judge([((), {"A": np.linalg.inv(frames["A"]), "B": frames["B"]})])
    assert {"inverse", "in-world"} in keys(verdict)
    assert "B is out of place too" in verdict.text


def test_a_frame_that_hangs_on_a_wrong_one_only_goes_with_it():
    frames = {"A": transl((1, 0, 0)), "B": transl((0, 2, 0)), "C": transl((0, 0, 3))}
    task = ArrangementTask(frames, {"B": "A", "C": "B"})
    wrong = rp2t(rotx(np.pi / 6), (1, 0, 0))
    drawn = {"A": wrong, "B": wrong @ frames["B"], "C": wrong @ frames["B"] @ frames["C"]}
    text = task.judge([((), drawn | {"A": wrong})]).text
    assert "All frames are right among each other" in text
    drawn = {"A": frames["A"], "B": frames["A"] @ frames["B"] @ wrong}
    drawn["C"] = drawn["B"] @ frames["C"]
    text = task.judge([((), drawn)]).text
    assert "Frame B is turned away from the wanted one by 30 degrees about the fixed x axis" in text
    assert "C only goes with it" in text


def test_csys_in_a_view_are_an_arrangement():
    from dhlab.grading.values import from_json, to_json

    frames = {"A": transl((1, 0, 0)), "B": rp2t(rotx(0.5), (0, 2, 0))}
    task = ArrangementTask(frames)
    view = View("scene").add(csys(frames["A"], name="A"), csys(frames["B"], name="B"))
    assert task.judge([((), from_json(to_json(view, "scene")))]).right


@pytest.mark.parametrize(
    ("value", "sentence"),
    [
        (None, "A scene with named coordinate systems"),
        ([np.eye(4)], "A scene with named coordinate systems"),
        ({"a": np.eye(4)}, "Not in the scene: A, B. Does each have its name?"),
        ({"A": np.eye(4), "B": np.eye(3)}, "The pose of B has shape"),
    ],
)
def test_what_is_no_arrangement_gets_a_sentence(value, sentence):
    task = ArrangementTask({"A": transl((1, 0, 0)), "B": transl((0, 2, 0))})
    assert sentence in task.judge([((), value)]).text


def test_parents_come_first():
    with pytest.raises(InputError, match="parent 'B' of 'A' must be a frame before it"):
        ArrangementTask({"A": np.eye(4), "B": np.eye(4)}, {"A": "B"})
    with pytest.raises(InputError, match="at least one frame"):
        ArrangementTask({})


def test_a_pose_that_is_inverted_is_told_in_one_way(keys):
    pose = rp2t(rotz(0.5), (0.1, 0.2, 0.3))
    verdict = ArrangementTask({"H": pose}).judge([((), {"H": inverse(pose)})])
    assert keys(verdict) == [{"inverse"}]


def test_a_frame_left_in_the_origin_is_told_in_one_way(keys):
    frames = {"R": np.eye(4), "H": rp2t(rotz(0.5), (0.1, 0.2, 0.3))}
    verdict = ArrangementTask(frames).judge([((), {"R": np.eye(4), "H": np.eye(4)})])
    assert keys(verdict) == [{"not-moved"}]
