"""A live view equals a fresh view, whatever was done before, also at the other end of the wire."""

import numpy as np
import pytest

from dhlab import dh, robot
from dhlab.view import Place, RecordingBackend, View, diff
from tests.worlds import World


def rests_where_it_stands(node):
    """Whether a planned motion ends where Python has the node."""
    if node.curve is None or node.curve.samples[-1].size < 16:
        return node.joint is None or node.curve is None or node.curve.samples[-1] == node.value
    return np.allclose(node.curve.samples[-1], node.pose, atol=1e-12)


@pytest.mark.parametrize("seed", range(125))
def test_a_live_view_equals_a_fresh_view_after_ten_thousand_operations(seed):
    world = World(seed)
    looks = np.random.default_rng(seed).random(80) < 0.25
    looks[-1] = True
    for step in range(80):
        world.act()
        if not looks[step]:
            continue
        live = world.live.nodes
        world.paged.flush()
        fresh = world.fresh()
        assert list(map(repr, diff(live, fresh))) == [], f"step {step}"
        assert set(world.backend.nodes) == set(fresh)
        assert diff(world.backend.nodes, fresh) == [], f"step {step}"
        assert world.replica.differs_from(fresh) == [], f"step {step}"
        assert [path for path in fresh if not rests_where_it_stands(fresh[path])] == []


def test_one_joint_moved_is_one_command():
    arm = robot([dh(0, 1, 0, 0)] * 6, "rrrrrr", name="arm", look="solid")
    backend = RecordingBackend()
    view = View(backend=backend).add(arm)
    view.flush()
    q = arm.q.copy()
    q[3] = 0.5
    arm.q = q
    view.flush()
    (command,) = backend.log[-1]
    assert isinstance(command, Place)
    assert command.path == "arm/1/2/3/4"
    assert command.node.value == 0.5
