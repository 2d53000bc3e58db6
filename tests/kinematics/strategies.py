"""What the laws are tried on: angles with the singular ones among them, poses, chains, trees."""

from math import pi

import numpy as np
from hypothesis import strategies as st

from dhlab.kinematics.angles import rpy2r
from dhlab.kinematics.chain import Chain
from dhlab.kinematics.dh import DHRow
from dhlab.kinematics.mechanism import Branch, Mechanism
from dhlab.kinematics.transforms import rp2t

right_angles = st.integers(-4, 4).map(lambda k: k * pi / 2)
tiny = st.sampled_from([1e-15, 1e-12, 1e-9, 1e-6, 1e-3])
angles = st.one_of(
    right_angles,
    st.floats(-2 * pi, 2 * pi),
    st.builds(lambda a, e, sign: a + sign * e, right_angles, tiny, st.sampled_from([-1, 1])),
)
lengths = st.floats(-2, 2)
rotations = st.builds(rpy2r, angles, angles, angles)
points = st.tuples(lengths, lengths, lengths).map(np.array)
poses = st.builds(rp2t, rotations, points)
rows = st.builds(DHRow, angles, lengths, lengths, angles)
conventions = st.sampled_from(["modified", "standard"])


@st.composite
def chains(draw):
    letters = draw(st.text("rp", max_size=4))
    n = len(letters)
    return Chain(
        draw(st.lists(rows, min_size=n, max_size=n)),
        letters,
        convention=draw(conventions),
        base=draw(poses),
        grasper=draw(poses),
        offset=draw(st.lists(lengths, min_size=n, max_size=n)),
    )


@st.composite
def mechanisms(draw):
    branches = []
    for number in range(draw(st.integers(1, 5))):
        parent = draw(st.integers(-1, number - 1))
        at = draw(st.integers(0, branches[parent].chain.n)) if parent >= 0 else 0
        branches.append(Branch(f"b{number}", draw(chains()), parent, at))
    return Mechanism(branches)


def configurations(n, steps=None):
    numbers = st.one_of(right_angles, st.floats(-4, 4))
    if steps is None:
        return st.lists(numbers, min_size=n, max_size=n).map(np.array)
    flat = st.lists(numbers, min_size=n * steps, max_size=n * steps)
    return flat.map(lambda values: np.reshape(values, (steps, n)))
