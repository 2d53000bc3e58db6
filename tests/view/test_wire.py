"""What goes over the wire, read back as a page reads it."""

import json

import numpy as np
import pytest

from dhlab.scene.node import Clock, Curve, Joint, Node, Style
from dhlab.shapes import Label, Lines, cube, sphere
from dhlab.view.commands import Remove, diff
from dhlab.view.wire import Wire

POSE = np.array([[0.0, -1, 0, 1], [1, 0, 0, 2], [0, 0, 1, 1 / 3], [0, 0, 0, 1]])
AFTER = np.eye(4) + np.eye(4, k=3)
CLOCK = Clock("clock-1", np.array([0.0, 0.5, 2.0]))


PLAIN = Style()


def finger(q=(0.0, 0.0), curves=(None, None), look=PLAIN):
    joint = Joint("r", np.eye(4), "k1"), Joint("p", AFTER, "k2")
    return {
        "finger": Node(),
        "finger/1": Node(pose=POSE, joint=joint[0], value=q[0], curve=curves[0]),
        "finger/1/body": Node(shape=cube(1), style=look),
        "finger/1/2": Node(pose=POSE, joint=joint[1], value=q[1], curve=curves[1]),
        "finger/1/2/body": Node(shape=cube(1), style=look),
        "finger/1/2/label": Node(shape=Label("x_1"), visible=False),
    }


def numbers(buffer, kind, at, count):
    return np.frombuffer(buffer, kind, count, at)


