"""How views and handles show themselves in a cell."""

import pytest

from dhlab.view import View, handle_mimebundle
from dhlab.view.display import register
from dhlab.view.outputs import outputs_of
from dhlab.view.view import WIDGET

from .test_outputs import Shell


@pytest.fixture
def kernel(monkeypatch, comms):
    """A shell with a kernel behind it."""
    shell = Shell()
    shell.kernel = object()
    monkeypatch.setattr("IPython.get_ipython", lambda: shell)
    yield shell
    outputs_of.cache_clear()


def run(kernel, show, cell="id-1"):
    """Run a cell that ends in an expression; return what it shows."""
    kernel.begin([], cell)
    bundle = show()
    kernel.callback(None)
    return bundle


def test_a_view_shows_its_widget_and_a_line_of_text(kernel, box):
    view = View("bench").add(box)
    bundle = run(kernel, view._repr_mimebundle_)
    assert bundle["text/plain"] == "View('bench': crate)"
    assert bundle[WIDGET]["model_id"] == view.widget.model_id


def test_without_a_kernel_there_is_text_alone(comms, box):
    assert View().add(box)._repr_mimebundle_() == {"text/plain": "View('view': crate)"}
    assert handle_mimebundle(box) == {"text/plain": repr(box)}
    assert comms == []


def test_a_handle_shows_itself_in_a_view_of_its_own(kernel, comms, box):
    bundle = run(kernel, lambda: handle_mimebundle(box))
    assert bundle["text/plain"] == repr(box)
    comm = next(c for c in comms if c.comm_id == bundle[WIDGET]["model_id"])
    box.shift(1)
    assert len(comm.batches) == 1


def test_a_handle_shown_fifty_times_by_one_cell_is_open_once(kernel, comms, box):
    for _ in range(50):
        run(kernel, lambda: handle_mimebundle(box))
    scenes = [comm for comm in comms if comm.opened["data"]["state"].get("library_digest")]
    assert len(scenes) == 50
    assert sum(not comm.is_closed for comm in scenes) == 1


def test_a_view_shown_again_by_its_cell_keeps_its_widget(kernel, box):
    view = View().add(box)
    first = run(kernel, view._repr_mimebundle_)
    assert run(kernel, view._repr_mimebundle_) == first


def test_a_view_whose_cell_shows_something_else_is_closed_and_comes_back(kernel, box):
    view = View().add(box)
    first = run(kernel, view._repr_mimebundle_)
    run(kernel, lambda: None)
    again = run(kernel, view._repr_mimebundle_)
    assert again[WIDGET]["model_id"] != first[WIDGET]["model_id"]


def test_ipython_is_told_once_how_handles_show_themselves(monkeypatch, box):
    from IPython.core.formatters import DisplayFormatter

    shell = Shell()
    shell.display_formatter = DisplayFormatter()
    monkeypatch.setattr("IPython.get_ipython", lambda: shell)
    register()
    register()
    data, _ = shell.display_formatter.format(box)
    assert data == {"text/plain": repr(box)}
    assert shell.display_formatter.mimebundle_formatter.lookup(box) is handle_mimebundle


def test_without_ipython_there_is_nobody_to_tell(monkeypatch):
    monkeypatch.setattr("IPython.get_ipython", lambda: None)
    register()


def test_a_recording_view_shows_text_in_a_notebook_too(kernel, monkeypatch, box):
    monkeypatch.setenv("DHLAB_VIEW", "record")
    assert View().add(box)._repr_mimebundle_() == {"text/plain": "View('view': crate)"}
