"""What the process beside a student's code was heard to say; nothing of it is trusted.

A line may be forged. So it only is a value for a case (right if its numbers are), a note that is
known, the text of an error (made harmless), or progress, which chooses no more than the cell that a
second run leaves out.
"""

from collections.abc import Collection, Sequence
from typing import Any

from dhlab.grading.asked import Ask, NoValue
from dhlab.grading.inside.notes import is_note
from dhlab.grading.inside.plain import NotPlain, loads, tidy
from dhlab.grading.values import from_json, no_value

MOST_NOTES = 20


class Heard:
    """Collects the lines of one run.

    Parameters
    ----------
    cells : collection of int
        The numbers of the cells that run.
    asks : sequence of Ask

    Attributes
    ----------
    is_ready, is_done : bool
        Whether the run began, and whether it came to its end.
    cell, question : int or None
        What was begun last.
    values : dict
        By question and case: what came first.
    ends : dict
        By question: why it ended, where that is told.
    notes : list of str
    student : str or None
        The name that the notebook gives.

    Examples
    --------
    >>> heard = Heard([1], [Ask("x")])
    >>> heard.hear(b'{"question": 0, "case": 0, "value": 2.5}')
    >>> heard.hear(b'{"question": 0, "case": 0, "value": 10}')
    >>> heard.hear(b'{"score": 100, "passed": true}')
    >>> heard.values
    {(0, 0): 2.5}
    """

    def __init__(self, cells: Collection[int], asks: Sequence[Ask]) -> None:
        self._cells = cells
        self._asks = asks
        self.is_ready = self.is_done = False
        self.cell: int | None = None
        self._furthest = 0
        self.question: int | None = None
        self.values: dict[tuple[int, int], Any] = {}
        self.ends: dict[int, NoValue] = {}
        self.notes: list[str] = []
        self.student: str | None = None

    @property
    def phase(self) -> tuple[int | None, int | None]:
        """What runs now: a cell or a question; it only goes forward."""
        return self.cell, self.question

    def hear(self, line: bytes) -> None:
        """Take one line, whatever it is."""
        try:
            words = loads(line) if line.strip() else None
        except NotPlain:
            return
        if not isinstance(words, dict):
            return
        self.is_ready |= words.get("ready") is True
        self.is_done |= words.get("done") is True
        if "cell" in words:
            self._begin_cell(words["cell"])
        if "question" in words:
            self._hear_question(words)
        if "end" in words:
            self._hear_end(words["end"], words.get("no"))
        self._hear_texts(words)

    def _begin_cell(self, number: Any) -> None:
        if number is None:
            self.cell = None
        elif type(number) is int and number in self._cells and number > self._furthest:
            self.cell = self._furthest = number

    def _hear_question(self, words: dict[str, Any]) -> None:
        k, j = words["question"], words.get("case")
        if not self._is_question(k):
            return
        if j is None:
            self.cell = None
            self.question = k if self.question is None else max(k, self.question)
        elif type(j) is int and 0 <= j < len(self._asks[k].cases) and (k, j) not in self.values:
            value = from_json(words["value"]) if "value" in words else _refusal(words.get("no"))
            self.values[k, j] = value

    def _hear_end(self, k: Any, why: Any) -> None:
        if self._is_question(k):
            self.ends.setdefault(k, _refusal(why))

    def _hear_texts(self, words: dict[str, Any]) -> None:
        note, student, error = (words.get(name) for name in ("note", "student", "error"))
        if isinstance(note, str) and is_note(note):
            self._note(note)
        if isinstance(student, str) and self.student is None:
            self.student = tidy(student)
        if isinstance(error, list) and [type(part) for part in error] == [int, str]:
            self._note(f"cell {error[0] if error[0] in self._cells else '?'}: {tidy(error[1])}")

    def _note(self, text: str) -> None:
        if text not in self.notes and len(self.notes) < MOST_NOTES:
            self.notes.append(text)

    def _is_question(self, k: Any) -> bool:
        return type(k) is int and 0 <= k < len(self._asks)


def _refusal(why: Any) -> NoValue:
    if isinstance(why, list) and len(why) == 2 and all(isinstance(word, str) for word in why):
        return no_value(*why)
    return NoValue("ended", "")
