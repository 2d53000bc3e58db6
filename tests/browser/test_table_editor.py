"""The table editor in a real page: typing moves the picture, mistakes are explained, keys."""

import numpy as np
import pytest

SETUP = """
from dhlab import *
table = [dh(0, 0, 0.4, 0.4), dh(90*deg, 0.25, 0, 0.6), dh(0, 0.7, 0, -0.8)]
arm = robot(table, "rrr", name="arm", grasper=(0.5, 0, 0), opacity=0.6, show_csys=True)
view = View("arm", height=440).add(arm)
editor = TableEditor(arm)
"""


@pytest.fixture(scope="module")
def notebook(open_notebook):
    notebook = open_notebook(SETUP, "side_by_side(view, editor)", width=1440, height=900)
    notebook.run_cell(0)
    notebook.run_cell(1)
    notebook.page.wait_for_selector(".dhlab-tables input")
    return notebook


def cell(notebook, row, name):
    return notebook.page.locator(f'.dhlab-tables input[aria-label="row {row}, {name}"]')


def test_typing_moves_the_picture_and_draws_the_dimension(notebook):
    shown = notebook.view("arm")
    shown.wait_until("view.scene.paths.has('arm/1/2/3')")
    cell(notebook, 2, "a").click()
    shown.wait_until("view.scene.paths.has('arm/1/a')")
    notebook.page.keyboard.type("0.5")
    notebook.page.keyboard.press("Tab")
    shown.wait_until("Math.abs(view.pose('arm/1/2')[11] - 0.4) < 1e-6 && view.scene.sequence > 1")
    notebook.page.wait_for_function(
        "() => document.querySelector('.dhlab-tables button[data-action=undo]').disabled === false"
    )
    expected = notebook.value("arm.frames()['arm/3']")
    assert notebook.value("arm.chain.rows[1].a") == 0.5
    assert np.allclose(shown.pose("arm/1/2/3"), expected, atol=1e-6)
    label = notebook.execute("print(arm.dimensions)")
    assert "2, 'd'" in label


def test_a_wrong_input_is_explained_and_changes_nothing(notebook):
    before = notebook.value("arm.frames()['arm/3']")
    box = cell(notebook, 2, "alpha")
    box.click()
    notebook.page.keyboard.type("ninety")
    notebook.page.keyboard.press("Enter")
    notebook.page.wait_for_selector('.dhlab-tables input[aria-invalid="true"]')
    note = notebook.page.locator(".dhlab-tables-note").inner_text()
    assert note.startswith("Row 2, α: 'ninety' is no number; type degrees")
    assert np.array_equal(notebook.value("arm.frames()['arm/3']"), before)
    box.click()
    notebook.page.keyboard.type("90")
    notebook.page.keyboard.press("Enter")
    notebook.page.wait_for_function(
        "() => document.querySelector('.dhlab-tables [aria-invalid]') === null"
    )
    assert cell(notebook, 3, "alpha").evaluate("(cell) => document.activeElement === cell")


def test_undo_gives_the_table_back_and_code_moves_the_cells(notebook):
    notebook.page.locator('.dhlab-tables button[data-action="undo"]').click()
    notebook.page.wait_for_timeout(300)
    notebook.page.locator('.dhlab-tables button[data-action="undo"]').click()
    box = cell(notebook, 2, "a")
    notebook.page.wait_for_function(
        "() => document.querySelector('.dhlab-tables input[aria-label=\"row 2, a\"]').value"
        " === '0.25'"
    )
    notebook.execute("arm.chain = arm.chain.replace(2, a=0.33)")
    notebook.page.wait_for_function(
        "() => document.querySelector('.dhlab-tables input[aria-label=\"row 2, a\"]').value"
        " === '0.33'"
    )
    assert box.input_value() == "0.33"
