"""Reading the code of a notebook out of whatever bytes came."""

import contextlib
import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhlab.errors import InputError
from dhlab.grading.reading import read_notebook
from tests.broken_files import UNREADABLE, notebook

GOOD = notebook("a = 1", ["b = 2\n", "c = 3"])


def test_code_cells_come_in_order_and_nothing_else():
    assert read_notebook(GOOD).cells == ("a = 1", "b = 2\nc = 3")
    assert read_notebook(GOOD).notes == ()


@pytest.mark.parametrize("nbformat", [4, 99, None, "four"])
def test_the_version_that_a_file_claims_does_not_count(nbformat):
    assert read_notebook(notebook("a = 1", nbformat=nbformat)).cells == ("a = 1",)


def test_version_3_is_read():
    cells = [
        {"cell_type": "code", "input": ["a = 1\n", "b = 2"], "language": "python"},
        {"cell_type": "heading", "source": "no code"},
    ]
    old = {"nbformat": 3, "worksheets": [{"cells": cells}, {"cells": cells[:1]}], "metadata": {}}
    assert read_notebook(json.dumps(old).encode()).cells == ("a = 1\nb = 2",) * 2


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16"])
def test_marks_of_an_encoding_are_understood(encoding):
    text = json.dumps(json.loads(notebook("gruß = 'ü'")), ensure_ascii=False)
    assert read_notebook(text.encode(encoding)).cells == ("gruß = 'ü'",)


def test_latin_1_is_read_and_noted():
    text = json.dumps(json.loads(notebook("gruß = 'ü'")), ensure_ascii=False)
    read = read_notebook(text.encode("latin-1"))
    assert read.cells == ("gruß = 'ü'",)
    assert read.notes == ("The file is not UTF-8; it was read as Latin-1.",)


def test_cells_given_twice_stay_twice():
    assert read_notebook(notebook("a = 1", "a = 1")).cells == ("a = 1", "a = 1")


@pytest.mark.parametrize(
    ("spec", "note"),
    [
        ({"name": "python3", "language": "python"}, None),
        ({"name": "conda-env-robots-py", "language": "python"}, None),
        ({"name": "python3"}, None),
        ({}, None),
        ({"name": "ir", "language": "R"}, "another kernel ('R')"),
        ({"name": "julia-1.9"}, "the kernel 'julia-1.9'"),
        ("python3", None),
    ],
)
def test_another_kernel_is_noted_and_read(spec, note):
    read = read_notebook(notebook("a = 1", kernelspec=spec))
    assert read.cells == ("a = 1",)
    assert (not read.notes) if note is None else (note in read.notes[0])


def test_a_huge_saved_output_does_not_matter():
    big = json.loads(GOOD)
    big["cells"][1]["outputs"] = [{"output_type": "stream", "text": "x" * 5_000_000}]
    assert read_notebook(json.dumps(big).encode()).cells == ("a = 1", "b = 2\nc = 3")


def test_halves_of_characters_are_replaced():
    assert read_notebook(
        rb'{"cells": [{"cell_type": "code", "source": "a = \"\ud83d\""}]}'
    ).cells == ('a = "?"',)


def test_cells_that_are_none_are_passed_over():
    odd = {"cells": [1, None, "text", {"cell_type": "code", "source": 5}, {}, [{}]]}
    read = read_notebook(json.dumps(odd).encode())
    assert read.cells == ()
    assert read.notes == (
        "A code cell without a text was passed over.",
        "The notebook holds no code cell.",
    )


@pytest.mark.parametrize("kind", UNREADABLE)
def test_what_cannot_be_read_is_one_phrase(kind):
    content, words = UNREADABLE[kind]
    with pytest.raises(InputError, match=words):
        read_notebook(content)


@given(st.binary(max_size=300) | st.integers(0, len(GOOD)).map(lambda n: GOOD[:n]))
def test_no_bytes_raise_anything_else(content):
    try:
        read = read_notebook(content)
    except InputError:
        return
    assert all(isinstance(cell, str) for cell in read.cells)


json_values = st.recursive(
    st.none() | st.booleans() | st.floats(allow_nan=False) | st.text(max_size=5),
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(
            st.sampled_from(
                ["cells", "source", "cell_type", "worksheets", "metadata", "kernelspec"]
            ),
            inner | st.just("code"),
            max_size=4,
        )
    ),
    max_leaves=12,
)


@given(json_values)
def test_no_json_raises_anything_else(value):
    with contextlib.suppress(InputError):
        assert read_notebook(json.dumps(value).encode()).cells is not None
