"""What an answer becomes on its way from a student's code to a judgement."""

import json
import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from dhlab import View, csys, cube, dh, models, robot, robot_complex, transl
from dhlab.grading.asked import NoValue
from dhlab.grading.inside import plain
from dhlab.grading.inside.plain import NotPlain
from dhlab.grading.values import from_json, no_value, to_json

FLOATS = st.floats()
LEAVES = st.none() | st.booleans() | FLOATS | st.text(st.characters(categories=["L", "N"]))
JSON = st.recursive(
    LEAVES | st.integers(),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(), inner, max_size=4),
    max_leaves=20,
)


def travelled(value, kind="values"):
    """The value after its way through text."""
    return from_json(plain.loads(json.dumps(to_json(value, kind), allow_nan=False)))


@given(arrays.arrays(np.float64, arrays.array_shapes(min_dims=0, max_dims=4, min_side=0)))
def test_an_array_comes_back_as_it_was(array):
    np.testing.assert_array_equal(travelled(array), array)


@given(FLOATS)
def test_a_number_comes_back_as_it_was(x):
    came = travelled(x)
    assert came == x or (math.isnan(came) and math.isnan(x))


@given(st.dictionaries(st.text(st.characters(categories=["L"]), max_size=9), LEAVES))
def test_a_mapping_comes_back_as_it_was(mapping):
    np.testing.assert_equal(travelled(mapping), mapping)


@pytest.mark.parametrize(
    ("value", "comes"),
    [
        ([[1, 0], [0, 1]], np.eye(2)),
        ((1, Fraction(1, 2)), np.array([1, 0.5])),
        ([dh(0, 1, 2, 3)], np.array([[0.0, 1, 2, 3]])),
        ([np.eye(2), np.eye(2)], np.array([np.eye(2)] * 2)),
        (np.array([True, False]), np.array([1.0, 0.0])),
        (np.array([2 + 0j]), np.array([2.0])),
        (np.float32(0.5), 0.5),
        (np.array([[1, 2]]).view(np.matrix), np.array([[1.0, 2.0]])),
        (np.ma.masked_array([1.0, 2.0], [False, False]), np.array([1.0, 2.0])),
        (7, 7),
        (True, True),
        (None, None),
        ([], np.empty(0)),
        (["r", "p"], ["r", "p"]),
        ([[1, 2], [3]], [np.array([1.0, 2.0]), np.array([3.0])]),
        (10**40, 1e40),
    ],
)
def test_what_is_made_of_numbers_comes_as_floats(value, comes):
    came = travelled(value)
    assert type(came) is type(comes)
    np.testing.assert_equal(came, comes)


def nested(depth):
    """A list in a list in a list."""
    return [nested(depth - 1)] if depth else []


@pytest.mark.parametrize(
    ("value", "reason", "text"),
    [
        ({1, 2}, "not numbers", "a set"),
        (lambda: 0, "not numbers", "a function"),
        ([1, object()], "not numbers", "a object"),
        (b"bytes", "not numbers", "a bytes"),
        (1 + 2j, "not numbers", "complex"),
        ({1: 2}, "not numbers", "names are not text but int"),
        (10**400, "not numbers", "beyond all measure"),
        (np.zeros(100_001), "too large", "100,000 numbers"),
        ([[0.0] * 60_000, [0.0] * 50_000], "too large", "100,000 numbers"),
        ("x" * 1001, "too large", "1,000 letters"),
        (nested(9), "too large", "lists in lists"),
    ],
)
def test_anything_else_is_refused(value, reason, text):
    with pytest.raises(NotPlain, match=text) as caught:
        to_json(value)
    assert caught.value.reason == reason


def test_a_list_that_holds_itself_is_refused():
    endless = []
    endless.append(endless)
    with pytest.raises(NotPlain, match="lists in lists"):
        to_json(endless)


class AlwaysRight(np.ndarray):
    """An array that says it equals everything."""

    def __eq__(self, other):
        return True

    __hash__ = None


def test_a_class_of_the_student_stays_behind():
    came = travelled(np.eye(2).view(AlwaysRight))
    assert type(came) is np.ndarray
    assert not (came == np.zeros((2, 2))).all()


@given(JSON)
def test_whatever_strict_json_holds_is_a_value_or_refused(value):
    line = json.dumps(value)
    try:
        read = plain.loads(line)
    except NotPlain:
        return
    from_json(read)


