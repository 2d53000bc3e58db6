"""The processes of a run: what they use, and their end."""

import os
import signal
import subprocess
from contextlib import suppress
from dataclasses import dataclass

import psutil


@dataclass
class Used:
    """What the processes of a run use at one moment."""

    memory: int = 0
    processes: int = 0
    cpu: float = 0
    is_busy: bool = False


def look(process: int, plenty: int) -> Used:
    """Look at a process and everything below it.

    Parameters
    ----------
    process : int
    plenty : int [bytes]
        More memory than this is looked at again: what a process shares with those that it came
        from is counted once then.
    """
    used = Used()
    with suppress(psutil.Error):
        all_of_it = [psutil.Process(process), *below(process)]
        for other in all_of_it:
            with suppress(psutil.Error), other.oneshot():
                used.memory += other.memory_info().rss
                used.processes += 1
                times = other.cpu_times()
                used.cpu += times.user + times.system + times.children_user + times.children_system
                used.is_busy |= other.status() == psutil.STATUS_RUNNING
        if used.memory > plenty:
            used.memory = sum(map(_share, all_of_it))
    return used


def _share(process: psutil.Process) -> int:
    """Return the memory of a process, of what it shares a part, where the system tells that."""
    with suppress(psutil.NoSuchProcess):
        try:
            info = process.memory_full_info()
            return int(getattr(info, "pss", info.rss))
        except psutil.AccessDenied:
            return int(process.memory_info().rss)
    return 0


def end(process: "subprocess.Popen[bytes]") -> None:
    """End a process and everything that came from it; return when all of it is gone.

    In a sandbox the first process below bubblewrap is the first of a process namespace: the
    kernel ends all others with it, and bubblewrap ends after it.
    """
    others = below(process.pid)
    for other in others:
        with suppress(psutil.Error):
            other.kill()
    with suppress(subprocess.TimeoutExpired):
        process.wait(2)
    with suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    psutil.wait_procs(others, timeout=2)


def below(process: int) -> list[psutil.Process]:
    """Return what came from a process, and from that, in this order."""
    found: list[psutil.Process] = []
    ahead = [process]
    while ahead:
        for child in _children(ahead.pop(0)):
            with suppress(psutil.Error):
                found.append(psutil.Process(child))
                ahead.append(child)
    return found


def _children(process: int) -> list[int]:
    """Return the children of a process; where the system has no list, of all processes."""
    children: list[int] = []
    try:
        for task in os.listdir(f"/proc/{process}/task"):
            with open(f"/proc/{process}/task/{task}/children", encoding="ascii") as file:
                children += map(int, file.read().split())
    except OSError:
        with suppress(psutil.Error):
            return [child.pid for child in psutil.Process(process).children()]
    return children
