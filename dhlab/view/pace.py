"""Not more often than the eye needs, and the last one always."""

import threading
from collections.abc import Callable
from time import monotonic, sleep

from dhlab.scene.handle import CHANGES

INTERVAL = 1 / 60
"""Seconds between two batches, at least."""

LINGER = 0.25
"""Seconds that the thread of late calls waits for more before it ends."""


class Pace:
    """Calls an action soon after it is asked for, but not more than about 60 times a second.

    Calls that come too early are put together into one, which comes by itself a moment later:
    from a thread of its own, so that it comes also while a cell is still running. An action that
    is slow leaves as much time again to others.

    Parameters
    ----------
    action : callable
        Called with `CHANGES` held.

    Examples
    --------
    >>> calls = []
    >>> pace = Pace(lambda: calls.append("now"))
    >>> for _ in range(1000):
    ...     pace.ask()
    >>> pace.stop()
    >>> len(calls) < 1000
    True
    """

    def __init__(self, action: Callable[[], None]) -> None:
        self._action = action
        self._earliest = 0.0
        self._waiting = False
        self._thread: threading.Thread | None = None

    def ask(self) -> None:
        """Call the action now, or as soon as it may be; the caller holds `CHANGES`."""
        if monotonic() >= self._earliest:
            self._act()
            return
        self._waiting = True
        if self._thread is None:
            self._thread = threading.Thread(target=self._act_late, daemon=True)
            self._thread.start()

    def stop(self) -> None:
        """Forget what waits; the caller holds `CHANGES`."""
        self._waiting = False

    def _act_late(self) -> None:
        """Act for calls that came too early, until none has come for a while.

        Nobody wakes this thread and it rarely wants the lock: that would cost those who ask more
        than they do.
        """
        end = monotonic() + LINGER
        while True:
            sleep(max(self._earliest - monotonic(), 0.0) or INTERVAL)
            if not self._waiting and monotonic() < end:
                continue
            with CHANGES:
                if self._waiting and monotonic() >= self._earliest:
                    this, self._thread = (
                        self._thread,
                        None,
                    )  # the next call starts another if it fails
                    self._act()
                    self._thread = this
                    end = monotonic() + LINGER
                elif not self._waiting and monotonic() >= end:
                    self._thread = None
                    return

    def _act(self) -> None:
        self._waiting = False
        began = monotonic()
        try:
            self._action()
        finally:
            ended = monotonic()
            self._earliest = ended + max(INTERVAL, ended - began)
