"""The paper's upper limb: its numbers, where it points, and how it looks."""

import json
from pathlib import Path

import numpy as np
import pytest
from numpy import pi
from numpy.testing import assert_allclose

from dhlab import shapes
from dhlab.errors import InputError, LimitError
from dhlab.kinematics.transforms import transl
from dhlab.models import arm, finger, hand, thumb, upper_limb
from dhlab.models import limb_look as look
from dhlab.scene.block import block_merge
from dhlab.scene.blocks import cuboid, prism

GOLDEN = json.loads(Path(__file__).parents[1].joinpath("data/limb_golden.json").read_text("utf-8"))
NAMES = ["arm", "thumb", "index", "middle", "ring", "little"]
HOME, Q0, QT = (np.array(c["q"]) for c in GOLDEN["configurations"])


def short(name):
    """Name of a frame without the path to its component."""
    return "/".join(name.split("/")[-2:])


def frames(q):
    return {short(name): T for name, T in upper_limb().frames(q).items()}


def golden_frames(configuration):
    for name, robot in zip(NAMES, configuration["frames"].values(), strict=True):
        yield from ((f"{name}/{i}", T) for i, T in enumerate(robot["joints"], start=1))
        if name != "arm":
            yield f"{name}/grasper", robot["tip"]


@pytest.mark.parametrize("configuration", GOLDEN["configurations"], ids=lambda c: c["name"])
def test_every_frame_of_the_limb_is_where_50_digits_put_it(configuration):
    found, wanted = frames(configuration["q"]), dict(golden_frames(configuration))
    assert list(found) == list(wanted)
    for name, T in wanted.items():
        assert_allclose(found[name], T, atol=1e-12, err_msg=name)


def test_the_limb_has_27_variables_in_6_components():
    limb = upper_limb()
    assert [(part.name, part.n) for part in limb.components] == [
        ("arm", 7),
        *((name, 4) for name in NAMES[1:]),
    ]
    assert (limb.n, len(limb.frames())) == (27, 32)
    assert_allclose(limb.limits, GOLDEN["range"])
    assert_allclose(limb.q, HOME)


def test_each_call_gives_a_fresh_limb():
    one, other = upper_limb(), upper_limb()
    one.q = QT
    assert_allclose(other.q, HOME)


def test_at_home_the_arm_hangs_and_the_forearm_points_to_the_front_palm_down():
    f = frames(HOME)
    assert_allclose(f["arm/4"][:3, 3], (0, 0, -0.25), atol=1e-12)
    assert_allclose(f["arm/7"][:3, 3], (0, -0.25, -0.25), atol=1e-12)
    assert_allclose(f["arm/7"][:3, 2], (0, 0, 1), atol=1e-12)
    assert_allclose(f["arm/7"][:3, 1], (1, 0, 0), atol=1e-12)


def test_q0_is_the_arm_stretched_to_the_side_and_qt_a_handshake():
    assert_allclose(frames(Q0)["arm/7"][:3, :3], np.diag((-1, -1, 1)), atol=1e-12)
    assert_allclose(frames(Q0)["arm/7"][:3, 3], (-0.5, 0, 0), atol=1e-12)
    shake = frames(QT)["arm/7"]
    assert_allclose(shake[:3, 0], (0, -1, 0), atol=1e-12)
    assert_allclose(shake[:3, 1], (0, 0, 1), atol=1e-12)
    assert_allclose(-shake[:3, 2], (1, 0, 0), atol=1e-12)


@pytest.mark.parametrize(("name", "side"), [("index", 1), ("ring", -1), ("little", -1)])
def test_fingers_spread_away_from_the_middle_one(name, side):
    one = finger(name)
    end = one.limits[0][np.abs(one.limits[0]).argmax()]
    moved = one.frames([end, 0, 0, 0])[f"{name}/grasper"] - one.frames(4 * [0])[f"{name}/grasper"]
    assert side * moved[1, 3] > 0.01


def test_the_thumb_bends_towards_the_fingers():
    t = thumb()
    assert_allclose(t.frames(4 * [0])["thumb/2"][:3, 0], (0, 0, -1), atol=1e-12)
    assert_allclose(t.frames([0, pi / 2, 0, 0])["thumb/2"][:3, 0], (1, 0, 0), atol=1e-12)


def test_the_limits_of_table_3_hold():
    index = finger()
    with pytest.raises(LimitError, match=r"joint 1 of 'index': 0\.5000 rad"):
        index.q = (0.5, 0, 0, 0)


def test_an_unknown_finger_is_refused_with_the_choice():
    with pytest.raises(InputError, match="no finger 'pinkie'; there are 'index', 'middle'"):
        finger("pinkie")


