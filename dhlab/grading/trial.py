"""An exercise's own cells, run as a notebook runs them: for the proof before it is released.

Only for what an instructor wrote: submissions run in the sandbox.
"""

import ast
import io
import os
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, redirect_stdout
from dataclasses import replace
from typing import Any

from dhlab.errors import DhlabError
from dhlab.grading.check import Check
from dhlab.grading.source import Cell

Namespace = dict[str, Any]


def run_cells(
    cells: Sequence[Cell], after: Callable[[Cell, Namespace], None] | None = None
) -> Namespace:
    """Run the code cells from top to bottom and show what each ends in.

    Views record what would be seen.

    Parameters
    ----------
    cells : sequence of Cell
    after : callable, optional
        Is called after each cell with the cell and the names there are.

    Returns
    -------
    names : dict

    Raises
    ------
    DhlabError
        A cell raised; the message names the place in the file.
    """
    names: Namespace = {"__name__": "__main__"}
    with _recording(), redirect_stdout(io.StringIO()):
        for cell in cells:
            if cell.kind == "code":
                run_cell(cell, names)
                if after is not None:
                    after(cell, names)
    return names


def check_of(names: Namespace, file: str) -> Check:
    """Return the check among the names that cells defined."""
    found = [value for value in names.values() if isinstance(value, Check)]
    if not found:
        raise DhlabError(f"{file}: no name holds the checks; write 'check = checks(course=...)'")
    return found[0]


def for_student(cells: Sequence[Cell], student: str) -> list[Cell]:
    """Cells with a student's name in place of the empty one."""
    named = f"STUDENT = {student!r}"
    return [
        replace(c, source="\n".join(_renamed(line, named) for line in c.source.splitlines()))
        for c in cells
    ]


def _renamed(line: str, named: str) -> str:
    return named if line.startswith("STUDENT = ") else line


def run_cell(cell: Cell, names: Namespace) -> None:
    """Run one code cell with the names there are, and show what it ends in.

    Raises
    ------
    DhlabError
        The cell raised; the message names the place in the file.
    """
    tree = ast.parse(cell.source)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    try:
        exec(compile(tree, cell.file, "exec"), names)
        if isinstance(last, ast.Expr):
            _shown(eval(compile(ast.Expression(last.value), cell.file, "eval"), names))
    except (Exception, SystemExit) as error:
        what = f"{type(error).__name__}: {error}"
        raise DhlabError(f"{cell.where()}: the cell that begins here raised {what}") from error


def _shown(value: Any) -> None:
    """Do what a notebook does with the value of a cell."""
    for method in ("_repr_mimebundle_", "_repr_html_", "__repr__"):
        if not isinstance(value, type) and hasattr(value, method):
            getattr(value, method)()


@contextmanager
def _recording() -> Iterator[None]:
    before = os.environ.get("DHLAB_VIEW")
    os.environ["DHLAB_VIEW"] = "record"
    try:
        yield
    finally:
        if before is None:
            del os.environ["DHLAB_VIEW"]
        else:
            os.environ["DHLAB_VIEW"] = before
