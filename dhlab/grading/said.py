"""What a check cell shows: a sentence in a box, or the same as plain text."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape

MARKS = {True: "\N{CHECK MARK}", False: "\N{BALLOT X}", None: "\N{MEDIUM SMALL WHITE CIRCLE}"}
COLORS = {True: "#1a7f37", False: "#b35900", None: "#57606a"}
BOX = (
    "border-left:4px solid {color};padding:.3em .8em;margin:.2em 0;max-width:46em;line-height:1.45"
)


@dataclass(frozen=True)
class Said:
    """A sentence for the student; a cell that ends in it shows it.

    Attributes
    ----------
    right : bool or None
        None where there is nothing to be right or wrong.
    head : str
        In a few words.
    text : str
        Sentences; what stands between backticks is code.
    tried : tuple of (str, bool)
        Each example as a call, and whether it is right.
    note : str
        What else is to be said.

    Examples
    --------
    >>> Said(False, "rot_z: not right yet", "Which way round?", (("rot_z(0)", True),))
    ✗ rot_z: not right yet
    Which way round?
      ✓ rot_z(0)
    """

    right: bool | None
    head: str
    text: str = ""
    tried: Sequence[tuple[str, bool]] = ()
    note: str = ""

    def __repr__(self) -> str:
        lines = [f"{MARKS[self.right]} {self.head}", self.text]
        lines += [f"  {MARKS[right]} {call}" for call, right in self.tried]
        return "\n".join(line for line in [*lines, self.note] if line)

    def _repr_html_(self) -> str:
        color = COLORS[self.right]
        head = f'<b style="color:{color}">{MARKS[self.right]}</b> <b>{_html(self.head)}</b>'
        calls = "<br>".join(
            f'<span style="color:{COLORS[right]}">{MARKS[right]}</span> <code>{escape(call)}</code>'
            for call, right in self.tried
        )
        parts = [head, _html(self.text), calls, _html(self.note)]
        inner = "".join(f'<div style="margin:.25em 0">{part}</div>' for part in parts if part)
        return f'<div role="status" style="{BOX.format(color=color)}">{inner}</div>'


def _html(text: str) -> str:
    """Text with its code marked; nothing in it is read as a tag."""
    return re.sub(r"`([^`]+)`", r"<code>\1</code>", escape(text))
