"""Files that are handed in as notebooks and cannot be read, and archives that do harm or try to.

Together with `submission_corpus` they are what marking must bear.
"""

import json
import stat
import struct
import zipfile
from pathlib import Path

from dhlab.grading.reading import MOST_CODE


def notebook(*sources: object, nbformat: object = 4, **metadata: object) -> bytes:
    """Bytes of a notebook with these code cells."""
    cells: list[dict[str, object]] = [{"cell_type": "markdown", "source": "# Title"}]
    cells += [{"cell_type": "code", "source": s, "outputs": [], "metadata": {}} for s in sources]
    return json.dumps({"nbformat": nbformat, "metadata": metadata, "cells": cells}).encode()


GOOD = notebook("a = 1", ["b = 2\n", "c = 3"])
CONFLICT = GOOD.replace(b'"a = 1"', b'\n<<<<<<< HEAD\n"a = 1"\n=======\n"a = 2"\n>>>>>>> mine\n')

UNREADABLE = {
    "empty": (b"", "is empty"),
    "blank": (b" \n\t", "is empty"),
    "picture": (b"\x89PNG\r\n\x1a\n...", "is a PNG picture, not a notebook"),
    "document": (b"%PDF-1.7", "is a PDF document, not a notebook"),
    "archive": (b"PK\x03\x04....", "is a zip archive, not a notebook"),
    "script": (b"import numpy as np\n", "is some other text, not a notebook"),
    "page": (b"\n<!DOCTYPE html><html></html>", "is a web page, not a notebook"),
    "binary": (bytes(range(128, 256)), "is some other text, not a notebook"),
    "cut off in a string": (GOOD[: GOOD.index(b"b = 2")], "is cut off: it ends within line 1"),
    "cut off after a comma": (GOOD[: GOOD.index(b", ") + 2], "is cut off"),
    "cut off at the end": (GOOD[:-1], "is cut off"),
    "conflict": (CONFLICT, r"has the marks of an unfinished merge \('<<<<<<<.*' in line 2\)"),
    "merged whole": (
        b"<<<<<<< HEAD\n" + GOOD + b"\n=======\n>>>>>>> mine\n",
        r"has the marks of an unfinished merge \('<<<<<<<.*' in line 1\)",
    ),
    "comma": (b'{"cells": [],}', r"is damaged in line 1 \("),
    "list": (b"[1, 2]", "not a notebook"),
    "number": (b"17", "not a notebook"),
    "no cells": (b'{"nbformat": 4}', "is not a notebook: it has no cells"),
    "cells of another kind": (b'{"cells": {"a": 1}}', "is not a notebook: it has no cells"),
    "deep": (b'{"cells": ' + b"[" * 100_000, "is nested too deeply"),
    "long number": (b'{"cells": [' + b"9" * 5000 + b"]}", "a number too long"),
    "many": (b'{"cells": [' + b"[]," * 2_000_001 + b"1]}", "more than 2 million lists"),
    "much code": (notebook("x" * (MOST_CODE + 1)), "holds more than 2 MB of code"),
}
"""Kind -> what lies in the file, and what is said of it."""

TRICKS = {
    "climbs": "has a path that climbs out of the archive",
    "linked": "is a symbolic link, which is not followed",
    "locked": "is encrypted",
    "bomb": "is a zip bomb",
    "large": "is larger than 32 MB",
    "odd": "is packed in a way that is not read",
    "damaged": "is damaged in the archive",
}
"""Student -> what is said of their file in the archive that `write_tricks` writes."""


def write_tricks(path: Path, good: bytes) -> None:
    """Write an archive of a good notebook, of a student called good, and of all tricks."""
    link = zipfile.ZipInfo("linked.ipynb")
    link.create_system, link.external_attr = 3, (stat.S_IFLNK | 0o777) << 16
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("good.ipynb", good)
        archive.writestr("../climbs.ipynb", good)
        archive.writestr(link, "/etc/passwd")
        archive.writestr("large.ipynb", bytes(33_000_000))
        archive.writestr("odd.ipynb", good, zipfile.ZIP_LZMA)
        for name in ("locked", "bomb", "damaged"):
            archive.writestr(f"{name}.ipynb", good)
    data = bytearray(path.read_bytes())
    directory = data.index(b"PK\x01\x02")
    told = {name: data.index(f"{name}.ipynb".encode(), directory) - 46 for name in TRICKS}
    data[told["locked"] + 8] |= 1
    struct.pack_into("<I", data, told["bomb"] + 24, 30_000_000)
    start = data.index(b"damaged.ipynb") + len("damaged.ipynb")
    data[start : start + 6] = b"\xff" * 6
    path.write_bytes(data)
