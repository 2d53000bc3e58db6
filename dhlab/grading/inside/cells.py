"""Running the cells of a notebook, one after the other, in one namespace."""

import ast
import builtins
import inspect
import linecache
import re
import sys
from types import CodeType, ModuleType
from typing import Any, NoReturn

from dhlab.grading.inside.answers import CELL

STATEMENT_MAGICS = ("time", "timeit", "prun", "capture")  # what follows them is Python
LINE_MAGIC = re.compile(r"^(?P<indent>\s*)%(?P<name>\w+)(?P<rest>.*)$")
OTHER_LINE = re.compile(r"^(?P<indent>\s*)(?:[!?].*|[\w.]+\?{1,2}\s*)$")
OPTIONS = re.compile(r"^(?:\s*-\w+(?:\s*\d+)?)*\s*")


def new_namespace() -> dict[str, Any]:
    """Make the names that a notebook begins with, and the module that they are in."""
    module = ModuleType("__main__")
    sys.modules["__main__"] = module
    names: dict[str, Any] = module.__dict__
    names.update(display=_nothing, get_ipython=_nothing, exit=sys.exit, quit=sys.exit)
    builtins.input = _nobody
    return names


def run_cell(text: str, number: int, names: dict[str, Any]) -> None:
    r"""Run one cell; it raises whatever the cell raises.

    Parameters
    ----------
    text : str
        Python; magics of IPython are left out, what they run is run.
    number : int
        Of the cell, from 1.
    names : dict
        What the cell finds and leaves.

    Examples
    --------
    >>> names = {}
    >>> run_cell("%matplotlib inline\n%time a = 1", 1, names)
    >>> names["a"]
    1
    """
    file = f"{CELL}{number}"
    code = _compiled(text, file)
    if code.co_flags & inspect.CO_COROUTINE:  # the cell awaits something
        import asyncio  # takes as long as half of numpy

        asyncio.run(eval(code, names))
    else:
        exec(code, names)


def without_magics(text: str) -> str:
    r"""Text of a cell without what only IPython understands, line by line as before.

    Examples
    --------
    >>> without_magics("%%capture out\nx = 1\n!ls\n%timeit -n 10 f(x)\nf?")
    'pass\nx = 1\npass\nf(x)\npass'
    >>> without_magics("%%html\n<b>bold</b>")
    ''
    """
    lines = text.splitlines()
    first = next((k for k, line in enumerate(lines) if line.strip()), 0)
    if lines and lines[first].startswith("%%"):
        name = re.match(r"%%(\w*)", lines[first])
        if name is None or name[1] not in STATEMENT_MAGICS:
            return ""
        lines[first] = "pass"
    return "\n".join(map(_line_without, lines))


def _line_without(line: str) -> str:
    magic = LINE_MAGIC.match(line)
    if magic is None:
        other = OTHER_LINE.match(line)
        return f"{other['indent']}pass" if other else line
    body = OPTIONS.sub("", magic["rest"]) if magic["name"] in STATEMENT_MAGICS[:3] else ""
    return magic["indent"] + (body or "pass")


def _compiled(text: str, file: str) -> CodeType:
    linecache.cache[file] = (len(text), None, text.splitlines(keepends=True), file)
    try:
        return _compile(text, file)
    except SyntaxError as error:
        try:
            return _compile(without_magics(text), file)
        except SyntaxError:
            raise error from None


def _compile(text: str, file: str) -> CodeType:
    flags = ast.PyCF_ALLOW_TOP_LEVEL_AWAIT
    code: CodeType = compile(text, file, "exec", flags, dont_inherit=True)
    return code


def _nothing(*_: Any, **__: Any) -> None:
    """Stand for what only a notebook has."""


def _nobody(*_: Any) -> NoReturn:
    raise EOFError("input() finds nobody to answer when this is marked")
