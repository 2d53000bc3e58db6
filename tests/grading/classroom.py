"""An exercise of two questions, and a class of forty who answered it in every way there is."""

import json
import random

from tests.broken_files import UNREADABLE

CHECKS = '''
"""Two questions: a turn about z by the student's own angle, and one by any angle."""

from dhlab.diagnosis import MatrixTask, turn
from dhlab.grading import Question


def numbers(rng):
    return {"angle": round(float(rng.uniform(0.2, 1.2)), 3)}


def questions(given):
    return [
        Question("R_own", MatrixTask(turn("z", given["angle"]), turn("x", 0.4), size=3), points=1),
        Question(
            "rot_z",
            MatrixTask(turn("z", lambda angle: angle), size=3),
            points=2,
            examples=[(0.3,), (1.2,)],
            inputs=lambda rng: [(0.0,), *((angle,) for angle in rng.uniform(-3, 3, 3))],
            hint="Where does x go?",
        ),
    ]
'''
NAME = "01_turns"

SETUP = """
import numpy as np
from dhlab.grading import checks
check = checks("", course="robots")
STUDENT = "{name}"
given = check.numbers(STUDENT)
"""
TURN = "np.array([[np.cos({0}), -np.sin({0}), 0], [np.sin({0}), np.cos({0}), 0], [0, 0, 1]])"
OWN = f"""
Z = {TURN.format("given['angle']")}
X = np.array([[1, 0, 0], [0, np.cos(0.4), -np.sin(0.4)], [0, np.sin(0.4), np.cos(0.4)]])
R_own = {{product}}
"""
FUNCTION = "def rot_z(angle):\n    return {}\n"
RIGHT = TURN.format("angle")
STUB = "def rot_z(angle):\n    raise NotImplementedError\n"

ANSWERS = {
    "right": ("Z @ X", FUNCTION.format(RIGHT)),
    "order": ("X @ Z", FUNCTION.format(RIGHT)),
    "order and sign": ("X @ Z", FUNCTION.format(TURN.format("-angle"))),
    "sign": ("Z @ X", FUNCTION.format(TURN.format("-angle"))),
    "degrees": ("Z @ X", FUNCTION.format(TURN.format("np.radians(angle)"))),
    "empty": ("None", STUB),
    "raises": ("Z @ X", FUNCTION.format("1 / 0")),
    "shape": ("Z", FUNCTION.format("[1, 2, 3]")),
}
SPREAD = ["right"] * 9 + ["order"] * 3 + ["order and sign"] * 2 + ["sign"] * 4
SPREAD += ["degrees"] * 3 + ["empty", "raises", "shape"]
NAMES = """
Ada Lovelace, Alan Turing, Emmy Noether, Kurt Gödel, Grace Hopper, Carl Gauß, Sofia Kovalevskaya,
Leonhard Euler, Maryam Mirzakhani, Évariste Galois, Hedy Lamarr, Jean Bartik, Niels Abel,
Mary Cartwright, Rózsa Péter, Ada Yonath, Felix Klein, Lise Meitner, Otto Hahn, Chien-Shiung Wu,
Paul Dirac, Vera Rubin, Max Born, Rosalind Franklin
""".replace(",", "\n")
NAMES = [name.strip() for name in NAMES.split("\n") if name.strip()]


def notebook(*cells):
    """Text of a notebook with these code cells."""
    made = [
        {"cell_type": "code", "source": cell, "outputs": [], "metadata": {}, "id": f"c{k}"}
        for k, cell in enumerate(cells)
    ]
    return json.dumps({"nbformat": 4, "nbformat_minor": 5, "metadata": {}, "cells": made})


def answered(name, kind="right"):
    """Text of the notebook of one student."""
    product, function = ANSWERS[kind]
    return notebook(SETUP.format(name=name), OWN.format(product=product), function)


def broken():
    """File name -> bytes of what cannot be read."""
    files = {f"{kind.title()}.ipynb": content for kind, (content, _) in UNREADABLE.items()}
    return files | {"Packed.zip": b"PK\x03\x04" + bytes(100)}


def odd():
    """File name -> bytes of what is unusual, and right."""

    def changed(name, change, encoding="utf-8"):
        document = json.loads(answered(name))
        return json.dumps(change(document), ensure_ascii=False).encode(encoding)

    def old(document):
        cells = [{"cell_type": "code", "input": c["source"]} for c in document["cells"]]
        return {"nbformat": 3, "worksheets": [{"cells": cells}]}

    def loud(document):
        for cell in document["cells"]:
            cell["outputs"] = [{"output_type": "stream", "text": ["x" * 1000] * 2000}]
        return document

    julia = {"kernelspec": {"name": "julia-1.9", "language": "julia"}}
    return {
        "Latin Öne.ipynb": changed("Latin Öne", lambda d: d, "latin-1"),
        "Format Three.ipynb": changed("Format Three", old),
        "Format Later.ipynb": changed("Format Later", lambda d: d | {"nbformat": 99}),
        "No Metadata.ipynb": changed("No Metadata", lambda d: {"cells": d["cells"]}),
        "Other Kernel.ipynb": changed("Other Kernel", lambda d: d | {"metadata": julia}),
        "Cells Twice.ipynb": changed("Cells Twice", lambda d: d | {"cells": d["cells"] * 2}),
        "Much Output.ipynb": changed("Much Output", loud),
        "Other Ending.ipynb.txt": answered("Other Ending").encode(),
        f"Named Longer_{NAME}.ipynb": answered("Named Longer").encode(),
    }


def write_exercise(folder):
    """Write the exercise, and another one beside it; return its folder."""
    for name in (NAME, "02_others"):
        (folder / "exercises" / name).mkdir(parents=True)
        (folder / "exercises" / name / "checks.py").write_text(CHECKS)
    return folder / "exercises" / NAME


def write_class(folder, seed=1):
    """Write a folder of the whole class's notebooks; return student -> kind of answer."""
    folder.mkdir(parents=True)
    kinds = random.Random(seed).sample(SPREAD, len(SPREAD))
    there = dict(zip(NAMES, kinds, strict=True))
    for name, kind in there.items():
        (folder / f"{name}.ipynb").write_text(answered(name, kind), "utf-8")
    for name, content in {**broken(), **odd()}.items():
        (folder / name).write_bytes(content)
    (folder / "Symbolic Link.ipynb").symlink_to("/etc/passwd")
    for copy in ("Two Versions.ipynb", "Two Versions-Copy1.ipynb"):
        (folder / copy).write_text(answered("Two Versions"))
    there |= {name.split(".")[0].split("_")[0]: "right" for name in odd()}
    rest = [*(name.split(".")[0] for name in broken()), "Symbolic Link", "Two Versions"]
    return there | dict.fromkeys(rest, "unreadable")
