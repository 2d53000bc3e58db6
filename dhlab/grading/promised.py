"""What the text of an exercise promises, held against its questions: check cells, points, hints."""

import ast
import re
from collections.abc import Iterable, Iterator, Sequence

from dhlab.grading.grades import number
from dhlab.grading.question import Question
from dhlab.grading.source import Cell, answers, assigned, calls_of, parsed

WORTH = re.compile(r"^#+ .*\((\d+(?:\.\d+)?) points?\)\s*$")
TOGETHER = re.compile(r"\*\*Points\.\*\* (\d+(?:\.\d+)?)(?![\d/])")
GIVES = re.compile(r"^(?:return|\w[\w, ]* =) (?=.{12})")
"""What may stand before the part of an answer that says something."""


def check_problems(cells: Sequence[Cell], questions: Sequence[Question]) -> Iterator[str]:
    """Say where a check cell asks for another question than there is, and which has none.

    Parameters
    ----------
    cells : sequence of Cell
        As students get them.
    questions : sequence of Question

    Yields
    ------
    problem : str
        With its place.
    """
    names, checked = [question.name for question in questions], set()
    there, checkers = ", ".join(names), checkers_in(cells)
    for cell in cells:
        for name, call in checks_in(cell, checkers):
            checked.add(name)
            if name not in names:
                yield (
                    f"{cell.where(call.lineno - 1)}: check({name!r}, ...) asks for a question that "
                    f"is not in checks.py; there are {there}"
                )
            elif not _shows(call, name):
                yield (
                    f"{cell.where(call.lineno - 1)}: what a check sees is marked; "
                    f"write check({name!r}, {name})"
                )
    for name in names:
        if name not in checked:
            yield f"{cells[0].file}: no cell checks {name!r}; write check({name!r}, {name})"


def point_problems(cells: Sequence[Cell], questions: Sequence[Question]) -> Iterator[str]:
    """Say where the text tells other points than the questions have.

    A heading that ends in "(2 points)" speaks of the questions that are checked below it, up to
    the next such heading; ``**Points.** 6`` speaks of all.

    Parameters
    ----------
    cells : sequence of Cell
        As students get them.
    questions : sequence of Question
        All that is checked.

    Yields
    ------
    problem : str
        With its place.
    """
    worth = {question.name: question.points for question in questions}
    total = number(sum(worth.values()))
    for cell in cells:
        for row, line in enumerate(_text(cell)):
            together = TOGETHER.search(line)
            if together and number(float(together[1])) != total:
                yield (
                    f"{cell.where(row)}: the text says {together[1]} points; the questions of "
                    f"checks.py have {total} together"
                )
    for where, said, names in _sections(cells):
        have = number(sum(worth[name] for name in names))
        if number(float(said)) != have:
            below = f"checks.py has {have} for {' and '.join(names)}"
            below = below if names else "no question is checked below it"
            yield f"{where}: the heading says {said} points; {below}"


def _sections(cells: Sequence[Cell]) -> list[tuple[str, str, dict[str, None]]]:
    """Place and points of each heading that tells some, with the questions checked below it."""
    found: list[tuple[str, str, dict[str, None]]] = []
    checkers = checkers_in(cells)
    for cell in cells:
        for row, line in enumerate(_text(cell)):
            heading = WORTH.match(line)
            if heading:
                found.append((cell.where(row), heading[1], {}))
        if found:
            found[-1][2].update((name, None) for name, _ in checks_in(cell, checkers))
    return found


def _text(cell: Cell) -> list[str]:
    return cell.source.splitlines() if cell.kind == "markdown" else []


def given_away(
    solved: Iterable[Cell], released: Iterable[Cell], questions: Iterable[Question]
) -> Iterator[str]:
    """Say which line of an answer stands in the notebook for students, or in a hint.

    Parameters
    ----------
    solved, released : iterable of Cell
        With the answers, and as students get them.
    questions : iterable of Question

    Yields
    ------
    problem : str
        With its place.
    """
    shown = [" ".join(cell.source.split()) for cell in released]
    hints = {question.name: _plain(question.hint) for question in questions}
    for cell in solved:
        for row, line in answers(cell):
            if any(line in text for text in shown):
                yield f"{cell.where(row)}: this line of an answer is also given away"
            told = [name for name, hint in hints.items() if _plain(line) in hint]
            told += [name for name in assigned(cell) if _given(line) in hints.get(name, "")]
            if told:
                yield f"{cell.where(row)}: the hint of {told[0]!r} gives this line away"


def _given(line: str) -> str:
    """What a line of an answer gives, without `return` or the name: an expression, or the line."""
    rest = GIVES.sub("", line)
    try:
        ast.parse(rest, mode="eval")
    except SyntaxError:
        return _plain(line)
    return _plain(rest)


def _plain(text: str) -> str:
    """Text without what does not change what Python reads: spaces, kinds of quotes."""
    return re.sub(r"\s+", "", text).replace('"', "'")


def checkers_in(cells: Iterable[Cell]) -> set[str]:
    """Names that hold what ``checks(...)`` gives."""
    found: set[str] = set()
    for cell in cells:
        made = {(call.lineno, call.col_offset) for call in calls_of(cell, {"checks"})}
        for node in parsed(cell).body if made else ():
            if isinstance(node, ast.Assign):
                is_check = (node.value.lineno, node.value.col_offset) in made
                names = {target.id for target in node.targets if isinstance(target, ast.Name)}
                found |= names if is_check else set()
    return found


def checks_in(cell: Cell, checkers: set[str]) -> Iterator[tuple[str, ast.Call]]:
    """Yield the name of each question that a cell checks, with the call."""
    for call in calls_of(cell, checkers):
        first = call.args[0] if call.args else None
        if isinstance(first, ast.Constant) and isinstance(first.value, str):
            yield first.value, call


def _shows(call: ast.Call, name: str) -> bool:
    """Whether a call checks what is called like the question."""
    return len(call.args) > 1 and isinstance(call.args[1], ast.Name) and call.args[1].id == name
