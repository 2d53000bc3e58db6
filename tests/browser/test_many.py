"""Fifty robots and two thousand blocks in one view: built in seconds, moved at a usable rate."""

import numpy as np
import pytest

SETUP = """
from time import perf_counter
import numpy as np
from dhlab import *
from dhlab.view import View
began = perf_counter()
rows = [dh(0.3, 0.2, 0.1, 0)] * 6
robots = [robot(rows, "rrrrrr", name=f"r{k}", base=(k % 10, k // 10, 0)) for k in range(50)]
blocks = [cube(0.1, name=f"b{k}").move((k % 50 / 5, k // 50 / 8, 1)) for k in range(2000)]
view = View("many", height=300, grid=False).add(*robots, *blocks)
"""
BUILT = "view.scene.nodes.size > 2600 && stage.settled"
APPLY = """(() => {
  const times = [];
  const { apply } = view.scene;
  view.scene.apply = function (...given) {
    const began = performance.now();
    apply.apply(this, given);
    times.push(performance.now() - began);
  };
  globalThis.applied = times;
})()"""


@pytest.fixture(scope="module")
def shown(open_notebook):
    notebook = open_notebook(SETUP, "view")
    notebook.run_cell(0)
    notebook.run_cell(1)
    shown = notebook.view("many")
    shown.wait_until(BUILT, seconds=60)
    assert float(notebook.execute("print(perf_counter() - began)")) < 60
    return shown


def moved(shown, code):
    """Let the kernel change something; return how long the page took for each batch [ms]."""
    shown.notebook.execute(code)
    sequence = int(shown.notebook.value("view.widget._wire.sequence"))
    shown.wait_until(f"view.scene.sequence === {sequence} && stage.settled", seconds=60)
    return shown.evaluate("applied.splice(0)")


def test_what_moves_is_moved_soon_however_much_stands_there(shown):
    shown.evaluate(APPLY)
    before = shown.pixels().astype(int)
    one = moved(shown, "for k in range(40):\n    robots[7].q = np.full(6, k / 40); view.flush()")
    every = moved(
        shown,
        "for k in range(20):\n    for r in robots: r.q = np.full(6, k / 20)\n    view.flush()",
    )
    assert len(one) >= 20
    assert np.median(one) < 16
    assert np.median(every) < 33
    for name in ("r7", "r49"):
        tip = shown.notebook.value(f"robots[{name[1:]}].frames()['{name}/6'][:3]")
        assert np.allclose(shown.pose(f"{name}/1/2/3/4/5/6")[:3], tip, atol=1e-6)
    assert (np.abs(shown.pixels() - before).max(axis=-1) > 30).mean() > 0.002
