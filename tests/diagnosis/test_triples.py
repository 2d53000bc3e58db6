"""Angles of a rotation: every triple that makes it is right."""

from math import pi

import numpy as np
import pytest

from dhlab.diagnosis import AnglesTask
from dhlab.diagnosis.triples import Triple, evaluate_triples, triple_slips
from dhlab.errors import InputError
from dhlab.kinematics.angles import eul2r, r2eul, r2rpy, rpy2r
from dhlab.kinematics.transforms import rotz

MAKE = {"rpy": rpy2r, "euler": eul2r}
TAKE = {"rpy": r2rpy, "euler": r2eul}
TASKS = {kind: AnglesTask(lambda R: R, kind) for kind in MAKE}
kinds = pytest.mark.parametrize("kind", ["rpy", "euler"])


def equal_triples(kind, angles):
    """Triples of the same rotation."""
    first, middle, last = angles
    yield angles
    yield angles + 2 * pi * np.array([1, -1, 2])
    yield np.array([first + pi, (pi if kind == "rpy" else 0) - middle, last - pi])


@kinds
def test_every_equal_triple_is_right(kind, tally):
    rng = np.random.default_rng(2)
    for _ in range(100):
        angles = rng.uniform(-pi, pi, (3, 3))
        triples = [list(equal_triples(kind, row)) for row in angles]
        for choice in zip(*triples, strict=True):
            cases = [((MAKE[kind](*a),), t) for a, t in zip(angles, choice, strict=True)]
            tally.judge(TASKS[kind], cases)
    tally.check(share=0)


@kinds
def test_where_two_axes_are_one_line_only_the_sum_counts(kind, tally):
    middle = pi / 2 if kind == "rpy" else 0.0
    sign = -1 if kind == "rpy" else 1
    verdicts = [
        tally.judge(
            TASKS[kind], [((MAKE[kind](0.3, middle, 0.5),), (0.3 + x, middle, 0.5 - sign * x))]
        )
        for x in (0, 0.4, -2)
    ]
    tally.check(share=0)
    assert all("turn about one line" in verdict.text for verdict in verdicts)


@kinds
@pytest.mark.parametrize("made", [1, 2])
def test_mistakes_with_angles_are_named(kind, made, tally):
    rng = np.random.default_rng(made)
    slips = triple_slips(kind)
    for _ in range(300):
        chosen = [slips[k] for k in sorted(rng.choice(len(slips), made, replace=False))]
        if made == 2 and chosen[0].about and chosen[0].about == chosen[1].about:
            continue
        cases = []
        for angles in rng.uniform(-1.2, 1.2, (3, 3)):
            model = Triple(angles, kind)
            for slip in chosen:
                model = slip.change(model)
            cases.append(((evaluate_triples([model])[0],), angles))
        tally.judge(TASKS[kind], cases, {s.mistake.key for s in chosen})
    tally.check()


def test_no_angle_is_told(keys):
    angles = np.array([0.4567, -0.3131, 1.2345])
    verdict = TASKS["rpy"].judge([((rpy2r(*angles),), angles * [0, 1, 1])])
    assert not verdict.right
    assert not any(character.isdigit() for character in verdict.text)


def test_what_is_asked_must_be_a_rotation():
    with pytest.raises(InputError, match="no angles 'ypr'; use 'rpy' or 'euler'"):
        AnglesTask(rotz(1), "ypr")
    with pytest.raises(InputError, match=r"must have shape \(3, 3\) or \(4, 4\), got \(2, 2\)"):
        AnglesTask(np.eye(2))
    assert AnglesTask(rotz(1)).judge([((), (0, 0, 1))]).right
