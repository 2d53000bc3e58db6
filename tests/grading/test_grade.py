"""A class marked from what was handed in to the files of results; on processes, killed, on Dask."""

import csv
import json
import os
import re
import signal
import subprocess
import sys
import time
import zipfile
from dataclasses import replace
from pathlib import Path

import psutil
import pytest

from dhlab.errors import DhlabError
from dhlab.grading.check import packed
from dhlab.grading.exercise import exercise_from_text
from dhlab.grading.grade import Order, grade
from dhlab.grading.journal import UNFINISHED
from dhlab.grading.sandbox import SandboxError
from tests.broken_files import TRICKS, UNREADABLE, write_tricks
from tests.grading.classroom import (
    CHECKS,
    NAME,
    NAMES,
    SETUP,
    answered,
    notebook,
    write_class,
    write_exercise,
)

pytestmark = pytest.mark.skipif(os.name != "posix", reason="answers are marked on Linux or macOS")
ROOT = Path(__file__).parents[2]


class Heard:
    """Remembers what was told of the progress."""

    def __init__(self):
        self.told = []

    def __call__(self, done, total, known):
        self.told.append((done, total, known))

    @property
    def known(self):
        """How many were marked before."""
        return self.told[-1][2]


def order(folder, **options):
    """Order to mark the class in a folder."""
    exercise, source = folder / "exercises" / NAME, folder / "class"
    options = {"course": "robots", "sandbox": "none", "workers": 2} | options
    return Order(exercise, source, folder / "results", **options)


