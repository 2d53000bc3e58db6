"""Marking a solved exercise beside its cells alone, in the same sandbox."""

from collections.abc import Iterator
from pathlib import Path

from rows import Row, Skipped, in_turns

from dhlab.grading.exercise import load_exercise
from dhlab.grading.mark import mark_cells
from dhlab.grading.runner import _Rounds
from dhlab.grading.sandbox import Limits, SandboxError
from dhlab.grading.source import read_cells
from dhlab.grading.tools import tool_modules

EXERCISES = Path(__file__).parents[2] / "exercises"
ASKED = {
    "07_dh_link": "functions",
    "04_detour": "a scene, a pose, a function",
    "12_base_tool_offset": "two frames, a robot",
    "14_hand": "a hand of 20 joints",
}
ROUNDS = 15
STUDENT = "Ada Lovelace"


def measure() -> Iterator[Row | Skipped]:
    for name, asked in ASKED.items():
        solved = Solved(name)
        try:
            marked, alone = in_turns((solved.mark, solved.run), ROUNDS)
        except SandboxError as error:
            yield Skipped("marking", str(error))
            return
        what = f"exercise {name[:2]} marked: {asked}"
        beside = "its cells alone, in the sandbox"
        yield Row(what, 1000 * marked, 1000 * alone, beside, target="<= 1.3")


class Solved:
    """An exercise with the cells that solve it."""

    def __init__(self, name: str) -> None:
        texts = read_cells(EXERCISES / name / "exercise.py")
        self.exercise = load_exercise(EXERCISES / name)
        self.cells = [cell.source for cell in texts if cell.kind == "code"]
        self.given = self.exercise.numbers(STUDENT, self.exercise.course)
        asked = self.exercise.questions(self.given)
        self.library = any(question.library or question.kind != "values" for question in asked)

    def mark(self) -> None:
        """Mark it."""
        course = self.exercise.course
        marked = mark_cells(self.exercise, STUDENT, self.cells, seed=1, course=course)
        if marked.points != marked.out_of:
            raise RuntimeError(f"{self.exercise.name}: {marked.points} of {marked.out_of} points")

    def run(self) -> None:
        """Run its cells and ask for nothing."""
        tools = tool_modules(self.exercise.tools)
        _Rounds(self.cells, self.given, tools, "bwrap", Limits())._once([], self.library)
