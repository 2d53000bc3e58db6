"""A filter of system calls for the sandbox: what no answer needs is refused by the kernel.

Memory that no process is seen to hold (`memfd_create`, shared segments), namespaces inside the
sandbox, keys, tracing, and interfaces through which kernels have been broken. The filter is a
program of the kernel's packet filter, as seccomp takes it; it knows two machines by their numbers.
"""

import platform
import struct
from collections.abc import Sequence

REFUSED = {
    "add_key": (248, 217),
    "bpf": (321, 280),
    "clone3": (435, 435),  # its flags cannot be seen: the C library then takes clone
    "io_uring_setup": (425, 425),
    "keyctl": (250, 219),
    "memfd_create": (319, 279),
    "memfd_secret": (447, 447),
    "mount": (165, 40),
    "mq_open": (240, 180),
    "msgget": (68, 186),
    "perf_event_open": (298, 241),
    "pivot_root": (155, 41),
    "process_vm_readv": (310, 270),
    "process_vm_writev": (311, 271),
    "ptrace": (101, 117),
    "request_key": (249, 218),
    "semget": (64, 190),
    "setns": (308, 268),
    "shmget": (29, 194),
    "unshare": (272, 97),
    "userfaultfd": (323, 282),
}
"""Numbers of the calls on x86_64 and on aarch64."""

MACHINES = {"x86_64": (0xC000003E, 0, 56), "aarch64": (0xC00000B7, 1, 220)}
"""What seccomp calls a machine, its column above, and its number of clone."""

LOAD, EQUAL, AT_LEAST, ANY_BIT, RETURN = 0x20, 0x15, 0x35, 0x45, 0x06
NUMBER, MACHINE, FIRST_ARGUMENT = 0, 4, 16  # where they are in what a filter sees
ALLOW, KILL = 0x7FFF0000, 0x80000000
NOT_PERMITTED, NOT_THERE = 0x00050001, 0x00050026  # the call gives EPERM, ENOSYS
FOREIGN = 0x40000000  # numbers of another calling convention begin here
NEW_NAMESPACES = 0x7E020000  # the flags of clone that make one


def filter_program(machine: str | None = None) -> bytes | None:
    """Return the filter as bytes; None for a machine whose numbers are not known.

    Parameters
    ----------
    machine : str, optional
        As `platform.machine` names it; this one's by default.

    Examples
    --------
    >>> len(filter_program("x86_64")) % 8, filter_program("vax")
    (0, None)
    """
    known = MACHINES.get(machine or platform.machine())
    if known is None:
        return None
    name, column, clone = known
    numbers = {call: columns[column] for call, columns in REFUSED.items()}
    missing = numbers.pop("clone3")
    program = [
        _step(LOAD, MACHINE),
        _step(EQUAL, name, 1, 0),
        _step(RETURN, KILL),
        _step(LOAD, NUMBER),
        _step(AT_LEAST, FOREIGN, 0, 1),
        _step(RETURN, NOT_PERMITTED),
        *_refuse(missing, NOT_THERE),
    ]
    for number in sorted(numbers.values()):
        program += _refuse(number, NOT_PERMITTED)
    program += [
        _step(EQUAL, clone, 0, 3),
        _step(LOAD, FIRST_ARGUMENT),
        _step(ANY_BIT, NEW_NAMESPACES, 0, 1),
        _step(RETURN, NOT_PERMITTED),
        _step(RETURN, ALLOW),
    ]
    return b"".join(program)


def _refuse(number: int, answer: int) -> Sequence[bytes]:
    return [_step(EQUAL, number, 0, 1), _step(RETURN, answer)]


def _step(code: int, value: int, if_so: int = 0, if_not: int = 0) -> bytes:
    """Return one instruction; it skips as many steps as the comparison says."""
    return struct.pack("=HBBI", code, if_so, if_not, value)
