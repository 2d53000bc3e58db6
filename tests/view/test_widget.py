"""The widget of a view, with a channel that leads nowhere."""

import gc
import json
import weakref
from time import monotonic, sleep

import numpy as np
import pytest

from dhlab.scene.node import Clock, Curve
from dhlab.view import View, assets
from dhlab.view.widget import Library
from dhlab.view.wire import Wire

from .conftest import Box


def scene_of(comm, state=None):
    """Header of the snapshot in a state of a widget."""
    data, buffers = (comm.opened["data"], comm.opened["buffers"]) if state is None else state
    snapshot = buffers[data["buffer_paths"].index(["scene"])]
    return json.loads(snapshot[4 : 4 + int.from_bytes(snapshot[:4], "little")])


def paths_of(header):
    return [put["path"] for put in header["puts"]]


def open_view(comms, *boxes, **options):
    view = View("test", **options).add(*boxes)
    widget = view.widget
    return view, next(comm for comm in comms if comm.comm_id == widget.model_id)


def registered():
    from ipywidgets.widgets.widget import _instances

    return [type(widget).__name__ for widget in _instances.values()]


def wait_for(condition, seconds=2.0):
    end = monotonic() + seconds
    while not condition() and monotonic() < end:
        sleep(0.002)
    return condition()


def test_a_view_opens_nothing_before_it_is_shown(comms, box):
    view = View().add(box)
    box.shift(1)
    assert view.nodes
    assert comms == []


def test_the_widget_opens_with_the_present_scene(comms, box):
    box.shift(4)
    _, comm = open_view(comms, box)
    header = scene_of(comm)
    assert paths_of(header) == ["crate", "crate/body", "crate/lid", "crate/lid/knob"]
    assert header["seq"] == 0


def test_a_change_is_one_message(comms, box):
    _, comm = open_view(comms, box)
    box.shift(1)
    ((header, buffer),) = comm.batches
    assert header["seq"] == 1
    assert header["poses"]["count"] == 1
    assert len(json.dumps(header)) + len(buffer) < 250


def test_whoever_asks_gets_the_scene_as_it_is_then(comms, box):
    view, comm = open_view(comms, box)
    box.change(has_lid=False)
    view.flush()
    comm.sent.clear()
    comm.receive({"ask": "scene"})
    ((data, buffers),) = comm.sent
    assert data["method"] == "update"
    header = scene_of(comm, (data, buffers))
    assert paths_of(header) == ["crate", "crate/body"]
    assert header["seq"] == 1


def test_a_page_that_has_the_present_scene_gets_no_other(comms, box):
    view, comm = open_view(comms, box)
    comm.receive({"ask": "scene", "have": 0})
    assert comm.sent == []
    box.shift(1)
    view.flush()
    comm.sent.clear()
    comm.receive({"ask": "scene", "have": 0})
    assert len(comm.sent) == 1


@pytest.mark.parametrize("key", [None, "scene", ["name", "scene"]])
@pytest.mark.parametrize("drop_defaults", [True, False])
def test_every_state_carries_the_scene(comms, box, key, drop_defaults):
    view, _ = open_view(comms, box)
    box.change(has_lid=False)
    view.flush()
    state = view.widget.get_state(key, drop_defaults)
    assert state["scene"] == Wire(view.nodes).snapshot()[:4] + state["scene"][4:]
    assert b"crate/lid" not in state["scene"]
    assert "scene" not in view.widget.get_state("name")


def test_an_unknown_message_of_the_page_is_no_error(comms, box):
    _, comm = open_view(comms, box)
    for content in ({}, {"ask": "money"}, [], None, "scene"):
        comm.receive(content)
    assert comm.sent == []


