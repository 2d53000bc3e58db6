"""How far a long command has come, on one line of a terminal."""

import time
from collections.abc import Callable
from typing import TextIO

WIDTH = 30


class Progress:
    """Shows a bar and the time left; silent where nobody watches.

    Parameters
    ----------
    stream : text file
        Written to only if it is a terminal.
    clock : callable
        Seconds.
    """

    def __init__(self, stream: TextIO, clock: Callable[[], float] = time.monotonic) -> None:
        self._stream = stream
        self._clock = clock
        self._start = clock()
        self._wide = 0

    def __call__(self, done: int, total: int, known: int = 0) -> None:
        """Show how far it is.

        Parameters
        ----------
        done, total : int
        known : int
            Of those done: what took no time.
        """
        if not self._stream.isatty():
            return
        filled = WIDTH * done // total
        bar = "#" * filled + "." * (WIDTH - filled)
        line = f"{done} of {total} [{bar}] {self._left(done, total, known)}"
        self._wide = max(self._wide, len(line))
        end = "\n" if done == total else ""
        self._stream.write(f"\r{line.ljust(self._wide)}{end}")
        self._stream.flush()

    def _left(self, done: int, total: int, known: int) -> str:
        elapsed = self._clock() - self._start
        if done == total:
            return f"in {clock_time(elapsed)}"
        if done == known:
            return ""
        return f"{clock_time(elapsed / (done - known) * (total - done))} left"


def clock_time(seconds: float) -> str:
    """Return a duration as a clock shows it.

    Examples
    --------
    >>> clock_time(75.2), clock_time(3725)
    ('1:15', '1:02:05')
    """
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02}:{rest:02}" if hours else f"{minutes}:{rest:02}"
