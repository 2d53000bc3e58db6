"""Properties of handles: checked first, then stored, then told to everybody who watches."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from typing import Any, Generic, Protocol, TypeVar, overload

import numpy as np

from dhlab.arrays import as_color, as_number
from dhlab.errors import InputError
from dhlab.scene.node import Color

T = TypeVar("T")


class Settable(Protocol):
    """What has settings: anything with a `set` that takes them by name."""

    def set(self, **values: Any) -> Any:
        """Set several properties at once."""


class Setting(Generic[T]):
    """One property of a handle, ``handle.color = ...`` or ``handle.set(color=...)``.

    Parameters
    ----------
    check : callable
        ``check(value, what, current)`` gives the value to store or raises; `what` names the
        property and its handle in the message.
    doc : str
        The property's docstring.
    read : callable, optional
        ``read(handle)`` gives the value where it is not simply what was stored.
    """

    def __init__(
        self,
        check: Callable[[Any, str, Any], Any],
        doc: str,
        *,
        read: Callable[[Any], T] | None = None,
    ) -> None:
        self.check = check
        self.read = read
        self.__doc__ = doc
        self.slot = ""

    def __set_name__(self, owner: type, name: str) -> None:
        self.slot = f"_{name}"

    @overload
    def __get__(self, handle: None, owner: type) -> Setting[T]: ...
    @overload
    def __get__(self, handle: Settable, owner: type) -> T: ...
    def __get__(self, handle: Settable | None, owner: type) -> Setting[T] | T:
        if handle is None:
            return self
        return self.value(handle)

    def value(self, handle: Settable) -> T:
        """Return the present value."""
        stored: T = self.read(handle) if self.read else getattr(handle, self.slot)
        return stored

    def __set__(self, handle: Settable, value: Any) -> None:
        handle.set(**{self.slot[1:]: value})


@cache
def settings_of(cls: type) -> dict[str, Setting[Any]]:
    """Return the settings of a class by name, inherited ones included."""
    return {
        name: value
        for base in reversed(cls.__mro__)
        for name, value in vars(base).items()
        if isinstance(value, Setting)
    }


def check_settings(owner: Settable, name: str, values: Mapping[str, Any]) -> dict[str, Any]:
    """Check values by the settings of `owner` and return what is to be stored.

    Parameters
    ----------
    owner : a handle or component
    name : str
        What the messages call it.
    values : mapping of str to object

    Raises
    ------
    TypeError
        A name that is no setting; the message lists those that are.
    """
    settings = settings_of(type(owner))
    for key in values:
        if key not in settings:
            kind = type(owner).__name__
            raise TypeError(f"no property {key!r} of a {kind}; choose from {choices(settings)}")
    return {
        key: settings[key].check(value, f"{key} of '{name}'", settings[key].value(owner))
        for key, value in values.items()
    }


def choices(names: Mapping[str, Any] | tuple[str, ...]) -> str:
    """Return names as they stand in an error: sorted, with commas between."""
    return ", ".join(sorted(names))


def flag(value: Any, what: str, current: Any) -> bool:
    """Check a yes or no."""
    if not isinstance(value, bool | np.bool_):
        raise InputError(f"{what} must be True or False, got {value!r}")
    return bool(value)


def color(value: Any, what: str, current: Any) -> Color | None:
    """Check a colour; None stands for the default."""
    return None if value is None else as_color(value, what)


def fraction(value: Any, what: str, current: Any) -> float:
    """Check a number from 0 to 1."""
    return as_number(value, what, minimum=0.0, maximum=1.0)


def number(value: Any, what: str, current: Any) -> float:
    """Check a number."""
    return as_number(value, what)


def positive(value: Any, what: str, current: Any) -> float:
    """Check a number above 0."""
    return as_number(value, what, above=0.0)


def positive_or_default(value: Any, what: str, current: Any) -> float | None:
    """Check a number above 0; None stands for the default."""
    return None if value is None else as_number(value, what, above=0.0)


def length_or_default(value: Any, what: str, current: Any) -> float | None:
    """Check a number of 0 or more; None stands for the default."""
    return None if value is None else as_number(value, what, minimum=0.0)


def one_of(*names: str) -> Callable[[Any, str, Any], str]:
    """Return a check for one of several words."""

    def check(value: Any, what: str, current: Any) -> str:
        if value not in names:
            raise InputError(f"{what} must be one of {', '.join(map(repr, names))}, got {value!r}")
        return str(value)

    return check
