"""The clocks of a run: each cell and each question has its own time."""

import time

import pytest

from dhlab.grading import watched
from dhlab.grading.asked import Ask
from dhlab.grading.heard import Heard
from dhlab.grading.processes import Used
from dhlab.grading.sandbox import Limits
from dhlab.grading.watched import _Clock

LIMITS = Limits(cpu=5, wall=6, memory=1000, processes=4)


@pytest.fixture
def clock(monkeypatch):
    """A function that tells what stops a run at a time, with what it uses."""
    now, used = [1000.0], [Used()]
    monkeypatch.setattr(time, "monotonic", lambda: now[0])
    monkeypatch.setattr(watched, "look", lambda *_: used[0])
    clock, heard = _Clock(LIMITS, 1090.0), Heard([1, 2], [Ask("x"), Ask("y")])

    def at(seconds, *, line=b"", **uses):
        heard.hear(line)
        now[0], used[0] = 1000.0 + seconds, Used(**uses)
        return clock.stops(heard, 0)

    return at


def test_a_cell_that_sleeps_is_stopped_by_the_clock(clock):
    assert clock(1, line=b'{"cell": 1}') is None
    assert clock(6.5) is None
    assert clock(7.5) == "too slow"


def test_a_cell_that_computes_is_stopped_by_what_it_computed(clock):
    assert clock(1, line=b'{"cell": 1}', cpu=0.5, is_busy=True) is None
    assert clock(20, cpu=6, is_busy=True) is None  # it had hardly a processor
    assert clock(21, cpu=7, is_busy=True) == "too slow"


def test_a_cell_that_seems_to_compute_is_not_waited_for_without_end(clock):
    clock(1, line=b'{"cell": 1}', is_busy=True)
    assert clock(30.5, is_busy=True) is None
    assert clock(31.5, is_busy=True) == "too slow"


def test_each_cell_and_each_question_has_its_own_time(clock):
    lines = [b'{"cell": 1}', b'{"cell": 2}', b'{"question": 0}', b'{"question": 1}']
    for k, line in enumerate(lines):
        assert clock(5 * k + 1, line=line, cpu=4 * k, is_busy=True) is None
        assert clock(5 * k + 1.1, cpu=4 * k, is_busy=True) is None
        assert clock(5 * k + 5, cpu=4 * k + 4, is_busy=True) is None


def test_the_whole_has_a_time_too(clock):
    assert clock(89, line=b'{"cell": 1}') is None
    assert clock(91, line=b'{"cell": 2}') == "too slow"


def test_memory_and_processes_are_those_of_all_together(clock):
    assert clock(1, line=b'{"cell": 1}', memory=1000, processes=8) is None
    assert clock(2, memory=1001) == "too much memory"
    assert clock(3, processes=9) == "ended"
