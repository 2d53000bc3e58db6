"""Robots of several chains whose inner frames stand otherwise: right as long as all tips agree."""

from math import pi

import numpy as np
import pytest

from dhlab import robot, robot_complex
from dhlab.diagnosis import RobotTask
from dhlab.diagnosis.chain_slips import table_slips
from dhlab.diagnosis.table_model import chain_of, table_of
from dhlab.grading.values import from_json, to_json
from dhlab.kinematics.chain import Chain
from dhlab.kinematics.transforms import inverse, rotx, rotz, rp2t, transl

OVER = rp2t(rotx(pi), (0, 0, 0))
COUNT = 60


def some_chain(rng):
    """A chain of one to four joints, many of them slides, often parallel or on one line."""
    n = int(rng.integers(1, 5))
    angles = [(0, 0, 0, pi / 2, -pi / 2), (0, pi / 2, -pi / 2, 0.4, -1.1)][int(rng.integers(2))]
    turns, lengths = rng.choice(angles, (n, 2)), rng.uniform(-1, 1, (n, 2))
    lengths *= rng.random((n, 2)) < 0.5
    return Chain(
        np.column_stack([turns[:, 0], lengths, turns[:, 1]]),
        "".join(rng.choice(["r", "p"], n)),
        rng.choice(["modified", "standard"]),
        base=rng.uniform(-1, 1, 3),
        grasper=rp2t(rotx(rng.uniform(-1, 1)), rng.uniform(-1, 1, 3)),
        offset=rng.uniform(-1, 1, n) * rng.integers(2),
    )


def tree(rng, chains=some_chain):
    """Random chains, and for each on which it hangs, and on which frame of it."""
    parts = []
    for i in range(rng.integers(1, 5)):
        on = int(rng.integers(-1, i)) if i else -1
        n = parts[on][0].n if on >= 0 else 0
        at = n if rng.random() < 0.6 else int(rng.integers(n + 1))
        parts.append((chains(rng).to_modified(), on, at))
    return parts


def built(parts):
    """The robot of these chains, joined by `connect` and `robot_complex`."""
    made = [
        robot(
            c.rows,
            c.joints,
            base=c.base,
            grasper=c.grasper,
            offset=c.offset,
            limits=c.limits,
            q=c.clip(c.home),
            name=f"part{i}",
        )
        for i, (c, _, _) in enumerate(parts)
    ]
    for one, (_, on, at) in zip(made, parts, strict=True):
        if on >= 0:
            made[on].connect(one, at=at)
    roots = [one for one, (_, on, _) in zip(made, parts, strict=True) if on < 0]
    return roots[0] if len(roots) == 1 else robot_complex(*roots)


def judged(task, parts):
    return task.judge([((), from_json(to_json(built(parts), "robot")))])


def otherwise(rng, chain):
    """A chain whose frames stand otherwise, and by which pose each of them does, from 0 to n.

    The base turns and slides along x; axes are turned over; the last frame turns about its axis
    and slides along it; joints count from other zeros.
    """
    rows, offset = np.array(chain.rows), np.array(chain.offset)
    limits = np.array(chain.limits)
    turn, slide = rng.uniform(-1, 1, 2)
    poses = [rp2t(rotx(turn), (slide, 0, 0))]
    rows[0, :2] -= turn, slide
    for i in range(chain.n):
        poses.append(np.eye(4))
        if rng.random() < 0.5:
            rows[i] *= (1, 1, -1, -1)
            rows[i, 0] += pi
            if i + 1 < chain.n:
                rows[i + 1, 0] -= pi
            offset[i] *= -1
            limits[i] = -limits[i, ::-1]
            poses[-1] = OVER
        zero = rng.uniform(-1, 1)  # a table with another zero tells the same frames
        offset[i] += zero
        limits[i] -= zero
    angle, length = rng.uniform(-1, 1, 2)
    poses[-1] = poses[-1] @ rp2t(rotz(angle), (0, 0, length))
    if chain.kinds[-1] == "r":
        rows[-1, 2] += length
        offset[-1] += angle
    else:
        rows[-1, 3] += angle
        offset[-1] += length
    grasper = inverse(poses[-1]) @ chain.grasper
    base = chain.base @ poses[0]
    return chain.replace(rows=rows, offset=offset, limits=limits, base=base, grasper=grasper), poses


def all_otherwise(rng, parts):
    """The same robot by other frames."""
    out, poses = [], []
    for chain, on, at in parts:
        other, moved = otherwise(rng, chain)
        if on >= 0:
            other = other.replace(base=inverse(poses[on][at]) @ other.base)
        out.append((other, on, at))
        poses.append(moved)
    return out


def anywhere(rng):
    """Return some pose."""
    turned = rotz(rng.uniform(-3, 3)) @ rotx(rng.uniform(-3, 3))
    return rp2t(turned, rng.uniform(-1, 1, 3))


def elsewhere(rng, parts, free):
    """The same robot with other poses before it or behind its tips, where these are free."""
    before = anywhere(rng)
    return [
        (
            c.replace(
                base=before @ c.base if free == "base_free" and on < 0 else c.base,
                grasper=c.grasper @ anywhere(rng) if free == "tool_free" else c.grasper,
            ),
            on,
            at,
        )
        for c, on, at in parts
    ]


