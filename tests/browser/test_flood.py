"""A hundred thousand changes in a loop: few messages, the newest state last, memory flat."""

import pytest

from .test_graphics import heap

SETUP = """
import gc, threading, psutil
from time import perf_counter
from dhlab import *
from dhlab.view import View
arm = robot([dh(0, 0.2, 0, 0)] * 6, "rrrrrr", name="arm", q=[0.0] * 6)
box = cube(0.1, name="box")
view = View("flood", height=260, grid=False).add(arm, box)

def used():
    gc.collect()
    return psutil.Process().memory_info().rss / 1e6

def turn(first, last):
    q = [0.0] * 6
    for k in range(first, last):
        q[k % 6] = k * 1e-5
        arm.q = q

def slide(first, last):
    for k in range(first, last):
        box.move((k * 1e-5, 0, 0))

def flood(*jobs):
    "Do the jobs at once, the first in this thread; seconds and messages that it takes."
    before, began = view.widget._wire.sequence, perf_counter()
    others = [threading.Thread(target=work, args=span) for work, span in jobs[1:]]
    for other in others: other.start()
    work, span = jobs[0]
    work(*span)
    for other in others: other.join()
    took = perf_counter() - began
    print(took, view.widget._wire.sequence - before)
"""
ONE = "flood((turn, (1, 100_001)))"
TWO = "flood((turn, (1, 50_001)), (slide, (1, 50_001)))"


@pytest.fixture(scope="module")
def notebook(open_notebook):
    notebook = open_notebook(SETUP, "view")
    notebook.run_cell(0)
    notebook.run_cell(1)
    notebook.view("flood").wait_until("view.scene.nodes.size > 6")
    return notebook


def measured(notebook, code):
    """Let the kernel do `code`; return its seconds and messages, and memory gained [MB]."""
    page, kernel = heap(notebook.page), float(notebook.value("used()"))
    took, messages = map(float, notebook.execute(code).split())
    shown = notebook.view("flood")
    sequence = int(notebook.value("(view.flush(), view.widget._wire.sequence)[1]"))
    shown.wait_until(f"view.scene.sequence === {sequence}", seconds=30)
    shown.wait_until("stage.settled", seconds=30)
    gained = heap(notebook.page) - page, float(notebook.value("used()")) - kernel
    return took, messages, *gained


def assert_newest(notebook):
    """The page has what Python has: the joints' values and the box."""
    shown = notebook.view("flood")
    q = notebook.value("arm.q").tolist()
    joints = "[...view.scene.nodes.values()].filter(n => n.joint).map(n => n.shown.value)"
    assert shown.evaluate(joints) == q
    x = float(notebook.value("box.pose[0, 3]"))
    assert shown.pose("box")[0, 3] == pytest.approx(x, abs=1e-6)


@pytest.mark.parametrize("slow", [1, 6], ids=["as it is", "page six times slower"])
@pytest.mark.parametrize("code", [ONE, TWO], ids=["one thread", "two threads"])
def test_a_flood_of_changes_is_few_messages_and_ends_in_the_newest_state(notebook, code, slow):
    client = notebook.page.context.new_cdp_session(notebook.page)
    client.send("Emulation.setCPUThrottlingRate", {"rate": slow})
    notebook.execute("arm.q = [0.5] * 6; box.move((0, 0, 0)); turn(1, 2000); slide(1, 2000)")
    took, messages, page, kernel = measured(notebook, code)
    client.send("Emulation.setCPUThrottlingRate", {"rate": 1})
    client.detach()
    assert_newest(notebook)
    assert messages <= 61 * took + 2
    assert page < 4
    assert kernel < 8
