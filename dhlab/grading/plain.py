"""Texts that others wrote, made harmless: for a line, a file's name, a spreadsheet, Markdown."""

import hashlib
import re
import unicodedata

LONGEST_NAME = 120
"""Bytes of a file's name, so that endings fit on any file system."""
RESERVED = re.compile(r"(con|prn|aux|nul|com\d|lpt\d)(\..*)?", re.IGNORECASE)
FORMULA = "=+-@\t\r\n＝＋－＠"
HIDDEN = {"Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp"}
"""Kinds of characters that are not seen, or that turn what stands around them."""


def one_line(text: str, longest: int = 2000) -> str:
    r"""Return a text as one line, without characters that cannot be seen.

    Examples
    --------
    >>> one_line("a\nb\u202ec \x1b[31m")
    'a b\ufffdc \ufffd[31m'
    """
    words = " ".join(text.split())
    seen = "".join("\ufffd" if unicodedata.category(c) in HIDDEN else c for c in words)
    return seen if len(seen) <= longest else f"{seen[: longest - 3]}..."


def file_name(student: str) -> str:
    """Return a name for a student's file: readable, safe on any system, another for each student.

    Where a name must be changed, a few digits of its SHA-256 keep it different from all others.

    Examples
    --------
    >>> file_name("Ada Lovelace")
    'Ada Lovelace'
    >>> file_name("../ada")
    '_ada-60088279'
    """
    kept = "".join(c if c.isalnum() or c in " _-.@+'()," else "_" for c in student)
    kept = kept.strip(" ._").lstrip(" ._-") or "_"
    safe = kept.encode("utf-8", "replace")[:LONGEST_NAME].decode("utf-8", "ignore").rstrip(" .")
    if safe == student and not RESERVED.fullmatch(safe):
        return safe
    digest = hashlib.sha256(student.encode("utf-8", "surrogatepass")).hexdigest()
    return f"_{safe}-{digest[:8]}"


def spreadsheet(text: str) -> str:
    """Return a text that no spreadsheet takes for a formula.

    Examples
    --------
    >>> spreadsheet("=1+1"), spreadsheet("ada")
    ("'=1+1", 'ada')
    """
    line = one_line(text)
    return f"'{line}" if line.startswith(tuple(FORMULA)) else line


def markdown(text: str) -> str:
    r"""Return a text that Markdown shows as it stands: no markup, no link, no HTML.

    Examples
    --------
    >>> print(markdown("<b>*dh_link*</b>"))
    &lt;b&gt;\*dh\_link\*&lt;/b&gt;
    """
    line = one_line(text).replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    line = re.sub(r"([\\`*_\[\]#|~$!{}])", r"\\\1", line)
    line = re.sub(r"^([-+=]|\d+(?=[.)]))", r"\\\1" if not line[:1].isdigit() else r"\1\\", line)
    return re.sub(r"(?i)(?<=http)(s?):|(?<=www)\.|@", _unlinked, line)


def _unlinked(found: re.Match[str]) -> str:
    """Write the character by which a link is known in another way."""
    text = found.group()
    return f"{text[:-1]}&#{ord(text[-1])};"
