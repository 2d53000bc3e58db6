"""Kernels that are killed, restarted or shut down, and connections that are lost and come back."""

import os
import signal

import pytest

from .test_motion import PLAYERS, joint
from .test_view import SETUP, same_poses

ARM = """
import os, threading, time
arm = robot([dh(0, 0, 0.2, 0), dh(pi/2, 0, 0, 0.3)], "rr", name="arm", limits=[(-3, 3), (-3, 3)])
main = View("main", height=320, grid=False).add(arm)
"""
MEANWHILE = """
def work():
    time.sleep(1)
    for k in range(60):
        arm.q = [k / 100, 0.5]
        time.sleep(0.01)
    main.add(cube(0.1, name="late"))
    arm.set(q=[1, 0.5], color="#d55e00")

worker = threading.Thread(target=work)
worker.start()
"""
ENDED = "Run the cell again"
SESSION = "jupyterapp.shell.currentWidget.sessionContext"


class Line:
    """The connection of one page to its kernel: it can be cut and mended."""

    def __init__(self, page):
        self.whole = True
        self.ends = []
        page.route_web_socket("**/channels*", self.connect)

    def connect(self, socket):
        if self.whole:
            self.ends += [socket.connect_to_server(), socket]
        else:
            socket.close()

    def cut(self):
        self.whole = False
        for end in self.ends:
            end.close()
        self.ends.clear()

    def mend(self):
        self.whole = True


@pytest.fixture(scope="module")
def notebook(open_notebook):
    """A notebook whose `line` can be cut."""
    notebook = open_notebook(SETUP + ARM, "main")
    notebook.line = Line(notebook.page)
    notebook.open()
    return notebook


@pytest.fixture
def shown(notebook):
    """The view after a run of the notebook from its beginning."""
    for index in range(2):
        notebook.run_cell(index)
    shown = notebook.view("main")
    shown.wait_until("view.scene.nodes.size > 3 && stage.ended.hidden")
    return shown


def test_a_kernel_killed_while_a_motion_plays_leaves_the_motion_and_a_sentence(notebook, shown):
    number = int(notebook.execute("print(os.getpid())"))
    notebook.execute(
        "animate(np.linspace(0, 3, 31), {arm: lambda t: [t / 3, t / 3]}); main.flush()"
    )
    shown.wait_until(f"{joint(1)} > 0.1")
    os.kill(number, signal.SIGKILL)
    assert shown.evaluate(f"{joint(1)} < 0.9")
    shown.wait_until(f"{joint(1)} === 1 && !{PLAYERS}[0].playing", seconds=30)
    shown.wait_until("!stage.ended.hidden", seconds=30)
    assert ENDED in shown.evaluate("stage.ended.textContent")
    notebook.page.locator(".jp-Dialog button.jp-mod-accept").click(timeout=30_000)
    shown.evaluate(f"{PLAYERS}[0].seek(1.5)")
    assert shown.evaluate(joint(1)) == pytest.approx(0.5)
    notebook.page.wait_for_function(f"{SESSION}.session?.kernel?.status === 'idle'", timeout=60_000)


def test_after_a_restart_the_cells_run_again_show_the_new_kernel_s_scene(notebook, shown):
    notebook.execute("arm.q = [1, 1]; main.flush()")
    notebook.evaluate(f"() => {SESSION}.restartKernel()")
    shown.wait_until("!stage.ended.hidden", seconds=30)
    for index in range(2):
        notebook.run_cell(index)
    again = notebook.view("main")
    again.wait_until("stage.ended.hidden && view.scene.nodes.size > 3")
    notebook.execute("arm.q = [0.5, -0.5]; main.flush()")
    again.wait_until(f"{joint(1)} === 0.5")
    assert same_poses(again) < 1e-9
    assert notebook.evaluate("() => document.querySelectorAll('.dhlab-view').length") == 1


def test_a_kernel_that_is_shut_down_is_told_too_and_one_that_is_only_busy_is_not(notebook, shown):
    notebook.execute("time.sleep(1)")
    notebook.evaluate(f"() => {SESSION}.session.kernel.interrupt()")
    assert shown.evaluate("stage.ended.hidden")
    notebook.evaluate(f"() => {SESSION}.shutdown()")
    shown.wait_until("!stage.ended.hidden", seconds=30)
    notebook.evaluate(f"() => {SESSION}.changeKernel({{ name: 'python3' }})")
    notebook.page.wait_for_function(f"{SESSION}.session?.kernel?.status === 'idle'", timeout=60_000)


@pytest.mark.parametrize("windows", [1, 2])
def test_a_connection_that_was_lost_and_comes_back_shows_what_came_meanwhile(
    open_notebook, notebook, shown, windows
):
    other = open_notebook(name=notebook.name) if windows == 2 else None
    notebook.execute(MEANWHILE)
    notebook.line.cut()
    notebook.page.wait_for_timeout(2500)
    assert not shown.evaluate("view.scene.paths.has('late')")
    notebook.line.mend()
    shown.wait_until(f"view.scene.paths.has('late') && {joint(1)} === 1", seconds=60)
    notebook.page.wait_for_function(
        f"{SESSION}.session?.kernel?.connectionStatus === 'connected'", timeout=60_000
    )
    assert shown.evaluate("stage.ended.hidden")
    assert same_poses(shown) < 1e-6
    notebook.execute("arm.q = [0.25, 0.5]; main.flush()")
    shown.wait_until(f"{joint(1)} === 0.25")
    if other is not None:
        other.page.close()