def test_a_motion_plays_where_the_widget_is_new_and_rests_where_a_page_comes_back(comms, box):
    clock = Clock("c", np.array([0.0, 1.0]))
    curve = Curve(clock, np.stack([np.eye(4)] * 2))
    original = box._nodes

    def moving(path):
        nodes = original(path)
        nodes[path] = type(nodes[path])(pose=box.pose, curve=curve)
        return nodes

    Moving = type("Moving", (Box,), {"_nodes": lambda self, path: moving(path)})
    view, comm = open_view(comms, Moving("m"))
    assert scene_of(comm)["play"] == ["c"]
    comm.receive({"ask": "scene"})
    assert scene_of(comm, comm.sent[-1])["play"] == []
    assert view.nodes["m"].curve is curve


def test_ten_thousand_changes_end_at_once_and_the_last_is_told(comms, box):
    view, comm = open_view(comms, box)
    began = monotonic()
    for x in range(10_000):
        box.shift(x)
    took = monotonic() - began
    assert wait_for(lambda: view._picture.nodes["crate"].pose[0, 3] == 9999)
    header, buffer = comm.batches[-1]
    assert np.frombuffer(buffer, "<f4", 12, header["poses"]["matrices"])[3] == 9999
    assert len(comm.batches) <= took * 60 + 3


def test_two_views_share_the_library(comms, box):
    views = [View(str(k)).add(box) for k in range(3)]
    libraries = {view.widget.library.model_id for view in views}
    assert len(libraries) == 1
    assert registered().count("Library") == 1
    sizes = [len(json.dumps(comm.opened["data"])) for comm in comms]
    assert sum(size > 500_000 for size in sizes) == 1


def test_the_page_gets_the_viewer_before_the_scene_is_described(comms, box):
    view = View().add(box)
    first = []
    describe = box.describe
    box.describe = lambda name: first.append([*comms]) or describe(name)
    assert view.widget.comm in comms
    states = [comm.opened["data"]["state"] for comm in first[0]]
    assert [state["digest"] for state in states if "meshcat" in state] == [assets.digest()]
    assert not any("scene" in state for state in states)


def test_the_library_comes_back_when_everything_was_closed(comms, box):
    from ipywidgets import Widget

    view = View().add(box)
    first = view.widget.library
    Widget.close_all()
    assert view.widget.library is not first
    assert isinstance(view.widget.library, Library)


def test_a_closed_view_leaves_nothing_in_the_registry(comms, box):
    View("keeps the library").widget  # noqa: B018
    before = registered()
    view, comm = open_view(comms, box)
    view.close()
    assert comm.is_closed
    assert [name for name in registered() if name == "SceneWidget"] == [
        name for name in before if name == "SceneWidget"
    ]
    box.shift(1)
    assert comm.batches == []


def test_a_closed_view_can_be_shown_again(comms, box):
    view, _ = open_view(comms, box)
    view.close()
    box.shift(2)
    header = scene_of(next(c for c in comms if c.comm_id == view.widget.model_id))
    assert paths_of(header)[0] == "crate"


def test_fifty_views_that_were_closed_are_gone(comms, box):
    references = []
    for _ in range(50):
        view, _ = open_view(comms, box)
        references.append(weakref.ref(view))
        view.close()
        comms.clear()
    del view
    gc.collect()
    assert [reference() for reference in references] == [None] * 50
    assert registered().count("SceneWidget") == 0
    assert registered().count("Layout") <= 2


def test_the_loader_of_each_view_is_small(comms, box):
    view, _ = open_view(comms, box)
    assert len(view.widget._esm) < 8000
    assert assets.digest() == view.widget.library_digest


def test_a_client_that_keeps_no_messages_is_told_the_scene_as_state_when_it_has_changed(comms, box):
    view, comm = open_view(comms, box)

    def told():
        view.keep()
        states = [(data, buffers) for data, buffers in comm.sent if data["method"] == "update"]
        comm.sent.clear()
        return [scene_of(comm, state) for state in states]

    assert [header["play"] for header in told()] == [[]]
    assert told() == []
    box.change(has_lid=False)
    (header,) = told()
    assert paths_of(header) == ["crate", "crate/body"]
    view.close()
    box.shift(1)
    view.keep()
