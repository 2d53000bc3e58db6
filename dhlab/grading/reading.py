"""From the bytes of a notebook to the text of its code cells; nothing in them is run.

What counts is the structure, not the version number that a file claims: cells lie in `cells`, or
in `worksheets` as in version 3. Outputs, metadata and markdown are not looked at.
"""

import json
import re
from dataclasses import dataclass
from typing import Any

from dhlab.errors import InputError

MOST_CODE = 2_000_000
"""More characters of code are no answer to an exercise."""
MOST_PARTS = 2_000_000
"""More lists and mappings are a trap for the reader's memory."""
KINDS = {
    b"\x89PNG": "a PNG picture",
    b"\xff\xd8\xff": "a JPEG picture",
    b"%PDF": "a PDF document",
    b"PK\x03\x04": "a zip archive",
    b"\x1f\x8b": "a packed file",
    b"Rar!": "an archive",
    b"7z\xbc\xaf": "an archive",
    b"\xd0\xcf\x11\xe0": "an Office document",
    b"\x7fELF": "a program",
    b"MZ": "a program",
}
ENCODINGS = {b"\xef\xbb\xbf": "utf-8-sig", b"\xff\xfe": "utf-16", b"\xfe\xff": "utf-16"}
CONFLICT = re.compile(r"^(<<<<<<< |=======$|>>>>>>> )", re.MULTILINE)


@dataclass(frozen=True)
class Notebook:
    """What marking needs of a notebook.

    Attributes
    ----------
    cells : tuple of str
        The code cells, in order.
    notes : tuple of str
        What is odd about it, in sentences for the instructor.
    """

    cells: tuple[str, ...]
    notes: tuple[str, ...] = ()


def read_notebook(content: bytes) -> Notebook:
    r"""Read the code cells of a notebook.

    Parameters
    ----------
    content : bytes

    Returns
    -------
    notebook : Notebook

    Raises
    ------
    InputError
        It is none, or damaged; the message completes "ada.ipynb ...".

    Examples
    --------
    >>> read_notebook(b'{"cells": [{"cell_type": "code", "source": ["a = 1\\n", "b = 2"]}]}')
    Notebook(cells=('a = 1\nb = 2',), notes=())
    >>> read_notebook(b"")
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: is empty
    """
    if not content.strip():
        raise InputError("is empty")
    kind = next((kind for start, kind in KINDS.items() if content.startswith(start)), None)
    if kind is not None:
        raise InputError(f"is {kind}, not a notebook")
    text, notes = decoded(content)
    document = _parsed(text)
    notes += _kernel_notes(document)
    cells = [_source(cell) for cell in _cells(document) if cell.get("cell_type") == "code"]
    code = tuple(_printable(cell) for cell in cells if cell is not None)
    if None in cells:
        notes.append("A code cell without a text was passed over.")
    if sum(len(cell) for cell in code) > MOST_CODE:
        raise InputError(f"holds more than {MOST_CODE // 1_000_000} MB of code")
    if not code:
        notes.append("The notebook holds no code cell.")
    return Notebook(code, tuple(notes))


def decoded(content: bytes) -> tuple[str, list[str]]:
    r"""Read text by the mark that it begins with, or as UTF-8, or else as Latin-1, with a note.

    Examples
    --------
    >>> decoded("Gödel".encode("utf-16"))[0], decoded(b"G\xf6del")
    ('Gödel', ('Gödel', ['The file is not UTF-8; it was read as Latin-1.']))
    """
    encoding = next((e for mark, e in ENCODINGS.items() if content.startswith(mark)), "utf-8")
    try:
        return content.decode(encoding), []
    except UnicodeDecodeError:
        return content.decode("latin-1"), ["The file is not UTF-8; it was read as Latin-1."]


def _parsed(text: str) -> dict[str, Any]:
    if text.count("[") + text.count("{") > MOST_PARTS:
        raise InputError(f"holds more than {MOST_PARTS // 1_000_000} million lists and mappings")
    try:
        document = json.loads(text)
    except json.JSONDecodeError as error:
        raise InputError(_broken(text, error)) from error
    except (RecursionError, ValueError) as error:
        raise InputError("is nested too deeply, or holds a number too long, to be read") from error
    if not isinstance(document, dict):
        raise InputError("is not a notebook: it has no cells")
    return document


def _broken(text: str, error: json.JSONDecodeError) -> str:
    """Say why a text is no JSON: a merge left unfinished, cut off, or something else."""
    mark = CONFLICT.search(text)
    if mark is not None:
        line = text.count("\n", 0, mark.start()) + 1
        return f"has the marks of an unfinished merge ({mark.group().strip()!r} in line {line})"
    if not text.lstrip().startswith("{"):
        page = re.match(r"\s*<(!doctype|html)", text, re.IGNORECASE)
        return f"is {'a web page' if page else 'some other text'}, not a notebook"
    if not text[error.pos :].strip() or error.msg.startswith("Unterminated string"):
        return f"is cut off: it ends within line {text.count(chr(10)) + 1}"
    return f"is damaged in line {error.lineno} ({error.msg})"


def _cells(document: dict[str, Any]) -> list[dict[str, Any]]:
    cells = document.get("cells")
    if not isinstance(cells, list):
        sheets = document.get("worksheets")
        if not isinstance(sheets, list):
            raise InputError("is not a notebook: it has no cells")
        found = [sheet.get("cells") for sheet in sheets if isinstance(sheet, dict)]
        cells = [cell for some in found if isinstance(some, list) for cell in some]
    return [cell for cell in cells if isinstance(cell, dict)]


def _source(cell: dict[str, Any]) -> str | None:
    source = cell.get("source", cell.get("input"))
    if isinstance(source, list) and all(isinstance(line, str) for line in source):
        return "".join(source)
    return source if isinstance(source, str) else None


def _printable(text: str) -> str:
    """Replace halves of characters, which JSON can hold and no file can."""
    return text.encode("utf-8", "replace").decode("utf-8")


def _kernel_notes(document: dict[str, Any]) -> list[str]:
    metadata = document.get("metadata")
    spec = metadata.get("kernelspec") if isinstance(metadata, dict) else None
    if not isinstance(spec, dict):
        return []
    language, name = spec.get("language"), spec.get("name")
    if isinstance(language, str) and language.lower() not in ("python", ""):
        return [f"The notebook was written for another kernel ({language[:40]!r})."]
    if isinstance(name, str) and not isinstance(language, str) and "python" not in name.lower():
        return [f"The notebook was written for the kernel {name[:40]!r}."]
    return []
