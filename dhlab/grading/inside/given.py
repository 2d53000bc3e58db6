"""The functions of dhlab that an exercise gives: modules from the texts that come with a job."""

import sys
from collections.abc import Mapping
from types import ModuleType
from typing import Any


def load(tools: Mapping[str, str], texts: Mapping[str, str]) -> dict[str, Any]:
    """Make the modules, and return the functions.

    Parameters
    ----------
    tools : mapping of str to str
        Name of each function -> that of its module.
    texts : mapping of str to str
        Name of each module -> its text; one that is imported stands before those that import it.
    """
    for name, text in texts.items():
        module = _registered(name)
        exec(compile(text, f"<{name}>", "exec"), module.__dict__)
    return {name: getattr(sys.modules[module], name) for name, module in tools.items()}


def _registered(name: str) -> ModuleType:
    """Return a module that can be imported, and that its package has."""
    if name not in sys.modules:
        sys.modules[name] = ModuleType(name)
        package, _, last = name.rpartition(".")
        if package:
            setattr(_registered(package), last, sys.modules[name])
    return sys.modules[name]
