"""An exercise in a real JupyterLab: blank, written wrong, written right."""

import json
import shutil
from pathlib import Path

import numpy as np
import pytest

from dhlab import rotz

from .lab import Notebook
from .test_notebooks import RUN_ALL

EXERCISE = Path(__file__).parents[2] / "exercises" / "01_rotation_matrices"
NOTEBOOK = EXERCISE / "01_rotation_matrices.ipynb"
CELLS = [cell["id"] for cell in json.loads(NOTEBOOK.read_text("utf-8"))["cells"]]

WRITE = """([index, source]) => {
  const { content } = jupyterapp.shell.currentWidget;
  content.model.cells.get(index).sharedModel.setSource(source);
}"""

SAID = """(index) => {
  const { node } = jupyterapp.shell.currentWidget.content.widgets[index];
  return node.querySelector("[role=status]")?.innerText;
}"""

FOLDED = """(index) => jupyterapp.shell.currentWidget.content.widgets[index].inputHidden"""

ANSWER = """def rot_z(angle):
    c, s = cos({sign}angle), sin({sign}angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
"""


@pytest.fixture(scope="module")
def notebook(lab, browser):
    """The released notebook, run blank in a page of its own."""
    shutil.copy(NOTEBOOK, lab.root / NOTEBOOK.name)
    page = browser.new_page(viewport={"width": 1440, "height": 900})
    notebook = Notebook(lab, page, NOTEBOOK.name)
    notebook.cells = notebook.evaluate(RUN_ALL)
    yield notebook
    page.close()
    lab.stop_kernels()


def said(notebook, cell):
    """Run a cell; return what its box says in the page."""
    notebook.run_cell(CELLS.index(cell))
    found = f"(index) => ({SAID})(index) !== undefined"
    notebook.page.wait_for_function(found, arg=CELLS.index(cell), timeout=30_000)
    return notebook.evaluate(SAID, CELLS.index(cell))


def write(notebook, sign):
    """Write an answer into its cell and run it."""
    notebook.evaluate(WRITE, [CELLS.index("rot-z"), ANSWER.format(sign=sign)])
    notebook.run_cell(CELLS.index("rot-z"))


def test_a_blank_notebook_runs_to_its_end_and_hints(notebook):
    outputs = [out for cell in notebook.cells for out in cell["outputs"]]
    assert not [out for out in outputs if out["output_type"] == "error"]
    assert notebook.evaluate(FOLDED, CELLS.index("checks"))
    assert "rot_z: still to be written" in said(notebook, "rot-z-check")
    assert "Nothing to draw yet" in said(notebook, "rot-z-yours")


def test_a_wrong_answer_is_explained_and_drawn_where_it_is(notebook):
    write(notebook, "-")
    text = said(notebook, "rot-z-check")
    assert "rot_z: not right yet" in text
    assert "goes the wrong way round" in text
    notebook.run_cell(CELLS.index("rot-z-yours"))
    view = notebook.view()
    view.wait_until("view.scene.paths.has('yours')", seconds=30)
    np.testing.assert_allclose(view.pose("yours")[:3, :3], rotz(np.radians(-50)), atol=1e-6)


def test_the_right_answer_is_right_at_once(notebook):
    write(notebook, "")
    assert said(notebook, "rot-z-check").startswith("✓ rot_z: right")
