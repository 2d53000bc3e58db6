"""Paths from the world to the tips of a tree, and from tip to tip."""

import numpy as np

from dhlab.diagnosis.paths import Part, joints_of, path, tips
from dhlab.diagnosis.values import inverted
from dhlab.kinematics.mechanism import Branch, Mechanism


def tree(rng, chains):
    parts = []
    for i in range(4):
        on = int(rng.integers(-1, i)) if i else -1
        at = int(rng.integers(parts[on].chain.n + 1)) if on >= 0 else 0
        chain = chains(rng).to_modified()
        parts.append(Part(chain, on, at, chain.base))
    return parts


def test_a_path_ends_where_the_mechanism_has_the_tip(chains):
    rng = np.random.default_rng(5)
    for _ in range(20):
        parts = tree(rng, chains)
        robot = Mechanism([Branch(str(i), p.chain, p.on, p.at) for i, p in enumerate(parts)])
        q = rng.uniform(-1, 1, robot.n)
        frames = robot.frames(q)
        for i in tips(parts):
            way = path(parts, i)
            np.testing.assert_allclose(
                way.tip(q[list(way.numbers)]), frames[f"{i}/grasper"], atol=1e-9
            )


def test_a_path_from_tip_to_tip_goes_back_and_out_and_leaves_out_what_they_share(chains):
    rng = np.random.default_rng(6)
    shared = 0
    for _ in range(30):
        parts = tree(rng, chains)
        q = rng.uniform(-1, 1, joints_of(parts)[-1].stop)
        first, *others = tips(parts)
        for i in others:
            a, b, way = path(parts, first), path(parts, i), path(parts, i, first)
            common = set(a.numbers) & set(b.numbers)
            shared += bool(common)
            assert set(way.numbers) == set(a.numbers) ^ set(b.numbers)
            back = inverted(a.tip(q[list(a.numbers)]))
            np.testing.assert_allclose(
                way.tip(q[list(way.numbers)]), back @ b.tip(q[list(b.numbers)]), atol=1e-9
            )
    assert shared > 5
