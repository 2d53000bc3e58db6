"""The JavaScript of dhlab: its modules are files, put together here without a build step."""

import re
from functools import cache
from hashlib import blake2b
from importlib.resources import files
from importlib.resources.abc import Traversable
from importlib.util import find_spec
from pathlib import Path

_IMPORT = re.compile(r'^import \{([^}]*)\} from "\./(\w+)\.js";\n', re.MULTILINE)
_EXPORT = re.compile(r"^export (?=(?:async )?(?:function|class|const) (\w+))", re.MULTILINE)


def bundle(entry: str, *folders: Traversable) -> str:
    """Return a module and all that it imports as one module.

    Each module keeps its names to itself. An import reads ``import { a, b } from "./name.js";``,
    an export stands before the ``function``, ``class`` or ``const`` that it names.

    Parameters
    ----------
    entry : str
        Name of the module: its file without ``.js``.
    *folders : Traversable
        Where modules lie besides the views' own folder.

    Returns
    -------
    source : str
        An ES module that imports nothing and exports what the entry does.

    Examples
    --------
    >>> "export class Pool" in bundle("pool")
    True
    """
    places = (files("dhlab.view") / "static", *folders)
    done: dict[str, str] = {}
    source = _source(entry, places)
    for _, name in _IMPORT.findall(source):
        _wrap(name, places, done)
    return "".join(done.values()) + _with_imports(source)


@cache
def viewer() -> str:
    """Return the viewer as a module, without meshcat."""
    return bundle("connection")


@cache
def meshcat() -> str:
    """Return the viewer script of the installed meshcat package, three.js included.

    The package itself, with its server, is not imported.
    """
    found = find_spec("meshcat")
    if found is None or found.origin is None:
        raise ModuleNotFoundError("a view needs the package meshcat: pip install meshcat")
    script = Path(found.origin).parent / "viewer" / "dist" / "main.min.js"
    return script.read_text(encoding="utf-8")


@cache
def digest() -> str:
    """Return the name of the viewer's content: a page loads each version once."""
    return blake2b((viewer() + meshcat()).encode(), digest_size=16).hexdigest()


def _source(name: str, places: tuple[Traversable, ...]) -> str:
    paths = [place / f"{name}.js" for place in places]
    return next(path for path in paths if path.is_file()).read_text(encoding="utf-8")


def _wrap(name: str, places: tuple[Traversable, ...], done: dict[str, str]) -> None:
    """Add a module to `done` as a function of its own, behind those that it imports."""
    if name in done:
        return
    source = _source(name, places)
    for _, imported in _IMPORT.findall(source):
        _wrap(imported, places, done)
    exports = ", ".join(_EXPORT.findall(source))
    body = _with_imports(_EXPORT.sub("", source))
    done[name] = f"const module_{name} = (() => {{\n{body}return {{ {exports} }};\n}})();\n"


def _with_imports(source: str) -> str:
    return _IMPORT.sub(lambda found: f"const {{{found[1]}}} = module_{found[2]};\n", source)
