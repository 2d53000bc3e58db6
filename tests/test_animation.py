"""Planned motions: checked first, last state left at once, played by whoever shows them."""

import numpy as np
import pytest
from numpy import pi

from dhlab import (
    InputError,
    LimitError,
    animate,
    block_complex,
    block_motion,
    csys,
    cube,
    dh,
    robot,
    robot_complex,
    robot_motion,
    rotz,
    rp2t,
    transl,
)


def planar(name=None, **options):
    """Two links of 1 m in a plane."""
    rows = [dh(0, 0, 0, 0), dh(0, 1, 0, 0)]
    return robot(rows, "rr", name=name, grasper=(1, 0, 0), **options)


def swing(t):
    return [0.1 * t, -0.2 * t]


class Listener:
    """Counts what it hears."""

    def __init__(self):
        self.heard = []

    def handle_changed(self, handle):
        self.heard.append(handle)


def test_everything_that_moves_is_left_in_its_last_state():
    r, b, A = planar(), cube(1), csys()
    motion = animate(
        [0, 1, 3],
        {r: swing, b: lambda t: (t, 0, 0), A: lambda t: rp2t(rotz(t), (0, 0, t))},
    )
    assert r.q == pytest.approx([0.3, -0.6])
    assert b.pose[:3, 3] == pytest.approx((3, 0, 0))
    assert A.pose == pytest.approx(rp2t(rotz(3), (0, 0, 3)))
    assert motion.duration == 3
    assert repr(motion) == "Motion of robot, block, csys: 3 steps in 3.00 s"


def test_the_nodes_carry_the_whole_motion():
    r = planar("r")
    motion = animate([0, 1, 3], {r: swing})
    node = r.describe()["r/1/2"]
    assert node.curve.clock is motion.clock
    assert node.curve.samples == pytest.approx([0, -0.2, -0.6])
    assert node.value == node.curve.samples[-1]


def test_an_offset_is_in_the_curve_as_it_is_in_the_node():
    r = planar("r", offset=[pi / 2, 0])
    animate([0, 1], {r: swing})
    node = r.describe()["r/1"]
    assert node.curve.samples == pytest.approx([pi / 2, pi / 2 + 0.1])
    assert node.value == pytest.approx(pi / 2 + 0.1)
    assert r.own.samples(node.curve.clock)[:, 0] == pytest.approx([0, 0.1])


def test_assigning_to_a_playing_handle_stops_it_there():
    r, b = planar("r"), cube(1)
    animate([0, 1], {r: swing, b: lambda t: (t, 0, 0)})
    r.q = [0, 0]
    b.pose = (5, 5, 5)
    assert r.describe()["r/1"].curve is None
    assert b.describe()["block"].curve is None
    assert b.pose[:3, 3] == pytest.approx((5, 5, 5))


def test_a_colour_does_not_stop_a_playing_handle():
    r = planar("r")
    animate([0, 1], {r: swing})
    r.color = "#ff0000"
    assert r.describe()["r/1"].curve is not None


def test_assigning_to_one_component_leaves_the_others_playing():
    pair = robot_complex(planar("left"), planar("right"), name="pair")
    animate([0, 1], {pair: lambda t: [t, t, t, t]})
    pair.components[0].q = [0, 0]
    nodes = pair.describe()
    assert nodes["pair/left/1"].curve is None
    assert nodes["pair/right/1"].curve is not None


def test_a_motion_is_told_once_to_each_who_watches():
    pair = robot_complex(planar("left"), planar("right"), name="pair")
    ear = Listener()
    pair.watch(ear)
    animate([0, 1], {pair: lambda t: [t, t, t, t]}, trace=True)
    assert ear.heard == [pair]


def test_nothing_moves_when_something_is_wrong():
    r, b = planar("r", limits=[(-1, 1), (-1, 1)]), cube(1)
    with pytest.raises(LimitError, match="joint 2 of 'r'"):
        animate([0, 4, 8], {b: lambda t: (t, 0, 0), r: swing})
    assert b.pose[:3, 3] == pytest.approx((0, 0, 0))
    assert r.q == pytest.approx([0, 0])
    assert b.describe()["block"].curve is None


@pytest.mark.parametrize(
    ("t", "make", "message"),
    [
        ([0, 0], lambda r: {r: swing}, "t must be one or more instants that increase"),
        ([], lambda r: {r: swing}, "t must be one or more instants that increase"),
        ([0, np.nan], lambda r: {r: swing}, "t must be finite"),
        ([0, 1], lambda r: {}, "a motion needs at least one handle"),
        ([0, 1], lambda r: {r: [0, 0]}, "motion of 'r' must be a function of t"),
        (
            [0, 2],
            lambda r: {r: lambda t: [t]},
            r"motion of 'r' at t = 0 s must have shape \(2,\), got \(1,\)",
        ),
        ([0, 2], lambda r: {r: lambda t: [t, 1 / (2 - t)] if t < 2 else [t, np.inf]}, "at t = 2 s"),
        ([0, 2], lambda r: {r: swing, r.own: swing}, "'r' is moved twice: by 'r' too"),
    ],
)
def test_motions_that_cannot_be_are_refused_in_words(t, make, message):
    r = planar("r")
    with pytest.raises(InputError, match=message):
        animate(t, make(r))
    assert r.q == pytest.approx([0, 0])


