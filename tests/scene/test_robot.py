"""Robots: one truth, trees of them, limits, parts."""

import numpy as np
import pytest
from numpy import pi

from dhlab import (
    AttachError,
    InputError,
    LimitError,
    cube,
    dh,
    robot,
    robot_complex,
    rotz,
    rp2t,
    transl,
)


def planar(name=None, **options):
    """Two links of 1 m in a plane."""
    rows = [dh(0, 0, 0, 0), dh(0, 1, 0, 0)]
    return robot(rows, "rr", name=name, grasper=(1, 0, 0), **options)


def tip(r, name):
    return r.frames()[name][:3, 3]


class Listener:
    """Counts what it hears."""

    def __init__(self):
        self.heard = []

    def handle_changed(self, handle):
        self.heard.append(handle)


def test_a_robot_stands_in_the_home_configuration_of_its_table():
    r = robot([dh(0, 0, 0, 0.5), dh(0, 1, 0.2, 0)], "rp")
    assert r.q == pytest.approx([0.5, 0.2])
    assert r.home == pytest.approx([0.5, 0.2])


def test_the_paper_s_two_letters_for_a_prismatic_joint_mean_the_same():
    rows = [dh(0, 0, 0.1, 0)]
    assert robot(rows, "p").chain.joints == robot(rows, ["d"]).chain.joints == "p"


def test_connect_changes_the_robot_in_place_and_returns_it():
    arm, hand = planar("arm"), planar("hand")
    assert arm.connect(hand) is arm
    assert arm.n == 4
    assert hand.parent is arm
    assert [c.name for c in arm.components] == ["arm", "hand"]


def test_what_is_attached_stands_in_the_last_joint_s_frame_not_in_the_gripper():
    arm, hand = planar("arm"), planar("hand", base=(0.5, 0, 0))
    arm.connect(hand)
    assert tip(arm, "arm/hand/1") == pytest.approx((1.5, 0, 0))
    assert "arm/grasper" not in arm.frames()


def test_connect_at_a_frame_leaves_the_grasper():
    arm, camera = planar("arm"), planar("camera", base=(0, 0, 0.1))
    arm.connect(camera, at=1)
    arm.q = [pi / 2, -pi / 2, 0, 0]
    assert tip(arm, "arm/camera/grasper") == pytest.approx((0, 2, 0.1))
    assert tip(arm, "arm/grasper") == pytest.approx((1, 1, 0))


def test_connecting_several_makes_a_complex_of_them_first():
    arm, left, right = planar("arm"), planar("left"), planar("right", base=(0, 1, 0))
    arm.connect(left, right)
    assert [r.name for r in arm.attached] == ["complex"]
    assert tip(arm, "arm/complex/right/1") == pytest.approx((1, 1, 0))
    assert arm.n == 6


def test_a_complex_leaves_its_components_where_they_are_in_the_world():
    left = planar("left", base=rp2t(rotz(0.3), (1, 2, 3)))
    right = planar("right", base=(-1, 0, 0))
    before = [left.world_pose, right.world_pose]
    pair = robot_complex(left, right, name="pair", base=rp2t(rotz(pi / 3), (0, 1, 0)))
    assert left.world_pose == pytest.approx(before[0], abs=1e-12)
    assert right.world_pose == pytest.approx(before[1], abs=1e-12)
    assert pair.base @ left.base == pytest.approx(before[0], abs=1e-12)


def test_moving_the_base_of_a_complex_moves_all():
    left, right = planar("left"), planar("right", base=(0, 5, 0))
    pair = robot_complex(left, right, name="pair")
    pair.base = (0, 0, 7)
    assert left.world_pose[:3, 3] == pytest.approx((0, 0, 7))
    assert tip(pair, "pair/right/grasper") == pytest.approx((2, 5, 7))


def test_a_complex_has_no_configuration_of_its_own():
    left, right = planar("left"), planar("right")
    pair = robot_complex(left, right)
    pair.q = [1, 2, 3, 4]
    assert left.q == pytest.approx([1, 2])
    assert right.q == pytest.approx([3, 4])
    left.q = [0, 0]
    assert pair.q == pytest.approx([0, 0, 3, 4])


