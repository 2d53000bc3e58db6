"""The files that were handed in, in a folder or a zip archive, listed and read without harm.

Nothing is unpacked to disk, no symbolic link is followed, and no more than `MOST_BYTES` of a file
are read, whatever an archive says of its size.
"""

import os
import re
import stat
import zipfile
import zlib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

from dhlab.errors import DhlabError, InputError

MOST_BYTES = 32_000_000
"""The largest notebook that is read, pictures included."""
MOST_FILES = 100_000
"""More files than these are no class."""
MOST_UNPACKED = 8_000_000_000
"""What all files of an archive may say to hold together [bytes]."""
MOST_TIMES = 1100
"""No file can be packed smaller than this many times, so a bomb says so of itself."""
DEEPEST = 12
PACKINGS = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)


@dataclass(frozen=True)
class Entry:
    """One file or folder that was handed in.

    Attributes
    ----------
    parts : tuple of str
        Its path below the folder or archive.
    is_folder : bool
    problem : str
        Why it cannot be read, in a few words; empty where it can.
    """

    parts: tuple[str, ...]
    is_folder: bool = False
    problem: str = ""
    content: Callable[[], bytes] | None = field(default=None, repr=False, compare=False)

    @property
    def path(self) -> str:
        """Its path as it is shown."""
        return "/".join(self.parts)

    @property
    def is_hidden(self) -> bool:
        """Whether it is of the kind that programs leave behind: checkpoints, folder settings."""
        return any(part.startswith(".") or part == "__MACOSX" for part in self.parts)

    def read(self) -> bytes:
        """Return its content.

        Raises
        ------
        InputError
            It cannot be read; the message completes "ada.ipynb ...".
        """
        if self.problem or self.content is None:
            raise InputError(self.problem or "is a folder")
        return self.content()


@contextmanager
def handed_in(source: Path, skip: Path | None = None) -> Iterator[list[Entry]]:
    """List what lies in a folder or a zip archive; a notebook alone is a class of one.

    Parameters
    ----------
    source : Path
    skip : Path, optional
        A folder that is not looked into: that of the results.

    Yields
    ------
    entries : list of Entry
        They can be read as long as the context lasts.

    Raises
    ------
    DhlabError
        There is nothing at `source`, it is no archive, or it holds too many files.
    """
    if source.is_dir():
        yield sorted(_in_folder(source.resolve(), skip), key=lambda entry: entry.parts)
    elif not source.exists():
        raise DhlabError(f"there is no folder or archive {str(source)!r}")
    elif source.suffix.lower() == ".zip" or zipfile.is_zipfile(source):
        with _opened(source) as archive:
            yield sorted(_in_archive(archive, source), key=lambda entry: entry.parts)
    elif source.suffix == ".ipynb":
        path = source.resolve()
        yield [Entry((shown(path.name),), content=lambda: _read_file(path))]
    else:
        raise DhlabError(f"{str(source)!r} is no folder, no zip archive and no notebook")


def shown(name: str) -> str:
    r"""Return a name that can be written in UTF-8, whatever bytes the file system has in it.

    Examples
    --------
    >>> shown("zo\udceb.ipynb")
    'zo\\xeb.ipynb'
    """
    return name.encode("utf-8", "surrogateescape").decode("utf-8", "backslashreplace")


# ---- a folder ----


def _in_folder(root: Path, skip: Path | None) -> Iterator[Entry]:
    left: list[tuple[Path, tuple[str, ...]]] = [(root, ())]
    count = 0
    while left:
        folder, parts = left.pop()
        try:
            with os.scandir(folder) as there:
                inside = list(there)
        except OSError as error:
            if not parts:
                raise
            yield Entry(parts, problem=f"cannot be opened ({error.strerror})")
            continue
        count += len(inside)
        if count > MOST_FILES:
            raise DhlabError(f"{str(root)!r} holds more than {MOST_FILES} files; is it the class?")
        for item in inside:
            entry, path = _entry(item, (*parts, shown(item.name))), folder / item.name
            if entry.is_hidden or (skip is not None and path == skip.resolve()):
                continue
            if entry.is_folder:
                left.append((path, entry.parts))
            yield entry


