"""The default looks: bodies run from joint to joint, whatever the table."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dhlab import Chain, dh, models, robot, robot_complex
from dhlab.scene.robot_look import default_radius, slide, spine

LENGTHS = st.floats(-2, 2).map(lambda x: round(x, 3))
ANGLES = st.floats(-3, 3)
ROWS = st.builds(dh, ANGLES, LENGTHS, LENGTHS, ANGLES)


@st.composite
def chains(draw):
    rows = draw(st.lists(ROWS, min_size=1, max_size=5))
    joints = "".join(draw(st.sampled_from("rp")) for _ in rows)
    convention = draw(st.sampled_from(["modified", "standard"]))
    return Chain(rows, joints, convention, grasper=(draw(LENGTHS), 0, 0.1))


@settings(derandomize=True, max_examples=60, deadline=None)
@given(chains())
def test_the_centre_line_goes_from_base_to_tip_along_a_and_d_and_nowhere_else(chain):
    paths = spine(chain)
    lengths = [np.linalg.norm(np.diff(path, axis=0), axis=1).sum() for path in paths]
    rows = zip(chain.rows, chain.joints, strict=True)
    table = sum(abs(row.a) + (abs(row.d) if kind == "r" else 0) for row, kind in rows)
    tool = np.linalg.norm(chain.grasper[:3, 3])
    assert sum(lengths) == pytest.approx(table + tool, abs=1e-6)


@settings(derandomize=True, max_examples=60, deadline=None)
@given(chains())
def test_each_link_ends_where_the_next_joint_sits(chain):
    q = chain.home
    frames = [chain.base, *chain.frames(q)]
    paths = spine(chain)
    for i in range(chain.n):
        end = frames[i] @ [*paths[i][-1], 1]
        before, after = chain.constants[i]
        assert end == pytest.approx(frames[i] @ before[:, 3], abs=1e-9)
        start = np.linalg.inv(after)[:3, 3]
        assert paths[i + 1][0] == pytest.approx(start, abs=1e-9)
        on_axis = np.linalg.inv(frames[i] @ before) @ frames[i + 1] @ [*start, 1]
        assert on_axis[:2] == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize("scale", [0.05, 1.0, 20.0])
def test_the_default_proportions_are_the_same_at_every_size(scale):
    def chain(k):
        return Chain([dh(0, 0, 0.3 * k, 0), dh(1, 1 * k, 0, 0)], "rr", grasper=(0.5 * k, 0, 0))

    assert default_radius(chain(scale)) == pytest.approx(scale * default_radius(chain(1)))


@pytest.mark.parametrize(
    ("limits", "home", "covered"),
    [
        ([(0.1, 0.5)], 0.2, (0.0, 0.5)),
        ([(-0.3, 0.5)], 0.2, (-0.3, 0.5)),
        (None, 0.4, (0.0, 0.4)),
        (None, -0.4, (-0.4, 0.0)),
    ],
)
def test_the_rail_of_a_prismatic_joint_reaches_from_the_link_over_all_it_slides(
    limits, home, covered
):
    chain = Chain([dh(0, 0, home, 0)], "p", limits=limits)
    assert slide(chain, 1) == pytest.approx(covered)


def test_the_bodies_of_the_hand_join_its_base_to_the_fingers():
    nodes = models.hand().describe()
    bodies = {path for path in nodes if path.startswith("hand/body")}
    assert len(bodies) == 5
    assert len([path for path in nodes if path.startswith("hand/ball")]) == 6


def test_without_configex_there_are_no_balls():
    rows = [dh(0, 0, 0, 0)]
    pair = robot_complex(robot(rows, "r", name="a", base=(1, 0, 0)), robot(rows, "r", name="b"))
    assert not [path for path in pair.describe() if "ball" in path]


def test_a_gripper_opens_as_far_as_it_is_told_and_goes_when_something_is_attached():
    rows = [dh(0, 0, 0, 0)]
    arm = robot(rows, "r", name="arm", grasper=(0, 0, 1), grasper_size=0.2)
    gripper = arm.describe()["arm/1/grasper/gripper"].shape
    inner = np.abs(gripper.vertices[:, 1])
    assert inner[inner > 0.05].min() == pytest.approx(0.1)
    arm.connect(robot(rows, "r", name="tool"))
    assert "arm/1/grasper/gripper" not in arm.describe()


def test_grasper_size_0_is_a_fingertip():
    assert "index/1/2/3/4/grasper/tip" in models.finger().describe()


@pytest.mark.parametrize(("model", "side"), [("arm", 1), ("finger", -1), ("puma", -1)])
def test_the_foot_stands_below_the_first_joint_and_above_it_where_the_robot_hangs(model, side):
    made = getattr(models, model)()
    foot = made.describe()[f"{made.name}/base"].shape
    assert (side * foot.vertices[:, 2] > 0).all()
