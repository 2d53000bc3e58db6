"""What is shown alone stands and moves in the world as what carries it has it."""

import numpy as np
import pytest

from dhlab import animate, block_complex, cube, dh, robot, robot_complex, rotz, rp2t
from dhlab.scene.marks import _at_instant

T = np.linspace(0, 2, 5)


def placed(nodes, clock, k):
    """Poses of nodes in the world at instant `k` of a motion."""
    poses = {"": np.eye(4)}
    for path, node in nodes.items():
        above = poses[path.rpartition("/")[0]]
        poses[path] = above @ _at_instant(node, clock, k).matrix
    return poses


class Limb:
    """An arm, a hand of two fingers on it, and on a finger two cubes as the user's part."""

    def __init__(self, seed):
        self.rng = np.random.default_rng(seed)
        fingers = [self.chain("one", 2), self.chain("two", 1)]
        self.hand = robot_complex(*fingers, name="hand", base=(0, 0, 0.1))
        self.arm = self.chain("arm", 3).connect(self.hand, at=2)
        self.inner = cube(0.1, name="inner", pose=self.pose())
        self.cubes = block_complex(self.inner, cube(0.2, name="other"), name="cubes")
        self.finger = fingers[0].set(look="user")
        self.finger.set_part(self.cubes, joint="grasper")
        self.parts = {
            "arm/1/2/hand": self.hand,
            "arm/1/2/hand/one": self.finger,
            "arm/1/2/hand/two": fingers[1],
            "arm/1/2/hand/one/1/2/grasper/part": self.cubes,
            "arm/1/2/hand/one/1/2/grasper/part/inner": self.inner,
        }

    def chain(self, name, n):
        rows = [dh(*self.rng.uniform(-1, 1, 4)) for _ in range(n)]
        joints = "".join(self.rng.choice(["r", "p"], n))
        convention = self.rng.choice(["modified", "standard"])
        base = self.pose()
        return robot(rows, joints, name=name, base=base, convention=str(convention))

    def pose(self):
        return rp2t(rotz(self.rng.uniform(-1, 1)), self.rng.uniform(-1, 1, 3))

    def swing(self, moved):
        end = self.rng.uniform(-1, 1, moved.n)
        return lambda t: t * end

    def drift(self, t):
        return rp2t(rotz(t), (t, 0, 0))


@pytest.fixture(params=range(4))
def limb(request):
    return Limb(request.param)


@pytest.mark.parametrize("movers", ["arm", "own", "hand", "finger", "cubes", "arm and cubes"])
def test_a_part_shown_alone_is_at_every_instant_where_the_whole_has_it(limb, movers):
    robots = {"arm": limb.arm, "own": limb.arm.own, "hand": limb.hand, "finger": limb.finger}
    motions = {r: limb.swing(r) for name, r in robots.items() if name in movers.split()}
    if "cubes" in movers:
        motions[limb.cubes] = limb.drift
    clock = animate(T, motions).clock
    whole = limb.arm.describe()
    for above, part in limb.parts.items():
        alone = part.describe("alone")
        for k in range(len(T)):
            there, here = placed(whole, clock, k), placed(alone, clock, k)
            for path, pose in here.items():
                if path:
                    wanted = there[path.replace("alone", above, 1)]
                    assert pose == pytest.approx(wanted, abs=1e-12), (above, path, k)


def test_of_two_motions_on_the_way_the_one_further_out_is_played(limb):
    first = animate(T, {limb.arm.own: limb.swing(limb.arm.own)}).clock
    assert limb.cubes.describe("alone")["alone"].curve.clock is first
    second = animate(T, {limb.finger: limb.swing(limb.finger)}).clock
    alone = limb.cubes.describe("alone")["alone"]
    assert alone.curve.clock is second
    assert alone.curve.samples[-1] == pytest.approx(alone.pose, abs=1e-12)
    assert alone.pose == pytest.approx(limb.cubes.world_pose, abs=1e-12)
    assert limb.hand.describe("alone")["alone"].curve.clock is first


def test_a_motion_of_what_carries_a_part_is_sent_once_and_ends_with_it(limb):
    animate(T, {limb.arm: limb.swing(limb.arm)})
    first = limb.finger.describe("alone")["alone"].curve
    limb.finger.color = "#d55e00"
    assert limb.finger.describe("alone")["alone"].curve is first
    limb.arm.base = limb.pose()
    assert limb.finger.describe("alone")["alone"].curve is None


def test_the_path_that_a_carried_block_leaves_is_that_in_the_world(limb):
    clock = animate(T, {limb.arm: limb.swing(limb.arm), limb.cubes: limb.drift}, trace=True).clock
    (trail,) = limb.cubes.trails(clock)
    way = [placed(limb.cubes.describe("alone"), clock, k)["alone"][:3, 3] for k in range(len(T))]
    assert trail.points == pytest.approx(np.array(way), abs=1e-12)
    assert not np.allclose(trail.points[0], trail.points[-1])


def test_a_pose_in_the_world_cannot_be_written_to(limb):
    for part in limb.parts.values():
        with pytest.raises(ValueError, match="read-only"):
            part.world_pose[0, 3] = 1
