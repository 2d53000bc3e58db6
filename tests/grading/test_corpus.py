"""Every submission of the corpus gets what it deserves and does no harm."""

import json
import os
import socket
import uuid
from dataclasses import asdict

import psutil
import pytest

from dhlab.grading.exercise import exercise_from_text
from dhlab.grading.mark import mark_cells
from dhlab.grading.sandbox import Limits
from tests.broken_files import TRICKS, UNREADABLE
from tests.submission_corpus import CHECKS, CORPUS, POINTS, filled

EXERCISE = exercise_from_text(CHECKS, "corpus", tools=("rp2t",))
SHORT = Limits(cpu=1, wall=2, memory=3 * 2**28)
LIVE = ("<", "SECRET", "checks.py", "dh.py", "T = [[", "wrote /")
"""What nothing that is told may hold: markup, and what was found where it was forbidden."""


@pytest.fixture
def outside(tmp_path):
    """A folder that anybody may write to, with somebody's secret in it."""
    folder = tmp_path / "outside"
    folder.mkdir()
    (folder / "secret").write_text("T = [[1, 0], [0, 1]]")
    folder.chmod(0o777)
    return folder


@pytest.fixture
def listener():
    """Somebody who listens on this machine."""
    with socket.create_server(("127.0.0.1", 0)) as server:
        server.setblocking(False)
        yield server


def processes_with(mark):
    """Processes of this machine whose command holds a mark."""
    commands = ((p, p.info["cmdline"] or ()) for p in psutil.process_iter(["cmdline"]))
    return [process for process, command in commands if any(mark in word for word in command)]


def test_the_corpus_has_all_sorts_and_at_least_sixty_bad_ones():
    assert {one.sort for one in CORPUS.values()} == {"good", "wrong", "crash", "cheat", "hostile"}
    bad = [name for name, one in CORPUS.items() if one.sort != "good"]
    assert len([*bad, *UNREADABLE, *TRICKS]) >= 60


@pytest.mark.parametrize("name", CORPUS)
def test_a_submission_gets_what_it_deserves_and_does_no_harm(
    name, outside, listener, monkeypatch, sandbox
):
    one, mark = CORPUS[name], f"left-by-{uuid.uuid4().hex}"
    if one.needs_sandbox and sandbox == "none":
        pytest.skip("needs bubblewrap, which does not work here")
    monkeypatch.setenv("WORD_OF_THE_GRADER", "SECRET")
    words = {"OUTSIDE": outside, "PORT": listener.getsockname()[1], "MARK": mark}
    cells = [filled(cell, words) for cell in one.cells]

    marked = mark_cells(
        EXERCISE, "Ada", cells, seed=7, course="robots", sandbox=sandbox, limits=SHORT
    )

    for question in marked.questions:
        assert question.reason in one.gets[question.name].split(" or "), question.text
    assert marked.points == sum(POINTS[q.name] for q in marked.questions if q.reason == "right")
    assert (marked.status, marked.left_out) == (one.status, one.left_out)
    assert any(one.noted in note for note in [*marked.notes, ""])
    told = json.dumps(asdict(marked), ensure_ascii=False, allow_nan=False)
    told.encode("utf-8")
    assert not [word for word in LIVE if word in told]
    assert os.listdir(outside) == ["secret"]
    assert not processes_with(mark)
    with pytest.raises(BlockingIOError):
        listener.accept()