def test_q_goes_own_joints_first_then_depth_first():
    a, b, c, d = (planar(name) for name in "abcd")
    b.connect(c)
    a.connect(b, at=1)
    a.connect(d)
    assert [part.name for part in a.components] == ["a", "b", "c", "d"]
    a.q = np.arange(8) / 10
    assert c.q == pytest.approx([0.4, 0.5])
    assert b.q == pytest.approx([0.2, 0.3, 0.4, 0.5])
    assert a.components[1].q == pytest.approx([0.2, 0.3])


def test_a_component_holds_its_own_joints_whatever_is_attached():
    arm, hand = planar("arm"), planar("hand")
    arm.connect(hand)
    own = arm.components[0]
    own.q = [0.1, 0.2]
    assert arm.q == pytest.approx([0.1, 0.2, 0, 0])
    assert own.n == 2
    own.color = "#ff0000"
    assert hand.color != own.color


def test_an_operation_on_the_whole_goes_to_all_components():
    arm, hand = planar("arm"), planar("hand")
    arm.connect(hand)
    arm.set(look="stick", color="#00ff00", show_csys=True)
    assert {c.look for c in arm.components} == {"stick"}
    assert hand.color == (0, 1, 0)
    arm.components[1].look = "solid"
    assert arm.look == "stick"


def test_a_complex_says_what_its_components_agree_on():
    pair = robot_complex(planar("left"), planar("right"))
    assert pair.look == "solid"
    pair.components[0].look = "stick"
    assert pair.look is None


def test_the_keywords_of_a_complex_leave_its_components_alone():
    left = planar("left", radius=0.3)
    robot_complex(left, planar("right"), radius=0.1, color="#000000")
    assert left.radius == 0.3
    assert left.color != (0, 0, 0)


def test_components_take_their_colours_from_the_palette_in_order():
    arm, hand = planar("arm"), planar("hand")
    alone = hand.color
    arm.connect(hand)
    assert arm.components[0].color == alone
    assert len({c.color for c in arm.components}) == 2


def test_frames_of_a_part_are_named_from_the_root_and_stand_in_the_world():
    arm, hand = planar("arm"), planar("hand")
    arm.connect(hand)
    arm.q = [pi / 2, 0, 0, 0]
    frames = hand.frames()
    assert list(frames) == ["arm/hand/1", "arm/hand/2", "arm/hand/grasper"]
    assert frames["arm/hand/grasper"][:3, 3] == pytest.approx((0, 3, 0))
    asked = hand.frames([[0, 0], [pi / 2, 0]])["arm/hand/grasper"]
    assert asked[1, :3, 3] == pytest.approx((-2, 1, 0))
    assert hand.q == pytest.approx([0, 0])


def test_frames_check_shape_and_finiteness_but_not_limits():
    r = planar("r", limits=[(-1, 1), (-1, 1)])
    r.frames([5, 5])
    with pytest.raises(InputError, match=r"q of 'r' must have shape \(2,\), got \(3,\)"):
        r.frames([1, 2, 3])
    with pytest.raises(InputError, match=r"q of 'r' must be finite, got nan"):
        r.frames([1, np.nan])


def test_a_configuration_outside_the_limits_is_refused_whole():
    arm, hand = planar("arm"), planar("hand", limits=[(-0.5, 0.5), (-1, 1)])
    arm.connect(hand)
    message = r"joint 1 of 'hand': 0.6000 rad \(34.4 deg\) is outside \[-0.5000, 0.5000\]"
    with pytest.raises(LimitError, match=message) as caught:
        arm.q = [1, 1, 0.6, 0]
    assert arm.q == pytest.approx([0, 0, 0, 0])
    assert caught.value.component == "hand"
    assert caught.value.joint == 1


def test_a_value_within_the_tolerance_is_put_on_the_limit():
    r = planar(limits=[(0, 1), (0, 1)])
    r.q = [1 + 5e-10, -5e-10]
    assert (r.q == [1, 0]).all()
    with pytest.raises(LimitError):
        r.q = [1 + 5e-9, 0]


def test_nothing_is_clipped_unless_asked():
    r = planar(limits=[(-1, 1), (-1, 1)])
    assert r.clip([5, -5]) == pytest.approx([1, -1])
    assert r.q == pytest.approx([0, 0])


