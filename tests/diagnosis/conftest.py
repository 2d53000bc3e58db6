"""How the tests of diagnosis count: which mistakes were made, and which were named."""

from collections import Counter
from math import pi
from time import process_time

import pytest

from dhlab.kinematics.chain import Chain
from dhlab.kinematics.transforms import rotx, rp2t


def keys_of(verdict):
    """Keys of the mistakes of each explanation."""
    groups = verdict.either or ((verdict.mistakes,) if verdict.mistakes else ())
    return [{m.key for m in group} for group in groups]


class Tally:
    """Counts judgements on answers whose mistakes are known."""

    def __init__(self):
        self.counts = Counter()
        self.seconds = []
        self.unnamed = []

    def judge(self, task, cases, made=()):
        """Judge an answer in which these mistakes were made; none: it must be right."""
        start = process_time()
        verdict = task.judge(cases)
        self.seconds.append(process_time() - start)
        made, found = set(made), keys_of(verdict)
        if not made:
            self.counts["right answers"] += 1
            self.counts["called wrong"] += not verdict.right
        elif verdict.right:
            self.counts["mistakes without effect"] += 1
        else:
            self.counts["wrong answers"] += 1
            if made in found or any(len(group) < len(made) for group in found):
                self.counts["named"] += 1
            else:
                self.counts["falsely"] += bool(found)
                self.unnamed.append((made, found))
        return verdict

    @property
    def share(self):
        """Part of the wrong answers whose mistake is named."""
        return self.counts["named"] / max(self.counts["wrong answers"], 1)

    def check(self, share=0.95):
        """No false accusation, no right answer called wrong, and most mistakes named."""
        assert self.counts["falsely"] == 0, self.unnamed
        assert self.counts["called wrong"] == 0
        assert self.share >= share, self.unnamed


@pytest.fixture
def tally(record_property):
    """A tally that is shown at the end of the test run."""
    count = Tally()
    yield count
    record_property("tally", {"counts": dict(count.counts), "seconds": count.seconds})


@pytest.fixture
def keys():
    """Keys of the mistakes of each explanation of a verdict."""
    return keys_of


def random_chain(rng):
    """A chain of two to six joints: special and slanted angles, base, tool, sometimes offsets."""
    n = int(rng.integers(2, 7))
    joints = "".join(rng.choice(["r", "r", "p"], n))
    angles = (0, pi / 2, -pi / 2, 0.4, -1.1)
    rows = [
        (rng.choice(angles), rng.uniform(-1, 1), rng.uniform(-1, 1), rng.choice(angles))
        for _ in range(n)
    ]
    return Chain(
        rows,
        joints,
        rng.choice(["modified", "standard"]),
        base=rng.uniform(-1, 1, 3),
        grasper=rp2t(rotx(rng.uniform(-1, 1)), rng.uniform(-1, 1, 3)),
        offset=rng.uniform(-1, 1, n) * rng.integers(2),
    )


@pytest.fixture
def chains():
    """From a generator of random numbers to a chain."""
    return random_chain
