"""What a student's code was seen to try: files, the network, processes. It costs no points."""

import os
import re
import sys
from collections.abc import Callable, Iterator
from types import FrameType
from typing import Any

from dhlab.grading.inside.answers import CELL

EVENTS = {
    "socket.connect": "tried to reach the network",
    "socket.getaddrinfo": "tried to reach the network",
    "socket.bind": "tried to open a port",
    "subprocess.Popen": "started another program",
    "os.system": "started another program",
    "os.posix_spawn": "started another program",
    "os.exec": "started another program",
    "os.fork": "started another process",
    "os.forkpty": "started another process",
    "os.kill": "sent a signal to a process",
    "os.killpg": "sent a signal to a process",
    "sys._getframe": "looked at the frames of its callers",
    "ctypes.dlopen": "called C code",
    "os.listdir": "looked for files",
    "os.scandir": "looked for files",
    "os.remove": "changed files",
    "os.rename": "changed files",
    "os.symlink": "changed files",
    "os.mkdir": "changed files",
    "shutil.rmtree": "changed files",
    "open": "opened a file",
}


USES = "uses {} of dhlab"
USED = re.compile(USES.format(r"\w{1,40}(\.\w{1,40}){0,4}"))


def is_note(text: str) -> bool:
    """Whether a text is one of the notes; a process that says another is not believed.

    Examples
    --------
    >>> is_note("opened a file"), is_note("uses View.add of dhlab"), is_note("got all points")
    (True, True, False)
    """
    return text in EVENTS.values() or USED.fullmatch(text) is not None


def watch(said: Callable[[str], None]) -> None:
    """Tell from now on what the cells try, each thing once.

    Parameters
    ----------
    said : callable
        Told each thing.
    """
    told: set[str] = set()
    inside: set[str] = set()  # to look at a frame is such an event too

    def hook(event: str, _: tuple[Any, ...]) -> None:
        what = EVENTS.get(event)
        if what is None or what in told or inside:
            return
        inside.add(event)
        if _by_a_cell(sys._getframe(1)):
            told.add(what)
            said(what)
        inside.clear()

    sys.addaudithook(hook)


def _by_a_cell(frame: FrameType | None) -> bool:
    """Whether a cell does it, by itself or through the standard library."""
    library = os.path.dirname(os.__file__)
    for name in _files(frame):
        if name.startswith(CELL):
            return True
        is_import = name.startswith("<frozen importlib")
        if is_import or "site-packages" in name or not name.startswith((library, "<frozen")):
            return False
    return False


def _files(frame: FrameType | None) -> Iterator[str]:
    while frame is not None:
        yield frame.f_code.co_filename
        frame = frame.f_back