def test_limits_that_shut_out_the_present_configuration_say_how_to_set_both():
    r = planar("r")
    with pytest.raises(LimitError, match=r"set\(limits=..., q=...\) sets both"):
        r.limits = [(1, 2), (0, 1)]
    assert np.isinf(r.limits).all()
    r.set(limits=[(1, 2), (0, 1)], q=[1.5, 0])
    assert r.q == pytest.approx([1.5, 0])


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"limits": [(1, -1), (0, 1)]}, "the lower limit 1 is above the upper limit -1"),
        ({"limits": [(0, 1)]}, r"limits must have shape \(2, 2\)"),
        ({"base": np.ones((4, 4))}, "base"),
        ({"look": "shiny"}, "look of 'robot' must be one of 'stick', 'solid', 'user', got 'shiny'"),
        ({"radius": 0}, "radius of 'robot' must be above 0, got 0"),
        ({"color": "red"}, "color of 'robot' must be three numbers in 0..1 or '#rrggbb'"),
    ],
)
def test_a_robot_that_cannot_be_is_refused_in_words(options, message):
    with pytest.raises(InputError, match=message):
        planar(**options)


def test_unknown_joint_letters_are_refused():
    with pytest.raises(InputError, match="no joint type 'x'"):
        robot([dh(0, 0, 0, 0)], "x")


def test_attaching_twice_to_itself_or_in_a_cycle_is_refused_and_changes_nothing():
    a, b, c = planar("a"), planar("b"), planar("c")
    a.connect(b)
    for wrong, message in [
        (lambda: c.connect(b), "'b' is attached to 'a' already"),
        (lambda: a.connect(a), "'a' cannot hang on 'a'"),
        (lambda: b.connect(a), "'a' cannot hang on 'b'"),
        (lambda: b.connect(c, a), "'a' cannot hang on 'b'"),
        (lambda: c.connect(c, planar("d")), "'c' cannot hang on 'c'"),
        (lambda: robot_complex(c, c), "'c' is attached to"),
    ]:
        with pytest.raises(AttachError, match=message):
            wrong()
    assert c.parent is None
    assert [r.name for r in a.robots()] == ["a", "b"]


def test_two_robots_of_one_name_are_refused_and_stay_free():
    a, b = planar("a"), planar("a")
    with pytest.raises(InputError, match="called 'a'"):
        robot_complex(a, b)
    assert a.parent is None
    assert b.parent is None


def test_a_complex_has_no_last_joint_to_connect_to():
    pair = robot_complex(planar("left"), planar("right"), name="pair")
    with pytest.raises(InputError, match=r"'pair' has no last joint .*'left', 'right'.* at=0"):
        pair.connect(planar("tool"))
    pair.connect(planar("tool"), at=0)
    assert pair.n == 6


@pytest.mark.parametrize("at", [3, -1, "grasper", True])
def test_a_frame_that_does_not_exist_is_refused(at):
    with pytest.raises(InputError, match=r"'arm' has frames 0 \(its base\) to 2"):
        planar("arm").connect(planar("hand"), at=at)


def test_a_robot_tells_once_whatever_is_set():
    arm, hand = planar("arm"), planar("hand")
    arm.connect(hand)
    ear = Listener()
    arm.watch(ear)
    arm.q = [1, 1, 1, 1]
    hand.set(q=[0, 0], color="#ff0000")
    arm.components[0].q = [0, 0]
    assert ear.heard == [arm, arm, arm]


def test_who_watches_the_hand_hears_that_the_arm_has_moved():
    arm, hand = planar("arm"), planar("hand")
    arm.connect(hand)
    ear = Listener()
    hand.watch(ear)
    arm.components[0].q = [1, 0]
    assert ear.heard == [hand]


def test_a_new_table_moves_the_frames():
    arm, hand = planar("arm"), planar("hand")
    arm.connect(hand)
    assert tip(arm, "arm/hand/grasper") == pytest.approx((3, 0, 0))
    hand.chain = hand.chain.replace(2, a=0.5)
    assert tip(arm, "arm/hand/grasper") == pytest.approx((2.5, 0, 0))
    with pytest.raises(InputError, match="chain of 'hand' must have 2 joints, got 1"):
        hand.chain = robot([dh(0, 0, 0, 0)], "r").chain


