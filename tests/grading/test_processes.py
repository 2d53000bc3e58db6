"""What the processes of a run use together."""

import subprocess
import sys

import psutil
import pytest

from dhlab.grading.processes import end, look

HOLDS = 100_000_000
CODE = f"""
import os, sys
held = bytearray(b"x") * {HOLDS}
child = os.fork()
if child:
    print("ready", flush=True)
sys.stdin.read()
"""


@pytest.fixture
def parent():
    """A process that holds memory, and shares it with a child."""
    command = [sys.executable, "-c", CODE]
    pipe = subprocess.PIPE
    with subprocess.Popen(command, stdin=pipe, stdout=pipe, start_new_session=True) as process:
        process.stdout.readline()
        yield process.pid
        end(process)


def test_plenty_of_memory_is_looked_at_again_and_what_is_shared_counts_once(parent):
    assert look(parent, plenty=sys.maxsize).memory > 2 * HOLDS
    if sys.platform == "linux":
        assert HOLDS < look(parent, plenty=0).memory < 1.5 * HOLDS


def test_a_process_that_does_not_tell_what_it_shares_has_all_of_it(parent, monkeypatch):
    def refuse(process):
        raise psutil.AccessDenied(process.pid)

    monkeypatch.setattr(psutil.Process, "memory_full_info", refuse)
    assert look(parent, plenty=0).memory > 2 * HOLDS


def test_a_process_that_is_gone_uses_nothing(parent):
    psutil.Process(parent).kill()
    psutil.Process(parent).wait()
    assert (look(parent, plenty=0).memory, look(parent, plenty=0).processes) == (0, 0)
