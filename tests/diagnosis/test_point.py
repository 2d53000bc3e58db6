"""Points and directions in another frame."""

import numpy as np
import pytest

from dhlab.diagnosis import PointTask, given, inverse_of, slide, turn
from dhlab.diagnosis.point import evaluate_points, point_slips
from dhlab.errors import InputError
from dhlab.kinematics.angles import rpy2r
from dhlab.kinematics.transforms import inverse, rp2t

DETOUR = [given("T_AB", lambda AB, CB, p: AB), inverse_of(given("T_CB", lambda AB, CB, p: CB))]


def random_inputs(rng, cases=3):
    def pose():
        return rp2t(rpy2r(*rng.uniform(-2, 2, 3)), rng.uniform(-1, 1, 3))

    return [(pose(), pose(), rng.uniform(-1, 1, 3)) for _ in range(cases)]


def task(direction):
    return PointTask(*DETOUR, point=lambda AB, CB, p: p, direction=direction)


@pytest.mark.parametrize("direction", [False, True])
def test_points_are_accepted_with_and_without_their_fourth_number(direction, tally):
    rng = np.random.default_rng(1)
    for _ in range(20):
        inputs = random_inputs(rng)
        last = 0 if direction else 1
        answers = [(AB @ inverse(CB) @ [*p, last]) for AB, CB, p in inputs]
        for shape in (np.array, lambda p: p[:3], lambda p: p[:3, None].tolist()):
            cases = [(i, shape(a)) for i, a in zip(inputs, answers, strict=True)]
            tally.judge(task(direction), cases)
    tally.check(share=0)


@pytest.mark.parametrize("direction", [False, True])
@pytest.mark.parametrize("made", [1, 2])
def test_mistakes_with_points_are_named(direction, made, tally):
    rng, asked = np.random.default_rng(made), task(direction)
    for _ in range(250 // made):
        inputs = random_inputs(rng)
        slips = [s for s in point_slips(asked._model(inputs[0])) if made == 1 or not s.alone]
        chosen = [slips[k] for k in sorted(rng.choice(len(slips), made, replace=False))]
        cases = []
        for case in inputs:
            model = asked._model(case)
            for slip in chosen:
                model = slip.change(model)
            cases.append((case, evaluate_points([model])[0]))
        tally.judge(asked, cases, {s.mistake.key for s in chosen})
    tally.check()


def test_a_point_of_three_moves_says_which_one_is_wrong(keys):
    asked = PointTask(turn("z", 0.4), slide((0.3, 0, 0)), point=(0.1, 0.2, 0.5))
    wrong = PointTask(turn("z", -0.4), slide((0.3, 0, 0)), point=(0.1, 0.2, 0.5))
    verdict = asked.judge([((), wrong.reference())])
    assert {"sign-1"} in keys(verdict)
    assert "The point is" in verdict.seen


def test_a_fourth_number_that_is_not_one_gets_a_sentence():
    asked = PointTask(turn("z", 0.4), point=(0.1, 0.2, 0.5))
    assert "fourth number of a point is 1" in asked.judge([((), (1, 2, 3, 0))]).text


def test_only_given_poses_can_be_inverted():
    with pytest.raises(InputError, match="only a given pose can be inverted, got a turn"):
        inverse_of(turn("x", 1))
    with pytest.raises(InputError, match="at least one factor"):
        PointTask(point=(0, 0, 0))


def test_an_angle_that_is_counted_from_the_ground_is_named(keys):
    asked = PointTask(turn("z", 0.4), slide((0.7, 0, 0)), turn("z", 0.9), point=(0.3, 0, 0))
    links = [length * np.array([np.cos(q), np.sin(q), 0]) for length, q in ((0.7, 0.4), (0.3, 0.9))]
    assert keys(asked.judge([((), sum(links))])) == [{"from-start-3"}]


def test_of_a_direction_its_angle_and_its_length_are_seen():
    asked = PointTask(turn("z", 0.3), point=(0.2, 0.1, 0.4), direction=True)
    right = asked.reference()
    for wrong, sentence in (
        (1.7 * right, "is too long"),
        (right[[2, 0, 1]], r"points [\d.]+ degrees away from the wanted one\."),
        (0 * right, "The direction is too short"),
    ):
        with pytest.raises(ValueError, match=sentence):
            raise ValueError(asked.judge([((), wrong)]).seen)


def test_of_the_shapes_that_are_taken_only_the_usual_one_is_told():
    text = PointTask(turn("z", 0.4), point=(0.1, 0.2, 0.5)).judge([((), (1, 2))]).text
    assert text == "The answer has shape (2,); shape (3,) is asked for."