@pytest.mark.parametrize("joint", [0, 1, 2, "grasper"])
def test_the_user_s_part_is_drawn_in_its_frame_in_the_user_look_only(joint):
    r = planar("r", q=[pi / 2, 0])
    part = r.set_part(cube(0.1), joint=joint)
    wanted = {0: (0, 0, 0), 1: (0, 0, 0), 2: (0, 1, 0), "grasper": (0, 2, 0)}[joint]
    assert part.world_pose[:3, 3] == pytest.approx(wanted)
    assert not any(path.endswith("part") for path in r.describe())
    r.look = "user"
    drawn = {path: node for path, node in r.describe().items() if node.shape is not None}
    assert [path.rpartition("/")[2] for path in drawn] == ["part"]


def test_a_part_can_be_taken_away_and_given_to_another():
    a, b, part = planar("a"), planar("b"), cube(0.1)
    a.set_part(part, joint=1)
    with pytest.raises(AttachError, match="attached to 'a' already"):
        b.set_part(part, joint=1)
    a.set_part(None, joint=1)
    b.set_part(part, joint="grasper")
    assert part.parent is b


def test_a_part_stays_live():
    r, ear = planar("r", look="user"), Listener()
    part = r.set_part(cube(0.1), joint=2)
    r.watch(ear)
    part.color = "#00ff00"
    assert ear.heard == [r]
    assert r.describe()["r/1/2/part"].style.color == (0, 1, 0)


@pytest.mark.parametrize("joint", [3, -1, "tip", None, True])
def test_a_joint_that_does_not_exist_is_refused(joint):
    with pytest.raises(
        InputError, match=r"'r' has no joint .*; choose from 0 \(the base\), 1 to 2"
    ):
        planar("r").set_part(cube(1), joint=joint)


def test_the_nodes_of_a_robot_are_its_frames():
    arm, hand = planar("arm", base=transl((0, 0, 1))), planar("hand")
    arm.connect(hand)
    arm.q = [0.1, 0.2, 0.3, 0.4]
    world = {"": np.eye(4)}
    nodes = arm.describe()
    for path, node in nodes.items():
        world[path] = world[path.rpartition("/")[0]] @ node.matrix
    frames = arm.frames()
    assert world["arm/1/2"] == pytest.approx(frames["arm/2"], abs=1e-12)
    assert world["arm/1/2/hand/1/2"] == pytest.approx(frames["arm/hand/2"], abs=1e-12)
    assert world["arm/1/2/hand/1/2/grasper"] == pytest.approx(frames["arm/hand/grasper"], abs=1e-12)


def test_one_joint_moved_changes_one_node():
    r = planar("r")
    before = r.describe()
    r.q = [0, 0.5]
    after = r.describe()
    assert before.keys() == after.keys()
    moved = [path for path in after if after[path].value != before[path].value]
    assert moved == ["r/1/2"]
    bodies = [path for path in after if after[path].shape is not None]
    assert all(after[path] is before[path] for path in bodies)


@pytest.mark.parametrize("look", ["solid", "stick"])
@pytest.mark.parametrize("convention", ["modified", "standard"])
@pytest.mark.parametrize("joints", ["rr", "rp", "pr", "pp"])
def test_both_looks_draw_every_kind_of_joint(look, convention, joints):
    rows = [dh(0.3, 0.1, 0.2, 0.4), dh(-0.5, 1, 0.3, 0.1)]
    r = robot(rows, joints, convention=convention, look=look, show_csys=True)
    names = {path.rpartition("/")[2] for path, node in r.describe().items() if node.shape}
    assert {"link", "joint", "label"} <= names


def test_a_robot_reads_well():
    arm, left, right = planar("arm"), planar("left"), planar("right")
    arm.connect(robot_complex(left, right, name="hand"))
    assert repr(arm) == "\n".join(
        [
            "Robot 'arm': 6 variables in 3 components",
            "  arm: RR, modified DH",
            "    on joint 2 of arm:",
            "      hand: complex",
            "        left: RR, modified DH",
            "        right: RR, modified DH",
        ]
    )
