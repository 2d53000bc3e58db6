"""What answers may use of dhlab, and that nothing else of it is there."""

from pathlib import Path

import pytest

from dhlab.grading.exercise import imports_from_dhlab, load_exercise
from dhlab.grading.mark import mark_cells
from dhlab.grading.source import read_cells
from dhlab.grading.tools import PACKAGE, files_of, tool_modules

EXERCISES = sorted(Path(__file__).parents[2].glob("exercises/*/exercise.py"))


def test_what_computes_is_a_tool_and_what_draws_is_none():
    modules = tool_modules(["rotx", "eul2r", "csys", "View", "trj_poly3", "robot", "nonsense"])
    assert modules == {
        "rotx": "dhlab.kinematics.transforms",
        "eul2r": "dhlab.kinematics.angles",
        "trj_poly3": "dhlab.kinematics.poly3",
    }


def test_a_tool_brings_the_files_that_it_needs_and_no_other():
    files = {path.as_posix() for path in files_of(["dhlab.kinematics.angles"])}
    assert {"kinematics/angles.py", "kinematics/transforms.py", "arrays.py"} <= files
    assert "kinematics/dh.py" not in files
    assert all((PACKAGE / path).is_file() for path in files)


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
