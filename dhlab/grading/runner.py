"""Running the cells of a submission and asking for its answers; nothing is judged here."""

import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from dhlab.grading.asked import Ask, NoValue, Reason
from dhlab.grading.heard import Heard
from dhlab.grading.mounts import Room
from dhlab.grading.sandbox import Limits, Sandbox, SandboxError, check_sandbox, started
from dhlab.grading.tools import tool_modules, tool_texts
from dhlab.grading.values import to_json
from dhlab.grading.watched import watch

ROUNDS = 3
"""The run, and at most two more without a cell or a question that ended it."""

BESIDE_LIBRARY = ("dhlab.grading", "dhlab.panel")
"""Parts of dhlab that are a stand-in where the rest is real: no answer is a panel."""

LEFT_OUT = {
    "too slow": "it took too long",
    "too much memory": "it needed too much memory",
    "too large": "it wrote too much",
    "ended": "it ended the whole program",
}


@dataclass(frozen=True)
class Run:
    """What a submission gave.

    Attributes
    ----------
    replies : dict
        By question: for each case the value, or a `NoValue`.
    left_out : mapping of int to str
        The cells, counted from 1, that had to be left out for the others to run, each with why.
    notes : tuple of str
        What was seen: errors of cells, files, network, processes.
    student : str or None
        The name that the notebook gives.
    seconds : float
    """

    replies: Mapping[str, tuple[Any, ...]]
    left_out: Mapping[int, str]
    notes: tuple[str, ...]
    student: str | None
    seconds: float


def run_cells(
    cells: Sequence[str],
    asks: Sequence[Ask],
    given: Mapping[str, Any],
    *,
    tools: Sequence[str] = (),
    sandbox: Sandbox = "bwrap",
    limits: Limits | None = None,
) -> Run:
    """Run the cells of a submission in a sandbox and ask for values.

    Parameters
    ----------
    cells : sequence of str
        Code cells in the order of the notebook.
    asks : sequence of Ask
        Those that need the library are asked where dhlab is; others where there is none, only a
        stand-in whose views and checks do nothing.
    given : mapping
        What ``check.numbers(STUDENT)`` gives, whoever is named.
    tools : sequence of str
        Names of dhlab that compute and are there all the same.
    sandbox : {'bwrap', 'none'}
        'none' runs the cells unprotected, as this user: for work that is trusted.
    limits : Limits, optional

    Returns
    -------
    run : Run

    Raises
    ------
    SandboxError
        The sandbox does not work here; nothing was run.
    """
    check_sandbox(sandbox)
    start = time.monotonic()
    rounds = _Rounds(cells, given, tool_modules(tools), sandbox, limits or Limits())
    replies: dict[str, tuple[Any, ...]] = {}
    for library in (False, True):
        group = [ask for ask in asks if ask.has_library == library]
        if group:
            replies |= rounds.ask(group, library)
    order = {ask.name: replies[ask.name] for ask in asks}
    notes = tuple(dict.fromkeys(rounds.notes))
    seconds = time.monotonic() - start
    return Run(order, dict(sorted(rounds.left_out.items())), notes, rounds.student, seconds)


@dataclass
class _Rounds:
    """Runs cells as often as it takes, within one time for all."""

    cells: Sequence[str]
    given: Mapping[str, Any]
    tools: Mapping[str, str]
    sandbox: Sandbox
    limits: Limits
    left_out: dict[int, str] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)
    student: str | None = None

    def __post_init__(self) -> None:
        self.deadline = time.monotonic() + self.limits.whole

    def ask(self, asks: Sequence[Ask], library: bool) -> dict[str, tuple[Any, ...]]:
        """Ask some questions; the answers by name."""
        found: dict[str, tuple[Any, ...]] = {}
        why: NoValue | None = None
        for _ in range(ROUNDS):
            pending = [ask for ask in asks if ask.name not in found]
            if not pending or time.monotonic() > self.deadline:
                break
            heard, stopped = self._once(pending, library)
            why = self._settle(pending, heard, stopped, found)
        nothing = why or NoValue("too slow", "the time for the whole notebook was over")
        return {ask.name: found.get(ask.name, (nothing,) * len(ask.cases)) for ask in asks}

    def _once(self, asks: Sequence[Ask], library: bool) -> tuple[Heard, Reason | None]:
        numbered = [(k, text) for k, text in enumerate(self.cells, 1) if k not in self.left_out]
        job = {
            "cells": numbered,
            "asks": [_written(ask) for ask in asks],
            "given": dict(self.given),
            "parts": BESIDE_LIBRARY if library else ["dhlab"],
            "tools": {} if library else dict(self.tools),
            "texts": {} if library else tool_texts(self.tools),
            "limits": self.limits.told(self.sandbox),
        }
        heard = Heard({k for k, _ in numbered}, asks)
        room = Room(library)
        try:
            stopped = self._heard_out(job, room, heard)
        except SandboxError:  # nothing has run; a machine out of memory ends a sandbox first
            stopped = self._heard_out(job, room, heard)
        self.notes += heard.notes
        self.student = heard.student if self.student is None else self.student
        return heard, stopped

    def _heard_out(self, job: Mapping[str, Any], room: Room, heard: Heard) -> Reason | None:
        with started(job, self.sandbox, self.limits, room) as process:
            return watch(process, heard, self.limits, self.deadline)

    def _settle(
        self,
        asks: Sequence[Ask],
        heard: Heard,
        stopped: Reason | None,
        found: dict[str, tuple[Any, ...]],
    ) -> NoValue | None:
        """Take the answers of one run; say why there are no more, if they are not all there."""
        for k, ask in enumerate(asks):
            values = [heard.values.get((k, j)) for j in range(len(ask.cases))]
            is_open = any((k, j) not in heard.values for j in range(len(ask.cases)))
            why = heard.ends.get(k)
            if why is None and heard.question == k and heard.cell is None:
                why = NoValue(stopped or "ended", "")
            if not is_open or why is not None:
                filled = [heard.values.get((k, j), why) for j in range(len(values))]
                found[ask.name] = tuple(filled)
        if stopped is None:
            return NoValue("ended", "")
        if heard.cell is not None:
            self.left_out[heard.cell] = LEFT_OUT[stopped]
            return NoValue(stopped, f"cell {heard.cell} did not let the notebook go on")
        return NoValue(stopped, "")


def _written(ask: Ask) -> dict[str, Any]:
    cases = [[to_json(argument) for argument in arguments] for arguments in ask.cases]
    return {"name": ask.name, "kind": ask.kind, "cases": cases}