def _entry(item: os.DirEntry[str], parts: tuple[str, ...]) -> Entry:
    if item.is_symlink():
        return Entry(parts, problem="is a symbolic link, which is not followed")
    if item.is_dir(follow_symlinks=False):
        deep = len(parts) > DEEPEST
        return Entry(parts, not deep, "lies too deep in folders" if deep else "")
    path = Path(item.path)
    return Entry(parts, content=lambda: _read_file(path))


def _read_file(path: Path) -> bytes:
    """Read a regular file; what was put in its place meanwhile is not followed."""
    flags = os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)
    try:
        with open(os.open(path, flags | getattr(os, "O_BINARY", 0)), "rb") as file:
            if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
                raise InputError("is not a file but a pipe or a device")
            return _bounded(file.read(MOST_BYTES + 1))
    except OSError as error:
        raise InputError(f"cannot be opened ({error.strerror})") from error


def _bounded(content: bytes) -> bytes:
    if len(content) > MOST_BYTES:
        raise InputError(f"is larger than {MOST_BYTES // 1_000_000} MB")
    return content


# ---- an archive ----


def _opened(source: Path) -> zipfile.ZipFile:
    try:
        archive = zipfile.ZipFile(source)
    except (zipfile.BadZipFile, ValueError, NotImplementedError) as error:
        raise DhlabError(f"the archive {str(source)!r} is damaged or cut off ({error})") from error
    said = sum(info.file_size for info in archive.infolist())
    if len(archive.infolist()) > MOST_FILES or said > MOST_UNPACKED:
        archive.close()
        raise DhlabError(
            f"the archive {str(source)!r} holds {len(archive.infolist())} files of together "
            f"{said / 1e9:.1f} GB: it looks like a zip bomb and is not read"
        )
    return archive


def _in_archive(archive: zipfile.ZipFile, source: Path) -> Iterator[Entry]:
    found = [_packed(archive, info) for info in archive.infolist()]
    wrapper = {entry.parts[:1] for entry in found if entry.parts}
    cut = wrapper == {(source.stem,)} and all(len(e.parts) > 1 or e.is_folder for e in found)
    for entry in found:
        parts = entry.parts[1:] if cut else entry.parts
        if parts and not entry.is_hidden:
            yield Entry(parts, entry.is_folder, entry.problem, entry.content)


def _packed(archive: zipfile.ZipFile, info: zipfile.ZipInfo) -> Entry:
    name = info.filename.replace("\\", "/")
    parts = tuple(shown(part) for part in name.split("/") if part not in ("", ".", ".."))
    problem = _problem(info, name)
    if info.is_dir() and not problem:
        return Entry(parts, is_folder=True)
    return Entry(parts, problem=problem, content=lambda: _unpack(archive, info))


def _problem(info: zipfile.ZipInfo, name: str) -> str:
    if name.startswith("/") or re.match(r"[A-Za-z]:", name) or ".." in name.split("/"):
        return "has a path that climbs out of the archive"
    if stat.S_ISLNK(info.external_attr >> 16):
        return "is a symbolic link, which is not followed"
    if info.flag_bits & 1:
        return "is encrypted"
    if info.compress_type not in PACKINGS:
        return "is packed in a way that is not read; pack it as an ordinary zip"
    if info.file_size > max(info.compress_size, 1) * MOST_TIMES:
        return "is a zip bomb: it says to be larger than it can be"
    if info.file_size > MOST_BYTES:
        return f"is larger than {MOST_BYTES // 1_000_000} MB"
    return ""


def _unpack(archive: zipfile.ZipFile, info: zipfile.ZipInfo) -> bytes:
    try:
        with archive.open(info) as file:
            return _bounded(file.read(MOST_BYTES + 1))
    except (zipfile.BadZipFile, zlib.error, EOFError, OSError, RuntimeError, ValueError) as error:
        raise InputError(f"is damaged in the archive ({error})") from error
