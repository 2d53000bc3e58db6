"""Good, wrong, crashing, cheating and hostile submissions: what marking must bear.

Files that cannot be read, and archives, are in `broken_files`.

They stand in ``data/submissions/*.txt``, one below the other, as code after a line ``# %% name``.
The code takes the place of the first answer of a good submission; it is the second cell of a good
one after a line ``# one more cell``, and all of it, cell by cell, after ``# the whole``. Lines
before the code say what it gets where that is not full marks: ``# dh_link: too slow``,
``# left out: 2``, ``# noted: network``, ``# status: second look``, ``# needs a sandbox``.

Words in capitals between at signs stand for the parts of a good submission, below, and for what
whoever runs them fills in: ``@OUTSIDE@``, a folder that is nobody's business; ``@PORT@``, where
somebody listens on this machine; ``@MARK@``, by which a process that was left behind is known.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

FOLDER = Path(__file__).parent / "data" / "submissions"

CHECKS = """
import numpy as np
from dhlab.diagnosis import LinkTask, MatrixTask, turn
from dhlab.grading import Question

def numbers(rng):
    return {"angle": float(rng.uniform(0.3, 1.2))}

def questions(given):
    examples = [(0.4, 0.5, 0.3, 1.1), (-0.9, 0.2, -0.4, 0.6)]
    about_z = MatrixTask(turn("z", lambda angle: angle), size=3)
    return [
        Question("dh_link", LinkTask(), points=4, examples=examples, inputs=rows),
        Question("rot_z", about_z, points=2, examples=[(0.3,), (-1.3,)], inputs=angles),
        Question("R_x", MatrixTask(turn("x", given["angle"]), size=3), points=1),
    ]

def rows(rng):
    special = [(0.0, 0.0, 0.0, 0.0), (np.pi / 2, -0.3, 0.0, 0.0)]
    return special + [tuple(row) for row in rng.uniform(-1, 1, (3, 4)).tolist()]

def angles(rng):
    return [(0.0,), (np.pi / 2,), *((x,) for x in rng.uniform(-3, 3, 3))]
"""
"""The exercise that all of them answer, as its `checks.py`."""

POINTS = {"dh_link": 4, "rot_z": 2, "R_x": 1}

PARTS = {
    "START": """
import numpy as np
from dhlab import View, csys, deg, rp2t
from dhlab.grading import checks

STUDENT = "Ada"
check = checks("eNqrVkpUslJQykvMTVWqBQAUlQPQ", course="robots")
given = check.numbers(STUDENT)
""",
    "LINK": """
def dh_link(alpha, a, d, theta):
    ca, sa, ct, st = np.cos(alpha), np.sin(alpha), np.cos(theta), np.sin(theta)
    return np.array([[ct, -st, 0, a], [st * ca, ct * ca, -sa, -sa * d],
                     [st * sa, ct * sa, ca, ca * d], [0, 0, 0, 1]])
""",
    "ROT_Z": """
def rot_z(t):
    c, s = np.cos(t), np.sin(t)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
""",
    "R_X": """
cx, sx = np.cos(given["angle"]), np.sin(given["angle"])
R_x = np.array([[1, 0, 0], [0, cx, -sx], [0, sx, cx]])
""",
    "SHOWN": """
View("mine").add(csys(rp2t(rot_z(90 * deg), (0, 0, 0))), csys(dh_link(0, 1, 0, 0)))
""",
    "CHECKED": """
check("dh_link", dh_link)
check("rot_z", rot_z)
check("R_x", R_x)
""",
    "FORGE": """
import os
def forge(data):
    for fd in range(3, 64):
        try:
            os.write(fd, data)
        except OSError:
            pass
""",
}
PARTS["RIGHT"] = PARTS["LINK"].replace("dh_link", "right_link")

GOOD = ("@START@", "@LINK@", "@ROT_Z@", "@R_X@", "@CHECKED@")
TELLS = re.compile(r"# (dh_link|rot_z|R_x|left out|noted|status): (.+)\n|# (needs a sandbox)\n")


@dataclass(frozen=True)
class Submission:
    """One submission and what it deserves.

    Attributes
    ----------
    name : str
    sort : {'good', 'wrong', 'crash', 'cheat', 'hostile'}
    cells : tuple of str
    gets : mapping
        By question: the reason that it is judged with, "right" or why not; "ended or too slow"
        where it depends on the machine.
    left_out : tuple of int
        The cells that must be left out.
    noted : str
        What a note says, where one is due.
    needs_sandbox : bool
        Whether it does harm without one.
    status : str
        What marking says of it as a whole.
    """

    name: str
    sort: str
    cells: tuple[str, ...]
    gets: Mapping[str, str] = field(default_factory=lambda: dict.fromkeys(POINTS, "right"))
    left_out: tuple[int, ...] = ()
    noted: str = ""
    needs_sandbox: bool = False
    status: str = "graded"


def filled(text: str, words: Mapping[str, object]) -> str:
    """Put what words between at signs stand for in their place."""
    return re.sub(r"@([A-Z_]+)@", lambda m: str(words.get(m[1], m[0])).strip("\n"), text)


def read_submission(sort: str, text: str) -> Submission:
    """Read one submission of a file."""
    name, _, code = text.partition("\n")
    told: dict[str, str] = {}
    while match := TELLS.match(code):
        told[match[1] or match[3]] = match[2]
        code = code[match.end() :]
    return Submission(
        name,
        sort,
        tuple(filled(cell, PARTS) for cell in _cells(code)),
        {question: told.get(question, "right") for question in POINTS},
        tuple(int(k) for k in told.get("left out", "").split(",") if k),
        told.get("noted", ""),
        "needs a sandbox" in told,
        told.get("status", "partly graded" if "left out" in told else "graded"),
    )


def _cells(code: str) -> tuple[str, ...]:
    where, _, rest = code.partition("\n")
    if where == "# the whole":
        return tuple(rest.split("\n# ----\n"))
    if where == "# one more cell":
        return (GOOD[0], rest, *GOOD[1:])
    return (GOOD[0], code, *GOOD[2:])


def read_corpus() -> dict[str, Submission]:
    """Read all submissions, by name."""
    found: dict[str, Submission] = {}
    for path in sorted(FOLDER.glob("*.txt")):
        for text in re.split(r"^# %% ", path.read_text("utf-8"), flags=re.MULTILINE)[1:]:
            one = read_submission(path.stem, text)
            if one.name in found:
                raise ValueError(f"two submissions are called {one.name!r}")
            found[one.name] = one
    return found


CORPUS = read_corpus()
