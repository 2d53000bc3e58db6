"""What came of a robot: its parts, and on what each hangs."""

from collections.abc import Mapping, Sequence
from typing import Any

from dhlab.diagnosis.paths import Part
from dhlab.diagnosis.reading import read_chain
from dhlab.diagnosis.values import Unreadable, numbers


def parts_told(value: Mapping[str, Any], names: Sequence[str]) -> list[Mapping[str, Any]]:
    """Parts that came, in the order of these names; by their place where names differ.

    Without names one chain is asked for: the robot itself.
    """
    parts = value.get("components")
    if not names:
        if isinstance(parts, list | tuple) and len(parts) > 1:
            raise Unreadable("One chain is asked for; this robot has several.")
        return [value]
    if not isinstance(parts, list | tuple) or not all(isinstance(p, Mapping) for p in parts):
        raise Unreadable(f"A robot of {len(names)} chains is asked for: which ones are joined?")
    if len(parts) != len(names):
        less = "fewer" if len(parts) < len(names) else "more"
        raise Unreadable(f"The robot has {less} chains than the one asked for.")
    by_name = {str(part.get("name")): part for part in parts}
    if set(by_name) == set(names):
        return [by_name[name] for name in names]
    return list(parts)


def read_parts(
    value: Mapping[str, Any],
    values: Sequence[Mapping[str, Any]],
    wanted: Sequence[Part],
    zero_free: bool,
) -> list[Part]:
    """Read what each component is and hangs on.

    Parameters
    ----------
    value : mapping
        The robot, whose components are numbered as they came.
    values : sequence of mapping
        The parts in the order of `wanted`.
    wanted : sequence of Part
    zero_free : bool
        As `read_chain` takes it.

    Raises
    ------
    Unreadable
        With a sentence for the student.
    """
    if len(wanted) == 1:
        chain = read_chain(value, wanted[0].chain, zero_free)
        return [Part(chain, -1, 0, chain.base)]
    order = [next(k for k, v in enumerate(values) if v is c) for c in value["components"]]
    parts = []
    for part, like in zip(values, wanted, strict=True):
        chain = read_chain(part, like.chain, zero_free)
        on, at = part.get("on"), part.get("at")
        if type(on) is not int or not -1 <= on < len(values) or type(at) is not int or at < 0:
            raise Unreadable("The robot does not tell what hangs on what.")
        stand = numbers(part.get("stand"), [(4, 4)], "the base")
        parts.append(Part(chain, order[on] if on >= 0 else -1, at, stand))
    if any(p.on >= 0 and p.at > parts[p.on].chain.n for p in parts):
        raise Unreadable("A part of the robot hangs on a frame that is not there.")
    return parts
