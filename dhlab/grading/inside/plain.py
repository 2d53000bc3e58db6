"""Between values and strict JSON: numbers, text, arrays, lists and mappings, and nothing else.

An array is ``{"shape": [2, 2], "data": [1, 0, 0, "nan"]}``. What comes out of a sandbox is read
by the same rules as it was written, whoever wrote it: `loads`, `from_json`.
"""

import json
import math
import unicodedata
from collections.abc import Mapping
from typing import Any, NoReturn

import numpy as np

MOST_NUMBERS = 100_000
LONGEST_TEXT = 1_000
DEEPEST = 8
LINE = ", in the line "
"""What stands between an error and the student's line that it came from."""
NOT_FINITE = {"nan": math.nan, "inf": math.inf, "-inf": -math.inf}
VISIBLE = {ord("<"): "\u2039", ord(">"): "\u203a"}  # no text of a student is ever live HTML


class NotPlain(Exception):
    """A value that is not made of numbers and text, or of too many.

    Parameters
    ----------
    reason : {'not numbers', 'too large', 'no function'}
    text : str
        What came, in a few words.
    """

    def __init__(self, reason: str, text: str) -> None:
        super().__init__(reason, text)
        self.reason = reason
        self.text = text


class Missing(TypeError):
    """Something of dhlab was used as a number where it is not there."""


def tidy(text: str, limit: int = 200) -> str:
    r"""Text on one line without control characters and angle brackets, cut to a limit.

    Examples
    --------
    >>> tidy("<b>one\n\x1b[31mtwo")
    '‹b›one [31mtwo'
    """
    line = " ".join(text[: 4 * limit].split())
    line = "".join(c for c in line if unicodedata.category(c)[0] != "C").translate(VISIBLE)
    return line if len(line) <= limit else line[: limit - 3] + "..."


def to_json(value: Any) -> Any:
    """Strict JSON value of numbers, text, arrays, lists and mappings.

    Parameters
    ----------
    value : object

    Returns
    -------
    plain : None, bool, int, float, str, list or dict
        What `json.dumps` takes with ``allow_nan=False``.

    Raises
    ------
    NotPlain
        If there is anything else in it, or more than 100,000 numbers.

    Examples
    --------
    >>> to_json({"q": np.array([0.5, np.inf]), "joints": "rr"})
    {'q': {'shape': [2], 'data': [0.5, 'inf']}, 'joints': 'rr'}
    >>> to_json([1, {2}])
    Traceback (most recent call last):
    ...
    dhlab.grading.inside.plain.NotPlain: ('not numbers', 'a set')
    """
    plain = _written(value, DEEPEST)
    _check_size(_count(plain))
    return plain


def from_json(plain: Any) -> Any:
    """Value that `to_json` wrote: floats, float64 arrays, text, lists and mappings.

    Parameters
    ----------
    plain : object
        As `loads` gives it.

    Returns
    -------
    value : None, bool, int, float, str, ndarray, list or dict

    Raises
    ------
    NotPlain
        If it is not what `to_json` writes.

    Examples
    --------
    >>> from_json({"shape": [1, 2], "data": [1, "-inf"]})
    array([[  1., -inf]])
    >>> from_json({"shape": [3], "data": [1]})
    Traceback (most recent call last):
    ...
    dhlab.grading.inside.plain.NotPlain: ('not numbers', 'an array whose shape does not fit')
    """
    value = _read(plain, DEEPEST)
    _check_size(_count(plain))
    return value


def loads(line: str | bytes) -> Any:
    """Read one strict JSON value: no NaN, no name twice, no depth that fills the stack.

    Examples
    --------
    >>> loads('{"a": 1, "a": 2}')
    Traceback (most recent call last):
    ...
    dhlab.grading.inside.plain.NotPlain: ('not numbers', 'no strict JSON')
    """
    try:
        return json.loads(line, parse_constant=_refuse, object_pairs_hook=_pairs)
    except (ValueError, RecursionError, MemoryError):
        raise NotPlain("not numbers", "no strict JSON") from None


def _refuse(word: str) -> NoReturn:
    raise ValueError(word)


