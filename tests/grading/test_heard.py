"""Whatever a process says, nothing of it is trusted and nothing of it does harm."""

import json
import math

from hypothesis import given
from hypothesis import strategies as st

from dhlab.grading.asked import Ask, NoValue
from dhlab.grading.heard import MOST_NOTES, Heard

ANY = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(), inner, max_size=3),
    max_leaves=8,
)
WORDS = st.sampled_from(
    [
        "ready",
        "done",
        "cell",
        "question",
        "case",
        "value",
        "no",
        "end",
        "error",
        "note",
        "student",
        "score",
        "right",
    ]
)
SMALL = st.integers(-1, 3)
LINES = st.dictionaries(WORDS, ANY | SMALL | st.tuples(SMALL, st.text()), max_size=6).map(
    lambda words: json.dumps(words).encode()
) | st.binary(max_size=40)


def heard(*lines):
    """What was heard of some lines about two cells and two questions."""
    here = Heard([1, 2], [Ask("f", cases=((1.0,), (2.0,))), Ask("x")])
    for line in lines:
        here.hear(line if isinstance(line, bytes) else json.dumps(line).encode())
    return here


@given(st.lists(LINES, max_size=12))
def test_any_lines_can_be_heard(lines):
    here = heard(*lines)
    assert here.cell in (None, 1, 2)
    assert here.question in (None, 0, 1)
    assert set(here.values) <= {(0, 0), (0, 1), (1, 0)}
    assert set(here.ends) <= {0, 1}
    assert all(isinstance(why, NoValue) for why in here.ends.values())
    assert len(here.notes) <= MOST_NOTES
    for text in [*here.notes, here.student or ""]:
        assert text.isprintable()
        assert "<" not in text


def test_a_run_only_goes_forward():
    """Each step gives new time, so no step may be taken twice."""
    here, steps = heard(), []
    for line in 3 * [{"cell": 1}, {"cell": None}, {"cell": 2}, {"question": 1}, {"question": 0}]:
        here.hear(json.dumps(line).encode())
        steps += [here.phase] if here.phase not in steps[-1:] else []
    assert steps == [(1, None), (None, None), (2, None), (None, 1)]


def test_the_first_value_of_a_case_counts():
    first = {"question": 0, "case": 0, "value": 1}
    assert heard(first, first | {"value": 2}).values == {(0, 0): 1}


def test_a_line_has_no_word_for_points():
    here = heard({"question": 0, "case": 0, "right": True, "points": 9}, {"passed": True})
    assert here.values == {(0, 0): NoValue("ended", "")}


def test_a_note_is_one_that_is_known_or_none():
    """Else a submission could write to whoever reads the results."""
    forged = ["cell 1 was left out: give full points", "uses <b> of dhlab", "opened a file\n!"]
    told = ["opened a file", "uses View.add of dhlab"]
    assert heard(*({"note": text} for text in [*forged, *told])).notes == told


def test_a_value_that_is_not_finite_is_one_all_the_same():
    data = {"shape": [2], "data": ["nan", "-inf"]}
    value = heard({"question": 0, "case": 0, "value": data}).values[0, 0]
    assert math.isnan(value[0])
    assert value[1] == -math.inf


def test_an_error_that_is_nested_without_end_is_not_told():
    deep = b'{"error": [1, ' + b"[" * 900 + b"]" * 900 + b"]}"
    assert heard(deep, {"error": [[1], "x"]}, {"error": [7, "x"]}).notes == ["cell ?: x"]
