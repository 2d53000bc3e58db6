"""All 32 frames of the 27-variable limb, beside a plain loop.

The loop makes one 4x4 array for each of the 27 joints and multiplies it by one ``@``; what stands
still in a link is worked out beforehand for us and in the loop for it, as a student would write it.
"""

from collections.abc import Iterator
from math import cos, sin

import numpy as np
from rows import Row, in_turns

from dhlab.models import upper_limb

CALLS = 300
STEPS = 10_000
TARGETS = "<= 0.45", "<= 0.03"


def measure() -> Iterator[Row]:
    limb = upper_limb()
    mechanism = limb.mechanism
    q = np.random.default_rng(1).uniform(*limb.limits.T, (STEPS, limb.n))
    one = q[0]
    table = [row for branch in mechanism.branches for row in branch.chain.rows]
    links = list(zip(parents(mechanism), table, strict=True))

    def loop():
        for _ in range(CALLS):
            frames = []
            for theta, (parent, (alpha, a, d, _)) in zip(one, links, strict=True):
                c, s, ca, sa = cos(theta), sin(theta), cos(alpha), sin(alpha)
                T = np.array(
                    [
                        [c, -s, 0, a],
                        [s * ca, c * ca, -sa, -sa * d],
                        [s * sa, c * sa, ca, ca * d],
                        [0, 0, 0, 1],
                    ]
                )
                frames.append(frames[parent] @ T if parent >= 0 else T)

    def single():
        for _ in range(CALLS):
            mechanism.frames(one)

    def robot():
        for _ in range(CALLS):
            limb.frames(one)

    def batch():
        mechanism.frames(q)

    times = in_turns([loop, single, robot, batch], rounds=15)
    beside, alone, handle = (1e6 * time / CALLS for time in times[:3])
    many = 1e6 * times[3] / STEPS
    name = "plain loop"
    yield Row("frames of one configuration", alone, beside, name, "us", TARGETS[0])
    yield Row("the same asked of the robot", handle, beside, name, "us", TARGETS[0])
    yield Row(f"one of {STEPS:,} configurations", many, beside, name, "us", TARGETS[1])


def parents(mechanism) -> list[int]:
    """Joint that each joint hangs on, -1 for none."""
    joints, last = [], {}
    for number, (_, chain, parent, at) in enumerate(mechanism.branches):
        on = last[parent][at] if parent >= 0 else -1
        last[number] = [on]
        for _ in range(chain.n):
            last[number].append(len(joints))
            joints.append(last[number][-2])
    return joints
