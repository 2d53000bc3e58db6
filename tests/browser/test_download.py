"""What the buttons of a view save."""

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from .test_view import ORANGE, SETUP, near


@pytest.fixture(scope="module")
def notebook(open_notebook):
    notebook = open_notebook(SETUP, "named = View('Öl&b: c', height=300).add(box)\nnamed")
    notebook.run_cell(0)
    notebook.run_cell(1)
    return notebook


def saved(shown, action):
    """Name and path of the file that a button saves."""
    with shown.notebook.page.expect_download(timeout=20_000) as downloading:
        shown.click(action)
    download = downloading.value
    return download.suggested_filename, Path(download.path())


def test_a_button_saves_the_present_picture(notebook):
    shown = notebook.view("Öl&b: c")
    notebook.execute("box.move((0.1, 0, 0)); named.flush()")
    shown.wait_until("view.pose('box')[3] > 0.09")
    shown.settle()
    name, path = saved(shown, "save")
    assert name == "Öl_b_ c.png"
    picture = np.asarray(Image.open(path).convert("RGB"))
    seen = shown.pixels()
    assert picture.shape == seen.shape
    assert np.abs(picture.astype(int) - seen).mean() < 0.5
    assert near(picture, ORANGE).mean() > 0.02


def test_a_key_saves_the_picture_too(notebook):
    shown = notebook.view("Öl&b: c")
    shown.evaluate("stage.element.focus()")
    with notebook.page.expect_download(timeout=20_000):
        notebook.page.keyboard.press("8")


def test_the_buttons_fit_into_a_narrow_view(notebook):
    shown = notebook.view("Öl&b: c")
    box = """(() => {
        stage.element.style.width = "220px";
        const bar = stage.element.querySelector(".dhlab-toolbar").getBoundingClientRect();
        const { left, right } = stage.element.getBoundingClientRect();
        stage.element.style.width = "";
        return [bar.left - left, right - bar.right];
    })()"""
    assert min(shown.evaluate(box)) >= 0
