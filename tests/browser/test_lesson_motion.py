"""A lesson's motions in a real page: stops, scrubbing, ghosts, all without asking the kernel."""

import numpy as np
import pytest

PAGE = 'globalThis[Symbol.for("dhlab.page")]'
PLAYER = f"[...{PAGE}.players.values()].find((player) => player.stops.length)"
SETUP = """
from dhlab import *
A, B = csys(name="A"), csys((0.5, 0, 0), name="B")
arm = models.scara()
lesson = Lesson("Moves", [
    Step("turn", "", turn(B, "z", 90 * deg)),
    Step("note", "nothing moves"),
    Step("both", "", slide(B, (1, 0, 0.5)), configure(arm, arm.clip([0.5, -0.7, 0.05, 0.3]))),
    Step("about A", "", turn(B, (1, 1, 0), 120 * deg, about=A)),
], handles=[A], keep=1)
main = View("main", height=420).add(*lesson.handles)
"""


@pytest.fixture(scope="module")
def shown(open_notebook):
    notebook = open_notebook(SETUP, "main")
    notebook.run_cell(0)
    notebook.run_cell(1)
    shown = notebook.view("main")
    shown.wait_until(f"{PLAYER} !== undefined && view.scene.paths.has('B')")
    shown.notebook = notebook
    return shown


def place(shown, k):
    """Go to step k in the page alone, and come to rest there."""
    shown.evaluate(f"{PLAYER}.goTo({k})")
    shown.wait_until(f"{PLAYER}.at === {k} && !{PLAYER}.playing")


def python_pose(shown, k):
    return np.array(shown.notebook.value(f"lesson.timeline.states[{k}][B]"))


def test_it_stands_at_the_start_and_does_not_play_by_itself(shown):
    shown.notebook.execute("lesson.go(0); main.flush()")
    shown.wait_until(f"{PLAYER}.time === 0 && !{PLAYER}.playing")
    assert np.allclose(shown.pose("B"), python_pose(shown, 0), atol=1e-6)
    assert shown.evaluate("stage.playerBar.element.hidden")


@pytest.mark.parametrize("k", [4, 1, 3, 0, 2])
def test_poses_are_python_s_at_every_stop_in_any_order(shown, k):
    place(shown, k)
    assert np.allclose(shown.pose("B"), python_pose(shown, k), atol=1e-6)
    frame = shown.notebook.value(f"arm.frames(lesson.timeline.states[{k}][arm])['scara/3']")
    path = next(path for path in shown.paths() if path.endswith("/1/2/3"))
    assert np.allclose(shown.pose(path), frame, atol=1e-6)


def test_a_step_is_played_to_its_end_and_can_be_scrubbed(shown):
    place(shown, 0)
    shown.evaluate(f"{PLAYER}.playTo(1)")
    shown.wait_until(f"{PLAYER}.time > 0.2 && {PLAYER}.playing")
    shown.wait_until(f"{PLAYER}.time === {PLAYER}.stops[1] && !{PLAYER}.playing")
    assert np.allclose(shown.pose("B"), python_pose(shown, 1), atol=1e-6)
    shown.evaluate(f"{PLAYER}.seek({PLAYER}.stops[1] / 2)")
    half = np.array(shown.pose("B")).reshape(4, 4)
    assert np.allclose(half[:2, :2], np.sqrt(0.5) * np.array([[1, -1], [1, 1]]), atol=1e-2)
    assert np.allclose(half[:3, 3], (0.5, 0, 0), atol=1e-6)


def test_ghosts_arcs_and_arrows_are_seen_only_with_their_step(shown):
    def seen(path):
        return shown.evaluate(f"stage.tree.group('{path}').visible")

    for k, expected in [
        (0, [0, 0, 0]),
        (1, [1, 0, 0]),
        (3, [0, 1, 0]),
        (4, [0, 1, 1]),
        (0, 3 * [0]),
    ]:
        place(shown, k)
        paths = ["B.lesson/1.way", "B.lesson/3.ghost", "B.lesson/4.way.head"]
        assert [seen(path) for path in paths] == [bool(x) for x in expected]
    shown.evaluate(f"{PLAYER}.seek(0.5 * {PLAYER}.stops[1])")
    count = "view.scene.nodes.get(view.scene.paths.get('B.lesson/1.way'))"
    assert (
        0
        < shown.evaluate(f"{count}.shown.count")
        < shown.evaluate(f"{count}.shape.segments.length / 6")
    )


def test_the_kernel_plays_the_next_step_and_jumps_to_any_other(shown):
    shown.notebook.execute("lesson.go(0); main.flush()")
    shown.wait_until(f"{PLAYER}.at === 0 && {PLAYER}.time === 0")
    shown.notebook.execute("lesson.go(1); main.flush()")
    shown.wait_until(f"{PLAYER}.at === 1 && {PLAYER}.time === {PLAYER}.stops[1]")
    shown.notebook.execute("lesson.go(4); main.flush()")
    shown.wait_until(f"{PLAYER}.at === 4 && {PLAYER}.time === {PLAYER}.stops[4]")
    assert np.allclose(shown.pose("B"), python_pose(shown, 4), atol=1e-6)


def test_a_page_that_has_gone_further_is_not_called_back(shown):
    shown.notebook.execute("lesson.go(1); main.flush()")
    shown.wait_until(f"{PLAYER}.at === 1")
    place(shown, 3)
    shown.notebook.execute("lesson.follow(2); main.flush()")
    sequence = shown.evaluate("view.scene.sequence")
    shown.notebook.execute("A.size = 0.9; main.flush()")
    shown.wait_until(f"view.scene.sequence > {sequence}")
    assert shown.evaluate(f"{PLAYER}.at") == 3
    assert np.allclose(shown.pose("B"), python_pose(shown, 3), atol=1e-6)


def test_a_reloaded_page_shows_the_step_that_python_is_at(shown):
    shown.notebook.execute("lesson.go(3); main.flush()")
    shown.notebook.execute("fresh = View('fresh', height=300).add(*lesson.handles)\nlesson.go(2)")
    shown.notebook.run_cell(1)
    shown.wait_until(f"{PLAYER}.at === 2")
    assert np.allclose(shown.pose("B"), python_pose(shown, 2), atol=1e-6)
