"""A student's own copy of the notebooks: filled, brought up to date, never overwritten."""

import hashlib
import json
import os
import shutil
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from dhlab.errors import DhlabError

RECORD = ".dhlab-copies.json"

OWN = ("cell_type", "source", "outputs", "attachments")
"""What of a notebook's cell its owner changes, by writing and by running."""


@dataclass(frozen=True)
class Refreshed:
    """What `refresh` did with each notebook, by its path in the working copy.

    Attributes
    ----------
    copied : tuple of str
        Were not there.
    updated : tuple of str
        Were as an older dhlab had written them, and are now as this one has them.
    kept : tuple of str
        Were changed by their owner, and dhlab has a newer version: left as they are.
    """

    copied: tuple[str, ...]
    updated: tuple[str, ...]
    kept: tuple[str, ...]


def shipped() -> dict[str, Path]:
    """Give the notebooks that came with dhlab: path in a working copy -> file.

    They lie inside the installed package, or beside it in a clone. Of the exercises only what a
    student works with is given, not the programs that build and check them.

    Raises
    ------
    DhlabError
        If no notebooks came with this dhlab.
    """
    place = home()
    return {
        path.relative_to(place).as_posix(): path
        for folder in (place / "notebooks", place / "exercises")
        for path in sorted(folder.rglob("*"))
        if path.is_file() and _is_for_students(path.relative_to(place))
    }


def home() -> Path:
    """Folder in which `notebooks` and `exercises` lie.

    Raises
    ------
    DhlabError
        If no notebooks came with this dhlab.
    """
    package = Path(__file__).parent
    found = next((p for p in (package, package.parent) if (p / "notebooks").is_dir()), None)
    if found is None:
        raise DhlabError(f"no notebooks lie in {package} nor beside it; install dhlab again")
    return found


def refresh(folder: Path, sources: Mapping[str, Path]) -> Refreshed:
    """Bring a working copy up to date without touching what its owner has changed.

    A file that is missing is copied; one that is still as dhlab last wrote it is replaced by a
    newer version; one that was changed stays. What was written is remembered by digest in a small
    file in `folder`.

    Parameters
    ----------
    folder : Path
        The working copy; made if it does not exist.
    sources : mapping of str to Path
        Path in the working copy -> file to copy from.

    Returns
    -------
    Refreshed
        What was done.

    Raises
    ------
    DhlabError
        If the record of an earlier copy cannot be read.
    """
    record = _read_record(folder / RECORD)
    done: dict[str, list[str]] = {"copied": [], "updated": [], "kept": []}
    for name, source in sources.items():
        target, wanted = folder / name, _digest(source)
        if not target.exists():
            action = "copied"
        elif (present := _digest(target)) == wanted:
            record[name] = wanted
            continue
        elif present == record.get(name):
            action = "updated"
        else:
            if record.get(name) != wanted:
                done["kept"].append(name)
            continue
        _copy(source, target)
        record[name] = wanted
        done[action].append(name)
    _write(folder / RECORD, json.dumps(record, indent=1, sort_keys=True))
    return Refreshed(**{action: tuple(names) for action, names in done.items()})


def _is_for_students(path: Path) -> bool:
    hidden = any(part.startswith((".", "__pycache__")) for part in path.parts)
    return not hidden and not (path.parts[0] == "exercises" and path.suffix == ".py")


def _digest(path: Path) -> str:
    """Digest of what an owner can change; JupyterLab rewrites the rest on opening a notebook."""
    content = path.read_bytes()
    if path.suffix == ".ipynb":
        try:
            cells = json.loads(content)["cells"]
            own = [[_text(cell.get(key)) for key in OWN] for cell in cells]
        except (ValueError, KeyError, TypeError, AttributeError):
            pass
        else:
            content = json.dumps(own, sort_keys=True).encode()
    return hashlib.sha256(content).hexdigest()


def _text(value: Any) -> Any:
    """Join the lines of a text, which a notebook keeps as one string or as many."""
    if isinstance(value, list) and all(isinstance(line, str) for line in value):
        return "".join(value)
    return value


def _read_record(path: Path) -> dict[str, str]:
    if not path.exists():
        return {}
    try:
        record = json.loads(path.read_text("utf-8"))
    except ValueError as error:
        raise DhlabError(f"{path} is damaged ({error}); move it away and start again") from error
    if not isinstance(record, dict):
        raise DhlabError(f"{path} is damaged (not a list of digests); move it away and start again")
    return record


def _copy(source: Path, target: Path) -> None:
    target.parent.mkdir(parents=True, exist_ok=True)
    half = target.with_name(f".{target.name}.part")
    shutil.copyfile(source, half)
    os.replace(half, target)


def _write(target: Path, text: str) -> None:
    target.parent.mkdir(parents=True, exist_ok=True)
    half = target.with_name(f"{target.name}.part")
    half.write_text(text, "utf-8")
    os.replace(half, target)
