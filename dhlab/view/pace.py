"""Not more often than the eye needs, and the last one always."""

import threading
from collections.abc import Callable
from time import monotonic

from dhlab.scene.handle import CHANGES

INTERVAL = 1 / 60
"""Seconds between two batches, at least."""


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
        self._waiting: threading.Timer | None = None

    def ask(self) -> None:
        """Call the action now, or as soon as it may be; the caller holds `CHANGES`."""
        wait = self._earliest - monotonic()
        if wait <= 0:
            self._act()
        elif self._waiting is None:
            self._waiting = threading.Timer(wait, self._act_late)
            self._waiting.daemon = True
            self._waiting.start()

    def stop(self) -> None:
        """Forget what waits; the caller holds `CHANGES`."""
        if self._waiting is not None:
            self._waiting.cancel()
            self._waiting = None

    def _act_late(self) -> None:
        with CHANGES:
            if self._waiting is threading.current_thread():
                self._act()

    def _act(self) -> None:
        self.stop()
        began = monotonic()
        try:
            self._action()
        finally:
            ended = monotonic()
            self._earliest = ended + max(INTERVAL, ended - began)