def test_only_handles_move():
    with pytest.raises(TypeError, match="a motion moves robots, components, blocks and csys"):
        animate([0, 1], {"arm": swing})
    with pytest.raises(TypeError, match="'block' is a Block, not a robot"):
        robot_motion({cube(1): [np.eye(4)]})
    with pytest.raises(TypeError, match="'r' is a Robot, not a block or csys"):
        block_motion({planar("r"): [[0, 0]]})


def test_a_function_with_a_start_gets_that_call_first():
    calls = []

    class Motion:
        def start(self, handle):
            calls.append(handle)

        def __call__(self, t):
            calls.append(t)
            return (t, 0, 0)

    b = cube(1)
    animate([1, 2], {b: Motion()})
    assert calls == [b, 1, 2]


def test_delay_stands_in_place_of_the_times():
    b = cube(1)
    motion = animate([0, 10, 20], {b: lambda t: (t, 0, 0)}, delay=0.5)
    assert motion.clock.times == pytest.approx([0, 0.5, 1])
    assert b.pose[0, 3] == 20


def test_a_shorter_motion_holds_its_last_configuration():
    a, b = planar("a"), planar("b")
    robot_motion({a: [[0, 0], [1, 1]], b: [[0, 0], [0, 1], [0, 2], [0, 3]]}, delay=0.1)
    assert a.describe()["a/1"].curve.samples == pytest.approx([0, 1, 1, 1])
    assert b.q == pytest.approx([0, 3])


def test_a_component_moves_its_own_joints_only():
    arm = planar("arm").connect(planar("hand"))
    robot_motion({arm.components[0]: [[0, 0], [1, 1]]})
    assert arm.q == pytest.approx([1, 1, 0, 0])


def test_block_motion_places_groups_and_frames_too():
    group, A = block_complex(cube(1), cube(1)), csys()
    block_motion({group: [np.eye(4), transl((1, 0, 0))], A: [transl((0, 2, 0))]})
    assert group.pose[:3, 3] == pytest.approx((1, 0, 0))
    assert A.pose[:3, 3] == pytest.approx((0, 2, 0))


def test_a_trace_is_the_path_of_the_grasper_in_the_world():
    arm, hand = planar("arm", base=(0, 0, 1)), planar("hand")
    arm.connect(hand)
    times = np.linspace(0, 1, 11)
    animate(times, {arm: lambda t: [t, 0, 0, t]}, trace=True)
    (line,) = [n for path, n in arm.describe().items() if path.startswith("arm.traces/")]
    wanted = arm.frames(np.outer(times, [1, 0, 0, 1]))["arm/hand/grasper"][:, :3, 3]
    assert line.shape.points == pytest.approx(wanted)
    assert line.curve.samples == pytest.approx(np.arange(11))


def test_the_trace_of_a_component_goes_with_what_else_moves():
    arm = planar("arm").connect(planar("hand"))
    own, hand = arm.components
    animate([0, 1, 2], {own: lambda t: [t, 0], hand: lambda t: [0, t]}, trace=True)
    lines = [n for path, n in arm.describe().items() if ".traces/" in path]
    assert len(lines) == 2
    wanted = arm.frames(arm.q)["arm/hand/grasper"][:3, 3]
    assert all(line.shape.points[-1] == pytest.approx(wanted) for line in lines)


def test_a_point_that_rests_leaves_no_trace():
    b = cube(1)
    animate([0, 1], {b: lambda t: rotz(t)}, trace=True)
    assert list(b.describe()) == ["block"]


def test_a_trace_has_the_colour_of_its_block():
    b = cube(1, color="#d55e00")
    pair = block_complex(cube(1, name="a", color="#d55e00"), cube(1, name="b", color="#d55e00"))
    animate([0, 1], {b: lambda t: (t, 0, 0), pair: lambda t: (0, t, 0)}, trace=True)
    for handle in (b, pair):
        (line,) = [n for path, n in handle.describe().items() if ".traces/" in path]
        assert line.style.color == b.color


def test_the_next_motion_clears_the_traces_of_the_last():
    b = cube(1)
    animate([0, 1], {b: lambda t: (t, 0, 0)}, trace=True)
    assert "block.traces/origin" in b.describe()
    animate([0, 1], {b: lambda t: (t, 0, 0)})
    assert list(b.describe()) == ["block"]


def test_ghosts_show_earlier_poses_and_can_be_cleared():
    b = cube(1, name="b")
    animate(np.arange(11), {b: lambda t: (t, 0, 0)}, trace="ghosts")
    ghosts = [node for path, node in b.describe().items() if path.startswith("b.ghosts/")]
    left = [ghost.shape.bounds[0, 0] for ghost in ghosts]
    assert left == pytest.approx([-0.5, 1.5, 3.5, 5.5, 7.5])
    assert all(ghost.style.opacity < 0.5 for ghost in ghosts)
    b.clear_traces()
    assert list(b.describe()) == ["b"]


def test_a_trace_that_is_not_known_is_refused():
    b = cube(1)
    with pytest.raises(InputError, match="trace must be True, False or 'ghosts', got 'path'"):
        animate([0, 1], {b: lambda t: (t, 0, 0)}, trace="path")
    assert b.pose[0, 3] == 0
