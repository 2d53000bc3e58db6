"""What answers may use of dhlab, and that nothing else of it is there."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

import dhlab
from dhlab.grading.exercise import imports_from_dhlab, load_exercise
from dhlab.grading.mark import mark_cells
from dhlab.grading.mounts import INSIDE
from dhlab.grading.source import read_cells
from dhlab.grading.tools import tool_modules, tool_texts

ALONE = """
import doctest, importlib, sys
names = dict(vars(importlib.import_module({module!r})))  # what the examples use besides
real = {{name: sys.modules.pop(name) for name in [*sys.modules] if name.split(".")[0] == "dhlab"}}
path, sys.path = sys.path, [{inside!r}, *[p for p in sys.path if p not in ("", {root!r})]]
finders, sys.meta_path = sys.meta_path, [f for f in sys.meta_path if "editable" not in str(f)]
from given import load
tool = load({tools!r}, {texts!r})[{name!r}]
files = [name for name in sys.modules if name.startswith("dhlab") and sys.modules[name].__spec__]
sys.modules.update(real)
sys.path, sys.meta_path = path, finders
runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE)
finder = doctest.DocTestFinder(recurse=False)
for test in finder.find(tool, {name!r}, module=False, globs=names | {{{name!r}: tool}}):
    runner.run(test)
print(runner.failures, files)
"""
EXERCISES = sorted(Path(__file__).parents[2].glob("exercises/*/exercise.py"))


def defined(text):
    """Names of the functions and classes of a text."""
    nodes = ast.parse(text).body
    return [n.name for n in nodes if isinstance(n, ast.FunctionDef | ast.ClassDef)]


def test_what_computes_is_a_tool_and_what_draws_is_none():
    modules = tool_modules(["rotx", "eul2r", "csys", "View", "trj_poly3", "robot", "nonsense"])
    assert modules == {
        "rotx": "dhlab.kinematics.transforms",
        "eul2r": "dhlab.kinematics.angles",
        "trj_poly3": "dhlab.kinematics.poly3",
    }


def test_a_tool_brings_what_it_needs_and_nothing_else():
    texts = tool_texts(tool_modules(["rp2t", "rpy2r"]))
    given = "\n".join(texts.values())
    assert list(texts)[-1] == "dhlab.kinematics.angles"  # after those that it imports from
    assert {"rp2t", "rpy2r", "as_array", "InputError"} <= set(defined(given))
    assert not {"inverse", "r2rpy", "link_transform", "DegreesWarning"} & set(defined(given))


@pytest.mark.parametrize("name", sorted(tool_modules(dhlab.__all__)))
def test_every_tool_alone_does_what_its_examples_say(name):
    """With what was made for it, and with nothing else of dhlab."""
    tools = tool_modules([name])
    words = {"module": tools[name], "root": str(INSIDE.parents[2]), "inside": str(INSIDE)}
    code = ALONE.format(tools=tools, texts=tool_texts(tools), name=name, **words)
    command = [sys.executable, "-c", code]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.stdout == "0 []\n", done.stdout + done.stderr


def test_the_tools_of_an_exercise_are_what_its_notebook_imports(folder):
    assert load_exercise(folder).tools == ("csys", "rotx", "rotz", "rp2t", "show")
    text = "from dhlab import (\n    deg,\n    rotx as x,\n)\nfrom dhlab.grading import checks\n"
    assert imports_from_dhlab(text) == ("deg", "rotx")


@pytest.mark.parametrize("path", EXERCISES, ids=lambda path: path.parent.name)
def test_the_solution_of_an_exercise_gets_all_points_where_it_is_marked(path, sandbox):
    exercise = load_exercise(path.parent)
    cells = [cell.source for cell in read_cells(path) if cell.kind == "code"]
    marked = mark_cells(exercise, "Ada", cells, seed=1, course="dhlab", sandbox=sandbox)
    told = [q.text for q in marked.questions if not q.right]
    assert (marked.points, told) == (marked.out_of, [])


@pytest.mark.parametrize(
    ("exercise", "asked"),
    [
        ("01_rotation_matrices", {"roty", "rotz"}),
        ("03_transforms", {"inverse"}),
        ("07_dh_link", {"link_transform"}),
    ],
)
def test_what_an_exercise_asks_for_does_not_come_with_what_it_gives(exercise, asked):
    tools = load_exercise(EXERCISES[0].parents[1] / exercise).tools
    assert not asked & set(defined("\n".join(tool_texts(tool_modules(tools)).values())))


def test_another_function_of_dhlab_is_not_there_and_is_told(folder, sandbox):
    cells = [
        'import numpy as np\nfrom dhlab import rotz, angvec2r\nSTUDENT = "Ada"',
        "def rot_z(angle):\n    return angvec2r(angle, (0, 0, 1))",
        "R = rotz(1.0) @ angvec2r(1.0, (0, 0, 1))",
    ]
    marked = mark_cells(load_exercise(folder), "Ada", cells, seed=1, sandbox=sandbox)
    assert [q.reason for q in marked.questions] == ["not numbers", "missing"]
    assert "angvec2r of dhlab is not there" in marked.questions[0].text
    assert "uses angvec2r of dhlab" in marked.notes
