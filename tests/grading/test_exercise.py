"""Questions and numbers from a `checks.py`, and the line of whatever is wrong in it."""

import hashlib
import pickle
import re

import numpy as np
import pytest

from dhlab.diagnosis import MatrixTask, turn
from dhlab.errors import DhlabError, InputError
from dhlab.grading.exercise import exercise_from_text, load_exercise, seed_of, title_of
from dhlab.grading.question import Question

TASK = MatrixTask(turn("z", 0.3), size=3)


def test_the_same_student_gets_the_same_numbers_whenever_and_however_the_name_is_written(folder):
    exercise = load_exercise(folder)
    ada = exercise.numbers("Ada Lovelace", "robots")
    for name in ("ada lovelace", "  Ada\tLOVELACE ", "Ａda Lovelace"):
        assert exercise.numbers(name, "robots") == ada
    others = [exercise.numbers(f"student {k}", "robots")["angle"] for k in range(30)]
    assert len(set(others)) > 20
    assert exercise.numbers("Ada Lovelace", "robots 2")["angle"] != ada["angle"]


def test_the_course_is_the_one_that_the_notebook_names(folder, edit):
    assert load_exercise(folder).course == "robots"
    edit(
        "exercise.py", 'checks(course="robots")', "checks(\n    raises=False, course = 'arms 2',\n)"
    )
    exercise = load_exercise(folder)
    assert exercise.course == "arms 2"
    assert pickle.loads(pickle.dumps(exercise)).course == "arms 2"
    (folder / "exercise.py").unlink()
    assert load_exercise(folder).course == ""


def test_the_title_is_the_first_heading_and_without_one_the_name(folder, edit):
    edit("exercise.py", "# # Turns", "# # A turn: $R_z$ ")
    assert title_of(folder) == "A turn: $R_z$"
    edit("exercise.py", "# # A turn", "# A turn")
    assert title_of(folder) == "01_turns"
    (folder / "exercise.py").unlink()
    assert title_of(folder) == "01_turns"


def test_seeds_are_the_same_on_every_machine():
    digest = hashlib.sha256(b"robots\nada lovelace").hexdigest()
    assert seed_of("robots", "Ada Lovelace") == int(digest[:16], 16)


def test_numbers_are_plain_whatever_numpy_made_them():
    text = (
        "import numpy as np\n"
        "def numbers(rng): return {'q': rng.uniform(size=2), 'n': rng.integers(5), 'w': ('a', 1)}\n"
        "def questions(given): return []"
    )
    given = exercise_from_text(text, "e").numbers("Ada")
    assert [type(x) for x in given["q"]] == [float, float]
    assert isinstance(given["n"], int)
    assert given["w"] == ["a", 1]


def test_an_exercise_travels_to_another_process_as_its_text(folder):
    exercise = load_exercise(folder)
    there = pickle.loads(pickle.dumps(exercise))
    assert there == exercise
    given = exercise.numbers("Ada")
    assert [q.name for q in there.questions(given)] == ["rot_z", "R"]


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("def questions(given):", "def questions(given)", "line 8: SyntaxError: expected ':'"),
        ("from dhlab import csys", "from dhlab import cys", "line 1: ImportError: cannot import"),
        ('turn("x", given["angle"])', 'turn("w", 1)', "line 18: no axis 'w'; use 'x', 'y', 'z'"),
        ('given["angle"]', 'given["angel"]', "line 18: KeyError: 'angel'"),
        ('"R", MatrixTask', '"rot_z", MatrixTask', "gives two questions 'rot_z'"),
        ('{"angle": round', '{"angle": rng, "a": round', "must give numbers"),
        ("points=2", "points=-1", "points must be"),
        ("(0.4,), (-1.1,)", "(0.4), (-1.1)", "examples must be tuples of arguments such as"),
    ],
)
def test_an_error_in_the_checks_names_file_line_and_reason(folder, edit, old, new, said):
    edit("checks.py", old, new)

    def use():
        exercise = load_exercise(folder)
        exercise.questions(exercise.numbers("Ada"))

    with pytest.raises(DhlabError, match=r"checks\.py.*" + re.escape(said)):
        use()


def test_a_folder_without_checks_or_with_half_of_them_is_refused(folder, tmp_path):
    with pytest.raises(DhlabError, match="is no exercise: there is no checks"):
        load_exercise(tmp_path)
    (folder / "checks.py").write_text("x = 1")
    with pytest.raises(DhlabError, match=r"must define questions\(given\)"):
        load_exercise(folder)
    (folder / "checks.py").write_bytes(b"x = '\xff'")
    with pytest.raises(DhlabError, match="is not written in UTF-8"):
        load_exercise(folder)


def test_what_questions_gives_must_be_questions():
    for given_back, said in (("[1]", "must give Questions, got 1"), ("[]", "gives no question")):
        exercise = exercise_from_text(f"def questions(given): return {given_back}", "e")
        with pytest.raises(DhlabError, match=said):
            exercise.questions({})


def test_an_unknown_picture_is_refused_with_the_choices(folder):
    exercise = load_exercise(folder)
    given = exercise.numbers("Ada")
    assert [handle.name for handle in exercise.picture("frame", given)] == ["A"]
    with pytest.raises(InputError, match="has no picture 'arm'; there are: frame"):
        exercise.picture("arm", given)


def test_an_error_in_further_inputs_names_the_line(folder, edit):
    edit("checks.py", "[(0.0,), (rng.uniform(-3, 3),)]", "[1 / 0]")
    exercise = load_exercise(folder)
    question = exercise.questions(exercise.numbers("Ada"))[0]
    with pytest.raises(DhlabError, match=r"checks\.py, line 15: ZeroDivisionError"):
        exercise.cases(question, np.random.default_rng(1))


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ({"name": "rot z"}, "cannot be the name of a function or variable"),
        ({"points": "many"}, "points must be"),
        ({"kind": "picture"}, "no kind 'picture'; use values, robot, csys, scene"),
        ({"task": "turn it"}, "the task must be one of dhlab.diagnosis, got 'turn it'"),
        ({"examples": []}, "there must be an example"),
        ({"inputs": lambda rng: []}, "only a function has further inputs"),
    ],
)
def test_a_question_that_makes_no_sense_is_refused(wrong, said):
    with pytest.raises(InputError, match=said):
        Question(**({"name": "R", "task": TASK} | wrong))
