"""Tasks whose answer is a matrix."""

import numpy as np
import pytest

from dhlab.diagnosis import MatrixTask, slide, turn
from dhlab.diagnosis.after import after_slips
from dhlab.diagnosis.product import evaluate_products
from dhlab.diagnosis.product_slips import product_slips
from dhlab.kinematics.transforms import rotx, roty, rp2t

FACTORS = [turn("z", lambda t, p: t), slide(lambda t, p: (p, 0.2, -0.1)), turn("x", 0.7)]
INPUTS = [(0.3, 0.5), (-1.1, 0.8), (2.0, -0.4)]


def made(task, *chain):
    values = []
    for inputs in INPUTS:
        model = task._model(inputs)
        for slip in chain:
            model = slip.change(model)
        values.append((inputs, evaluate_products([model])[0][: task.size, : task.size].tolist()))
    return values


def keys(verdict):
    groups = verdict.either or ((verdict.mistakes,) if verdict.mistakes else ())
    return [{m.key for m in group} for group in groups]


@pytest.mark.parametrize("about", [None, "moving", "fixed"])
def test_each_mistake_in_a_product_is_named(about):
    task = MatrixTask(*FACTORS, about=about)
    for slip in product_slips(task._model(INPUTS[0]).moves, about, rotation=False):
        verdict = task.judge(made(task, slip))
        assert verdict.right or {slip.mistake.key} in keys(verdict)


def test_random_pairs_of_mistakes_are_named_or_explained_by_fewer():
    task = MatrixTask(*FACTORS)
    slips = product_slips(task._model(INPUTS[0]).moves, None, rotation=False)
    slips = [s for s in slips if not s.alone]
    rng, named, tried = np.random.default_rng(1), 0, 0
    for _ in range(60):
        i, j = sorted(rng.choice(len(slips), 2, replace=False))
        verdict = task.judge(made(task, slips[i], slips[j]))
        if verdict.right:
            continue
        tried += 1
        pair = {slips[i].mistake.key, slips[j].mistake.key}
        named += pair in keys(verdict) or any(len(group) == 1 for group in keys(verdict))
    share = f"pairs of mistakes named: {named} of {tried}"
    assert named >= 0.95 * tried, share


def test_a_mistake_that_is_not_known_is_not_named():
    task = MatrixTask(turn("z", lambda t, p: t), size=3)
    odd = [(i, (np.eye(3) + 0.1 * np.arange(9).reshape(3, 3)).tolist()) for i in INPUTS]
    verdict = task.judge(odd)
    assert not verdict.right
    assert not verdict.mistakes
    assert "no rotation matrix" in verdict.text


@pytest.mark.parametrize(
    ("value", "sentence"),
    [
        (None, "is None"),
        ("eye(3)", "is text"),
        ([[1, 2], [3]], "rows of different lengths"),
        (np.eye(4), r"has shape \(4, 4\); shape \(3, 3\)"),
        (np.full((3, 3), np.nan), "holds nan"),
        (np.full((3, 3), np.inf), "infinite"),
        (np.full((3, 3), 1e300), "immense"),
        ({"a": 1}, "not made of numbers"),
        ([[1j] * 3] * 3, "not made of numbers"),
    ],
)
def test_what_is_no_matrix_gets_a_sentence(value, sentence):
    verdict = MatrixTask(turn("z", 0.5), size=3).judge([((), value)])
    assert not verdict.right
    with pytest.raises(ValueError, match=sentence):
        raise ValueError(verdict.text)


def test_a_left_handed_frame_is_named():
    task = MatrixTask(*FACTORS)
    (flip,) = [c for m, c in after_slips(rotation=False) if m.key == "left-handed-y"]
    wrong = [(i, flip(task.reference(*i))) for i in INPUTS]
    assert {"left-handed-y"} in keys(task.judge(wrong))
    assert "left-handed" in task.judge(wrong).seen


def test_one_coordinate_with_the_wrong_sign_is_named_alone():
    tool = (slide((0.4, 0, 0)), turn("y", 0.6), slide((0.15, 0, 0)))
    right = rp2t(roty(0.6), (0.4 + 0.15 * np.cos(0.6), 0, -0.15 * np.sin(0.6)))
    task = MatrixTask(*tool)
    assert task.judge([((), right)]).right
    right[2, 3] *= -1
    assert keys(task.judge([((), right)])) == [{"origin-sign-z"}]


def test_what_is_seen_says_of_turn_and_origin_what_is_off():
    task = MatrixTask(turn("z", 0.5), slide((0.3, 0, 0)))
    came = rp2t(rotx(0.2), (0.1, 0.7, 0.2))
    text = task.judge([((), came)]).text
    assert "The frame is turned away from the wanted one by 30.8 degrees about an axis" in text
    assert "; its origin is 613 mm off, most of it along y." in text
