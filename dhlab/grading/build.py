"""From an exercise's folder to the notebook for students."""

import os
import re
import shutil
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from dhlab.errors import DhlabError, InputError
from dhlab.grading.check import opened
from dhlab.grading.proof import SOURCE, Source, prove
from dhlab.grading.source import notebook_text


@dataclass(frozen=True)
class Built:
    """What a build found and wrote.

    Attributes
    ----------
    notebook : Path
    changed : bool
        Whether the notebook was written, or was up to date.
    questions, wrong : int
        How many questions and wrong answers were tried.
    """

    notebook: Path
    changed: bool
    questions: int
    wrong: int


def build(folder: Path) -> Built:
    """Prove an exercise and write its notebook, `NN_name.ipynb` in the same folder.

    Parameters
    ----------
    folder : Path

    Returns
    -------
    built : Built

    Raises
    ------
    DhlabError
        The exercise is not fit to be released: the message has a line for each problem, with file
        and line. Then nothing is written.
    """
    source = Source(folder)
    prove(source)
    notebook = notebook_path(folder)
    text = notebook_text(source.released)
    changed = not notebook.exists() or not same(notebook.read_text("utf-8"), text)
    if changed:
        half = notebook.with_name(f".{notebook.name}.part")
        half.write_text(text, "utf-8")
        os.replace(half, notebook)
    return Built(notebook, changed, len(source.names), len(source.wrong))


def exercises_in(folders: Sequence[Path]) -> list[Path]:
    """Folders of exercises: those given, and those inside the others.

    Raises
    ------
    DhlabError
        One is no exercise and holds none.
    """
    found: list[Path] = []
    for folder in folders:
        if (folder / SOURCE).is_file():
            found.append(folder)
            continue
        inside = sorted(path.parent for path in folder.glob(f"*/{SOURCE}"))
        if not inside:
            raise DhlabError(f"no exercise lies in {folder}: there is no {SOURCE}")
        found += inside
    return found


def begin(folder: Path, like: Path) -> Path:
    """Begin a new exercise as a copy of another one.

    Parameters
    ----------
    folder : Path
        Must not exist.
    like : Path
        The exercise to copy.

    Returns
    -------
    folder : Path

    Raises
    ------
    DhlabError
        `folder` exists or cannot be the name of an exercise, or `like` is no exercise.
    """
    if not re.fullmatch(r"[\w-]+", folder.name):
        raise InputError(
            f"{str(folder)!r} cannot be an exercise: its name is that of the notebook, and made of "
            "letters, digits, '_' and '-', such as 12_my_arm"
        )
    texts = [path for path in sorted(like.glob("*.py")) if path.is_file()]
    if SOURCE not in [path.name for path in texts]:
        raise DhlabError(f"{like} is no exercise: there is no {SOURCE} in it")
    if folder.exists():
        raise DhlabError(f"{folder} exists already; name a new folder")
    folder.mkdir(parents=True)
    for path in texts:
        shutil.copyfile(path, folder / path.name)
    return folder


def notebook_path(folder: Path) -> Path:
    """Where the notebook of an exercise lies."""
    return folder / f"{folder.resolve().name}.ipynb"


def same(a: str, b: str) -> bool:
    """Whether two texts of notebooks are the same, however their checks were compressed."""
    return _readable(a) == _readable(b)


def _readable(text: str) -> str:
    return re.sub(r'checks\(\\"([A-Za-z0-9+/=]+)\\"', lambda found: opened(found[1])[1], text)
