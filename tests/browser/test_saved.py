"""Notebooks saved with their widgets' state, opened again with a kernel that knows nothing."""

import json
from base64 import b64decode
from io import BytesIO

import nbformat
import numpy as np
import pytest
from PIL import Image

from dhlab import models
from dhlab.panel.living import LivingExporter

from .test_panel import Sliders
from .test_view import ORANGE, near

SETUP = """
import numpy as np
from dhlab import Panel, View, animate, cube, models, polyline, side_by_side
limb = models.upper_limb()
gone = cube(0.1, name="gone")
box = cube(0.1, name="box", pose=(0.4, 0.4, 0))
view = View("limb").add(limb, gone); panel = Panel(limb)
side_by_side(view, panel)
"""
CHANGE = """
limb.set(q=limb.clip(limb.home + 0.3), dimensions=1)
line = polyline([(0, 0, 0), (0.3, 0, 0), (0.3, 0.2, 0)], name="line")
view.add(box, line)
view.remove(gone)
box.set(color="#d55e00", edges=False)
view.flush(); panel.flush()
"""
MOVE = """
q0, q1 = limb.q, limb.home
moving = animate(np.linspace(0, 1, 11), {limb: lambda t: q0 + t * (q1 - q0)}, delay=0.01)
view.flush()
"""
TOGGLE = "() => jupyterapp.commands.execute('@jupyter-widgets/jupyterlab-manager:saveWidgetState')"
KEPT = "application/vnd.jupyter.widget-state+json"


@pytest.fixture(scope="module")
def save(lab):
    """Save a notebook with its widgets and close it, its kernel too."""

    def save_(notebook):
        notebook.evaluate(TOGGLE)
        notebook.page.wait_for_timeout(300)
        notebook.evaluate("() => jupyterapp.commands.execute('docmanager:save')")
        notebook.evaluate(TOGGLE)
        notebook.page.wait_for_timeout(300)
        notebook.page.close()
        lab.stop_kernels()
        return nbformat.read(lab.root / notebook.name, 4).metadata["widgets"][KEPT]["state"]

    return save_


def furthest(shown, limb):
    """How far the page's nodes of the limb are from where this limb has them, at most."""
    world = {"": np.eye(4)}
    for path, node in limb.describe().items():
        world[path] = world[path.rpartition("/")[0]] @ node.matrix
    del world[""]
    assert len(world) > 60
    return max(np.abs(shown.pose(path) - pose).max() for path, pose in world.items())


def at(limb, q):
    limb.q = limb.clip(q)
    return limb


@pytest.fixture(scope="module")
def reopened(open_notebook, save):
    """The notebook as it is seen later, and the limb as it was when it was saved."""
    notebook = open_notebook(SETUP, width=1280)
    notebook.run_cell(0)
    shown = notebook.view("limb")
    notebook.execute(CHANGE)
    shown.wait_until("!view.scene.paths.has('gone')")
    limb = models.upper_limb()
    limb.q = notebook.value("limb.q")
    save(notebook)
    return open_notebook(name=notebook.name, width=1280), limb


def test_the_scene_is_drawn_as_it_was_when_it_was_saved(reopened):
    notebook, limb = reopened
    shown = notebook.view("limb")
    assert notebook.execute("print('limb' in dir())") == "False\n"
    assert furthest(shown, limb) < 1e-6
    assert "gone" not in shown.paths()
    assert shown.pose("box")[:3, 3] == pytest.approx([0.4, 0.4, 0])
    shown.settle()
    assert near(shown.pixels(), ORANGE).sum() > 100
    assert shown.evaluate("view.scene.geometry.size") > 10
    assert not [text for text in notebook.messages if "dhlab" in text]


def test_its_sliders_move_the_picture_without_the_kernel(reopened):
    notebook, limb = reopened
    shown = notebook.view("limb")
    sliders = Sliders(notebook)
    sliders.wait_for(np.degrees(limb.q))
    sliders.drag(0, -20)
    value = shown.evaluate("view.scene.nodes.get(view.scene.paths.get('arm/1')).shown.value")
    q = limb.q.copy()
    q[0] = value - limb.components[0].chain.offset[0]
    assert q[0] < limb.q[0] - 0.1
    assert np.degrees(q[0]) == pytest.approx(sliders.values()[0], abs=0.051)
    assert furthest(shown, at(limb, q)) < 1e-6
    said = shown.evaluate("stage.tree.body('arm/theta/label').text")
    assert said == f"θ_{{1}} = {np.degrees(value):z.4g}°"


def test_a_planned_motion_is_kept_and_plays_from_its_end(open_notebook, save):
    notebook = open_notebook(SETUP, width=1280)
    notebook.run_cell(0)
    shown = notebook.view("limb")
    notebook.execute(CHANGE + MOVE)
    shown.wait_until("view.scene.players.length === 1 && !view.scene.players[0].playing")
    start, end = notebook.value("q0"), notebook.value("q1")
    save(notebook)
    again = open_notebook(name=notebook.name, width=1280)
    shown, limb = again.view("limb"), models.upper_limb()
    assert furthest(shown, at(limb, end)) < 1e-6
    for part in (0.0, 0.55):
        shown.evaluate(f"[view.scene.players[0]].map(p => p.seek({part} * p.end)).length")
        assert furthest(shown, at(limb, start + part * (end - start))) < 1e-6


def test_saved_without_its_widgets_a_notebook_still_holds_a_picture(open_notebook, lab):
    notebook = open_notebook(SETUP, width=1280)
    notebook.run_cell(0)
    notebook.view("limb")
    notebook.evaluate("() => jupyterapp.commands.execute('docmanager:save')")
    saved = nbformat.read(lab.root / notebook.name, 4)
    assert "widgets" not in saved.metadata
    ((data,),) = [[out.data for out in cell.outputs] for cell in saved.cells if cell.outputs]
    picture = np.asarray(Image.open(BytesIO(b64decode(data["image/png"]))).convert("RGB"))
    assert (picture.min(axis=2) < 200).mean() > 0.01
    assert len(json.dumps(data)) < 20_000
    html, _ = LivingExporter().from_filename(str(lab.root / notebook.name))
    assert "data:image/png;base64," in html
    assert "widget-view" not in html
