"""Every notebook in a real JupyterLab: it runs to its end, and each picture shows something."""

import shutil
from pathlib import Path

import numpy as np
import pytest

from .lab import Notebook, Shown

FOLDER = Path(__file__).parents[2] / "notebooks"
NOTEBOOKS = sorted(path.name for path in FOLDER.glob("*.ipynb"))
VIEWS = 'globalThis[Symbol.for("dhlab.page")]?.views ?? []'

RUN_ALL = """async () => {
  await jupyterapp.commands.execute("notebook:run-all-cells");
  return jupyterapp.shell.currentWidget.content.widgets.map((cell) => ({
    source: cell.model.sharedModel.getSource(),
    outputs: cell.model.toJSON().outputs ?? [],
  }));
}"""

TO_CELL = """async (index) => {
  const { content } = jupyterapp.shell.currentWidget;
  content.activeCellIndex = index;
  await content.scrollToItem(index, "start");
}"""

PICTURES = f"""(index) => {{
  const {{ node }} = jupyterapp.shell.currentWidget.content.widgets[index];
  const there = (stage) => node.contains(stage.canvas);
  return ({VIEWS}).flatMap((view, i) =>
    view.stages.flatMap((stage, j) => (there(stage) ? [[i, j]] : [])));
}}"""

REST = """() => {
  for (const player of globalThis[Symbol.for("dhlab.page")].players.values()) {
    player.pause();
    player.seek(player.end);
  }
}"""


def shows_a_picture(cell):
    """Whether the output of a cell, as Jupyter keeps it, is a view or contains one."""
    texts = [str(out.get("data", {}).get("text/plain", "")) for out in cell["outputs"]]
    shown = ("Block", "Robot", "Csys", "Lesson")
    return any("View(" in text or text.startswith(shown) for text in texts)


@pytest.fixture(scope="module", params=NOTEBOOKS)
def notebook(request, lab, browser):
    """A notebook of the repository, run in a page of its own; `cells` is what came out."""
    shutil.copy(FOLDER / request.param, lab.root / request.param)
    page = browser.new_page(viewport={"width": 1440, "height": 900})
    notebook = Notebook(lab, page, request.param)
    notebook.cells = notebook.evaluate(RUN_ALL)
    yield notebook
    page.close()
    lab.stop_kernels()


def test_a_notebook_runs_without_an_error(notebook):
    for k, cell in enumerate(notebook.cells):
        errors = [out for out in cell["outputs"] if out["output_type"] == "error"]
        assert not errors, f"cell {k}: " + "\n".join(errors[0]["traceback"])
    assert not [said for said in notebook.messages if said.startswith("error: dhlab")]


def test_each_picture_of_a_notebook_shows_something(notebook):
    shown = [k for k, cell in enumerate(notebook.cells) if shows_a_picture(cell)]
    assert bool(shown) == (notebook.name != "index.ipynb")
    for k in shown:
        notebook.evaluate(TO_CELL, k)
        notebook.page.wait_for_function(f"(k) => ({PICTURES})(k).length > 0", arg=k, timeout=30_000)
        notebook.evaluate(REST)
        for i, j in notebook.evaluate(PICTURES, k):
            picture = Shown(notebook, "", -1)
            picture.connection = f"({VIEWS})[{i}]"
            picture.stage = f"{picture.connection}.stages[{j}]"
            picture.wait_until("stage.settled", seconds=30)
            pixels = picture.pixels().astype(int)
            background = np.median(pixels, axis=1, keepdims=True)
            drawn = np.abs(pixels - background).max(axis=2) > 60
            assert 0.003 < drawn.mean() < 0.8, f"picture of cell {k}"
