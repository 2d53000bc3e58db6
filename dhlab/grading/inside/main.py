"""The process beside the student's code: runs the cells, then asks each question in a fork.

It reads one job from its input and writes one line of strict JSON for everything that happens:
the cell or question that begins, the error of a cell, a value, the end of a question. Whoever
reads these lines must not trust them: the student's code can write to the same place.
"""

import json
import os
import resource
import signal
import sys
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from os import _exit, fork, kill, killpg, wait4, write  # as they were before the cells ran
from time import monotonic, sleep
from typing import Any

from dhlab.grading.inside.answers import no, reply, told
from dhlab.grading.inside.cells import new_namespace, run_cell
from dhlab.grading.inside.given import load
from dhlab.grading.inside.notes import watch
from dhlab.grading.inside.plain import from_json, loads
from dhlab.grading.inside.stub import Stage, install

Say = Callable[..., None]


def main() -> None:
    """Do the one job that comes on the input."""
    job = loads(_read_all(0))
    say = speaker(os.dup(1))
    tools = load(job["tools"], job["texts"])
    limit(job["limits"])
    say(ready=True)  # what fails before this is no student's fault
    silence()
    forget_own_modules()
    note, named = (lambda text: say(note=text)), (lambda name: say(student=name[:200]))
    plain = {ask["name"]: ask["kind"] for ask in job["asks"] if not any(ask["cases"])}
    stage = Stage(job["given"], job["parts"], tools, plain, {})
    install(stage, note, named)
    names = new_namespace()
    watch(note)
    run_cells(job["cells"], names, say)
    for k, ask in enumerate(job["asks"]):
        say(question=k)
        if ask["name"] in stage.seen:
            for j in range(len(ask["cases"])):
                say(question=k, case=j, **stage.seen[ask["name"]])
        else:
            say(end=k, **asked_apart(k, ask, names, say, job["limits"]))
    say(done=True)


def run_cells(cells: Sequence[tuple[int, str]], names: dict[str, Any], say: Say) -> None:
    """Run cells, each with its number; one that raises does not stop the next."""
    for number, text in cells:
        say(cell=number)
        try:
            run_cell(text, number, names)
        except BaseException as error:
            say(error=[number, told(error)])
    say(cell=None)


def asked_apart(
    k: int, ask: Mapping[str, Any], names: Mapping[str, Any], say: Say, limits: Mapping[str, Any]
) -> dict[str, Any]:
    """Ask one question in a process of its own; say why it ended, if not by itself."""
    child = fork()
    if child == 0:
        try:
            os.setpgid(0, 0)
            resource.setrlimit(resource.RLIMIT_CPU, (limits["cpu"], limits["cpu"] + 1))
            for j, arguments in enumerate(ask["cases"]):
                came = reply(names, ask["name"], ask["kind"], [from_json(a) for a in arguments])
                say(question=k, case=j, **came)
        finally:
            _exit(0)
    status, seconds = wait_for(child, limits["wall"])
    with suppress(OSError):
        killpg(child, signal.SIGKILL)
    return how(None if seconds > 0.8 * limits["cpu"] else status)


def how(status: int | None) -> dict[str, Any]:
    """Say how a process ended; None: its time was over."""
    if status is None or (os.WIFSIGNALED(status) and os.WTERMSIG(status) == signal.SIGXCPU):
        return no("too slow")
    if os.WIFSIGNALED(status):
        return no("ended", f"by {signal.Signals(os.WTERMSIG(status)).name}")
    return no("ended")


def wait_for(child: int, wall: float) -> tuple[int | None, float]:
    """Wait for a process, and return its status, None if its time was over, and what it computed.

    One that still computes when the time is over may have had no processor: it gets more time.
    """
    start = monotonic()
    pause = 0.0005
    while True:
        done, status, used = wait4(child, os.WNOHANG)
        if done:
            return status, used.ru_utime + used.ru_stime
        late = monotonic() - start - wall
        if late > 0 and (late > 4 * wall or not is_computing(child)):
            kill(child, signal.SIGKILL)
            wait4(child, 0)
            return None, 0.0
        sleep(pause)
        pause = min(2 * pause, 0.02)


def is_computing(process: int) -> bool:
    """Whether a process runs or waits for a processor, as far as the system tells."""
    try:
        with open(f"/proc/{process}/stat", "rb") as file:
            return file.read().rpartition(b")")[2].split()[0] == b"R"
    except OSError:
        return False


def speaker(to: int) -> Say:
    """Make a function that writes one line of strict JSON."""

    def say(**words: Any) -> None:
        line = memoryview(f"\n{json.dumps(words, allow_nan=False)}\n".encode())
        while line:
            line = line[write(to, line) :]

    return say


def silence() -> None:
    """Let go of input, output and errors."""
    nothing = os.open(os.devnull, os.O_RDWR)
    for descriptor in (0, 1, 2):
        os.dup2(nothing, descriptor)
    os.close(nothing)


def limit(limits: Mapping[str, Any]) -> None:
    """Take the limits that hold for this process and all that come from it."""
    for name, most in (
        ("RLIMIT_AS", limits["memory"]),
        ("RLIMIT_CORE", 0),
        ("RLIMIT_FSIZE", limits["file"]),
        ("RLIMIT_NOFILE", limits["files"]),
        ("RLIMIT_NPROC", limits["processes"]),
    ):
        if most is None:
            continue
        with suppress(ValueError, OSError):  # not above what there was, and not on every system
            resource.setrlimit(getattr(resource, name), (most, most))


def forget_own_modules() -> None:
    """Let the cells import another dhlab than these modules."""
    for name in [name for name in sys.modules if name.split(".")[0] == "dhlab"]:
        del sys.modules[name]


def _read_all(source: int) -> bytes:
    with os.fdopen(os.dup(source), "rb") as file:
        return file.read()
