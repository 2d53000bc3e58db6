"""Nobody is accused of what they did not do: noise, one number off, special numbers, rounding."""

from math import pi

import numpy as np
import pytest

from dhlab.diagnosis import (
    AnglesTask,
    ArrangementTask,
    ForwardTask,
    LinkTask,
    MatrixTask,
    PointTask,
    TableTask,
    TrajectoryTask,
    given,
    inverse_of,
    slide,
    turn,
)
from dhlab.diagnosis.chain_slips import chain_slips, table_slips
from dhlab.diagnosis.point import evaluate_points, point_slips
from dhlab.diagnosis.product import evaluate_products
from dhlab.diagnosis.product_slips import product_slips
from dhlab.diagnosis.table_model import chain_of, evaluate_tables, table_of
from dhlab.kinematics.angles import rpy2r
from dhlab.kinematics.chain import Chain
from dhlab.kinematics.dh import link_transform
from dhlab.kinematics.transforms import rp2t

SPECIAL = {
    "angle": np.radians([0, 30, 45, 60, 90, 180, -90, 40, 50]),
    "length": [0, 0.1, 0.2, 0.3, 0.3, 0.5, -0.2],
}


class Numbers:
    """Random angles, lengths and poses: any, or those of textbooks, where mistakes look alike."""

    def __init__(self, rng, special):
        self.rng, self.special = rng, special

    def angle(self):
        return float(self.rng.choice(SPECIAL["angle"]) if self.special else self.rng.uniform(-2, 2))

    def length(self):
        return float(
            self.rng.choice(SPECIAL["length"]) if self.special else self.rng.uniform(-1, 1)
        )

    def vector(self):
        return np.array([self.length() for _ in range(3)])

    def pose(self):
        return rp2t(rpy2r(self.angle(), self.angle(), self.angle()), self.vector())

    def factors(self):
        """One to four factors of a product."""
        made = [
            lambda k: turn("xyz"[self.rng.integers(3)], self.angle()),
            lambda k: slide(self.vector()),
            lambda k: slide(np.eye(3)[self.rng.integers(3)] * self.length()),
            lambda k: given(f"T_{k}", self.pose()),
            lambda k: inverse_of(given(f"T_{k}", self.pose())),
        ]
        return [made[self.rng.integers(5)](k) for k in range(self.rng.integers(1, 5))]

    def chain(self):
        """One to four joints."""
        n = self.rng.integers(1, 5)
        quarter = [0, pi / 2, -pi / 2, pi] if self.special else [0, pi / 2, 0.4, -1.1]
        rows = [
            (self.rng.choice(quarter), self.length(), self.length(), self.rng.choice(quarter))
            for _ in range(n)
        ]
        convention = self.rng.choice(["modified", "standard"])
        joints = "".join(self.rng.choice(["r", "r", "p"], n))
        return Chain(rows, joints, convention, grasper=self.pose())


def matrix(numbers):
    task = MatrixTask(*numbers.factors())
    model = task._model(())
    return task, (), model, product_slips(model.moves, None, rotation=False), evaluate_products


def point(numbers):
    direction = bool(numbers.rng.integers(2))
    task = PointTask(*numbers.factors(), point=numbers.vector(), direction=direction)
    model = task._model(())
    return task, (), model, point_slips(model), evaluate_points


def forward(numbers):
    chain = numbers.chain()
    q = np.array([numbers.angle() for _ in range(chain.n)])
    return ForwardTask(chain), (q,), table_of(chain, q), chain_slips(chain), evaluate_tables


both_kinds = pytest.mark.parametrize("special", [False, True], ids=["any numbers", "special"])
for_each = pytest.mark.parametrize("make", [matrix, point, forward])


