"""Running cells: what comes back, what is left out, and the limits."""

import itertools
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from dhlab import transl
from dhlab.errors import InputError
from dhlab.grading import runner
from dhlab.grading.asked import Ask
from dhlab.grading.mounts import Room, mounts, package_folders
from dhlab.grading.runner import run_cells
from dhlab.grading.sandbox import Limits, SandboxError, check_sandbox, started

ROOT = Path(__file__).parents[2]
WRITE_TO_JOB = """
wrote = 0
try:
    with open("/proc/1/fd/0", "r+b", 0) as f:
        wrote = f.write(b"x" * 9)
except OSError:
    pass
"""
SHORT = Limits(cpu=2, wall=3)
HALF = "def half(x):\n    return x / 2"


@pytest.fixture
def run(sandbox):
    """A function that runs cells and asks for names."""

    def run(*cells, names=("x",), cases=((),), kind="values", **more):
        asks = [Ask(name, kind, cases) for name in names]
        return run_cells(cells, asks, {"a": [1, 2]}, sandbox=sandbox, limits=SHORT, **more)

    return run


@pytest.fixture
def bwrap(sandbox):
    """Skip where there is no bubblewrap."""
    if sandbox != "bwrap":
        pytest.skip("needs bubblewrap, which does not work here")


@pytest.fixture
def another_bwrap(monkeypatch, tmp_path):
    """A function that puts a script in the place of bubblewrap."""

    def put(script):
        (tmp_path / "bwrap").write_text(f"#!/bin/sh\n{script}\n")
        (tmp_path / "bwrap").chmod(0o755)
        monkeypatch.setenv("PATH", str(tmp_path))

    return put


def test_a_function_is_asked_for_all_its_cases(run):
    replies = run(HALF, names=["half"], cases=((3.0,), (np.array([1.0, 2.0]),))).replies["half"]
    assert replies[0] == 1.5
    np.testing.assert_array_equal(replies[1], [0.5, 1.0])


def test_arguments_come_anew_for_each_case(run):
    spoil = "def f(x):\n    x += 1\n    return x"
    same = np.zeros(2)
    replies = run(spoil, names=["f"], cases=((same,), (same,))).replies["f"]
    np.testing.assert_array_equal(replies, np.ones((2, 2)))
    assert not same.any()


def test_questions_do_not_disturb_each_other(run):
    cells = ["n = 0\ndef f(x):\n    global n\n    n += 1\n    return n", "g = f"]
    done = run(*cells, names=["f", "g"], cases=((1.0,), (1.0,)))
    assert done.replies == {"f": (1, 2), "g": (1, 2)}


def test_a_case_that_fails_does_not_spoil_the_next(run):
    first, second = run(HALF, names=["half"], cases=(("a",), (3.0,))).replies["half"]
    assert first.reason == "raised"
    assert "in the line `return x / 2`" in first.text
    assert second == 1.5


def test_a_plain_value_is_not_called(run):
    assert run("x = 3").replies["x"] == (3,)
    assert run("def x():\n    return 3").replies["x"][0].reason == "not numbers"


def test_the_numbers_of_the_student_are_there(run):
    cells = ["from dhlab.grading import checks", "x = checks('e').numbers('Bob')['a']"]
    done = run(*cells)
    np.testing.assert_array_equal(done.replies["x"][0], [1.0, 2.0])
    assert done.student == "Bob"


@pytest.mark.parametrize(
    ("kind", "answer", "fields"),
    [
        ("robot", "robot([dh(0, 0.5, 0, 0)], 'r', name='arm')", {"rows", "joints", "frames"}),
        ("scene", "View('v').add(csys(name='A'), csys(transl([1, 0, 0]), name='B'))", {"A", "B"}),
        ("scene", "[csys(name='A')]", {"A"}),
    ],
)
def test_answers_of_the_library_leave_as_plain_data(run, kind, answer, fields):
    cells = [
        "from dhlab import View, csys, dh, robot, transl\nfrom dhlab.grading import checks",
        "check = checks('e')\nview = View('mine').add(*check.picture('one'))",
        f"x = {answer}",
    ]
    done = run(*cells, kind=kind)
    assert done.notes == ()
    assert fields <= done.replies["x"][0].keys()


