"""What a benchmark gives: rows of one table, and times taken in turns."""

import gc
from collections.abc import Callable, Sequence
from time import perf_counter, sleep
from typing import NamedTuple


class Row(NamedTuple):
    """One line of the table.

    Attributes
    ----------
    what : str
        What was measured.
    value : float
        How much it was, in `unit`.
    beside : float or None
        What stands beside it, in `unit`; None where there is no other.
    name : str
        Name of what stands beside it.
    unit : str
    target : str
        Where the ratio (without another: the value) has to be, as text: ``"<= 1.3"``.
    """

    what: str
    value: float
    beside: float | None = None
    name: str = ""
    unit: str = "ms"
    target: str = ""

    @property
    def ratio(self) -> float | None:
        """Value over what stands beside it."""
        return self.value / self.beside if self.beside else None

    def met(self) -> bool | None:
        """Whether the target is met; None where there is none."""
        if not self.target:
            return None
        relation, bound = self.target.split()[:2]
        figure = self.value if self.ratio is None else self.ratio
        return {"<=": figure <= float(bound), ">=": figure >= float(bound)}[relation]


class Skipped(NamedTuple):
    """What could not be measured here, and why."""

    what: str
    reason: str


def in_turns(
    functions: Sequence[Callable[[], object]],
    rounds: int = 7,
    pick: Callable[[Sequence[float]], float] = min,
) -> list[float]:
    """Seconds that each function took; they run in turns, so that all meet the same noise."""
    times: list[list[float]] = [[] for _ in functions]
    for function in functions:
        function()
    gc.collect()
    for _ in range(rounds):
        for function, taken in zip(functions, times, strict=True):
            sleep(0.005)  # lets other threads finish what the last one left to them
            began = perf_counter()
            function()
            taken.append(perf_counter() - began)
    return [pick(taken) for taken in times]


def median(numbers: Sequence[float]) -> float:
    """Middle of some numbers."""
    return sorted(numbers)[len(numbers) // 2]