def _pairs(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    if len(named := dict(pairs)) < len(pairs):
        raise ValueError("a name twice")
    return named


def _check_size(count: int) -> None:
    if count > MOST_NUMBERS:
        raise NotPlain("too large", f"more than {MOST_NUMBERS:,} numbers")


def _count(plain: Any) -> int:
    """Numbers and texts in a value of strict JSON."""
    if isinstance(plain, dict):
        plain = list(plain.values())
    return sum(map(_count, plain)) if isinstance(plain, list) else 1


def _written(value: Any, depth: int) -> Any:
    if depth == 0:
        raise NotPlain("too large", "lists in lists in lists without end")
    if value is None or isinstance(value, bool | np.bool_):
        return value if value is None else bool(value)
    if isinstance(value, str):
        return _text(str(value))
    if isinstance(value, Mapping):
        _check_size(len(value))
        return {_name(key): _written(item, depth - 1) for key, item in value.items()}
    array = _as_floats(value)
    if array is not None:
        return _array_written(array, isinstance(value, int | np.integer))
    if isinstance(value, list | tuple):
        return [_written(item, depth - 1) for item in value]
    raise NotPlain("not numbers", f"a {type(value).__name__}")


def _as_floats(value: Any) -> np.ndarray[Any, np.dtype[np.float64]] | None:
    """Float64 array of what is made of numbers alone, None of what is not."""
    if isinstance(value, list | tuple | np.ndarray):
        _check_size(np.size(value) if isinstance(value, np.ndarray) else len(value))
    try:
        array = np.array(value)
        if array.dtype.kind == "c" and not np.imag(array).any():
            array = np.real(array)
        if array.dtype.kind == "c":
            raise NotPlain("not numbers", "complex numbers")
        if array.dtype.kind not in "biufO":
            return None
        return np.array(array, dtype=np.float64)
    except Missing as refusal:
        raise NotPlain("not numbers", str(refusal)) from None
    except (ValueError, TypeError):  # rows of different lengths, or no numbers
        return None
    except OverflowError:
        raise NotPlain("not numbers", "an integer beyond all measure") from None


def _array_written(array: np.ndarray[Any, np.dtype[np.float64]], whole: bool) -> Any:
    _check_size(array.size)
    if array.ndim > DEEPEST:
        raise NotPlain("too large", "lists in lists in lists without end")
    if array.ndim == 0 and np.isfinite(array):
        return int(array) if whole and abs(array) < 2**53 else float(array)
    data = [x if math.isfinite(x) else str(x) for x in array.ravel().tolist()]
    return {"shape": list(array.shape), "data": data}


def _read(plain: Any, depth: int) -> Any:
    if depth == 0:
        raise NotPlain("too large", "lists in lists in lists without end")
    if plain is None or isinstance(plain, bool):
        return plain
    if isinstance(plain, int | float):
        return _number(plain)
    if isinstance(plain, str):
        return _text(plain)
    if isinstance(plain, list):
        return [_read(item, depth - 1) for item in plain]
    if plain.keys() == {"shape", "data"}:
        return _array_read(plain["shape"], plain["data"])
    return {_name(key): _read(item, depth - 1) for key, item in plain.items()}


def _array_read(shape: Any, data: Any) -> Any:
    sizes = shape if isinstance(shape, list) and len(shape) <= DEEPEST else [-1]
    fits = all(type(n) is int and 0 <= n <= MOST_NUMBERS for n in sizes)
    if not fits or not isinstance(data, list) or math.prod(sizes) != len(data):
        raise NotPlain("not numbers", "an array whose shape does not fit")
    array = np.array([_entry(x) for x in data], dtype=np.float64).reshape(sizes)
    return array if sizes else float(array)


def _entry(x: Any) -> float:
    if isinstance(x, str) and x in NOT_FINITE:
        return NOT_FINITE[x]
    if type(x) not in (int, float):
        raise NotPlain("not numbers", "an array that is not made of numbers")
    return float(_number(x))


def _number(x: float) -> float:
    """Check a number: finite as a float; a whole one stays an int while floats can tell it."""
    if isinstance(x, int):
        if x.bit_length() > 1000:
            raise NotPlain("not numbers", "an integer beyond all measure")
        return x if abs(x) < 2**53 else float(x)
    if not math.isfinite(x):
        raise NotPlain("not numbers", "a number beyond all measure")
    return x


def _text(text: str) -> str:
    if len(text) > LONGEST_TEXT:
        raise NotPlain("too large", f"a text of more than {LONGEST_TEXT:,} letters")
    return tidy(text, LONGEST_TEXT)


def _name(key: Any) -> str:
    if not isinstance(key, str):
        raise NotPlain(
            "not numbers", f"a mapping whose names are not text but {type(key).__name__}"
        )
    return tidy(key)
