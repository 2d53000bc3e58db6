"""Where a student's code runs: a bubblewrap sandbox, or, asked for in so many words, no sandbox."""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import threading
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from typing import Any, BinaryIO, Literal, TypeAlias, get_args

from dhlab.errors import DhlabError, InputError
from dhlab.grading.mounts import (
    INSIDE,
    MOUNTED,
    Room,
    compile_once,
    mounts,
    package_folders,
    python,
)
from dhlab.grading.processes import end
from dhlab.grading.syscalls import filter_program
from dhlab.grading.tools import PACKAGE

Sandbox: TypeAlias = Literal["bwrap", "none"]

USERS = range(60578, 61184)
"""User numbers that no system hands out (systemd's list of them)."""

ADVICE = (
    "install bubblewrap (`apt install bubblewrap`) and allow user namespaces, or, for work that "
    "you trust or in a container of its own, choose the sandbox 'none'"
)


class SandboxError(DhlabError):
    """The sandbox does not work here; nothing was run."""


@dataclass(frozen=True)
class Limits:
    """What a submission may use.

    Attributes
    ----------
    cpu, wall : float [s]
        Of a cell and of a question: of the processor, and of the clock.
    whole : float [s]
        Of the clock, for everything together.
    memory : int [bytes]
        Of all its processes together.
    file, files : int
        Bytes of a file; files open at once in one process.
    scratch : int [bytes]
        Of all files together.
    output : int [bytes]
        Of everything that comes back.
    processes : int
    """

    cpu: int = 5
    wall: float = 6
    whole: float = 90
    memory: int = 2**30
    file: int = 2**23
    files: int = 64
    scratch: int = 2**24
    output: int = 2**22
    processes: int = 32

    def told(self, sandbox: Sandbox) -> dict[str, float | None]:
        """Return them for the process inside, which takes some upon itself.

        Without a sandbox not that of processes: the system would count all of this user's.
        """
        return asdict(self) | ({"processes": None} if sandbox == "none" else {})


def check_sandbox(sandbox: Sandbox) -> None:
    """Refuse a sandbox that is not known or does not work here.

    Parameters
    ----------
    sandbox : {'bwrap', 'none'}

    Raises
    ------
    InputError
        There is no such sandbox.
    SandboxError
        It does not work here; the message says what to do.
    """
    if sandbox not in get_args(Sandbox):
        raise InputError(f"no sandbox {sandbox!r}; use 'bwrap' or 'none'")
    if os.name != "posix":
        raise SandboxError("answers are marked on Linux, and with the sandbox 'none' on macOS")
    if sandbox == "none":
        return
    if sys.platform != "linux":
        raise SandboxError(f"the sandbox 'bwrap' needs Linux, this is {sys.platform}; {ADVICE}")
    if shutil.which("bwrap") is None:
        raise SandboxError(f"there is no bubblewrap here; {ADVICE}")


@contextmanager
def started(
    job: Mapping[str, Any], sandbox: Sandbox, limits: Limits, room: Room
) -> Iterator[subprocess.Popen[bytes]]:
    """Start a process on a job; at the end it and everything that came from it is gone.

    Parameters
    ----------
    job : mapping
        What `dhlab.grading.inside.main` reads.
    sandbox : {'bwrap', 'none'}
    limits : Limits
    room : Room
        What of dhlab is there.

    Yields
    ------
    process : Popen
        Its output is the lines of `main`, its errors what is said before it is ready.
    """
    check_sandbox(sandbox)
    compile_once()
    text = json.dumps(job, allow_nan=False).encode()
    with _scratch(sandbox) as folder, _filter(sandbox) as calls, _readable(text) as source:
        process = subprocess.Popen(
            _bwrap(limits, room, calls) if sandbox == "bwrap" else _bare(room),
            stdin=source,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            cwd=folder,
            env={},
            pass_fds=calls,
            start_new_session=True,
        )
        with process:
            try:
                yield process
            finally:
                end(process)


@contextmanager
def _readable(content: bytes) -> Iterator[BinaryIO]:
    """Yield a file of this content; on Linux it is in memory, and nobody can write to it any more.

    The first process of a sandbox holds it open, and an ordinary user's cells can look into that.
    """
    if sys.platform != "linux":
        with tempfile.TemporaryFile() as file:
            file.write(content)
            file.seek(0)
            yield file
        return
    import fcntl

    seals = fcntl.F_SEAL_WRITE | fcntl.F_SEAL_GROW | fcntl.F_SEAL_SHRINK | fcntl.F_SEAL_SEAL
    descriptor = os.memfd_create("job", os.MFD_CLOEXEC | os.MFD_ALLOW_SEALING)
    with open(descriptor, "w+b") as file:
        file.write(content)
        file.seek(0)
        fcntl.fcntl(file, fcntl.F_ADD_SEALS, seals)
        yield file


@contextmanager
def _scratch(sandbox: Sandbox) -> Iterator[str]:
    """Yield the folder to begin in; a sandbox has one of its own, in memory."""
    if sandbox == "bwrap":
        yield "/"
        return
    with tempfile.TemporaryDirectory(prefix="dhlab-") as folder:
        yield folder


@contextmanager
def _filter(sandbox: Sandbox) -> Iterator[list[int]]:
    """Yield the descriptor of the filter of system calls, if there is one for this machine."""
    program = filter_program() if sandbox == "bwrap" else None
    if program is None:
        yield []
        return
    source, sink = os.pipe()
    try:
        with os.fdopen(sink, "wb") as file:
            file.write(program)
        yield [source]
    finally:
        os.close(source)


def _bare(room: Room) -> list[str]:
    """Return the command without a sandbox."""
    return [python(), "-I", "-S", "-B", str(INSIDE / "boot.py"), "0", *package_folders(room)]


def _bwrap(limits: Limits, room: Room, calls: Sequence[int] = ()) -> list[str]:
    """Return the command of a sandbox: Python and packages to read, a little memory to write."""
    boot = f"{MOUNTED}/{INSIDE.relative_to(PACKAGE)}/boot.py"
    bwrap = shutil.which("bwrap") or "bwrap"
    return [
        *(bwrap, "--unshare-ipc", "--unshare-pid", "--unshare-net", "--unshare-uts"),
        *("--unshare-cgroup-try", "--new-session", "--die-with-parent", "--hostname", "sandbox"),
        *("--cap-add", "CAP_SETUID", "--cap-add", "CAP_SETGID") * (os.getuid() == 0),
        *("--size", str(limits.scratch), "--perms", "1777", "--tmpfs", "/tmp"),
        *mounts(room),
        *("--proc", "/proc", "--dev", "/dev", "--size", "1048576", "--tmpfs", "/dev/shm"),
        *("--remount-ro", "/dev", "--remount-ro", "/", "--chdir", "/tmp"),
        *(word for descriptor in calls for word in ("--seccomp", str(descriptor))),
        *(python(), "-I", "-S", "-B", boot, str(_user()), *package_folders(room)),
    ]


def _user() -> int:
    """Return the number of a user that has nothing else, for when this is root."""
    return USERS[threading.get_native_id() % len(USERS)]
