"""The `dhlab` of the sandbox: what draws does nothing, what computes is not there.

A question about plain values is to be answered with numpy. The cells around it show pictures and
checks, so every name of dhlab can be imported and called; it gives `Nothing`.
"""

import copy
import sys
from collections.abc import Callable, Iterator, Mapping, MutableMapping, Sequence
from importlib.machinery import ModuleSpec
from math import pi
from types import ModuleType
from typing import Any, NamedTuple, NoReturn

from dhlab.grading.inside.answers import reply
from dhlab.grading.inside.notes import USES
from dhlab.grading.inside.plain import Missing

OPERATORS = ("add", "floordiv", "matmul", "mod", "mul", "pow", "sub", "truediv")
AS_NUMBER = (
    *(f"__{side}{name}__" for name in OPERATORS for side in ("", "r")),
    *("__abs__", "__array__", "__complex__", "__float__", "__index__", "__int__", "__neg__"),
)

deg = pi / 180


class DHRow(NamedTuple):
    """A row of a Denavit-Hartenberg table, as in dhlab."""

    alpha: float
    a: float
    d: float
    theta: float


class Nothing:
    """What any name of dhlab gives here: it takes every call and every assignment.

    Parameters
    ----------
    name : str
        How it came about, "View.add".
    said : callable
        Told of the first use as a number.
    """

    __array_ufunc__ = None  # numpy leaves operators to this class

    def __init__(self, name: str, said: Callable[[str], None]) -> None:
        self.__dict__.update(_name=name, _said=said)

    _name: str
    _said: Callable[[str], None]

    def __getattr__(self, name: str) -> Any:
        if name.startswith(("__", "_repr")):
            raise AttributeError(name)
        return Nothing(f"{self._name}.{name}", self._said)

    def __setattr__(self, name: str, value: Any) -> None:
        pass

    def __call__(self, *_: Any, **__: Any) -> "Nothing":
        """Take any call."""
        return self

    def __getitem__(self, _: Any) -> "Nothing":
        return self

    def __setitem__(self, _: Any, __: Any) -> None:
        pass

    def __iter__(self) -> Iterator[Any]:
        return iter(())

    def __len__(self) -> int:
        return 0

    def __enter__(self) -> "Nothing":
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def __repr__(self) -> str:
        return self._name

    def _refuse(self, *_: Any, **__: Any) -> NoReturn:
        self._said(USES.format(self._name))
        raise Missing(f"{self._name} of dhlab is not there when this is marked: write it yourself")


for _method in AS_NUMBER:
    setattr(Nothing, _method, Nothing._refuse)


class Checks:
    """The check of a notebook: it gives the student's numbers, notes answers and says nothing.

    Parameters
    ----------
    stage : Stage
    named : callable
        Told the name that the notebook gives.
    """

    def __init__(self, stage: "Stage", named: Callable[[str], None]) -> None:
        self._stage = stage
        self._named = named

    def numbers(self, student: Any = "") -> dict[str, Any]:
        """Return the numbers of the student who is marked, whoever is named."""
        self._named(str(student))
        return copy.deepcopy(dict(self._stage.given))

    def picture(self, *_: Any) -> tuple[Any, ...]:
        """Draw nothing."""
        return ()

    def show(self, *_: Any) -> None:
        """Draw nothing."""

    def __call__(self, name: Any = None, answer: Any = ..., *_: Any, **__: Any) -> None:
        """Note the answer as it is now, if it is one of those that are plain data."""
        if isinstance(name, str) and name in self._stage.plain:
            self._stage.seen.pop(name, None)
            if answer is not ...:
                self._stage.seen[name] = reply({name: answer}, name, self._stage.plain[name], ())


class Library:
    """Finds `dhlab` and everything in it, and makes modules whose names give `Nothing`.

    Parameters
    ----------
    root : str
        What is replaced: "dhlab", or one part of it.
    real : mapping
        The names that are there after all.
    said : callable
        Told what is used as a number.
    """

    def __init__(self, root: str, real: Mapping[str, Any], said: Callable[[str], None]) -> None:
        self.root = root
        self.real = real
        self.said = said

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> ModuleSpec | None:
        """Claim the modules below the root."""
        if name != self.root and not name.startswith(f"{self.root}."):
            return None
        return ModuleSpec(name, self, is_package=True)  # type: ignore[arg-type]

    def create_module(self, spec: ModuleSpec) -> ModuleType:
        """Make a module that has every name."""
        module = ModuleType(spec.name, "Stands for dhlab where answers are marked.")
        module.__dict__.update(self.real, __all__=list(self.real))
        module.__dict__["__getattr__"] = self._anything
        return module

    def exec_module(self, module: ModuleType) -> None:
        """Do nothing more: the module is made."""

    def _anything(self, name: str) -> Nothing:
        if name.startswith("__"):
            raise AttributeError(name)
        return Nothing(name, self.said)


class Stage(NamedTuple):
    """What the cells find.

    Attributes
    ----------
    given : mapping
        The numbers of the student who is marked.
    parts : sequence of str
        "dhlab", or the parts of it that are replaced where the rest is real.
    tools : mapping
        What is real all the same.
    plain : mapping of str to str
        The kinds of the answers that are plain data and no functions, by name.
    seen : mapping of str to dict
        Filled with the reply of each of these that a check saw, as it was when it saw it last.
    """

    given: Mapping[str, Any]
    parts: Sequence[str]
    tools: Mapping[str, Any]
    plain: Mapping[str, str]
    seen: MutableMapping[str, dict[str, Any]]


def install(stage: Stage, said: Callable[[str], None], named: Callable[[str], None]) -> None:
    """Replace dhlab, or parts of it, for all cells that follow.

    Parameters
    ----------
    stage : Stage
    said, named : callable
        Told what is noted, and the name that the notebook gives.
    """

    def checks(*_: Any, **__: Any) -> Checks:
        return Checks(stage, named)

    real: dict[str, Any] = {"checks": checks}
    if "dhlab" in stage.parts:
        real |= {"deg": deg, "dh": DHRow, "DHRow": DHRow, **stage.tools}
    finders: list[Any] = [Library(part, real, said) for part in stage.parts]
    sys.meta_path[:0] = finders
