"""Every notebook in a real JupyterLab: it runs, twice over, and its pictures show something."""

import json
from pathlib import Path

import numpy as np
import pytest

from .lab import PAGE

ROOT = Path(__file__).parents[2] / "notebooks"
NOTEBOOKS = {path.stem: path for path in sorted(ROOT.glob("*.ipynb"))}


def code_of(path):
    """Text of the code cells of a notebook file."""
    cells = json.loads(path.read_text("utf-8"))["cells"]
    return ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]


def drawn(pixels):
    """Share of the picture that stands out from the background of its row."""
    rows = np.median(pixels, axis=1, keepdims=True)
    return (np.abs(pixels - rows).max(axis=2) > 25).mean()


@pytest.mark.parametrize("name", [name for name, path in NOTEBOOKS.items() if code_of(path)])
def test_a_notebook_runs_and_its_pictures_are_not_blank(open_notebook, name):
    cells = code_of(NOTEBOOKS[name])
    notebook = open_notebook(*cells, width=1300)
    for index in range(len(cells)):
        notebook.run_cell(index)
    views = notebook.evaluate(f"() => {PAGE}.views.map((view) => view.name)")
    assert views
    for view in set(views):
        shown = notebook.view(view)
        shown.wait_until("stage.settled", seconds=60)
        assert drawn(shown.pixels()) > 0.005, f"the picture of {view!r} is blank"
    errors = [said for said in notebook.messages if said.startswith("error: dhlab")]
    assert not errors


def test_the_limb_s_notebook_runs_twice_over_and_keeps_no_more_open(open_notebook):
    cells = code_of(NOTEBOOKS["12_upper_limb"])
    notebook = open_notebook(*cells, width=1300)
    open_views = []
    for _ in range(2):
        for index in range(len(cells)):
            notebook.run_cell(index)
        open_views.append(notebook.views())
    assert open_views[1] <= open_views[0] + 1
    limb = notebook.view("limb")
    frames = notebook.value("limb.frames()['arm/hand/index/4']")
    path = next(path for path in limb.paths() if path.endswith("hand/index/1/2/3/4"))
    limb.wait_until("!view.scene.players.some((player) => player.playing)", seconds=60)
    np.testing.assert_allclose(limb.pose(path), frames, atol=1e-6)
