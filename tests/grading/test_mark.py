"""Marking one submission: what comes out, who it is for, and what is said."""

import json
import re
from dataclasses import asdict

import pytest

from dhlab.grading.exercise import exercise_from_text
from dhlab.grading.mark import imports_of, mark_cells

EXERCISE = exercise_from_text(
    """
from dhlab.diagnosis import MatrixTask, turn
from dhlab.grading import Question

def numbers(rng):
    return {"angle": float(rng.uniform(0.2, 1.2))}

def questions(given):
    about_z = MatrixTask(turn("z", lambda angle: angle), size=3)
    own = MatrixTask(turn("x", given["angle"]), size=3)
    drawn = lambda rng: [(x,) for x in rng.uniform(-3, 3, 4)]
    return [
        Question("rot_z", about_z, points=2, examples=[(0.3,), (-1.1,)], inputs=drawn),
        Question("R_x", own, points=1, hint="Which row stays as it is?"),
    ]
""",
    "turns",
)
START = """
import numpy as np
from dhlab import View, csys, deg, rp2t
from dhlab.grading import checks
check = checks("eNq", course="robots")
given = check.numbers(STUDENT)
"""
ROT_Z = """
def rot_z(t):
    return np.array([[np.cos(t), -np.sin(t), 0], [np.sin(t), np.cos(t), 0], [0, 0, 1]])
"""
R_X = """
c, s = np.cos(given["angle"]), np.sin(given["angle"])
R_x = np.array([[1, 0, 0], [0, c, -s], [0, s, c]])
"""
SHOWN = 'View("mine").add(csys(rp2t(rot_z(90 * deg), (0, 0, 0))))\ncheck("rot_z", rot_z)'


@pytest.fixture
def marked(sandbox):
    """A function that marks the submission of some cells."""

    def mark(*cells, student="Ada", seed=1, named="Ada"):
        all_cells = [f"STUDENT = {named!r}", START, *cells]
        return mark_cells(EXERCISE, student, all_cells, seed=seed, course="robots", sandbox=sandbox)

    return mark


def test_a_right_submission_gets_all_points(marked):
    ada = marked(ROT_Z, SHOWN, R_X)
    assert (ada.points, ada.out_of, ada.status, ada.reason) == (3, 3, "graded", "")
    assert (ada.notes, ada.left_out) == ((), ())
    assert [q.reason for q in ada.questions] == ["right", "right"]


def test_a_question_is_worth_all_its_points_or_none(marked):
    half = marked(ROT_Z, "R_x = ...")
    assert [q.points for q in half.questions] == [2, 0]
    assert "Which row stays" in half.questions[1].text


def test_what_fits_the_examples_alone_gets_nothing(marked):
    table = "def rot_z(t):\n    assert t == 0.3\n    return right(t)\n"
    only = marked(ROT_Z.replace("rot_z", "right"), table)
    assert only.questions[0].reason == "raised"
    assert only.questions[0].points == 0


def test_a_value_in_place_of_a_function_is_there_and_told_to_be_a_value(marked):
    value = marked("rot_z = np.eye(3)", R_X)
    assert value.questions[0].reason == "no function"
    assert value.questions[0].text == "`rot_z` is a value: a function of this name is asked for."


@pytest.mark.parametrize(
    ("right_for", "said"),
    [
        ("t > 0", "Of the inputs in the notebook, `rot_z(0.3)` is right, `rot_z(-1.1)` is not."),
        ("t in (0.3, -1.1)", "Those in the notebook are all right."),
        ("t not in (0.3, -1.1)", "Of those in the notebook none is right."),
    ],
)
def test_of_an_answer_that_is_right_for_some_inputs_those_of_the_notebook_are_told(
    marked, right_for, said
):
    some = f"def rot_z(t):\n    return right(t) if {right_for} else np.eye(3)\n"
    text = marked(ROT_Z.replace("rot_z", "right"), some).questions[0].text
    assert re.search(r"For \d of 6 inputs it is right", text)
    assert text.endswith(said)


def test_of_an_answer_that_is_wrong_for_all_inputs_none_is_told(marked):
    assert "in the notebook" not in marked("def rot_z(t):\n    return np.eye(3)").questions[0].text


def test_a_mistake_is_named(marked):
    wrong = marked(ROT_Z.replace("-np.sin", "+np.sin").replace("[np.sin", "[-np.sin"), R_X)
    assert "inverse" in wrong.questions[0].mistakes
    assert wrong.questions[1].right


def test_the_further_cases_are_those_of_the_seed(marked):
    spy = "def rot_z(t):\n    raise ValueError(t)\n"
    first, again, other = (marked(spy, seed=seed).questions[0].text for seed in (1, 1, 2))
    assert first == again == other  # the first case is the example
    spy = "def rot_z(t):\n    return right(t) if t == 0.3 else 1 / 0 * t\n"
    assert marked(ROT_Z.replace("rot_z", "right"), spy).points == 0


def test_the_numbers_are_those_of_the_student_who_is_marked(marked):
    ada = marked(R_X, named="Charles")
    assert ada.questions[1].right
    assert ada.status == "second look"
    assert ada.reason == (
        "the notebook names 'Charles'; its answers were compared with those for 'Ada'."
    )


@pytest.mark.parametrize("named", ["ada ", "ADA"])
def test_a_name_may_be_written_in_another_way(marked, named):
    assert marked(R_X, named=named).reason == ""


def test_a_notebook_without_a_name_is_told_so(marked):
    nobody = marked(R_X, named="")
    assert nobody.status == "second look"
    assert "the notebook names nobody; its answers" in nobody.reason


def test_a_cell_that_ends_everything_is_left_out_and_told(marked):
    part = marked("import os\nos._exit(0)", ROT_Z, R_X)
    assert (part.points, part.status, part.left_out) == (3, "partly graded", (3,))
    assert part.reason == "cell 3 was left out: it ended the whole program."
    assert not [note for note in part.notes if "left out" in note]  # once is enough


def test_no_submission_writes_its_own_reason(marked):
    forge = """
import os
for fd in range(3, 64):
    try:
        os.write(fd, b'\\n{"note": "cell 1 was left out: x", "error": [1, "left out: x"]}\\n')
    except OSError:
        pass
"""
    ada = marked(forge, ROT_Z, R_X)
    assert (ada.points, ada.status, ada.reason) == (3, "graded", "")
    assert ada.notes == ("cell 1: left out: x",)


def test_all_of_it_is_plain_data(marked):
    whole = asdict(marked(ROT_Z, "R_x = '<b>'"))
    assert json.loads(json.dumps(whole, allow_nan=False))["student"] == "Ada"


def test_imports_are_told_from_the_text():
    cells = [
        "import numpy as np, math\nfrom dhlab import (\n    View,\n    deg as d)",
        "  from a import b # c\nfrom x.y import *; import sys",
        "broken (\n  import os",
    ]
    names = ("numpy", "math", "dhlab.View", "dhlab.deg", "a.b", "x.y.*", "sys", "os")
    assert imports_of(cells) == names
    assert len(imports_of([f"import m{k}" for k in range(999)])) == 50
