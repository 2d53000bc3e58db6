"""What a student's function or variable gives, as strict JSON, or the reason for nothing."""

import linecache
from collections.abc import Mapping, Sequence
from types import TracebackType
from typing import Any

from dhlab.grading.inside.handles import READERS
from dhlab.grading.inside.plain import LINE, NotPlain, tidy, to_json

CELL = "cell "
"""How the file names of cells begin: "cell 3"."""


class Untouched(Exception):
    """The stub is as it was."""


def reply(there: Mapping[str, Any], name: str, kind: str, arguments: Sequence[Any]) -> Any:
    """What an answer gives for one case; nothing that it does raises.

    Parameters
    ----------
    there : mapping
        The names that the cells left.
    name : str
        Of the function or variable.
    kind : {'values', 'robot', 'csys', 'scene'}
    arguments : sequence
        None for a plain value.

    Returns
    -------
    reply : dict
        ``{"value": ...}`` in strict JSON, or ``{"no": [reason, text]}``.

    Examples
    --------
    >>> reply({"half": lambda x: x / 2}, "half", "values", [3.0])
    {'value': 1.5}
    >>> reply({"half": lambda x: x / 0}, "half", "values", [3.0])
    {'no': ['raised', 'ZeroDivisionError: float division by zero']}
    """
    if name not in there:
        return no("missing")
    try:
        return {"value": to_json(READERS[kind](_value(there[name], arguments)))}
    except (Untouched, NotImplementedError):
        return no("stub")
    except NotPlain as refusal:
        return no(refusal.reason, refusal.text)
    except MemoryError:
        return no("too much memory")
    except BaseException as error:
        return no("raised", told(error))


def no(reason: str, text: str = "") -> dict[str, list[str]]:
    """Reply that there is no value."""
    return {"no": [reason, text]}


def told(error: BaseException) -> str:
    """Say an error on one line, with the student's line that it came from; it never raises."""
    try:
        text = tidy(f"{type(error).__name__}: {error}".rstrip(": "), 140)
        line = _line_of(error.__traceback__)
        return tidy(f"{text}{LINE}`{line}`" if line else text)
    except BaseException:
        return "an error that cannot be told"


def _value(thing: Any, arguments: Sequence[Any]) -> Any:
    if thing is ...:
        raise Untouched
    if not arguments:
        return thing
    if not callable(thing):
        raise NotPlain("no function", "")
    value = thing(*arguments)
    if value is ...:
        raise Untouched
    return value


def _line_of(trace: TracebackType | None) -> str:
    """Find the last line of a cell that an error went through."""
    place = None
    while trace is not None:
        if trace.tb_frame.f_code.co_filename.startswith(CELL):
            place = trace.tb_frame.f_code.co_filename, trace.tb_lineno
        trace = trace.tb_next
    return linecache.getline(*place).strip() if place else ""
