"""What was asked and what came, case by case, as JSON: for the instructor's records alone."""

import json
from collections.abc import Sequence
from typing import Any

from dhlab.grading.asked import Ask, NoValue
from dhlab.grading.inside.plain import NotPlain, to_json

LONGEST = 4000
"""Characters of a value that are kept; of a longer one its length is."""


def recorded(ask: Ask, values: Sequence[Any]) -> list[dict[str, Any]]:
    """Return the cases of a question with the values that came.

    Parameters
    ----------
    ask : Ask
    values : sequence
        What came, one for each case; a `NoValue` where nothing did.

    Returns
    -------
    cases : list of dict
        "arguments", and either "value" or "nothing", the reason with its text.

    Examples
    --------
    >>> recorded(Ask("half", cases=((1,), (0,))), [0.5, NoValue("raised", "ZeroDivisionError")])
    [{'arguments': [1], 'value': 0.5},
     {'arguments': [0], 'nothing': 'raised', 'text': 'ZeroDivisionError'}]
    """
    return [_case(arguments, value) for arguments, value in zip(ask.cases, values, strict=True)]


def _case(arguments: Sequence[Any], value: Any) -> dict[str, Any]:
    case: dict[str, Any] = {"arguments": [_kept(argument) for argument in arguments]}
    if isinstance(value, NoValue):
        return case | {"nothing": value.reason, "text": value.text}
    return case | {"value": _kept(value)}


def _kept(value: Any) -> Any:
    try:
        plain = to_json(value)
    except NotPlain as refusal:
        return f"({refusal.text})"
    size = len(json.dumps(plain))
    return plain if size <= LONGEST else f"({size} characters)"