@pytest.mark.parametrize(
    "line",
    [
        "NaN",
        '{"shape": [1], "data": [Infinity]}',
        '{"a": 1, "a": 2}',
        "[" * 100_000,
        '{"a":' * 100_000,
        "9" * 1_000_000,
        b"\xff\xfe",
        "",
        "1 2",
        "{'a': 1}",
    ],
)
def test_what_is_no_strict_json_is_refused(line):
    with pytest.raises(NotPlain, match="no strict JSON"):
        plain.loads(line)


@pytest.mark.parametrize(
    ("line", "reason"),
    [
        ("1e999", "not numbers"),
        ("9" * 4000, "not numbers"),
        ('{"shape": [2], "data": [1]}', "not numbers"),
        ('{"shape": [-1], "data": [1]}', "not numbers"),
        ('{"shape": [true], "data": [1]}', "not numbers"),
        ('{"shape": [0, 100000000000000], "data": []}', "not numbers"),
        ('{"shape": "ab", "data": [1, 2]}', "not numbers"),
        ('{"shape": [1], "data": [[1]]}', "not numbers"),
        ('{"shape": [1], "data": [true]}', "not numbers"),
        ('{"shape": [1], "data": ["Infinity"]}', "not numbers"),
        ('{"shape": [1,1,1,1,1,1,1,1,1], "data": [1]}', "not numbers"),
        ("[" * 9 + "]" * 9, "too large"),
        (json.dumps([0] * 100_001), "too large"),
        (json.dumps("x" * 1001), "too large"),
    ],
)
def test_a_forged_line_is_no_value(line, reason):
    came = from_json(plain.loads(line))
    assert isinstance(came, NoValue)
    assert came.reason == reason


def test_a_text_is_never_live_html_and_holds_no_half_letters():
    assert from_json("<b>\ud800\u202e\x00é") == "\u2039b\u203aé"
    assert no_value("raised", "<script>\n" + "x" * 999).text == (
        "\u2039script\u203a " + "x" * 188 + "..."
    )


def test_a_reason_that_is_not_known_is_ended():
    assert no_value("passed", "10 of 10") == NoValue("ended", "10 of 10")


def test_a_robot_is_its_table():
    arm = robot([dh(0, 0, 0.4, 0), dh(1, 0.1, 0, 0)], "rr", name="arm", grasper=(0.4, 0, 0))
    arm.q = [0.3, -0.6]
    came = travelled(arm, "robot")
    assert came["joints"] == "rr"
    assert came["convention"] == "modified"
    np.testing.assert_allclose(came["rows"], [[0, 0, 0.4, 0], [1, 0.1, 0, 0]])
    np.testing.assert_allclose(came["grasper"], transl([0.4, 0, 0]))
    np.testing.assert_allclose(came["q"], [0.3, -0.6])
    np.testing.assert_allclose(came["frames"]["arm/grasper"], arm.frames()["arm/grasper"])
    assert "components" not in came


def test_a_complex_robot_lists_its_components():
    limb = models.upper_limb()
    came = travelled(limb, "robot")
    assert [c["name"] for c in came["components"]] == [c.name for c in limb.components]
    assert came["q"].shape == (27,)
    pair = robot_complex(robot([dh(0, 0, 0, 0)], "r", name="a"), robot([dh(0, 0, 0, 0)], "r"))
    assert [len(c["rows"]) for c in travelled(pair, "robot")["components"]] == [1, 1]


def test_a_csys_is_its_pose():
    np.testing.assert_allclose(travelled(csys(transl([1, 2, 3])), "csys"), transl([1, 2, 3]))
    np.testing.assert_allclose(travelled(transl([1, 2, 3]), "csys"), transl([1, 2, 3]))


def test_a_scene_is_its_poses_by_name(monkeypatch):
    monkeypatch.setenv("DHLAB_VIEW", "record")
    frame, box = csys(transl([1, 2, 3]), name="A"), cube(1, name="box")
    arm = robot([dh(0, 0.5, 0, 0)], "r", name="arm")
    listed = travelled([frame, box, arm], "scene")
    assert list(listed) == ["A", "box", "arm", "arm/1", "arm/grasper"]
    np.testing.assert_allclose(listed["A"], transl([1, 2, 3]))
    view = View("scene").add(frame, box, arm)
    np.testing.assert_equal(travelled(view, "scene"), listed)
    np.testing.assert_equal(travelled(frame, "scene"), {"A": listed["A"]})


@pytest.mark.parametrize(
    ("kind", "value", "text"),
    [
        ("robot", [[0, 0, 0, 0]], "a list is no robot"),
        ("scene", "A", "a str is no view"),
        ("scene", [1], "a int is no handle"),
    ],
)
def test_what_is_not_of_the_kind_is_refused(kind, value, text):
    with pytest.raises(NotPlain, match=text):
        to_json(value, kind)
