"""Views of handles, without a screen."""

import gc
import subprocess
import sys
import threading
import weakref

import numpy as np
import pytest

from dhlab.errors import InputError
from dhlab.view import Place, Put, RecordingBackend, Remove, View, show

from .conftest import Box


def kinds(batch):
    return [type(command) for command in batch]


def test_a_handle_that_is_added_is_seen(recorded, box):
    view, _ = recorded
    assert view.add(box) is view
    assert view.handles == (box,)
    assert list(view.nodes) == ["crate", "crate/body", "crate/lid", "crate/lid/knob"]


def test_a_change_of_a_handle_is_seen_and_is_one_command(recorded, box):
    view, backend = recorded
    view.add(box).flush()
    box.shift(2)
    assert view.nodes["crate"].pose[0, 3] == 2
    assert [kinds(batch) for batch in backend.log] == [[Put] * 4, [Place]]


def test_nothing_is_sent_for_a_change_that_changes_nothing(recorded, box):
    view, backend = recorded
    view.add(box).flush()
    box.change(color=box.color)
    view.flush()
    assert len(backend.log) == 1


def test_many_changes_between_two_looks_are_one_batch(recorded, box):
    view, backend = recorded
    view.add(box).flush()
    for x in range(100):
        box.shift(x)
    view.flush()
    assert kinds(backend.log[-1]) == [Place]
    assert len(backend.log) == 2
    assert box.described == 2


def test_all_views_of_a_handle_follow_it(box):
    views = [View(str(k)).add(box) for k in range(3)]
    box.shift(1)
    assert [view.nodes["crate"].pose[0, 3] for view in views] == [1, 1, 1]


def test_a_handle_added_twice_is_there_once(recorded, box):
    view, _ = recorded
    view.add(box, box).add(box)
    assert view.handles == (box,)
    assert len(view.nodes) == 4


def test_handles_of_one_name_get_numbers(recorded):
    view, _ = recorded
    view.add(Box(), Box(), Box("box_2"))
    assert [path for path in view.nodes if "/" not in path] == ["box", "box_2", "box_2_2"]
    assert repr(view) == "View('test': box, box_2, box_2_2)"


def test_a_name_stays_in_the_view_when_another_goes(recorded):
    view, backend = recorded
    first, second = Box(), Box()
    view.add(first, second).flush()
    view.remove(first)
    second.shift(1)
    assert view.nodes["box_2"].pose[0, 3] == 1
    assert kinds(backend.log[-1]) == [Remove, Place]


def test_a_name_that_is_free_again_is_taken_again(recorded):
    view, backend = recorded
    first, second = Box(), Box()
    second.pose = np.eye(4) + np.eye(4, k=3)
    view.add(first).flush()
    view.remove(first)
    view.add(second)
    assert view.nodes["box"].pose[0, 3] == 1
    assert kinds(backend.log[-1]) == [Place]
    assert list(backend.nodes) == list(view.nodes)


def test_what_is_removed_is_not_seen_and_not_followed(recorded, box):
    view, backend = recorded
    view.add(box).flush()
    view.remove(box)
    box.shift(3)
    assert dict(view.nodes) == {}
    assert kinds(backend.log[-1]) == [Remove]


def test_a_handle_added_and_removed_between_two_looks_leaves_no_trace(recorded, box):
    view, backend = recorded
    view.add(box)
    view.remove(box)
    view.flush()
    assert backend.log == []


def test_clear_removes_all(recorded):
    view, _ = recorded
    view.add(Box(), Box()).clear()
    assert view.handles == ()
    assert dict(view.nodes) == {}


def test_removing_what_is_not_there_says_what_is(recorded, box):
    view, _ = recorded
    view.add(Box("lamp"), Box("desk"))
    with pytest.raises(InputError, match=r"^'test' does not show 'crate'; it shows lamp, desk$"):
        view.remove(view.handles[0], box)
    assert len(view.handles) == 2


@pytest.mark.parametrize("thing", [np.eye(4), "arm", None, View("other")])
def test_only_handles_can_be_shown(recorded, box, thing):
    view, _ = recorded
    with pytest.raises(InputError, match="'test' shows coordinate systems, blocks and robots, got"):
        view.add(box, thing)
    assert view.handles == ()


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"background": "blue"}, "no background 'blue'; use 'light' or 'dark'"),
        ({"height": -3}, "height of 'view'"),
        ({"name": ""}, "name of a view"),
    ],
)
def test_bad_options_are_told(options, message):
    with pytest.raises(InputError, match=message):
        View(**options)


def test_show_is_a_new_view_of_its_handles(box):
    view = show(box, height=200, name="mine")
    assert isinstance(view, View)
    assert repr(view) == "View('mine': crate)"


def test_what_is_seen_cannot_be_changed_from_outside(recorded, box):
    view, _ = recorded
    with pytest.raises(TypeError):
        view.add(box).nodes["crate"] = None


def test_handles_do_not_keep_their_views(box):
    view = View("gone").add(box)
    reference = weakref.ref(view)
    del view
    gc.collect()
    assert reference() is None
    box.shift(1)


def test_a_batch_is_never_half_of_a_change(recorded):
    view, backend = recorded
    pair = [Box("left"), Box("right")]
    view.add(*pair).flush()
    stop = threading.Event()

    def change():
        x = 0
        while not stop.is_set():
            x += 1
            pair[0].shift(x)

    worker = threading.Thread(target=change)
    worker.start()
    for _ in range(200):
        pair[1].shift(0.5)
        view.flush()
    stop.set()
    worker.join()
    assert {path: n.pose[0, 3] for path, n in view.nodes.items() if n.shape is None} == {
        path: n.pose[0, 3] for path, n in backend.nodes.items() if n.shape is None
    }


RECORDING = """
import sys
from dhlab.view import View
from dhlab.scene.csys import Csys
view = View("quiet").add(Csys(name="frame"))
assert view._repr_mimebundle_() == {"text/plain": "View('quiet': frame)"}
assert "frame" in view.nodes
loaded = {"ipywidgets", "anywidget", "meshcat"} & set(sys.modules)
assert not loaded, loaded
"""


def test_a_recording_view_imports_no_screen():
    environment = {"DHLAB_VIEW": "record", "PATH": "/usr/bin", "PYTHONPATH": ":".join(sys.path)}
    done = subprocess.run(
        [sys.executable, "-c", RECORDING], env=environment, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr


def test_the_environment_makes_every_view_record(monkeypatch, box):
    monkeypatch.setenv("DHLAB_VIEW", "record")
    view = View().add(box)
    assert isinstance(view._backend, RecordingBackend)
    assert view._repr_mimebundle_() == {"text/plain": "View('view': crate)"}
