"""The check cell: right or wrong at once, never a traceback, never the expected number."""

import json
import re
import subprocess
import sys
from html.parser import HTMLParser

import numpy as np
import pytest

from dhlab import rotx, rotz
from dhlab.errors import DhlabError, InputError
from dhlab.grading.build import build
from dhlab.grading.check import Check, NotRight, checks, packed
from dhlab.grading.exercise import exercise_from_text, load_exercise


@pytest.fixture
def check(folder):
    """The check of a notebook, with a student's numbers."""
    check = checks(packed(load_exercise(folder)), course="robots")
    check.numbers("Ada Lovelace")
    return check


def fails(angle):
    return 1 / 0 * angle


def leaves(angle):
    raise SystemExit


def goes_deep(angle):
    return goes_deep(angle)


class Hostile:
    """Answers nothing like a value does."""

    def __getattr__(self, name):
        raise RuntimeError("no")

    def __eq__(self, other):
        return True

    __hash__ = None


def test_a_right_answer_is_right_and_its_examples_are_shown(check):
    said = check("rot_z", rotz)
    assert said.right
    assert repr(said).splitlines() == [
        "✓ rot_z: right",
        "  ✓ rot_z(0.4)",
        "  ✓ rot_z(-1.1)",
        "When it is marked, further cases are tried.",
    ]


def test_a_wrong_answer_is_explained_and_never_given_away(check):
    said = check("rot_z", lambda angle: rotz(-angle))
    assert "✗ rot_z: not right yet" in repr(said)
    assert "goes the wrong way round" in repr(said)
    numbers = {f"{abs(x):.3f}" for x in rotz(0.4).ravel()} - {"0.000", "1.000"}
    assert not any(number in repr(said) for number in numbers)


def test_an_answer_that_is_right_for_some_examples_shows_which(check):
    said = check("rot_z", lambda angle: rotz(abs(angle)))
    assert said.tried == [("rot_z(0.4)", True), ("rot_z(-1.1)", False)]


def test_a_stub_gets_its_hint(check):
    def stub(angle):
        raise NotImplementedError

    for answer in (stub, ..., lambda angle: ...):
        said = check("rot_z", answer)
        assert said.right is None
        assert repr(said) == (
            "\N{MEDIUM SMALL WHITE CIRCLE} rot_z: still to be written\n"
            "Nothing is there yet. Which column stays as it is?"
        )


@pytest.mark.parametrize(
    ("answer", "said"),
    [
        (fails, "`rot_z` raised an error. (ZeroDivisionError: division by zero, in the line `ret"),
        (leaves, "raised an error. (SystemExit"),
        (goes_deep, "raised an error. (RecursionError"),
        (rotz(0.4), "`rot_z` is a value: a function of this name is asked for."),
        (lambda: 1, "raised an error. (TypeError"),
        (lambda angle: None, "is there a return at the end?"),
        (lambda angle: "R", "is text"),
        (lambda angle: np.full((3, 3), np.nan), "nan"),
        (lambda angle: np.ones((2, 2)), "has shape (2, 2); shape (3, 3) is asked for"),
        (lambda angle: [[1, 2], [3]], "rows of different lengths"),
        (lambda angle: np.zeros((400, 400)), "is far too large"),
        (lambda angle: {1, 2}, "is not made of numbers. (a set)"),
        (lambda angle: Hostile(), "is not made of numbers."),
        (lambda angle: rotz(angle) * (1 + 1j), "is not made of numbers."),
    ],
)
def test_whatever_an_answer_does_there_is_a_sentence_and_no_traceback(check, answer, said):
    judged = check("rot_z", answer)
    assert judged.right is False
    assert said in repr(judged)


def test_a_hostile_value_in_place_of_a_function_gets_a_sentence(check):
    assert "a function of this name is asked for" in repr(check("rot_z", Hostile()))


def test_an_interrupt_still_stops_a_loop(check):
    def interrupted(angle):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        check("rot_z", interrupted)


def test_an_answer_cannot_change_what_it_is_compared_with():
    text = (
        "import numpy as np\n"
        "from dhlab.diagnosis import MatrixTask, slide\n"
        "from dhlab.grading import Question\n"
        "def questions(given):\n"
        "    task = MatrixTask(slide(lambda p: p))\n"
        "    return [Question('shift', task, examples=[(np.array([1.0, 2, 3]),)])]\n"
    )
    check = Check(exercise_from_text(text, "shifts"))

    def shift(p):
        p *= 0
        return np.eye(4)

    assert check("shift", shift).right is False


