"""Watching a run from outside: its lines, its clocks, its memory, its processes."""

import os
import selectors
import subprocess
import time
from contextlib import suppress

from dhlab.grading.asked import Reason
from dhlab.grading.heard import Heard
from dhlab.grading.processes import Used, look
from dhlab.grading.sandbox import Limits, SandboxError

PAUSE = 0.1
START = 60
"""Seconds within which a sandbox must have begun, on a machine that is busy too."""

MOST_LINES = 10_000
PATIENCE = 5
"""How many times longer a run may take that computes but gets no processor."""


def watch(
    process: "subprocess.Popen[bytes]", heard: Heard, limits: Limits, deadline: float
) -> Reason | None:
    """Listen to a run until it is done, gone, or has used more than it may.

    Parameters
    ----------
    process : Popen
        Of `started`.
    heard : Heard
        Told every line.
    limits : Limits
    deadline : float [s]
        On the monotonic clock, for the whole run.

    Returns
    -------
    reason : str or None
        Why it stopped; None if it came to its end.

    Raises
    ------
    SandboxError
        It never began.
    """
    ear = _Ear(process)
    clock = _Clock(limits, deadline)
    while not heard.is_done:
        for line in ear.lines():
            heard.hear(line)
        stopped: Reason | None = None
        if ear.amount > limits.output or ear.count > MOST_LINES:
            stopped = "too large"
        elif ear.is_over and not heard.is_done:
            stopped = "ended"
        elif heard.is_ready:
            stopped = clock.stops(heard, process.pid)
        elif time.monotonic() > clock.began + START:
            raise SandboxError(f"the sandbox did not start within {START} s")
        if stopped and not heard.is_ready:
            raise SandboxError(f"the sandbox does not work here: {ear.complaint or _end(process)}")
        if stopped:
            return stopped
    return None


def _end(process: "subprocess.Popen[bytes]") -> str:
    """Say how a process ended that said nothing."""
    with suppress(subprocess.TimeoutExpired):
        return f"it ended with the status {process.wait(1)}"
    return "it says nothing"


class _Ear:
    """Reads what a process writes, line by line."""

    def __init__(self, process: "subprocess.Popen[bytes]") -> None:
        self._selector = selectors.DefaultSelector()
        self._output = process.stdout
        for stream in (process.stdout, process.stderr):
            if stream is not None:
                self._selector.register(stream, selectors.EVENT_READ)
        self._rest = bytearray()
        self._complaint = bytearray()
        self.amount = 0
        self.count = 0
        self.is_over = False

    @property
    def complaint(self) -> str:
        """The last line of errors."""
        lines = self._complaint.decode("utf-8", "replace").strip().splitlines()
        return lines[-1] if lines else ""

    def lines(self) -> list[bytes]:
        """Wait a little; return the lines that came."""
        lines: list[bytes] = []
        for key, _ in self._selector.select(PAUSE):
            data = os.read(key.fd, 1 << 16)
            if not data:
                self._selector.unregister(key.fileobj)
                self.is_over |= key.fileobj is self._output
            elif key.fileobj is self._output:
                self.amount += len(data)
                *whole, last = data.split(b"\n")
                for piece in whole:
                    lines.append(bytes(self._rest) + piece)
                    self._rest.clear()
                self._rest += last
            elif len(self._complaint) < 4000:
                self._complaint += data
        self.count += len(lines)
        return lines


class _Clock:
    """Compares what a run uses with what it may."""

    def __init__(self, limits: Limits, deadline: float) -> None:
        self._limits = limits
        self._deadline = deadline
        self.began = self._phase_began = self._looked = time.monotonic()
        self._phase: object = None
        self._cpu_before: float | None = None

    def stops(self, heard: Heard, process: int) -> Reason | None:
        """Say what there is too much of, if anything."""
        now = time.monotonic()
        if now > self._deadline:
            return "too slow"
        if heard.phase != self._phase:
            self._phase, self._phase_began, self._cpu_before = heard.phase, now, None
        if now - self._looked < 2 * PAUSE:
            return None
        self._looked = now
        used = look(process, self._limits.memory)
        if self._cpu_before is None:  # what was used before it was first seen is not counted
            self._cpu_before = used.cpu
        if used.memory > self._limits.memory:
            return "too much memory"
        if used.processes > 2 * self._limits.processes:
            return "ended"
        slack = 0 if heard.question is None else 1  # a question's own clock is inside
        if used.cpu - self._cpu_before > self._limits.cpu + 1:
            return "too slow"
        return self._too_late(now - self._phase_began - slack, used)

    def _too_late(self, seconds: float, used: Used) -> Reason | None:
        late = seconds - self._limits.wall
        too_late = late > 0 and not used.is_busy
        return "too slow" if too_late or late > (PATIENCE - 1) * self._limits.wall else None
