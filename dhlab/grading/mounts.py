"""What a sandbox shows of this machine: Python, packages, and no more of dhlab than is due."""

import compileall
import os
import re
import site
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

from dhlab.grading.tools import PACKAGE

INSIDE = Path(__file__).resolve().parent / "inside"
MOUNTED = "/grader/dhlab"
"""Where a sandbox has the few files of dhlab that do the work."""

SYSTEM = ("/usr", "/lib", "/lib32", "/lib64", "/libx32", "/bin", "/sbin", "/nix/store")
MORE = ("/etc/ld.so.cache", "/etc/fonts")
HIDDEN = ("grading", "diagnosis", "exercises", "notebooks")
"""Parts of dhlab that are not there where the rest of it is."""


@dataclass(frozen=True)
class Room:
    """What of dhlab is there.

    Attributes
    ----------
    library : bool
        Whether it is all there, but for what judges and what solves.
    """

    library: bool = False


@cache
def compile_once() -> None:
    """Compile what a sandbox shows of dhlab: in there nothing could be kept that is compiled."""
    hidden = re.compile("|".join(re.escape(f"{PACKAGE / part}{os.sep}") for part in HIDDEN))
    compileall.compile_dir(PACKAGE, quiet=2, rx=hidden)
    compileall.compile_dir(INSIDE, quiet=2)


def mounts(room: Room) -> Iterator[str]:
    """Yield bubblewrap's arguments that show files, and hide some of them again.

    Parameters
    ----------
    room : Room
    """
    shown: list[Path] = []
    for source, target in _shown(room):
        path = Path(target)
        if Path(source).is_symlink():
            yield from ("--symlink", os.readlink(source), target)
        elif Path(source).exists() and not any(path.is_relative_to(other) for other in shown):
            for parent in reversed(path.parents[:-1]):  # bubblewrap's own would be root's alone
                yield from ("--dir", str(parent))
            yield from ("--ro-bind", source, target)
            shown.append(path)
    for hidden in _hidden(room):
        if hidden.is_dir() and any(hidden.is_relative_to(path) for path in shown):
            yield from ("--size", "4096", "--tmpfs", str(hidden), "--remount-ro", str(hidden))


def package_folders(room: Room) -> list[str]:
    """Return the folders of packages that this process imports from, and dhlab's if it is there."""
    names = ("site-packages", "dist-packages")
    found = [Path(p).resolve() for p in sys.path if Path(p).name in names and Path(p).is_dir()]
    found.append(Path(np.__file__).resolve().parents[1])
    return [str(p) for p in dict.fromkeys(found + [PACKAGE.parent] * room.library)]


def python() -> str:
    """Return the Python below a virtual environment."""
    base = getattr(sys, "_base_executable", None) or sys.executable
    return str(Path(base).resolve())


def _shown(room: Room) -> Iterator[tuple[str, str]]:
    """Yield what is shown, and where."""
    base = str(Path(sys.base_prefix).resolve())
    for folder in (*SYSTEM, *MORE, base, *package_folders(Room())):
        yield folder, folder
    if room.library:
        yield str(PACKAGE), str(PACKAGE)
    yield str(INSIDE), f"{MOUNTED}/{INSIDE.relative_to(PACKAGE)}"


def _hidden(room: Room) -> list[Path]:
    """Return the folders that hold solutions, or the functions that are asked for."""
    prefixes = [*package_folders(Room()), *site.getsitepackages([sys.base_prefix])]
    copies = {PACKAGE, *(Path(p).resolve() / "dhlab" for p in prefixes)}
    if not room.library:
        return sorted(copies)
    return [*sorted(copies - {PACKAGE}), *(PACKAGE / part for part in HIDDEN)]
