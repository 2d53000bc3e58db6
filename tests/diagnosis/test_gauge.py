"""Every right table is accepted, whatever choices it makes, and no other one."""

from math import pi

import numpy as np
import pytest

from dhlab.diagnosis.gauge import match
from dhlab.kinematics.chain import Chain
from dhlab.kinematics.dh import joint_motion, link_transform
from dhlab.kinematics.transforms import inverse, rotx, rotz, rp2t, transl

ANGLES = (0, 0, pi / 2, -pi / 2, pi, 0.4, -1.1)
LENGTHS = (0, 0, 0.3, -0.2, 0.55)
FREE = [(False, False), (True, False), (False, True), (True, True)]


def random_chain(rng):
    n = int(rng.integers(1, 7))
    joints = "".join(rng.choice(["r", "r", "r", "p"], n))
    rows = [
        (rng.choice(ANGLES), rng.choice(LENGTHS), rng.choice(LENGTHS), rng.choice(ANGLES))
        for _ in range(n)
    ]
    grasper = rp2t(rotx(rng.choice(ANGLES)) @ rotz(rng.choice(ANGLES)), rng.choice(LENGTHS, 3))
    return Chain(rows, joints, base=rng.choice(LENGTHS, 3), grasper=grasper)


def other_choices(chain, rng):
    """Same mechanism: z and x turned about, frames slid along z, other zeros.

    Frame i is carried along by C_i, which commutes with its joint but for the sense.
    """
    constants, carried = [], np.eye(4)
    for i, (before, _) in enumerate(chain.constants):
        C = rp2t(rotx(pi * rng.integers(2)), (0, 0, 0)) @ joint_motion("p", rng.choice(LENGTHS))
        if chain.kinds[i] == "p":
            C = transl(rng.choice(LENGTHS, 3)) @ C
        zero = joint_motion(chain.kinds[i], rng.uniform(-2, 2))
        constants.append(inverse(carried) @ before @ zero @ C)
        carried = C
    return Product(constants, chain.kinds, chain.base, inverse(carried) @ chain.grasper)


class Product(Chain):
    """A chain by its constant poses instead of a table."""

    def __init__(self, constants, kinds, base, grasper):
        n = len(kinds)
        super().__init__([(0, 0, 0, 0)] * n, kinds, base=base, grasper=grasper)
        object.__setattr__(self, "constants", tuple((c, np.eye(4)) for c in constants))


@pytest.mark.parametrize(("base_free", "tool_free"), FREE)
def test_all_choices_of_one_mechanism_match(base_free, tool_free):
    rng = np.random.default_rng(5)
    for _ in range(300):
        chain = random_chain(rng)
        other = other_choices(chain, rng)
        if base_free:
            other = Product(
                [c for c, _ in other.constants],
                other.kinds,
                rp2t(rotz(0.3), (1, 2, 3)),
                other.grasper,
            )
        if tool_free:
            other = Product(
                [c for c, _ in other.constants],
                other.kinds,
                other.base,
                rp2t(rotx(0.7), (0.1, 0, 1)),
            )
        found = match(chain, other, base_free, tool_free)
        assert found is not None, (chain, [c for c, _ in other.constants])


@pytest.mark.parametrize(("base_free", "tool_free"), FREE)
def test_a_standard_table_matches_its_modified_one(base_free, tool_free):
    rng = np.random.default_rng(6)
    for _ in range(100):
        chain = random_chain(rng)
        assert match(chain, chain.to_standard(), base_free, tool_free)


def test_another_length_does_not_match():
    rows = [(0, 0, 0.2, 0), (pi / 2, 0.3, 0, 0), (0, 0.4, 0, 0)]
    chain = Chain(rows, "rrr", grasper=(0.1, 0, 0))
    assert link_transform(rows[1])[0, 3] == 0.3
    for joint, name in [(2, "a"), (3, "a"), (1, "d")]:
        assert match(chain, chain.replace(joint, **{name: 0.35})) is None
    assert match(chain, chain.replace(1, d=0.9), base_free=True, tool_free=True)


def test_without_a_free_zero_offsets_are_part_of_the_mechanism():
    rng = np.random.default_rng(9)
    for _ in range(100):
        chain = random_chain(rng)
        shifted = chain.replace(offset=rng.uniform(0.2, 1, chain.n))
        assert match(shifted, shifted.to_standard(), zero_free=False)
        assert match(chain, shifted, zero_free=True)
        same = np.allclose(chain.tip(np.ones(chain.n)), shifted.tip(np.ones(chain.n)))
        assert same or not match(chain, shifted, zero_free=False)
