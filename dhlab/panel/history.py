"""Configurations to go back to."""

import numpy as np
from numpy.typing import NDArray

Config = NDArray[np.float64]


class History:
    """What a panel's user did, to be undone and done again.

    An entry is the configuration before a change by the user. Changes by code make no entries of
    their own: undo leads to where the robot stood when the user last took hold of it.

    Parameters
    ----------
    length : int
        Entries kept.

    Examples
    --------
    >>> history = History()
    >>> history.add(np.zeros(1))
    >>> history.undo(np.ones(1)), history.undo(np.zeros(1))
    (array([0.]), None)
    >>> history.redo(np.zeros(1))
    array([1.])
    """

    __slots__ = ("_future", "_length", "_past")

    def __init__(self, length: int = 200) -> None:
        self._length = length
        self._past: list[Config] = []
        self._future: list[Config] = []

    @property
    def can_undo(self) -> bool:
        """Whether there is something to undo."""
        return bool(self._past)

    @property
    def can_redo(self) -> bool:
        """Whether there is something to do again."""
        return bool(self._future)

    def add(self, before: Config) -> None:
        """Note the configuration that the user is about to change; what was undone is gone."""
        self._past = [*self._past, before][-self._length :]
        self._future = []

    def undo(self, now: Config) -> Config | None:
        """Give the configuration before the user's last change, None if there is none."""
        if not self._past:
            return None
        self._future.append(now)
        return self._past.pop()

    def redo(self, now: Config) -> Config | None:
        """Give the configuration before the last undo, None if there is none."""
        if not self._future:
            return None
        self._past.append(now)
        return self._future.pop()

    def clear(self) -> None:
        """Forget everything: the robot has become another."""
        self._past, self._future = [], []
