"""Answers as plain data: the way that an answer takes when it is checked and when it is marked.

Whatever a student's code gives is written as strict JSON and read back as numbers, float64
arrays, text, lists and mappings. So no class, comparison or patched function of the student's
takes part in a judgement, and the notebook and the marking judge the same thing.
"""

from typing import Any, cast, get_args

from dhlab.grading.asked import Kind, NoValue, Reason
from dhlab.grading.inside import plain as strict
from dhlab.grading.inside.handles import READERS
from dhlab.grading.inside.plain import NotPlain


def to_json(value: Any, kind: Kind = "values") -> Any:
    """Strict JSON value of an answer.

    Parameters
    ----------
    value : object
    kind : {'values', 'robot', 'csys', 'scene'}
        A robot becomes a mapping of its table, a csys its pose, a scene its poses by name.

    Returns
    -------
    plain : None, bool, int, float, str, list or dict

    Raises
    ------
    NotPlain
        If there is anything else in it, or more than 100,000 numbers.

    Examples
    --------
    >>> to_json([[1, 0], [0, float("nan")]])
    {'shape': [2, 2], 'data': [1.0, 0.0, 0.0, 'nan']}
    """
    return strict.to_json(READERS[kind](value))


def from_json(plain: Any) -> Any:
    """Plain value of an answer, or why there is none.

    Parameters
    ----------
    plain : object
        What a line of JSON held; it need not come from `to_json`.

    Returns
    -------
    value : bool, int, float, str, ndarray, list, dict or NoValue

    Examples
    --------
    >>> from_json({"rows": {"shape": [1, 4], "data": [0, 1, 0, 0]}, "joints": "r"})
    {'rows': array([[0., 1., 0., 0.]]), 'joints': 'r'}
    >>> from_json({"shape": [2], "data": [0, "much"]})
    NoValue(reason='not numbers', text='an array that is not made of numbers')
    """
    try:
        return strict.from_json(plain)
    except NotPlain as refusal:
        return no_value(refusal.reason, refusal.text)


def no_value(reason: str, text: str) -> NoValue:
    """Make a `NoValue` of what came from a student's process, whatever it is."""
    known = reason if reason in get_args(Reason) else "ended"
    return NoValue(cast(Reason, known), strict.tidy(text))