def grades(folder):
    """Student -> row of grades.csv."""
    with (folder / "results" / "grades.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert len({row["student_id"] for row in rows}) == len(rows)
    return {row["student_id"]: row for row in rows}


SCORES = {
    "right": 3, "order": 2, "order and sign": 0, "sign": 1, "degrees": 1,
    "empty": 0, "raises": 1, "shape": 0, "unreadable": 0,
}  # fmt: skip


def check_class(folder, kinds):
    """Each student has one row, one feedback and the points of their answers."""
    rows = grades(folder)
    assert set(rows) == set(kinds)
    assert {s: rows[s]["score"] for s in kinds} == {s: str(SCORES[kinds[s]]) for s in kinds}
    for student, kind in kinds.items():
        unreadable = kind == "unreadable"
        assert (rows[student]["status"] == "unreadable") == unreadable
        assert bool(rows[student]["reason"]) == unreadable
    for part, ending in (("feedback", ".md"), ("gradescope", ".json")):
        files = (folder / "results" / part).iterdir()
        assert {path.name.removesuffix(ending) for path in files} == set(kinds)
    assert not (folder / "results" / UNFINISHED).exists()


@pytest.fixture(scope="module")
def marked(tmp_path_factory):
    """A class of forty that was marked once: folder, kinds of answers, results."""
    folder = tmp_path_factory.mktemp("marked")
    write_exercise(folder)
    kinds = write_class(folder / "class")
    return folder, kinds, grade(order(folder, seed=7))


def test_a_class_of_forty_gets_what_its_answers_are_worth(marked):
    folder, kinds, results = marked
    assert len(kinds) > 40
    check_class(folder, kinds)
    assert [row.student for row in results.rows] == sorted(kinds, key=str.casefold)


@pytest.mark.parametrize("kind", UNREADABLE)
def test_a_file_that_cannot_be_read_is_a_row_that_says_why(marked, kind):
    row = next(row for row in marked[2].rows if row.student == kind.title())
    assert (row.status, row.points) == ("unreadable", 0)
    assert re.search(UNREADABLE[kind][1], row.reason)


def test_the_results_hold_every_case_and_the_seed(marked):
    folder, _, _ = marked
    document = json.loads((folder / "results" / "results.json").read_text("utf-8"))
    assert document["seed"] == 7
    ada = next(s for s in document["students"] if s["student"] == "Ada Lovelace")
    assert len(ada["sha256"]) == 64
    assert len(ada["details"]["cases"]["rot_z"]) == 6
    assert all({"arguments"} < set(case) for case in ada["details"]["cases"]["rot_z"])


def test_the_page_counts_the_mistakes_of_the_class(marked):
    folder, kinds, _ = marked
    page = (folder / "results" / "class.html").read_text("utf-8")
    for words in ("the factors are multiplied in the reverse order", "taken for degrees"):
        assert words in page
    assert all(student in page for student in kinds)


def test_feedback_names_the_mistake_and_no_number_of_a_hidden_case(marked):
    folder, kinds, results = marked
    student = next(s for s, kind in kinds.items() if kind == "degrees")
    text = (folder / "results" / "feedback" / f"{student}.md").read_text("utf-8")
    assert "angles in radians are taken for degrees" in text
    row = next(row for row in results.rows if row.student == student)
    for case in row.details["cases"]["rot_z"][2:]:
        for number in (*case["arguments"], *case["value"]["data"]):
            assert number in (0.0, 1.0) or f"{abs(number):.4f}"[:5] not in text


def test_what_was_marked_is_not_marked_again(marked):
    folder, kinds, before = marked
    heard = Heard()
    again = grade(order(folder), heard)
    assert heard.known == sum(kind != "unreadable" for kind in kinds.values())
    assert (again.run, again.rows) == (before.run, before.rows)
    check_class(folder, kinds)


@pytest.fixture
def few(tmp_path):
    """Three students, marked once."""
    write_exercise(tmp_path)
    (tmp_path / "class").mkdir()
    for student, kind in (("ada", "right"), ("bob", "sign"), ("eve", "order")):
        (tmp_path / "class" / f"{student}.ipynb").write_text(answered(student, kind))
    grade(order(tmp_path, seed=7))
    return tmp_path


def marked_again(folder, **options):
    """How many were marked in one more run."""
    heard = Heard()
    results = grade(order(folder, **options), heard)
    return len(results.rows) - heard.known


def test_a_changed_submission_is_marked_anew(few):
    (few / "class" / "bob.ipynb").write_text(answered("bob", "right"))
    assert marked_again(few) == 1
    assert grades(few)["bob"]["score"] == "3"


@pytest.mark.parametrize("options", [{"seed": 8}, {"course": "other"}])
def test_another_seed_or_course_marks_everybody_anew(few, options):
    assert marked_again(few, **options) == 3
    assert marked_again(few, **options) == 0


def test_a_changed_exercise_marks_everybody_anew(few):
    path = few / "exercises" / NAME / "checks.py"
    path.write_text(CHECKS.replace("points=2", "points=5"))
    assert marked_again(few) == 3
    assert grades(few)["ada"]["score"] == "6"


def test_another_tool_for_answers_marks_everybody_anew(few):
    (few / "exercises" / NAME / "exercise.py").write_text("# %%\nfrom dhlab import rotz\n")
    assert marked_again(few) == 3
    assert marked_again(few) == 0


def test_who_has_left_leaves_no_feedback_behind(few):
    (few / "class" / "eve.ipynb").rename(few / "class" / "zoe.ipynb")
    (few / "results" / "feedback" / "mine.txt").write_text("the instructor's own")
    marked_again(few)
    assert set(grades(few)) == {"ada", "bob", "zoe"}
    names = {path.name for path in (few / "results" / "feedback").iterdir()}
    assert names == {"ada.md", "bob.md", "zoe.md", "mine.txt"}


def test_who_is_on_the_list_and_handed_in_nothing_has_a_row(few):
    (few / "list.csv").write_text("ada\nbob\nlost\n")
    marked_again(few, people=few / "list.csv")
    rows = grades(few)
    assert rows["lost"]["status"] == "missing"
    assert rows["eve"]["notes"] == "Not on the list of students."
    marked_again(few)
    assert rows["eve"]["score"] == "2"
    assert grades(few)["eve"]["notes"] == ""


@pytest.fixture
def known_by_ids(tmp_path):
    """A class of four in nbgrader's layout, whose notebooks have names; one is a neighbour's.

    The answers are typed in numbers, as the student of that name has them.
    """
    exercise = exercise_from_text(CHECKS, NAME)
    write_exercise(tmp_path)
    names = {"al1": "Ada Lovelace", "cb2": "Ada Lovelace", "gh3": "Grace Hopper", "nn4": ""}
    for student, name in names.items():
        (tmp_path / "class" / student / NAME).mkdir(parents=True)
        path = tmp_path / "class" / student / NAME / f"{NAME}.ipynb"
        angle = exercise.numbers(name, "robots")["angle"]
        path.write_text(answered(name).replace("given['angle']", str(angle)))
    return tmp_path


def looked_at(rows):
    """Student -> score and status."""
    return {student: (row["score"], row["status"]) for student, row in rows.items()}


def test_a_right_answer_has_its_point_however_the_submission_is_named(known_by_ids):
    grade(order(known_by_ids))
    rows = grades(known_by_ids)
    assert looked_at(rows) == {
        "al1": ("3", "graded"),
        "cb2": ("3", "graded"),
        "gh3": ("3", "graded"),
        "nn4": ("2", "second look"),
    }
    whose = "The numbers are those of '{}', whom the notebook names; the submission is that of "
    assert rows["gh3"]["notes"] == whose.format("Grace Hopper") + "'gh3'."
    twice = "2 submissions name 'Ada Lovelace'. "
    assert all(rows[s]["notes"].startswith(twice) for s in ("al1", "cb2"))
    grade(order(known_by_ids))
    assert grades(known_by_ids) == rows


def test_a_list_that_says_otherwise_goes_before_the_notebook(known_by_ids):
    people = known_by_ids / "list.csv"
    people.write_text("id,name\nal1,Ada Lovelace\ncb2,Charles Babbage\ngh3,Hopper Grace\n")
    grade(order(known_by_ids, people=people))
    rows = grades(known_by_ids)
    assert looked_at(rows) == {
        "al1": ("3", "graded"),
        "cb2": ("2", "second look"),
        "gh3": ("3", "graded"),
        "nn4": ("2", "second look"),
    }
    assert rows["cb2"]["reason"] == (
        "the notebook names 'Ada Lovelace'; its answers were compared with those for "
        "'Charles Babbage'."
    )
    assert all("2 submissions name" in rows[s]["notes"] for s in ("al1", "cb2"))
    assert rows["gh3"]["notes"] == ""


def test_a_list_of_ids_says_nothing_of_names(known_by_ids):
    (known_by_ids / "list.csv").write_text("al1\ncb2\ngh3\nnn4\n")
    grade(order(known_by_ids, people=known_by_ids / "list.csv"))
    assert grades(known_by_ids)["gh3"]["score"] == "3"


def other_checks(text, name="07_dh_link"):
    """A notebook with the checks of another exercise in it."""
    other = packed(exercise_from_text(CHECKS, name))
    return text.replace('checks(\\"\\"', f'checks(\\"{other}\\"')


def test_a_notebook_of_another_exercise_is_told_and_not_marked(few):
    (few / "class" / "bob.ipynb").write_text(other_checks(answered("bob").replace("R_own", "T")))
    (few / "class" / "eve.ipynb").write_text(
        other_checks(notebook(SETUP.format(name="eve"), "dh_link = 1"))
    )
    for _ in range(2):
        marked_again(few)
        rows = grades(few)
        assert rows["eve"]["status"] == "unreadable"
        assert rows["eve"]["reason"] == "This is a notebook of '07_dh_link', not of '01_turns'."
        assert (rows["bob"]["score"], rows["bob"]["status"]) == ("2", "second look")
        assert rows["bob"]["reason"] == (
            "The notebook has the checks of '07_dh_link', not those of '01_turns'."
        )
        assert rows["ada"]["status"] == "graded"


def test_an_archive_gives_the_same_as_its_folder(few):
    before = grades(few)
    with zipfile.ZipFile(few / "class.zip", "w") as archive:
        for path in (few / "class").iterdir():
            archive.write(path, f"class/{path.name}")
    other = Order(
        few / "exercises" / NAME, few / "class.zip", few / "results", 7, "robots", sandbox="none"
    )
    grade(other)
    assert grades(few) == before


def test_an_archive_of_tricks_gives_each_student_a_row_and_nobody_else_less(few):
    write_tricks(few / "tricks.zip", answered("good").encode())
    exercise = few / "exercises" / NAME
    before = sorted(few.rglob("*"))
    found = grade(Order(exercise, few / "tricks.zip", few / "other", 7, "robots", sandbox="none"))
    rows = {row.student: row for row in found.rows}
    assert set(rows) == {"good", *TRICKS}
    assert (rows["good"].status, rows["good"].points) == ("graded", 3)
    for student, words in TRICKS.items():
        assert (rows[student].status, rows[student].points) == ("unreadable", 0)
        assert words in rows[student].reason
    assert sorted(p for p in few.rglob("*") if few / "other" not in (p, *p.parents)) == before


def test_marks_of_other_submissions_are_not_replaced(few):
    before = (few / "results" / "results.json").read_bytes()
    (few / "late").mkdir()
    (few / "late" / "zoe.ipynb").write_text(answered("zoe"))
    late = Order(few / "exercises" / NAME, few / "late", few / "results", sandbox="none")
    said = re.escape(
        f"{str(few / 'results')!r} holds the marks of '01_turns' for {str(few / 'class')!r}; those "
        f"of '01_turns' for {str(few / 'late')!r} would take their place: name another --out"
    )
    with pytest.raises(DhlabError, match=said):
        grade(late)
    for name in ("ada", "bob", "eve"):  # the same students, another attempt
        (few / "late" / f"{name}.ipynb").write_text(answered(name, "degrees"))
    with pytest.raises(DhlabError, match=said):
        grade(late)
    assert (few / "results" / "results.json").read_bytes() == before
    assert set(grades(few)) == {"ada", "bob", "eve"}
    assert {row.student for row in grade(replace(late, out=few / "new")).rows} >= {"zoe", "ada"}


def test_marks_of_another_exercise_are_not_replaced(few):
    other = replace(order(few), exercise=few / "exercises" / "02_others")
    with pytest.raises(DhlabError, match=r"holds the marks of '01_turns' for .*'02_others' for"):
        grade(other)


def test_submissions_that_have_moved_are_known_again(few):
    (few / "class" / "none.ipynb").write_bytes(b"")
    assert marked_again(few) == 1
    (few / "class").rename(few / "moved")
    moved = replace(order(few), source=few / "moved")
    heard = Heard()
    assert len(grade(moved, heard).rows) == heard.known + 1 == 4


def test_results_may_lie_among_the_submissions(few):
    inside = Order(
        few / "exercises" / NAME, few / "class", few / "class" / "results", 7, "robots",
        sandbox="none", workers=1,
    )  # fmt: skip
    for _ in range(2):
        assert len(grade(inside).rows) == 3


def bad_orders(folder):
    """Words of the error -> what is ordered."""
    exercise, source, out = folder / "exercises" / NAME, folder / "class", folder / "new"
    broken = folder / "broken"
    broken.mkdir()
    (broken / "checks.py").write_text("def questions(given):\n    return [1 / 0]\n")
    cases = folder / "cases"
    cases.mkdir()
    (cases / "checks.py").write_text(CHECKS.replace("rng.uniform(-3, 3, 3)", "rng.none"))
    (folder / "empty").mkdir()
    (folder / "foreign").mkdir()
    (folder / "foreign" / "results.json").write_text("{}")
    return {
        "is no exercise: there is no checks.py": Order(folder, source, out),
        "checks.py, line 2: ZeroDivisionError": Order(broken, source, out),
        "checks.py, line [0-9]+: AttributeError": Order(cases, source, out),
        "there is no folder or archive": Order(exercise, folder / "none", out, sandbox="none"),
        "there is no submission in": Order(exercise, folder / "empty", out, sandbox="none"),
        "the results cannot go into": Order(exercise, source, source),
        "the list of students '.*' cannot be read": Order(exercise, source, out, people=out / "x"),
        "is not a file of results": Order(exercise, source, folder / "foreign"),
    }


def test_what_cannot_be_done_is_one_sentence_and_nothing_is_written(few):
    for words, wanted in bad_orders(few).items():
        with pytest.raises(DhlabError, match=words):
            grade(wanted)
        assert not (few / "new").exists()


def without_bwrap(folder, monkeypatch):
    """Take bubblewrap away."""
    monkeypatch.setenv("PATH", str(folder))


def with_a_bwrap_that_fails(folder, monkeypatch):
    """Put in its place one that does not work, as where user namespaces are shut."""
    (folder / "bin").mkdir()
    bwrap = folder / "bin" / "bwrap"
    bwrap.write_text(
        "#!/bin/sh\necho 'bwrap: No permissions to create new namespace' >&2\nexit 1\n"
    )
    bwrap.chmod(0o755)
    monkeypatch.setenv("PATH", f"{folder / 'bin'}{os.pathsep}{os.environ['PATH']}")


@pytest.mark.parametrize("hinder", [without_bwrap, with_a_bwrap_that_fails])
def test_without_a_working_sandbox_nobody_is_marked(few, monkeypatch, hinder):
    hinder(few, monkeypatch)
    with pytest.raises(SandboxError, match="sandbox"):
        grade(Order(few / "exercises" / NAME, few / "class", few / "new"))
    assert not (few / "new").exists()


def test_in_the_sandbox_the_class_gets_the_same(marked, sandbox):
    if sandbox == "none":
        pytest.skip("needs bubblewrap, which does not work here")
    folder, kinds, before = marked
    exercise, out = folder / "exercises" / NAME, folder / "boxed"
    boxed = grade(Order(exercise, folder / "class", out, 7, "robots", workers=2))
    assert {row.student: row.points for row in boxed.rows} == {
        row.student: row.points for row in before.rows
    }
    assert set(kinds) == {row.student for row in boxed.rows}


def rows_written(path):
    """How many rows an unfinished run has written."""
    return max(0, path.read_bytes().count(b"\n") - 1) if path.exists() else 0


def wait_until(true, seconds=120):
    """Wait for something that must come."""
    end = time.monotonic() + seconds
    while not true():
        assert time.monotonic() < end, "waited in vain"
        time.sleep(0.02)


def test_a_run_that_is_killed_goes_on_and_leaves_no_process(tmp_path):
    check_goes_on(tmp_path, signal.SIGKILL, -signal.SIGKILL)


def test_a_run_that_is_interrupted_goes_on_and_leaves_no_process(tmp_path):
    said = check_goes_on(tmp_path, signal.SIGINT, 130)
    assert said == "\ndhlab: interrupted; the same command goes on from here\n"


def check_goes_on(folder, how, code):
    """End a run in its middle, see what is left, and let it go on; return what it said."""
    exercise = write_exercise(folder)
    (folder / "class").mkdir()
    for name in NAMES:
        (folder / "class" / f"{name}.ipynb").write_text(answered(name))
    command = [sys.executable, "-m", "dhlab", "grade", str(exercise), str(folder / "class")]
    command += ["--out", str(folder / "results"), "--course", "robots", "--sandbox", "none"]
    env = os.environ | {"PYTHONPATH": str(ROOT)}
    journal = folder / "results" / UNFINISHED
    process = subprocess.Popen(
        command, env=env, cwd=folder, stderr=subprocess.PIPE, text=True, start_new_session=True
    )
    try:
        wait_until(lambda: rows_written(journal) >= 3 or process.poll() is not None)
        os.killpg(process.pid, signal.SIGSTOP)  # so that it does not end while it is looked at
        started = psutil.Process(process.pid).children(recursive=True)
    finally:
        send = os.killpg if how == signal.SIGINT else os.kill  # Ctrl-C is heard by all
        send(process.pid, how)
        os.killpg(process.pid, signal.SIGCONT)
        _, said = process.communicate(timeout=120)
    there = rows_written(journal)
    assert process.returncode == code, said
    assert 3 <= there < len(NAMES), "ended before its end"
    assert len(grades(folder)) >= there - 1
    _, alive = psutil.wait_procs(started, timeout=60)
    assert not [p for p in alive if p.status() != psutil.STATUS_ZOMBIE]
    heard = Heard()
    results = grade(order(folder), heard)
    assert heard.known >= 3
    assert {row.student for row in results.rows} == set(NAMES)
    assert {row["score"] for row in grades(folder).values()} == {"3"}
    return said


@pytest.mark.filterwarnings("ignore")
def test_a_dask_cluster_of_several_workers_gives_the_same(marked, monkeypatch):
    distributed = pytest.importorskip("distributed")
    folder, kinds, before = marked
    monkeypatch.setenv("PYTHONPATH", str(ROOT))
    worked = set()

    class Watch(distributed.SchedulerPlugin):
        def transition(self, key, start, finish, *_, worker=None, **options):
            if finish == "memory" and worker:
                worked.add(worker)

    with distributed.LocalCluster(
        n_workers=3, threads_per_worker=1, dashboard_address=None, local_directory=str(folder)
    ) as cluster:
        cluster.scheduler.add_plugin(Watch())
        other = Order(
            folder / "exercises" / NAME, folder / "class", folder / "dask", 7, "robots",
            dask=cluster.scheduler_address, sandbox="none",
        )  # fmt: skip
        results = grade(other)
    assert len(worked) > 1
    assert {row.student: row.points for row in results.rows} == {
        row.student: row.points for row in before.rows
    }
    assert set(kinds) == {row.student for row in results.rows}


def test_a_scheduler_that_is_not_there_is_one_sentence(few):
    pytest.importorskip("distributed")
    with pytest.raises(DhlabError, match="there is no Dask scheduler at 'nowhere'"):
        grade(order(few, dask="nowhere"))