@both_kinds
@for_each
def test_of_one_or_two_mistakes_none_but_those_made_is_named(make, special, tally):
    numbers = Numbers(np.random.default_rng(11), special)
    for _ in range(120):
        task, inputs, model, slips, evaluate = make(numbers)
        made = min(len(slips), int(numbers.rng.integers(1, 3)))
        chosen = [slips[k] for k in sorted(numbers.rng.choice(len(slips), made, replace=False))]
        for slip in chosen:
            model = slip.change(model)
        came = evaluate([model])[0]
        keys = {slip.mistake.key for slip in chosen}
        if len({slip.about for slip in chosen}) == made or not chosen[0].about:
            tally.judge(task, [(inputs, came)], keys)
    tally.check(share=0.7)  # slips of the pen are not searched in pairs


@both_kinds
@for_each
@pytest.mark.parametrize("before", [0, 1], ids=["alone", "with a mistake"])
def test_a_number_that_is_off_has_no_cause(make, special, before):
    numbers = Numbers(np.random.default_rng(12), special)
    falsely = []
    for _ in range(120):
        task, inputs, model, slips, evaluate = make(numbers)
        made = [slips[k] for k in numbers.rng.choice(len(slips), before, replace=False)]
        for slip in made:
            model = slip.change(model)
        came = np.array(evaluate([model])[0])
        place = tuple(numbers.rng.integers(n) for n in came[:3].shape)
        came[place] += 0.0717  # a number that is nowhere in a task
        verdict = task.judge([(inputs, came)])
        assert not verdict.right
        named = {m.key for m in verdict.mistakes}  # in millimetres 0.07 is what rounding does
        falsely += [named] if named - {slip.mistake.key for slip in made} else []
    assert not falsely


@both_kinds
def test_one_wrong_sign_is_no_pair_of_mistakes(special):
    numbers = Numbers(np.random.default_rng(13), special)
    for make in (matrix, point, forward):
        for _ in range(80):
            task, inputs, model, _, evaluate = make(numbers)
            came = np.array(evaluate([model])[0])
            place = tuple(numbers.rng.integers(n) for n in came[:3].shape)
            came[place] *= -1
            verdict = task.judge([(inputs, came)])
            assert verdict.right == (abs(came[place]) < 1e-6)
            assert all(len(group) == 1 for group in verdict.either or [verdict.mistakes] if group)


def test_a_cosine_with_the_wrong_sign_is_named(keys):
    task = MatrixTask(turn("z", lambda x: x), size=3)
    c, s = np.cos(0.4), np.sin(0.4)
    wrong = np.array([[c, -s, 0], [s, -c, 0], [0, 0, 1]])
    verdict = task.judge([((0.4,), wrong)])
    assert {"cosine-sign-1"} in keys(verdict)
    assert "Only the number in row 2, column 2 is not right." in verdict.seen


def test_a_coordinate_of_the_wrong_sign_is_not_only_a_left_handed_frame(keys):
    task = PointTask(turn("z", 0.4), point=(0.3, 0.2, 0.1))
    verdict = task.judge([((), task.reference() * (1, -1, 1))])
    assert {"sign-of-y"} in keys(verdict)


@both_kinds
def test_of_two_slips_in_a_table_none_but_those_made_is_named(special, tally):
    numbers = Numbers(np.random.default_rng(14), special)
    for _ in range(100):
        chain = numbers.chain()
        slips, table = table_slips(chain), table_of(chain, chain.home)
        made = min(len(slips), 2)
        chosen = [slips[k] for k in sorted(numbers.rng.choice(len(slips), made, replace=False))]
        for slip in chosen:
            table = slip.change(table)
        if table.is_chain(chain.n):
            wrong = chain_of(table)
            told = ("rows", "joints", "convention", "base", "grasper", "offset")
            came = {name: getattr(wrong, name) for name in told}
            task = TableTask(chain, *numbers.rng.integers(0, 2, 3).astype(bool).tolist())
            tally.judge(task, [((), came)], {slip.mistake.key for slip in chosen})
    tally.check(share=0)  # slips of the pen are not searched in pairs


