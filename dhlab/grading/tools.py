"""What answers may use of dhlab: functions that their exercise gives, and what these need.

In a module stand functions that another exercise asks for. So what goes into the sandbox is not the
module but a text of it with no more than the functions given, and all that they use.
"""

import ast
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from graphlib import TopologicalSorter
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
    public = {name: module for module, names in _imports("dhlab") for name in names}
    found = {name: public.get(name, "") for name in names}
    return {name: module for name, module in found.items() if module.startswith(COMPUTING)}


def tool_texts(tools: Mapping[str, str]) -> dict[str, str]:
    """Texts of the modules that some tools need, each after those that it imports from.

    Parameters
    ----------
    tools : mapping of str to str
        From `tool_modules`.

    Examples
    --------
    >>> texts = tool_texts(tool_modules(["deg"]))
    >>> print(texts["dhlab.kinematics.dh"])
    from math import pi
    deg = pi / 180
    """
    return dict(_texts(tuple(sorted(tools.items()))))


@cache
def _texts(tools: tuple[tuple[str, str], ...]) -> tuple[tuple[str, str], ...]:
    wanted: dict[str, set[str]] = {}
    ahead = [(module, name) for name, module in tools]
    while ahead:
        module, name = ahead.pop()
        if name not in wanted.setdefault(module, set()):
            wanted[module].add(name)
            ahead += _needed_elsewhere(_kept(module, frozenset(wanted[module])))
    kept = {module: _kept(module, frozenset(names)) for module, names in wanted.items()}
    before = {module: {m for m, _ in _needed_elsewhere(kept[module])} for module in kept}
    order = TopologicalSorter(before).static_order()
    return tuple((m, "\n".join(map(ast.unparse, kept[m]))) for m in order)


def _needed_elsewhere(nodes: Iterable[ast.stmt]) -> Iterator[tuple[str, str]]:
    """Yield what statements import from other modules of dhlab; of a whole module all names."""
    for node in nodes:
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("dhlab."):
            for alias in node.names:
                inner = f"{node.module}.{alias.name}"
                if _file(inner).is_file():
                    yield from ((inner, name) for name in _defined(inner))
                else:
                    yield node.module or "", alias.name


@cache
def _kept(module: str, names: frozenset[str]) -> tuple[ast.stmt, ...]:
    """Return the statements of a module by which some names are there, in order."""
    defined = _defined(module)
    found: set[str] = set()
    ahead = list(names)
    while ahead:
        name = ahead.pop()
        if name in defined and name not in found:
            found.add(name)
            ahead += [n.id for n in ast.walk(defined[name]) if isinstance(n, ast.Name)]
    kept = {id(defined[name]): defined[name] for name in defined if name in found}
    return tuple(kept.values())


@cache
def _defined(module: str) -> dict[str, ast.stmt]:
    """Read what the statements of a module define; an import is one statement for each name."""
    found: dict[str, ast.stmt] = {}
    for node in ast.parse(_file(module).read_text("utf-8")).body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            found[node.name] = node
        elif isinstance(node, ast.Assign | ast.AnnAssign):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            found |= {n.id: node for t in targets for n in ast.walk(t) if isinstance(n, ast.Name)}
        elif isinstance(node, ast.Import):
            found |= {a.asname or a.name.split(".")[0]: ast.Import([a]) for a in node.names}
        elif isinstance(node, ast.ImportFrom):
            alone = {a.asname or a.name: ast.ImportFrom(node.module, [a], 0) for a in node.names}
            found |= alone
    return found


def _file(module: str) -> Path:
    path = PACKAGE.joinpath(*module.split(".")[1:])
    return path / "__init__.py" if path.is_dir() else path.with_suffix(".py")


@cache
def _imports(module: str) -> tuple[tuple[str, tuple[str, ...]], ...]:
    """Read what a module of the package imports from where; it stays as it is while this runs."""
    tree = ast.parse(_file(module).read_text("utf-8"))
    nodes = [node for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)]
    return tuple((n.module or "", tuple(alias.name for alias in n.names)) for n in nodes)
