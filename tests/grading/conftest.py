"""A small exercise, to be built, broken and copied."""

import textwrap

import pytest

from dhlab.grading.asked import Ask
from dhlab.grading.runner import run_cells
from dhlab.grading.sandbox import SandboxError

CHECKS = """
from dhlab import csys
from dhlab.diagnosis import MatrixTask, turn
from dhlab.grading import Question

def numbers(rng):
    return {"angle": round(float(rng.uniform(0.2, 1.2)), 2)}

def questions(given):
    return [
        Question(
            "rot_z",
            MatrixTask(turn("z", lambda angle: angle), size=3),
            points=2,
            examples=[(0.4,), (-1.1,)],
            inputs=lambda rng: [(0.0,), (rng.uniform(-3, 3),)],
            hint="Which column stays as it is?",
        ),
        Question("R", MatrixTask(turn("x", given["angle"]), turn("z", 0.7), size=3)),
    ]

def pictures(given):
    return {"frame": [csys(name="A")]}
"""
EXERCISE = """
# %% title [markdown]
# # Turns

# %% imports
import numpy as np
from dhlab import csys, rotx, rotz, rp2t, show
from dhlab.grading import checks

# %% checks
check = checks(course="robots")

# %% student
STUDENT = ""
given = check.numbers(STUDENT)

# %% rot-z
def rot_z(angle):
    ### BEGIN SOLUTION
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    ### END SOLUTION

# %%
check("rot_z", rot_z)

# %%
### BEGIN SOLUTION
first = rotx(given["angle"])
R = first @ rot_z(0.7)
### END SOLUTION

# %%
check("R", R)

# %% yours
def yours(R):
    return show(*check.picture("frame"), csys(rp2t(R, (0, 0, 0)), name="yours"))

check.show(yours, R)
"""
WRONG = """
# %% rot_z: sign-1
rot_z = lambda angle: rotz(-angle)

# %% rot_z: degrees
rot_z = lambda angle: rotz(np.radians(angle))

# %% rot_z: axis-1-x
rot_z = lambda angle: rotx(angle)

# %% R: reversed-order
R = rotz(0.7) @ rotx(given["angle"])

# %% R: shape (3,)
R = [given["angle"], 0, 0.7]
"""


@pytest.fixture
def folder(tmp_path):
    """The folder of a good exercise."""
    folder = tmp_path / "01_turns"
    folder.mkdir()
    for name, text in (("checks", CHECKS), ("exercise", EXERCISE), ("wrong", WRONG)):
        (folder / f"{name}.py").write_text(textwrap.dedent(text).lstrip(), "utf-8")
    return folder


@pytest.fixture
def edit(folder):
    """Replace text in one of the exercise's files."""

    def edit(name, old, new):
        path = folder / name
        text = path.read_text("utf-8")
        assert old in text
        path.write_text(text.replace(old, new, 1), "utf-8")

    return edit


@pytest.fixture(scope="session")
def sandbox():
    """The sandbox of this machine; 'none' where bubblewrap does not work."""
    return "bwrap" if works("bwrap") else "none"


def works(sandbox):
    """Whether a sandbox works here."""
    try:
        run_cells(["x = 1"], [Ask("x")], {}, sandbox=sandbox)
    except SandboxError:
        return False
    return True