@pytest.mark.parametrize("free", ["nothing", "base_free", "tool_free"])
def test_no_choice_of_inner_frames_is_called_wrong(free, tally):
    rng = np.random.default_rng(21)
    for _ in range(COUNT):
        parts = [
            (c.replace(limits=np.sort(rng.uniform(-1, 1, (c.n, 2)))), on, at)
            for c, on, at in tree(rng)
        ]
        ends = {} if free == "nothing" else {free: True}
        task = RobotTask(built(parts).mechanism, limits=True, **ends)
        came = built(elsewhere(rng, all_otherwise(rng, parts), free))
        tally.judge(task, [((), from_json(to_json(came, "robot")))])
    tally.check(share=0)


def test_a_robot_by_other_frames_that_moves_otherwise_is_wrong():
    rng = np.random.default_rng(22)
    for _ in range(COUNT):
        parts = tree(rng)
        task = RobotTask(built(parts).mechanism)
        came = all_otherwise(rng, parts)
        k = int(rng.integers(len(came)))
        chain, on, at = came[k]
        wrong = chain.replace(base=chain.base @ transl(rng.uniform(0.1, 0.5, 3)) @ OVER)
        came[k] = (wrong, on, at)
        assert not judged(task, came).right


@pytest.mark.parametrize("free", ["base_free", "tool_free"])
def test_a_table_with_a_free_end_that_moves_otherwise_is_wrong(free):
    """A base is free, but not the way from one tip to another; a tool, but not how it moves."""
    rng = np.random.default_rng(24)
    for _ in range(COUNT // 2):
        first, second = some_chain(rng), some_chain(rng)
        parts = [(first.to_modified(), -1, 0), (second.to_modified(), -1, 0)]
        task = RobotTask(built(parts).mechanism, **{free: True})
        came = elsewhere(rng, all_otherwise(rng, parts), free)
        assert judged(task, came).right
        chain = came[1][0]
        came[1] = (chain.replace(base=anywhere(rng) @ chain.base), -1, 0)
        assert not judged(task, came).right


def test_slides_that_do_the_same_may_share_their_zero_as_they_like():
    """Two slides along one line, on two parts: the limits tell which zeros were meant."""

    def lift(first, second, height=0):
        column = robot([(0, 0, 0, 0)], "p", name="column", limits=[first], q=[first[0]])
        rows, limits = [(0, 0, 0, 0), (0, 0.2, 0, 0)], [second, (-1, 1)]
        arm = robot(rows, "pr", name="arm", base=(0, 0, height), limits=limits, q=[second[0], 0])
        return column.connect(arm)

    task = RobotTask(lift((0, 1), (0, 0.5)).mechanism, limits=True)

    def verdict(*ends):
        return task.judge([((), from_json(to_json(lift(*ends), "robot")))])

    assert verdict((0.3, 1.3), (-0.3, 0.2)).right
    assert verdict((0.3, 1.3), (0, 0.5), -0.3).right
    off = verdict((0.3, 1.3), (0, 0.5))
    assert not off.right
    assert "limit of joint 1 is not the one asked for" in off.text


def test_joints_that_branches_share_must_be_renamed_alike():
    palm = robot([(0, 0, 0, 0)], "r", name="palm")
    fingers = [
        robot([(pi / 2, 0.1, 0, 0)], "r", name=n, base=(0, y, 0), grasper=(0.1, 0, 0))
        for n, y in (("one", 0.1), ("two", -0.1))
    ]
    task = RobotTask(palm.connect(*fingers).mechanism)

    def turned(first, second):
        hub = robot([(0, 0, 0, 0)], "r", name="palm")
        for n, y, angle in (("one", 0.1, first), ("two", -0.1, second)):
            base = rp2t(rotz(angle), (0, 0, 0)) @ transl((0, y, 0))
            hub.connect(robot([(pi / 2, 0.1, 0, 0)], "r", name=n, base=base, grasper=(0.1, 0, 0)))
        return task.judge([((), from_json(to_json(hub, "robot")))])

    assert turned(0.4, 0.4).right
    assert not turned(0.4, 0.3).right


@pytest.mark.parametrize("swivels", [("one",), ("one", "two"), ("two",)])
def test_what_one_branch_leaves_open_another_settles(swivels):
    """A branch that turns about the palm's own axis tells nothing of the palm's zero."""

    def hand(angle):
        hub = robot([(0, 0, 0, 0)], "r", name="palm")
        for n in ("one", "two"):
            rows = [(0, 0, 0.1, 0), (pi / 2, 0, 0, 0)] if n in swivels else [(pi / 2, 0.2, 0, 0)]
            base = rp2t(rotz(angle), (0, 0, 0))
            one = robot(rows, "r" * len(rows), name=n, base=base, grasper=(0.1, 0, 0))
            hub.connect(one)
        return hub

    task = RobotTask(hand(0).mechanism)
    assert task.judge([((), from_json(to_json(hand(0.4), "robot")))]).right


def test_the_mistake_in_the_table_of_one_part_is_still_named(chains, tally):
    rng = np.random.default_rng(23)
    for _ in range(COUNT):
        parts = tree(rng, chains)
        k = int(rng.integers(len(parts)))
        chain, on, at = parts[k]
        slips = [s for s in table_slips(chain) if s.mistake.key != "radians"]
        slip = slips[rng.integers(len(slips))]
        table = slip.change(table_of(chain, chain.home))
        if table.is_chain(chain.n):
            came = [*parts]
            came[k] = (chain_of(table), on, at)
            value = from_json(to_json(built(came), "robot"))
            task = RobotTask(built(parts).mechanism)
            tally.judge(task, [((), value)], {slip.mistake.key})
    tally.check()
