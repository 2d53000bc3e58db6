"""The bar of a long command."""

import io

import pytest

from dhlab.cli.progress import Progress


class Terminal(io.StringIO):
    """What somebody watches."""

    def isatty(self):
        return True


@pytest.fixture
def ticking():
    """A clock that moves by hand."""
    now = [100.0]
    return now, lambda: now[0]


def test_the_time_left_follows_from_what_took_time(ticking):
    now, clock = ticking
    terminal = Terminal()
    progress = Progress(terminal, clock)
    progress(2, 10, 2)
    now[0] += 30
    progress(5, 10, 2)
    now[0] += 30
    progress(10, 10, 2)
    lines = [line.rstrip() for line in terminal.getvalue().lstrip("\r").split("\r")]
    assert lines == [
        "2 of 10 [######........................]",
        "5 of 10 [###############...............] 0:50 left",
        "10 of 10 [##############################] in 1:00",
    ]
    assert terminal.getvalue().endswith("\n")


def test_a_shorter_line_hides_a_longer_one(ticking):
    now, clock = ticking
    terminal = Terminal()
    progress = Progress(terminal, clock)
    now[0] += 40000
    progress(1, 3)
    long = len(terminal.getvalue())
    terminal.truncate(0)
    progress(3, 3, 3)
    assert len(terminal.getvalue().rstrip("\n").strip("\x00")) >= long


def test_where_nobody_watches_nothing_is_written():
    stream = io.StringIO()
    Progress(stream)(1, 2)
    assert stream.getvalue() == ""
