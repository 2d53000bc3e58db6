"""Exercises with more than one right answer: what the solution does not choose is right too."""

from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

from dhlab import csys, deg, dh, robot, robot_complex, rotx, rp2t
from dhlab.grading.exercise import load_exercise
from dhlab.grading.judge import judge
from dhlab.grading.proof import Source
from dhlab.grading.trial import for_student, run_cells
from dhlab.grading.tried import values_of

ROOT = Path(__file__).parents[1]
HALF = 180 * deg


def said(folder, name, answer):
    """What is said of an answer, a function of the student's numbers."""
    exercise = load_exercise(ROOT / "exercises" / folder)
    given = exercise.numbers("Ada Lovelace", "dhlab")
    question = next(q for q in exercise.questions(given) if q.name == name)
    return judge(question, values_of(question, answer(given)))


@pytest.mark.parametrize(
    "rows",
    [
        lambda g: [dh(0, 0, 0.2, 0), dh(0, g["l1"], -0.3, 0), dh(0, g["l2"], 0.05, 0)],
        lambda g: [dh(HALF, 0, 0, 0), dh(0, g["l1"], 0, 0), dh(HALF, g["l2"], 0, 0)],
        lambda g: [dh(0, 0, 0, 1), dh(0, -g["l1"], 0, 2), dh(0, g["l2"], 0, 3)],
        lambda g: [[2 * HALF, 0, 0, 0], [0, g["l1"], 0, 0], [0, g["l2"], 0, 0]],
    ],
    ids=["other heights", "axes upside down", "x the other way", "a full turn"],
)
def test_tables_of_the_planar_arm(rows):
    assert said("08_planar_table", "table", rows).right


@pytest.mark.parametrize("alpha", [90 * deg, -90 * deg])
def test_either_sense_of_the_level_axes(alpha):
    def rows(g):
        return [dh(alpha, 0, 0, 0), dh(0, g["l1"], 0, 0), dh(0, g["l2"], 0, 0)]

    assert said("08_planar_table", "table_upright", rows).right


def upwards(g):
    """A SCARA whose axes all point up; the tool turns down behind the last."""
    rows = [dh(0, 0, 0, 0), dh(0, g["l1"], 0.1, 0), dh(0, g["l2"], 0, 0), dh(0, 0, g["h"] - 0.1, 0)]
    return robot(rows, "rrpr", grasper=rp2t(rotx(HALF), (0, 0, -g["tool"])))


def in_standard(g):
    """A SCARA by its standard table, which says so."""
    rows = [dh(0, g["l1"], g["h"], 0), dh(HALF, g["l2"], 0, 0), dh(0, 0, 0, 0), dh(0, 0, 0, 0)]
    return robot(rows, "rrpr", convention="standard", grasper=(0, 0, g["tool"]))


@pytest.mark.parametrize("scara", [upwards, in_standard])
def test_scaras(scara):
    assert said("09_scara", "scara", scara).right


@pytest.mark.parametrize("signs", [(1, 1), (-1, 1), (1, -1), (-1, -1)])
def test_six_axes_with_either_sense_of_the_shoulder_and_of_the_forearm(signs):
    shoulder, fore = signs

    def rows(g):
        return [
            dh(0, 0, 0, 0),
            dh(-90 * deg * shoulder, 0, 0, 0),
            dh(0, g["upper"], g["aside"], 0),
            dh(-90 * deg * fore, g["step"], fore * g["fore"], 0),
            dh(90 * deg * fore, 0, 0, 0),
            dh(-90 * deg, 0, 0, 0),
        ]

    assert said("10_six_axes", "table", rows).right


def test_a_standard_table_is_no_answer_where_the_modified_one_is_asked_for():
    def same(g):
        rows = [dh(alpha * deg, a, d, theta * deg) for alpha, a, d, theta in g["standard"]]
        return {"rows": rows, "convention": "standard", "joints": "rrr"}

    assert not said("11_two_conventions", "to_modified", same).right


