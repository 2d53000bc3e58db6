"""Which cell shows what, so that what no cell shows any more can be closed.

A cell that runs again replaces its outputs. ipywidgets keeps every open widget in a registry of
its own, so that a cell run fifty times would leave fifty of them; the kernel knows which cell runs
and closes the ones that were replaced.

A client that runs a notebook without a page, as ``nbconvert --execute`` does, keeps the state that
it is told and no messages. It can be known by its requests, which name no cell.
"""

import sys
from functools import cache
from typing import Any, Protocol
from weakref import WeakSet


class Shown(Protocol):
    """Something that is open while an output shows it."""

    def close(self) -> None:
        """Close it: its last output has gone. It may be shown again later."""


class Kept(Protocol):
    """Something whose changes are messages, which not every client keeps."""

    def keep(self) -> None:
        """Tell its state as a whole, if that is news."""


class Outputs:
    """The outputs of one kernel.

    Keeps what it watches alive for as long as an output shows it, because handles hold their
    views weakly. What is shown outside a cell, in the callback of a widget say, stays open.

    Parameters
    ----------
    shell : InteractiveShell
    """

    def __init__(self, shell: Any) -> None:
        self._shell = shell
        self._runs: dict[Shown, dict[str, str]] = {}
        self._kept: WeakSet[Kept] = WeakSet()
        shell.events.register("post_run_cell", self._end_cell)

    def note(self, shown: Shown) -> None:
        """Note that the running cell shows something.

        Parameters
        ----------
        shown : Shown
        """
        cell, run = self._present()
        self._runs.setdefault(shown, {})[cell] = run

    def keep(self, kept: Kept) -> None:
        """Let clients without a page keep the present state of something, for as long as it lives.

        Parameters
        ----------
        kept : Kept
        """
        self._kept.add(kept)

    def has_page(self) -> bool:
        """Whether the request that runs comes from a front end with cells, and so with a page."""
        return bool(self._named())

    def _present(self) -> tuple[str, str]:
        """Return the cell that runs, by its id or else by its text, and which run of it this is."""
        parent = self._shell.get_parent() or {}
        header = parent.get("header") or {}
        if header.get("msg_type") != "execute_request":
            return "", ""
        cell = self._named() or parent["content"]["code"]
        return str(cell), str(header.get("msg_id"))

    def _named(self) -> Any:
        """Return the id of the cell that runs, if the client gave one."""
        return ((self._shell.get_parent() or {}).get("metadata") or {}).get("cellId")

    def _end_cell(self, *_: Any) -> None:
        self._close_replaced()
        if not self._named():
            for kept in list(self._kept):
                kept.keep()

    def _close_replaced(self) -> None:
        cell, run = self._present()
        for shown, runs in list(self._runs.items()):
            if runs.get(cell, run) != run:
                del runs[cell]
            if not runs:
                del self._runs[shown]
                shown.close()


@cache
def outputs_of(shell: Any) -> Outputs:
    """Return the outputs of a kernel's shell.

    Parameters
    ----------
    shell : InteractiveShell
    """
    return Outputs(shell)


def shell_with_kernel() -> Any:
    """Return the IPython shell if there is a kernel behind it, else None; imports nothing.

    Returns
    -------
    shell : InteractiveShell or None
    """
    ipython = sys.modules.get("IPython")
    shell = None if ipython is None else ipython.get_ipython()
    return shell if getattr(shell, "kernel", None) is not None else None
