"""Fifty robots of six joints and two thousand blocks: what is sent grows with what moved."""

import json

import numpy as np
import pytest

from dhlab import cube, dh, robot
from dhlab.view import View
from dhlab.view.wire import Wire

JOINT = 8 + 4
POSE = 12 * 4 + 4
HEADER = 160


class Counter:
    """A backend that counts the bytes of each message."""

    def __init__(self):
        self.wire = Wire({})
        self.sizes = []

    def send(self, batch):
        header, buffer = self.wire.batch(batch)
        self.sizes.append(len(json.dumps(header)) + len(buffer))


def scene(robots, blocks):
    rows = [dh(0.3, 0.2, 0.1, 0)] * 6
    backend = Counter()
    arms = [robot(rows, "rrrrrr", name=f"r{k}", look="stick") for k in range(robots)]
    cubes = [cube(0.1, name=f"b{k}") for k in range(blocks)]
    view = View("many", backend=backend).add(*arms, *cubes)
    view.flush()
    return view, backend, arms, cubes


@pytest.fixture(scope="module")
def many():
    return scene(50, 2000)


def size_of(view, backend, change):
    """Bytes of all messages that a change makes."""
    view.flush()
    backend.sizes.clear()
    change()
    view.flush()
    return sum(backend.sizes)


def test_what_one_robot_or_one_block_sends_does_not_depend_on_what_else_is_there(many):
    sizes = []
    for view, backend, arms, cubes in (scene(1, 1), many):
        sizes.append(
            (
                size_of(view, backend, lambda arm=arms[0]: setattr(arm, "q", np.full(6, 0.5))),
                size_of(view, backend, lambda box=cubes[0]: box.move((1, 2, 3))),
                size_of(view, backend, lambda box=cubes[0]: box.set(color="#0072b2")),
            )
        )
    assert np.abs(np.subtract(*sizes)).max() <= 8  # the digits of a number
    assert sizes[1][0] < 6 * JOINT + HEADER
    assert sizes[1][1] < POSE + HEADER


@pytest.mark.parametrize("count", [1, 10, 50])
def test_a_message_about_robots_has_twelve_bytes_for_each_joint(many, count):
    _, backend, arms, _ = many
    many[0].flush()
    backend.sizes.clear()
    from_here = backend.wire.nodes.copy()
    for arm in arms[:count]:
        arm.q = arm.q + 0.01
    many[0].flush()
    commands = [p for p, node in backend.wire.nodes.items() if node is not from_here[p]]
    assert len(commands) == 6 * count
    assert sum(backend.sizes) < 6 * count * JOINT + HEADER * len(backend.sizes)


def test_a_message_about_blocks_has_fifty_two_bytes_for_each(many):
    view, backend, _, cubes = many
    size = size_of(view, backend, lambda: [box.move((k, 0, 2)) for k, box in enumerate(cubes)])
    assert size < len(cubes) * POSE + HEADER * len(backend.sizes)
