"""What answers may use of dhlab: functions that their exercise gives, and the files they need."""

import ast
from collections.abc import Iterable
from functools import cache
from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[1]
COMPUTING = "dhlab.kinematics."


def tool_modules(names: Iterable[str]) -> dict[str, str]:
    """Modules of those names of dhlab that compute; others draw, and need not be there.

    Examples
    --------
    >>> tool_modules(["rotz", "View"])
    {'rotz': 'dhlab.kinematics.transforms'}
    """
    imports = _imports(Path("__init__.py"))
    public = {name: module for module, names in imports for name in names}
    found = {name: public.get(name, "") for name in names}
    return {name: module for name, module in found.items() if module.startswith(COMPUTING)}


def files_of(modules: Iterable[str]) -> list[Path]:
    """Files of some modules of dhlab and of all that these import, in the package's folder.

    Examples
    --------
    >>> [path.as_posix() for path in files_of(["dhlab.kinematics.transforms"])]
    ['arrays.py', 'errors.py', 'kinematics/__init__.py', 'kinematics/transforms.py']
    """
    found: set[Path] = set()
    ahead = [_file_of(module) for module in modules]
    while ahead:
        path = ahead.pop()
        if path in found or not (PACKAGE / path).is_file():
            continue
        found.add(path)
        ahead += [parent / "__init__.py" for parent in path.parents[:-1]]
        ahead += [_file_of(m) for m, _ in _imports(path) if m.startswith("dhlab.")]
    return sorted(found)


def _file_of(module: str) -> Path:
    path = Path(*module.split(".")[1:])
    return path / "__init__.py" if (PACKAGE / path).is_dir() else path.with_suffix(".py")


@cache
def _imports(path: Path) -> tuple[tuple[str, tuple[str, ...]], ...]:
    """Read what a file of the package imports from where; it stays as it is while this runs."""
    tree = ast.parse((PACKAGE / path).read_text("utf-8"))
    nodes = [node for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)]
    return tuple((n.module or "", tuple(alias.name for alias in n.names)) for n in nodes)