def test_what_judges_and_solves_is_not_there_beside_the_library(run, bwrap):
    looks = "import os, dhlab\nhere = os.path.dirname(dhlab.__file__)\nx = []"
    counts = "for n in ('grading', 'diagnosis', 'exercises', 'kinematics'):\n    x.append(n * "
    counts += "(os.path.isdir(f'{here}/{n}') and bool(os.listdir(f'{here}/{n}'))))"
    done = run(looks, counts, names=["x"], kind="csys")
    assert done.replies["x"] == (["", "", "", "kinematics"],)


def test_both_kinds_of_questions_are_asked_of_one_notebook(sandbox):
    cells = ["from dhlab import csys, transl", "x = 1", "A = csys(transl([1, 2, 3]))"]
    done = run_cells(cells, [Ask("A", "csys"), Ask("x")], {}, sandbox=sandbox)
    assert list(done.replies) == ["A", "x"]
    np.testing.assert_allclose(done.replies["A"][0], transl([1, 2, 3]))
    assert done.replies["x"] == (1,)


@pytest.mark.parametrize(("library", "runs"), [(True, 1), (False, 2)])
def test_cells_run_twice_only_where_a_value_must_not_have_the_library(
    library, runs, sandbox, monkeypatch
):
    rooms = []
    monkeypatch.setattr(
        runner, "started", lambda *job: rooms.append(job[-1].library) or started(*job)
    )
    cells = ["import dhlab", "A = dhlab.csys((1, 2, 3))", "x = dhlab.transl((1, 2, 3))[0, 3]"]
    asks = [Ask("A", "csys"), Ask("x", library=library)]
    done = run_cells(cells, asks, {}, sandbox=sandbox)
    np.testing.assert_allclose(done.replies["A"][0], transl([1, 2, 3]))
    assert (done.replies["x"] == (1,)) == library
    assert len(rooms) == runs


def test_panels_beside_the_library_do_nothing_and_load_nothing(run):
    cells = [
        "from dhlab import Panel, dh, robot, show, side_by_side",
        "arm = robot([dh(0, 0.5, 0, 0)], 'r')\npanel = Panel(arm)",
        "side_by_side(show(arm), panel)\npanel.width = 3",
        "import sys\nx = [sum(name in sys.modules for name in ('ipywidgets', 'IPython'))]",
    ]
    done = run(*cells, kind="csys")
    assert (done.replies["x"], done.notes) == (([0],), ())


def test_nothing_of_dhlab_is_compiled_in_a_sandbox(run, bwrap):
    """There it could not be kept, and each submission would pay for it."""
    cells = [
        "import os, sys, dhlab",
        "dhlab.show(dhlab.csys())",
        "there = [m for n, m in sys.modules.items() if n.startswith('dhlab.')]",
        "x = [os.path.exists(m.__cached__) for m in there if getattr(m, '__cached__', None)]",
    ]
    compiled = run(*cells, kind="csys").replies["x"][0]
    assert len(compiled) > 20
    assert all(compiled)


def test_the_time_for_everything_is_limited(sandbox):
    limits = Limits(cpu=5, wall=3, whole=4)
    cells = [f"import time\ntime.sleep(2.9)  # {k}" for k in range(4)]
    done = run_cells([*cells, "x = 1"], [Ask("x")], {}, sandbox=sandbox, limits=limits)
    assert done.replies["x"][0].reason == "too slow"
    assert done.seconds < 15


def test_a_value_is_exact_to_the_last_bit(run):
    values = np.random.default_rng(1).normal(size=(50, 4)) * 10.0 ** np.arange(-8, 0, 2)
    done = run("def f(x):\n    return x", names=["f"], cases=((values,),))
    np.testing.assert_array_equal(done.replies["f"][0], values)