def test_a_base_given_as_a_pose_or_with_an_offset_in_full_turns():
    exercise = load_exercise(ROOT / "exercises" / "12_base_tool_offset")

    def base(g):
        chain = exercise.questions(g)[2].task.robot
        return csys(chain.base, name="anything")

    def arm(g):
        chain = exercise.questions(g)[2].task.robot
        turned = np.add(chain.offset, [2 * np.pi, 0, -2 * np.pi])
        return robot(chain.rows, "rrr", base=chain.base, grasper=chain.grasper, offset=turned)

    assert said("12_base_tool_offset", "base", base).right
    assert said("12_base_tool_offset", "arm", arm).right


def test_a_hand_whose_fingers_are_named_and_bent_as_the_student_likes():
    exercise = load_exercise(ROOT / "exercises" / "14_hand")

    def hand(g):
        mechanism = exercise.questions(g)[1].task.robot
        fingers = [
            robot(
                b.chain.rows, "rrrr", name=f"finger {k}", base=b.chain.base,
                grasper=b.chain.grasper, limits=b.chain.limits, q=b.chain.limits.mean(axis=1),
            )
            for k, b in enumerate(mechanism.branches) if b.chain.n
        ]  # fmt: skip
        return robot_complex(*fingers, name="mine")

    assert said("14_hand", "hand", hand).text == "Right."


PLAIN = {  # questions whose answer is made of numbers, and what is right for them
    "01_rotation_matrices": ("rot_z", "rot_y", "R_AB"),
    "02_sequences": ("R_moving", "R_fixed", "wheel"),
    "03_transforms": ("T_AB", "to_A", "inverse_pose"),
    "04_detour": ("T_HP", "camera_pose"),
    "05_roll_pitch_yaw": ("rpy_matrix", "rpy_angles", "attitude"),
    "06_chain_by_hand": ("tip", "arm_pose"),
    "07_dh_link": ("dh_link", "T_own"),
    "08_planar_table": ("table", "table_upright"),
    "10_six_axes": ("arm_table", "table"),
    "11_two_conventions": ("to_modified", "behind", "to_standard"),
    "12_base_tool_offset": ("base", "tool"),
    "13_finger": ("finger_tip", "thumb_in_hand"),
    "15_cubic": ("cubic", "position", "velocity"),
}
FORMS = {
    "lists": lambda x: np.asarray(x).tolist(),
    "rows as arrays": lambda x: tuple(np.asarray(x)),
    "single precision": lambda x: np.asarray(x, np.float32),
    "a matrix of numpy's": np.matrix,
    "five digits": lambda x: np.round(x, 5),
    "numbers of every kind": lambda x: np.asarray(x, object),
    "fractions": lambda x: np.vectorize(Fraction, otypes=[object])(np.asarray(x, float)),
    "arrays of one number": lambda x: np.vectorize(np.array, otypes=[object])(x).tolist(),
    "a column": lambda x: np.reshape(x, (-1, 1)) if np.ndim(x) == 1 else x,
    "complex without an imaginary part": lambda x: np.asarray(x) + 0j,
}


@pytest.fixture(scope="module", params=PLAIN)
def solved(request):
    """An exercise, what its notebook leaves when it is solved, and its questions by name."""
    source = Source(ROOT / "exercises" / request.param)
    left = run_cells(for_student(source.solved, "Ada Lovelace"))
    questions = source.exercise.questions(source.exercise.numbers("Ada Lovelace", "dhlab"))
    return {q.name: (q, left[q.name]) for q in questions if q.name in PLAIN[request.param]}


@pytest.mark.filterwarnings("ignore:the matrix subclass:PendingDeprecationWarning")
@pytest.mark.parametrize("form", FORMS)
def test_an_answer_is_right_whatever_its_numbers_are_made_of(solved, form):
    assert solved
    change = FORMS[form]
    for question, answer in solved.values():
        if question.kind == "csys":
            answer = answer.pose
        if question.name == "cubic" and form == "five digits":
            continue  # of t^3, and 3 s later that is a degree
        came = (lambda *x, f=answer: change(f(*x))) if question.is_function else change(answer)
        cases = question.cases(np.random.default_rng(5))
        judged = judge(question, values_of(question, came, cases))
        assert judged.right, f"{question.name}: {judged.text}"
