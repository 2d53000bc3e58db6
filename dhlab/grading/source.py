"""The text of an exercise, cell by cell, and what students get of it."""

import ast
import hashlib
import json
import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from dhlab.errors import DhlabError
from dhlab.grading.exercise import text_of

BEGIN, END = "### BEGIN SOLUTION", "### END SOLUTION"
MARKER = re.compile(r"^# %%(?!%)", re.MULTILINE)
FUNCTION_STUB = (
    "# Write your answer here, in place of the next line.",
    "raise NotImplementedError",
)
OPEN_STUB = "# Write your answer here."


@dataclass(frozen=True)
class Cell:
    """One cell of an exercise.

    Attributes
    ----------
    kind : {'code', 'markdown'}
    source : str
    file : str
        Where it was read.
    title : str
        Behind its ``# %%``; becomes the id of the notebook's cell.
    line : int
        Of the first line of `source` in the file.
    metadata : dict
    """

    kind: str
    source: str
    file: str
    line: int
    title: str
    metadata: dict[str, Any]

    def where(self, row: int = 0) -> str:
        """File and line of one row of the cell, from 0."""
        return f"{self.file}, line {self.line + row}"


def read_cells(path: Path) -> list[Cell]:
    """Read a text in jupytext's percent form.

    Parameters
    ----------
    path : Path

    Returns
    -------
    cells : list of Cell

    Raises
    ------
    DhlabError
        There is no such file, or it is not in UTF-8; it does not begin with a cell; a code cell
        is no Python.
    """
    import jupytext

    text = text_of(path)
    starts = [text.count("\n", 0, found.start()) + 2 for found in MARKER.finditer(text)]
    notebook = jupytext.reads(text, fmt="py:percent")
    if len(starts) != len(notebook.cells):
        raise DhlabError(f"{path}, line 1: the text must begin with a cell, '# %% [markdown]'")
    cells = [
        Cell(
            found.cell_type,
            found.source,
            str(path),
            line,
            found.metadata.get("title", ""),
            {key: found.metadata[key] for key in ("tags",) if key in found.metadata},
        )
        for line, found in zip(starts, notebook.cells, strict=True)
    ]
    for cell in cells:
        parsed(cell)
    return cells


def blanked(cell: Cell, names: Collection[str]) -> Cell:
    """Take the answers out of a cell: stubs stand in their places.

    Within a function the stub raises NotImplementedError; else each name that is asked for
    becomes ``...``.

    Parameters
    ----------
    cell : Cell
    names : collection of str
        Names of the questions.

    Raises
    ------
    DhlabError
        A region is nested, not closed in its cell, or closed without having begun.
    """
    out: list[str] = []
    rows = cell.source.splitlines()
    regions = list(_regions(cell))
    row = 0
    for first, last in regions:
        out += rows[row:first]
        inside = rows[first + 1 : last]
        indent = rows[first][: len(rows[first]) - len(rows[first].lstrip())]
        out += [indent + line for line in _stub(inside, indent, names)]
        row = last + 1
    return replace(cell, source="\n".join([*out, *rows[row:]])) if regions else cell


def answers(cell: Cell) -> list[tuple[int, str]]:
    """Lines of the answers in a cell that say something, each with its row, without indents."""
    rows = cell.source.splitlines()
    return [
        (row, " ".join(rows[row].split()))
        for first, last in _regions(cell)
        for row in range(first + 1, last)
        if re.search(r"\w.*[=(+*/@\[-]|[=(+*/@\[-].*\w", rows[row])
        and not rows[row].lstrip().startswith("#")
    ]


def assigned(cell: Cell) -> set[str]:
    """Names that a code cell defines at its top level."""
    names: set[str] = set()
    for node in parsed(cell).body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            names.add(node.name)
        elif isinstance(node, ast.Assign | ast.AnnAssign):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            names |= {n.id for t in targets for n in ast.walk(t) if isinstance(n, ast.Name)}
    return names


def parsed(cell: Cell) -> ast.Module:
    """Read a cell as Python; one of markdown is empty.

    Raises
    ------
    DhlabError
        It is no Python; the message names the line.
    """
    if cell.kind != "code":
        return ast.Module([], [])
    try:
        return ast.parse(cell.source)
    except SyntaxError as error:
        raise DhlabError(f"{cell.where((error.lineno or 1) - 1)}: {error.msg}") from None


