"""Cells that run again close what they showed before."""

import gc

import pytest

from dhlab.view.outputs import Outputs


class Shell:
    """As much of an IPython shell as knows which cell runs."""

    def __init__(self):
        self.events = self
        self.parent = {}
        self.runs = 0
        self.callback = lambda result: None

    def register(self, event, callback):
        assert event == "post_run_cell"
        self.callback = callback

    def get_parent(self):
        return self.parent

    def run(self, code, cell=None):
        """Run a cell that notes what it shows; `code` is a list of (outputs, thing)."""
        self.begin(code, cell)
        for outputs, thing in code:
            outputs.note(thing)
        self.callback(None)

    def begin(self, code, cell=None):
        self.runs += 1
        self.parent = {
            "header": {"msg_type": "execute_request", "msg_id": f"run-{self.runs}"},
            "metadata": {} if cell is None else {"cellId": cell},
            "content": {"code": str(code)},
        }


class Thing:
    def __init__(self, name="thing"):
        self.name = name
        self.closed = 0

    def __repr__(self):
        return self.name

    def close(self):
        self.closed += 1


@pytest.fixture
def shell():
    return Shell()


@pytest.fixture
def outputs(shell):
    return Outputs(shell)


@pytest.mark.parametrize("cell", ["id-1", None])
def test_a_cell_run_fifty_times_leaves_one_thing_open(shell, outputs, cell):
    things = [Thing() for _ in range(50)]
    for thing in things:
        shell.run([(outputs, thing)], cell)
    assert [thing.closed for thing in things] == [1] * 49 + [0]


def test_the_same_thing_shown_again_stays_open(shell, outputs):
    thing = Thing()
    for _ in range(3):
        shell.run([(outputs, thing)], "id-1")
    assert thing.closed == 0


def test_a_thing_in_two_cells_stays_until_both_have_replaced_it(shell, outputs):
    thing = Thing()
    shell.run([(outputs, thing)], "id-1")
    shell.run([(outputs, thing)], "id-2")
    shell.run([], "id-1")
    assert thing.closed == 0
    shell.run([], "id-2")
    assert thing.closed == 1


def test_other_cells_close_nothing(shell, outputs):
    thing = Thing()
    shell.run([(outputs, thing)], "id-1")
    shell.run([], "id-2")
    shell.run([(outputs, Thing())], "id-3")
    assert thing.closed == 0


def test_what_a_callback_shows_stays_open(shell, outputs):
    thing = Thing()
    shell.parent = {"header": {"msg_type": "comm_msg", "msg_id": "x"}}
    outputs.note(thing)
    shell.run([], "id-1")
    shell.run([], "id-1")
    assert thing.closed == 0


def test_a_closed_thing_may_be_shown_again(shell, outputs):
    thing = Thing()
    shell.run([(outputs, thing)], "id-1")
    shell.run([], "id-1")
    shell.run([(outputs, thing)], "id-1")
    shell.run([(outputs, thing)], "id-1")
    assert thing.closed == 1


class Kept:
    def __init__(self):
        self.told = 0

    def keep(self):
        self.told += 1


def test_a_client_that_names_no_cell_is_told_the_whole_at_the_end_of_each(shell, outputs):
    kept = Kept()
    outputs.keep(kept)
    shell.run([])
    shell.run([])
    assert kept.told == 2


def test_a_page_that_names_its_cells_is_not(shell, outputs):
    kept = Kept()
    outputs.keep(kept)
    shell.run([], "id-1")
    assert kept.told == 0


def test_what_is_kept_may_go(shell, outputs):
    outputs.keep(Kept())
    gc.collect()
    shell.run([])
    assert not list(outputs._kept)
