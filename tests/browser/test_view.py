"""Views in a real JupyterLab: what three.js has and what the canvas shows."""

import pytest


@pytest.fixture(scope="module")
def notebook(open_notebook):
    notebook = open_notebook(
        "import numpy as np\nfrom dhlab import *\n"
        "c = cube(0.2, name='c')\nview = View('main', height=400).add(c)\nview",
    )
    notebook.run_cell(0)
    return notebook


def test_a_view_draws_its_scene(notebook):
    shown = notebook.view("main")
    shown.settle()
    pixels = shown.pixels()
    notebook.page.screenshot(path="/tmp/vb/lab.png")
    assert pixels.shape[0] == 400
