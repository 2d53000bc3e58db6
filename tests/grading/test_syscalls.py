"""System calls that the kernel refuses in the sandbox."""

import platform

import pytest

from dhlab.grading.asked import Ask
from dhlab.grading.runner import run_cells
from dhlab.grading.syscalls import MACHINES, REFUSED, filter_program

TRY = """
import ctypes, errno
libc = ctypes.CDLL(None, use_errno=True)
def tried(number, flags):
    ctypes.set_errno(0)
    done = libc.syscall(int(number), int(flags), 0, 0, 0, 0)
    return errno.errorcode.get(ctypes.get_errno(), "done") if done < 0 else "done"
"""
NEW_USER = 0x10000000 | 17


@pytest.mark.parametrize("machine", MACHINES)
def test_a_filter_ends_by_allowing_the_rest(machine):
    program = filter_program(machine)
    assert program[-8:] == bytes.fromhex("060000000000ff7f")
    assert len(program) // 8 < 4096


def test_a_machine_that_is_not_known_has_no_filter():
    assert filter_program("vax") is None


def test_what_no_answer_needs_is_refused(sandbox):
    if sandbox != "bwrap" or platform.machine() not in MACHINES:
        pytest.skip("needs bubblewrap, which does not work here")
    _, column, clone = MACHINES[platform.machine()]
    calls = {name: (numbers[column], 0) for name, numbers in REFUSED.items()}
    calls |= {"clone": (clone, NEW_USER), "getppid": (libc_getppid(), 0)}
    cases = tuple(calls.values())
    told = run_cells([TRY], [Ask("tried", cases=cases)], {}).replies["tried"]
    got = dict(zip(calls, told, strict=True))
    assert got.pop("getppid") == "done"
    assert got.pop("clone3") == "ENOSYS"
    assert set(got.values()) == {"EPERM"}, got


def libc_getppid():
    """The number of a call that is allowed."""
    return {"x86_64": 110, "aarch64": 173}[platform.machine()]