def split(snapshot):
    length = int.from_bytes(snapshot[:4], "little")
    header = json.loads(snapshot[4 : 4 + length])
    return header, snapshot[-(-(4 + length) // 8) * 8 :]


def test_joints_that_move_are_one_small_array_of_numbers():
    wire = Wire(finger())
    header, buffer = wire.batch(diff(wire.nodes, finger(q=(0.25, 1e-9))))
    joints = header["joints"]
    assert numbers(buffer, "<f8", joints["values"], 2).tolist() == [0.25, 1e-9]
    assert numbers(buffer, "<u4", joints["ids"], 2).tolist() == [2, 4]
    assert header.keys() == {"kind", "format", "seq", "joints"}


def test_a_body_that_moves_is_twelve_single_precision_numbers():
    wire = Wire({"cube": Node(shape=cube(1))})
    header, buffer = wire.batch(diff(wire.nodes, {"cube": Node(shape=cube(1), pose=POSE)}))
    matrix = numbers(buffer, "<f4", header["poses"]["matrices"], 12)
    assert matrix.tolist() == POSE[:3].astype(np.float32).ravel().tolist()
    assert "geometry" not in header


def test_a_joint_whose_constant_changes_sends_pose_and_value():
    wire = Wire(finger())
    new = finger() | {"finger/1": finger()["finger/1"]._replace(pose=AFTER)}
    header, _ = wire.batch(diff(wire.nodes, new))
    assert (header["joints"]["count"], header["poses"]["count"]) == (1, 1)


def test_batches_are_numbered_from_the_snapshot_on():
    wire = Wire(finger())
    assert split(wire.snapshot())[0]["seq"] == 0
    assert [wire.batch(diff(wire.nodes, finger((q, 0))))[0]["seq"] for q in (1, 2)] == [1, 2]
    assert split(wire.snapshot())[0]["seq"] == 2


def test_the_constants_of_a_node_are_sent_in_double_precision():
    header, buffer = split(Wire(finger()).snapshot())
    put = header["puts"][3]
    assert put["path"] == "finger/1/2"
    assert numbers(buffer, "<f8", put["pose"], 12).tolist() == POSE[:3].ravel().tolist()
    assert put["joint"] == {"kind": "p", "key": "k2", "after": AFTER[:3].ravel().tolist()}
    assert header["puts"][1]["joint"]["after"] is None


def test_geometry_is_sent_once_for_all_that_share_it():
    header, buffer = split(Wire(finger()).snapshot())
    assert sorted(header["geometry"]) == sorted([cube(1).digest, Label("x_1").digest])
    mesh = header["geometry"][cube(1).digest]
    positions, normals, index = cube(1).render_arrays()
    assert numbers(buffer, "<f4", mesh["positions"], positions.size).tolist() == [
        *positions.ravel()
    ]
    assert numbers(buffer, "<f4", mesh["normals"], normals.size).tolist() == [*normals.ravel()]
    assert numbers(buffer, "<u4", mesh["indices"], index.size).tolist() == [*index.ravel()]
    assert mesh["segments"] == 12


def test_geometry_that_the_page_has_is_not_sent_again():
    wire = Wire(finger())
    header, _ = wire.batch(diff(wire.nodes, finger() | {"more": Node(shape=cube(1))}))
    assert "geometry" not in header
    header, _ = wire.batch(diff(wire.nodes, wire.nodes | {"ball": Node(shape=sphere(1))}))
    assert list(header["geometry"]) == [sphere(1).digest]


def test_geometry_that_nothing_used_any_more_is_sent_again():
    wire = Wire({"a": Node(shape=cube(1))})
    wire.batch(diff(wire.nodes, {}))
    header, _ = wire.batch(diff(wire.nodes, {"a": Node(shape=cube(1))}))
    assert list(header["geometry"]) == [cube(1).digest]


def test_lines_are_sent_as_the_ends_of_their_segments():
    lines = Lines([[0, 0, 0], [1, 0, 0], [1, 2, 0]], [[0, 1], [1, 2]])
    header, buffer = split(Wire({"path": Node(shape=lines)}).snapshot())
    form = header["geometry"][lines.digest]
    ends = [0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 2, 0]
    assert numbers(buffer, "<f4", form["segments"], 12).tolist() == ends


def test_styles_are_named_by_number():
    red = Style(color=(1, 0, 0), edge_color=(0, 0, 0))
    header, _ = split(Wire(finger(look=red)).snapshot())
    assert [put["style"] for put in header["puts"]] == [0, 0, 1, 0, 1, 0]
    assert header["styles"][1]["color"] == (1, 0, 0) or header["styles"][1]["color"] == [1, 0, 0]
    assert header["puts"][-1]["visible"] is False


def test_a_planned_motion_is_sent_whole_and_its_clock_once():
    curves = [Curve(CLOCK, np.array([0.0, 1, 2])), Curve(CLOCK, np.array([3.0, 4, 5]))]
    wire = Wire(finger())
    header, buffer = wire.batch(diff(wire.nodes, finger((2.0, 5.0), curves)))
    (first, one), (second, two) = header["curves"]
    assert (first, second) == (2, 4)
    assert numbers(buffer, "<f8", two["at"], 3).tolist() == [3, 4, 5]
    clock = header["clocks"]["clock-1"]
    assert numbers(buffer, "<f8", clock["at"], 3).tolist() == [0, 0.5, 2]
    assert one["clock"] == "clock-1"
    header, _ = wire.batch(diff(wire.nodes, finger((2.0, 5.0))))
    assert header["curves"] == [(2, None), (4, None)]


def test_poses_of_a_planned_motion_have_twelve_numbers_each():
    samples = np.stack([np.eye(4), POSE, AFTER])
    node = Node(pose=AFTER, curve=Curve(CLOCK, samples))
    header, buffer = split(Wire({"block": node}).snapshot(play=True))
    curve = header["puts"][0]["curve"]
    assert (curve["width"], curve["count"]) == (12, 3)
    sent = numbers(buffer, "<f4", curve["at"], 36).reshape(3, 3, 4)
    assert np.array_equal(sent, samples[:, :3].astype(np.float32))
    assert header["play"] == ["clock-1"]


def test_a_node_that_comes_back_is_a_new_one():
    wire = Wire({"a": Node(), "b": Node()})
    header, _ = wire.batch([Remove("a")])
    assert header["removes"] == [1]
    header, _ = wire.batch(diff(wire.nodes, {"b": Node(), "a": Node()}))
    assert header["puts"][0]["id"] == 3


@pytest.mark.parametrize("count", [1, 27, 60])
def test_a_change_of_many_joints_stays_small(count):
    still = {str(k): Node(joint=Joint("r", np.eye(4), f"k{k}")) for k in range(count)}
    moved = {path: node._replace(value=1 / 3) for path, node in still.items()}
    header, buffer = Wire(still).batch(diff(still, moved))
    assert len(json.dumps(header)) + len(buffer) < 110 + 12 * count + 16
