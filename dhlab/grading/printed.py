"""What a student's function prints while it is tried: below a line that says of which call."""

import sys
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stdout
from io import TextIOBase
from typing import TextIO


class Labelled(TextIOBase):
    """Writes on to another stream, and a label before the first text.

    Parameters
    ----------
    stream : text file
    label : str
    """

    def __init__(self, stream: TextIO, label: str) -> None:
        self._stream = stream
        self._label = label
        self._last = ""

    def writable(self) -> bool:
        """Whether it can be written to."""
        return True

    def write(self, text: str) -> int:
        """Write a text."""
        if text:
            self._stream.write(text if self._last else f"{self._label}\n{text}")
            self._last = text[-1]
        return len(text)

    def flush(self) -> None:
        """Let the other stream show what it has."""
        self._stream.flush()

    def end(self) -> None:
        """End the line that was begun, if one was."""
        if self._last not in ("", "\n"):
            self._stream.write("\n")


@contextmanager
def labelled(label: str) -> Iterator[None]:
    """Put a label before what is printed meanwhile, if anything is.

    Parameters
    ----------
    label : str

    Examples
    --------
    >>> with labelled("half(3) prints"):
    ...     print("here")
    half(3) prints
    here
    """
    out = Labelled(sys.stdout, label)
    try:
        with redirect_stdout(out):
            yield
    finally:
        out.end()