def test_rows_that_change_places_are_not_only_another_convention(keys):
    chain = Chain([(0.4, 0.1, 0.3, 0), (-1.1, 0.2, 0.5, 0)], "rr", grasper=(0.1, 0, 0))
    verdict = TableTask(chain).judge([((), chain.rows[::-1])])
    assert {"rows-exchanged-1-2"} in keys(verdict)


@both_kinds
def test_one_number_off_in_a_table_is_no_pair_of_mistakes(special):
    numbers = Numbers(np.random.default_rng(15), special)
    for _ in range(100):
        chain = numbers.chain()
        rows = np.array(chain.rows)
        rows[numbers.rng.integers(chain.n), numbers.rng.integers(4)] += 0.0717
        verdict = TableTask(chain, zero_free=False).judge([((), rows)])
        assert not verdict.mistakes


ROUNDED = {
    "rotation": (MatrixTask(turn("z", 0.7), turn("x", -0.4), size=3), ()),
    "pose": (MatrixTask(slide((1.23456, 0.2, 0)), turn("x", 1.1)), ()),
    "point": (PointTask(turn("y", 0.7), slide((1, 2, 3)), point=(0.1, 0.5, 0.3)), ()),
    "forward": (ForwardTask(Chain([(0.3, 0.2, 0.1, 0), (1, 0.3, 0, 0)], "rr")), ((0.4, -1.3),)),
    "motion": (TrajectoryTask(0.2, 1.3, 1, 3, at=np.linspace(1, 3, 6), answer="motion"), ()),
    "coefficients": (TrajectoryTask(0.2, 1.3, 0, 1, answer="coefficients"), ()),
}


def rounded(task, inputs, digits):
    return task.judge([(inputs, np.round(task.reference(*inputs), digits))])


@pytest.mark.parametrize("name", ROUNDED)
def test_four_digits_are_enough_and_three_are_nearly_right(name):
    task, inputs = ROUNDED[name]
    assert rounded(task, inputs, 4).right
    near = rounded(task, inputs, 3)
    assert near.right == (name == "coefficients") or near.text.startswith("Nearly")


def test_other_answers_with_four_digits_are_right():
    row, angles = (0.4, 0.5, 0.3, 1.1), (0.4, -0.3, 1.2)
    assert LinkTask().judge([(row, link_transform(row).round(4))]).right
    assert AnglesTask(rpy2r(*angles)).judge([((), np.add(np.round(angles, 4), 4e-5))]).right
    pose = rp2t(rpy2r(*angles), row[:3])
    assert ArrangementTask({"A": pose}).judge([((), {"A": pose.round(4)})]).right
    assert ArrangementTask({"A": pose}).judge([((), {"A": pose.round(3)})]).text[:6] == "Nearly"
    arm = Chain([(0, 0, 0, 0), (pi / 2, 0.3, 0, 0)], "rr")
    assert TableTask(arm).judge([((), [(0, 0, 0, 0), (1.5708, 0.3, 0, 0)])]).right
    assert "Nearly" in TableTask(arm).judge([((), [(0, 0, 0, 0), (1.571, 0.3, 0, 0)])]).text


def test_a_mistake_in_a_rounded_answer_is_still_named(keys):
    task = MatrixTask(turn("z", 0.7), turn("x", -0.4), slide((0.5, 0.2, 0.1)))
    wrong = MatrixTask(slide((0.5, 0.2, 0.1)), turn("x", -0.4), turn("z", 0.7)).reference()
    verdict = task.judge([((), wrong.round(4))])
    assert keys(verdict) == [{"reversed-order"}]
    assert "no rotation matrix" not in verdict.text


def test_the_coefficients_of_a_slow_motion_count_though_they_are_small(keys):
    task = TrajectoryTask(0.0, 1.0, 0, 200, answer="coefficients")
    c = task.reference()
    assert task.judge([((), c)]).right
    assert {"sign-c3"} in keys(task.judge([((), c * [[-1], [1], [1], [1]])]))
