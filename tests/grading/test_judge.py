"""From what came for a question to points and a sentence."""

import pytest

from dhlab.diagnosis import MatrixTask, turn
from dhlab.grading.asked import NoValue
from dhlab.grading.judge import judge
from dhlab.grading.question import Question
from dhlab.kinematics.transforms import rotz

QUESTION = Question(
    "rot_z", MatrixTask(turn("z", lambda angle: angle), size=3), points=2, examples=[(0.3,)]
)
HIDDEN = 2.345678


def judged(text, case):
    """What is said where one case raises: the example, 0, or a further one, 1."""
    nothing = NoValue("raised", text)
    cases = [((0.3,), rotz(0.3)), ((HIDDEN,), rotz(HIDDEN))]
    cases[case] = (cases[case][0], nothing)
    return judge(QUESTION, cases)


def test_the_error_of_an_example_is_told_as_it_is():
    assert judged("ValueError: 0.3", 0).text == "`rot_z` raised an error. (ValueError: 0.3)"


@pytest.mark.parametrize("number", [HIDDEN, -HIDDEN, 1e-9, -2.5e17, 7, 0.1])
def test_the_error_of_a_further_case_is_told_without_its_numbers(number):
    text = f"ValueError: no angle {number}, got x1, in the line `return x / 2`"
    told = judged(text, 1)
    assert told.text == (
        "`rot_z` raised an error. (ValueError: no angle #, got x1, in the line `return x / 2`)"
    )
    assert (told.points, told.right) == (0, False)