def test_the_forefinger_is_made_of_the_blocks_of_the_papers_listing():
    pentagon = [[-0.01, -0.01], [0, -0.01], [0.01, 0], [0.01, 0.01], [-0.01, 0.01]]
    tongue = cuboid(0.02, 0.01, 0.005).move((0, 0, -0.0025))
    segments = {
        (0.05, look.phalanx): cuboid(0.03, 0.02, 0.02).move((0.025, 0, -0.01)),
        (0.03, look.phalanx): cuboid(0.01, 0.02, 0.02).move((0.015, 0, -0.01)),
        (0.025, look.fingertip): cuboid(0.005, 0.02, 0.02).move((0.0125, 0, -0.01)),
    }
    for (length, segment), body in segments.items():
        if segment is look.fingertip:
            ends = [prism(shapes.arc([0.015, 0.01], [0.015, -0.01], 0.01), 0.02)]
            ends[0].move((0, 0, -0.01))
        else:
            ends = [prism(pentagon, 0.007).move((length, 0, z)) for z in (-0.01, 0.003)]
        listed, made = block_merge(tongue, body, *ends), segment(length, 0.01)
        assert_allclose(made.vertices, listed.vertices, atol=1e-15)
        assert made.faces == listed.faces


def test_the_bevel_of_the_prongs_faces_the_palm_and_the_thumbs_the_other_way():
    for segment, palmwards in (
        (look.phalanx(0.05, 0.01), -1),
        (look.opposed(look.phalanx(0.05, 0.012)), 1),
    ):
        front = segment.vertices[:, 0] > 0.05 + 1e-6
        assert (palmwards * segment.vertices[front, 1] < 1e-9).all()


def test_the_fingertip_ends_at_25_mm_in_joint_frame_4():
    assert_allclose(look.fingertip(0.025, 0.01).bounds[:, 0], (-0.01, 0.025), atol=1e-12)


def test_a_tongue_fits_between_the_prongs_of_the_segment_before():
    for r in (0.008, 0.009, 0.010, 0.012):
        z = look.phalanx(0.04, r).vertices
        tongue = z[:8, 2]
        prongs = z[16:, 2]
        assert np.abs(tongue).max() < np.abs(prongs).min()


def test_the_palm_has_78_vertices_and_37_faces_of_which_two_have_26_corners():
    palm = look.palm()
    sizes = sorted(map(len, palm.faces))
    assert (len(palm.vertices), len(palm.faces)) == (78, 37)
    assert sizes[-2:] == [26, 26]
    assert_allclose(palm.vertices[:2], [(0, 0.02, 0.015), (0.02, 0.04, 0.015)])
    assert_allclose(palm.bounds[:, 2], (-0.015, 0.015))


def test_the_palm_leaves_a_slot_around_each_knuckle():
    faces = shapes.polygon(look.BACK_OF_HAND)
    a, b, c = faces.vertices[faces.triangles.T][..., :2]

    def covered(p):
        turns = [np.linalg.det(np.stack([v - u, p - u], -1)) for u, v in ((a, b), (b, c), (c, a))]
        return (np.sign(turns) == np.sign(turns[0])).all(axis=0).any()

    for name in NAMES[2:]:
        x, y, _ = finger(name).base[:3, 3]
        assert not covered((x, y))
        assert covered((x, y + 0.005))
        assert covered((x, y - 0.005))


PARTS = {
    path: node
    for path, node in upper_limb().set(look="user").describe().items()
    if node.shape is not None
}


@pytest.mark.parametrize("path", PARTS)
def test_every_part_is_a_closed_body_that_looks_outwards(path):
    mesh = PARTS[path].shape
    assert mesh.is_closed
    assert mesh.volume > 0


def test_every_segment_of_the_limb_has_a_part():
    bodies = {path.partition("/part")[0].removeprefix("arm/1/2/3/4/5/6/7/") for path in PARTS}
    fingers = {f"hand/{name}/1/{rest}" for name in NAMES[1:] for rest in ("2", "2/3", "2/3/4")}
    own = {"arm", "arm/1/2/3", "arm/1/2/3/4", "arm/1/2/3/4/5", "arm/1/2/3/4/5/6", "hand"}
    assert bodies == own | fingers | {"hand/thumb/1"}


def test_the_arm_is_one_body_without_a_step_at_elbow_and_turning_place():
    upper, fore, lower = look.UPPER_ARM[-1], look.FOREARM, look.LOWER_FOREARM
    assert_allclose(upper[1:3], fore[0][1:3], atol=3e-3)
    assert fore[-1] == lower[0]
    assert fore[-1][1] == fore[-1][2]
    assert_allclose(look.upper_arm().bounds[:, 0], (-0.048, 0.280), atol=2e-3)
    assert_allclose(look.forearm().bounds[:, 1], (-0.14, 0.034), atol=2e-3)
    assert_allclose(look.lower_forearm().bounds[:, 2], (-0.15, -0.002), atol=2e-3)


def test_hand_and_arm_can_be_had_alone():
    assert (hand().n, arm().n) == (20, 7)
    assert hand().base == pytest.approx(transl((0, 0, 0)))