def test_an_unknown_question_and_missing_numbers_are_told_in_a_sentence(folder):
    check = checks(packed(load_exercise(folder)))
    assert "Run the cell with `given = check.numbers(STUDENT)` first" in repr(check("R", rotz(1)))
    with pytest.raises(InputError, match=r"Run the cell with given = check\.numbers"):
        check.picture("frame")
    check.numbers("Ada")
    assert "The questions are: rot_z, R." in repr(check("rotz", rotz))
    with pytest.raises(InputError, match="STUDENT must be text"):
        check.numbers(...)


def test_who_has_not_written_their_name_is_told_so(check):
    given = check.numbers(" ")
    said = check("R", rotx(given["angle"]) @ rotz(0.7))
    assert said.right
    assert "STUDENT is still empty" in repr(said)


def test_told_to_raise_it_raises_unless_the_answer_is_right(folder):
    strict = checks(packed(load_exercise(folder)), raises=True)
    strict.numbers("Ada")
    assert strict("rot_z", rotz).right
    with pytest.raises(NotRight, match="goes the wrong way round") as error:
        strict("rot_z", lambda angle: rotz(-angle))
    assert isinstance(error.value, AssertionError)
    with pytest.raises(NotRight, match="Nothing is there yet"):
        strict("rot_z", ...)
    assert strict("rot_z", ..., raises=False).right is None


def test_with_a_seed_the_cases_that_marking_tries_are_tried_too_and_not_told(check):
    def knows_the_examples(angle):
        return rotz(angle) if angle in (0.4, -1.1) else np.eye(3)

    assert check("rot_z", knows_the_examples).right
    said = check("rot_z", knows_the_examples, seed=3)
    assert said.right is False
    assert said.tried == [("rot_z(0.4)", True), ("rot_z(-1.1)", True)]
    assert "For 3 of 4 inputs it is right" in repr(said)
    assert check("rot_z", rotz, seed=3).note == ""


def test_what_a_function_prints_stands_below_the_call_that_it_comes_from(check, capsys):
    def talks(angle):
        sys.stdout.write(f"angle {angle}")
        return rotz(angle)

    assert check("rot_z", talks).right
    assert capsys.readouterr().out == (
        "rot_z(0.4) prints:\nangle 0.4\nrot_z(-1.1) prints:\nangle -1.1\n"
    )
    check("rot_z", talks, seed=1)
    said = capsys.readouterr().out
    assert said.count("rot_z in a further case prints:\n") == 2
    check("rot_z", rotz)
    check("R", rotz(1))
    assert capsys.readouterr().out == ""


def test_what_was_printed_before_an_error_is_shown_too_and_printing_goes_on_as_before(
    check, capsys
):
    def breaks_off(angle):
        sys.stdout.write("so far\n")
        raise ValueError

    check("rot_z", breaks_off)
    sys.stdout.write("after\n")
    lines = capsys.readouterr().out.splitlines()
    assert lines == [
        "rot_z(0.4) prints:", "so far", "rot_z(-1.1) prints:", "so far", "after"
    ]  # fmt: skip


def test_nothing_to_draw_yet_is_said_and_not_raised(check):
    def drawing(R):
        return R(1)

    assert "Nothing to draw yet" in repr(check.show(drawing, ...))

    def stub(angle):
        raise NotImplementedError

    assert "Nothing to draw yet" in repr(check.show(drawing, stub))
    assert "This cannot be drawn yet" in repr(check.show(drawing, fails))
    assert check.show(drawing, lambda angle: "drawn") == "drawn"


class Tags(HTMLParser):
    """All tags of a text."""

    def __init__(self):
        super().__init__()
        self.found = set()

    def handle_starttag(self, tag, attributes):
        self.found.add(tag)


def test_no_answer_puts_live_html_into_the_page(check):
    def attacks(angle):
        raise ValueError("<script>alert(1)</script> `<img src=x onerror=alert(1)>`")

    for said in (check("rot_z", attacks), check("<b onload=x>", 1), check("rot_z", "<i>")):
        tags = Tags()
        tags.feed(said._repr_html_())
        assert tags.found <= {"div", "b", "span", "code", "br"}


def test_damaged_checks_say_where_to_get_others(folder):
    text = packed(load_exercise(folder))
    for damaged in ("", "eNq", text[:-8], text[8:], "§"):
        with pytest.raises(DhlabError, match="is damaged; copy that cell from a fresh copy"):
            checks(damaged)


def test_the_released_notebook_needs_no_files_of_the_exercise(folder, tmp_path):
    cells = json.loads(build(folder).notebook.read_text("utf-8"))["cells"]
    code = ["".join(c["source"]) for c in cells if c["cell_type"] == "code"]
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    run = [sys.executable, "-c", "\n".join([*code, "print(check('rot_z', rot_z))"])]
    done = subprocess.run(run, cwd=elsewhere, capture_output=True, text=True, check=True)
    assert re.search("rot_z: still to be written", done.stdout)