def calls_of(cell: Cell, names: Collection[str]) -> list[ast.Call]:
    """Calls in a cell of what has one of these names."""
    calls = [n for n in ast.walk(parsed(cell)) if isinstance(n, ast.Call)]
    return [c for c in calls if isinstance(c.func, ast.Name) and c.func.id in names]


def with_checks(cells: Sequence[Cell], text: str) -> list[Cell]:
    """Put the checks, as text, into the one call of ``checks(...)``, and hide its cell.

    Raises
    ------
    DhlabError
        There is no such call, or more than one, or it has a text already.
    """
    found = [(k, call) for k, cell in enumerate(cells) for call in calls_of(cell, {"checks"})]
    if len(found) != 1:
        what = "no cell calls" if not found else "more than one cell calls"
        raise DhlabError(
            f"{cells[0].file}: {what} checks(); one must be 'check = checks(course=...)'"
        )
    k, call = found[0]
    cell = cells[k]
    if call.args:
        raise DhlabError(f"{cell.where(call.lineno - 1)}: checks() gets its text from the build")
    rows = cell.source.splitlines()
    row, column = (call.func.end_lineno or 1) - 1, call.func.end_col_offset or 0
    line = rows[row].encode("utf-8")  # ast counts bytes
    comma = ", " if call.keywords else ""
    rows[row] = (line[: column + 1] + f'"{text}"{comma}'.encode() + line[column + 1 :]).decode()
    hidden = cell.metadata | {"jupyter": {"source_hidden": True}}
    done = list(cells)
    done[k] = replace(cell, source="\n".join(rows), metadata=hidden)
    return done


def notebook_text(cells: Sequence[Cell]) -> str:
    """Text of a notebook of these cells: the same cells always give the same text."""
    ids: list[str] = []
    made: list[dict[str, Any]] = []
    for cell in cells:
        ids.append(_id(cell, ids))
        new = {
            "cell_type": cell.kind,
            "id": ids[-1],
            "metadata": cell.metadata,
            "source": cell.source.splitlines(keepends=True),
        }
        made.append(
            new | ({} if cell.kind == "markdown" else {"execution_count": None, "outputs": []})
        )
    kernel = {"display_name": "Python 3 (ipykernel)", "language": "python", "name": "python3"}
    notebook = {
        "cells": made,
        "metadata": {"kernelspec": kernel, "language_info": {"name": "python"}},
        "nbformat": 4,
        "nbformat_minor": 5,
    }
    return json.dumps(notebook, ensure_ascii=False, indent=1, sort_keys=True) + "\n"


def _regions(cell: Cell) -> Iterator[tuple[int, int]]:
    begun: int | None = None
    for row, line in enumerate(cell.source.splitlines()):
        if line.strip() == BEGIN:
            if begun is not None:
                raise DhlabError(f"{cell.where(row)}: a solution begins inside another one")
            begun = row
        elif line.strip() == END:
            if begun is None:
                raise DhlabError(f"{cell.where(row)}: a solution ends that has not begun")
            yield begun, row
            begun = None
        elif "SOLUTION" in line:
            raise DhlabError(
                f"{cell.where(row)}: a marker must be a line of its own, '{BEGIN}' or '{END}'"
            )
    if begun is not None:
        raise DhlabError(f"{cell.where(begun)}: a solution begins that does not end in its cell")


def _stub(inside: Sequence[str], indent: str, names: Collection[str]) -> list[str]:
    if indent:
        return list(FUNCTION_STUB)
    body = Cell("code", "\n".join(inside), "", 0, "", {})
    asked = sorted(assigned(body) & set(names), key=body.source.index)
    return [f"{name} = ..." for name in asked] or [OPEN_STUB]


def _id(cell: Cell, taken: Collection[str]) -> str:
    name = re.sub(r"[^a-z0-9]+", "-", cell.title.lower()).strip("-")
    name = name[:48] or hashlib.sha256(f"{cell.kind}\n{cell.source}".encode()).hexdigest()[:8]
    numbered = (name if k == 1 else f"{name}-{k}" for k in range(1, len(taken) + 2))
    return next(name for name in numbered if name not in taken)
