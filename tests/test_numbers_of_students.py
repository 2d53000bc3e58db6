"""The numbers that students draw: none of them makes one mistake look like another."""

from itertools import permutations
from pathlib import Path

import pytest

from dhlab.grading.exercise import load_exercise

ROOT = Path(__file__).parents[1]
ANGLES = {
    "02_sequences": ("a", "b", "c"),
    "03_transforms": ("angle",),
    "06_chain_by_hand": (("q", 0), ("q", 1)),
    "07_dh_link": ("alpha", "theta"),
    "12_base_tool_offset": ("turn", "tilt"),
}
STUDENTS = 12


def get(given, angle):
    name, *index = angle if isinstance(angle, tuple) else (angle,)
    return given[name][index[0]] if index else given[name]


def put(given, angle, value):
    name, *index = angle if isinstance(angle, tuple) else (angle,)
    if not index:
        return given | {name: value}
    return given | {name: [value if k == index[0] else x for k, x in enumerate(given[name])]}


def misread(given, angles):
    """Numbers as they may be misread, and which mistake this is, if it is one."""
    for angle in angles:
        for change in (lambda x: x + 10, lambda x: x - 5, lambda x: x - 90, lambda x: x / 2):
            yield put(given, angle, change(get(given, angle))), "none"
        yield put(given, angle, 180 - get(given, angle)), "cosine-sign"
    for one, other in permutations(angles, 2):
        yield put(given, one, get(given, other)), "none"
        exchanged = put(put(given, one, get(given, other)), other, get(given, one))
        yield exchanged, "angles-exchanged"


@pytest.mark.parametrize("folder", ANGLES)
def test_a_number_that_is_misread_looks_like_no_mistake(folder):
    exercise = load_exercise(ROOT / "exercises" / folder)
    named, wrong = [], 0
    for k in range(STUDENTS):
        given = exercise.numbers(f"student {k}", "dhlab")
        right = {q.name: q for q in exercise.questions(given) if not q.is_function}
        for numbers, made in misread(given, ANGLES[folder]):
            for question in exercise.questions(numbers):
                if question.name in right and hasattr(question.task, "reference"):
                    came = question.task.reference()
                    verdict = right[question.name].task.judge([((), came)])
                    wrong += not verdict.right
                    if not any(m.key.startswith(made) for m in verdict.mistakes):
                        named += [(given, numbers, verdict.text)] if verdict.mistakes else []
    assert wrong >= 5 * STUDENTS
    assert not named