def test_a_sandbox_that_is_not_known_is_refused():
    with pytest.raises(InputError, match="no sandbox 'docker'; use 'bwrap' or 'none'"):
        run_cells(["x = 1"], [Ask("x")], {}, sandbox="docker")


def test_without_bubblewrap_nothing_runs(monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(SandboxError, match=r"no bubblewrap here.*the sandbox 'none'"):
        run_cells([f"open({str(tmp_path / 'ran')!r}, 'w')"], [Ask("x")], {})
    assert not list(tmp_path.iterdir())


def test_a_bubblewrap_that_does_not_work_is_told(another_bwrap):
    another_bwrap("echo 'No permissions to create new namespace' >&2\nexit 1")
    with pytest.raises(SandboxError, match="No permissions to create new namespace"):
        run_cells(["x = 1"], [Ask("x")], {})


def test_a_sandbox_that_did_not_begin_once_begins_again(bwrap, another_bwrap, tmp_path):
    real, failed = shutil.which("bwrap"), tmp_path / "failed"
    another_bwrap(f'[ -e {failed} ] || {{ : > {failed}; exit 137; }}\n{real} "$@"')
    assert run_cells(["x = 1"], [Ask("x")], {}).replies["x"] == (1,)
    assert failed.exists()


def test_a_sandbox_that_ends_without_a_word_is_told(another_bwrap):
    another_bwrap("exit 137")
    with pytest.raises(SandboxError, match="does not work here: it ended with the status 137"):
        run_cells(["x = 1"], [Ask("x")], {})


def test_no_other_system_has_the_sandbox(monkeypatch):
    monkeypatch.setattr(sys, "platform", "darwin")
    with pytest.raises(SandboxError, match="needs Linux, this is darwin"):
        check_sandbox("bwrap")
    check_sandbox("none")


def test_the_sandbox_shows_no_folder_of_this_project():
    shown = list(mounts(Room()))
    sources = {Path(b) for a, b in itertools.pairwise(shown) if a == "--ro-bind"}
    inside = [path for path in sources if path.is_relative_to(ROOT) and ".venv" not in path.parts]
    assert inside == [ROOT / "dhlab" / "grading" / "inside"]


@pytest.mark.parametrize("protected", ["bwrap", "none"])
def test_without_the_rights_of_root_it_works_too_beside_many_programs(bwrap, protected):
    if os.getuid() != 0 or shutil.which("setpriv") is None:
        pytest.skip("is for root, who can become somebody else")
    nobody = ["setpriv", "--reuid", "65534", "--regid", "65534", "--clear-groups"]
    env = {"PYTHONPATH": os.pathsep.join([str(ROOT), *package_folders(Room())])}

    def as_nobody(python, code):
        command = [*nobody, python, "-c", code]
        return subprocess.run(
            command, capture_output=True, text=True, check=False, cwd="/", env=os.environ | env
        )

    can = "import numpy, psutil, pathlib, sys; pathlib.Path(sys._base_executable).resolve(True)"
    pythons = [p for p in (sys.executable, "/usr/bin/python3") if not as_nobody(p, can).returncode]
    if not pythons:
        pytest.skip("no Python here can be used by everybody")
    done = as_nobody(
        pythons[0],
        "import subprocess\n"
        "from dhlab.grading.asked import Ask\nfrom dhlab.grading.runner import run_cells\n"
        "others = [subprocess.Popen(['sleep', '600']) for _ in range(40)]\n"
        f"cells = ['import os', {WRITE_TO_JOB!r}, 'x = [os.getuid(), wrote]']\n"
        f"run = run_cells(cells, [Ask('x')], {{}}, sandbox={protected!r})\n"
        "for other in others:\n    other.kill()\n"
        "print(*run.replies['x'][0])",
    )
    assert done.stdout == "65534.0 0.0\n", done.stderr
