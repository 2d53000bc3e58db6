"""A notebook that ``jupyter nbconvert --to html`` made a page of, from disk, offline."""

import json
import subprocess
import sys

import ipywidgets
import nbformat
import numpy as np
import pytest

from dhlab import View, cube, models
from dhlab.panel.living import STATE, WIDGET, LivingExporter

from .lab import PAGE, Lab, Window
from .servers import ROOT, surroundings
from .test_html import only_files
from .test_saved import at, furthest, reopened, save  # noqa: F401

CELLS = [
    """
from dhlab import Panel, View, cube, models, side_by_side
from dhlab.lessons import course
limb = models.upper_limb()
side_by_side(View("limb").add(limb), Panel(limb))
""",
    "limb.q = limb.clip(limb.home + 0.3)",
    "again = View('again').add(limb, cube(0.1, name='box', pose=(0.4, 0.4, 0)))\nagain",
    "course.order_matters()",
]


class Page(Window):
    """The page; it may ask for nothing but its file."""

    def __init__(self, page, file):
        super().__init__(page)
        self.asked = []
        page.on("request", lambda request: self.asked.append(request.url))
        page.route("**/*", only_files)
        page.goto(file.as_uri())

    def see(self, name, output):
        """Scroll to an output and return the view in it once it is drawn."""
        hosts = f"[...document.querySelectorAll('.dhlab-live')][{output}]"
        self.page.evaluate(f"() => {hosts}.scrollIntoView({{ block: 'center' }})")
        shown = self.view(name, seconds=60)
        shown.wait_until("stage.settled && view.scene.nodes.size", seconds=60)
        return shown


@pytest.fixture(scope="module")
def executed(tmp_path_factory):
    """What the command line makes of a notebook that was never run, with dhlab's configuration."""
    folder = tmp_path_factory.mktemp("living")
    name = Lab("", folder).write(*CELLS)
    environment = surroundings(folder) | {"JUPYTER_CONFIG_PATH": str(ROOT / "dhlab" / "jupyter")}
    command = [sys.executable, "-m", "nbconvert", "--to", "html", "--execute", name]
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, check=False)
    assert done.returncode == 0, done.stderr.decode()
    return (folder / name).with_suffix(".html")


@pytest.fixture
def page(browser, executed):
    page = browser.new_page(viewport={"width": 1280, "height": 900})
    yield Page(page, executed)
    page.close()


def slider(page, name):
    return page.page.get_by_role("slider", name=name, exact=True)


def drag(page, name, way):
    """Drag a slider of the page to a part of its way."""
    slider(page, name).scroll_into_view_if_needed()
    box = slider(page, name).bounding_box()
    at_now = float(slider(page, name).evaluate("s => (s.value - s.min) / (s.max - s.min)"))
    places = [box["x"] + 7.5 + part * (box["width"] - 15) for part in (at_now, way)]
    height = box["y"] + box["height"] / 2
    page.page.mouse.move(places[0], height)
    page.page.mouse.down()
    page.page.mouse.move(places[1], height, steps=5)
    page.page.mouse.up()


def q_of(shown):
    """Configuration that the page shows, by what its sliders say."""
    return np.radians(
        shown.notebook.evaluate(
            "() => [...document.querySelectorAll('.joint input[type=range]')]"
            ".map(({ value }) => Number(value))"
        )
    )


def test_the_page_shows_the_last_state_of_the_notebook(page, executed):
    limb = models.upper_limb()
    limb.q = limb.clip(limb.home + 0.3)
    shown = page.see("limb", 0)
    assert furthest(shown, limb) < 1e-6
    assert len(np.unique(shown.pixels().reshape(-1, 3), axis=0)) > 200
    again = page.see("again", 1)
    assert furthest(again, limb) < 1e-6
    assert again.pose("box")[:3, 3] == pytest.approx([0.4, 0.4, 0])
    assert executed.stat().st_size < 1_500_000
    assert executed.read_text("utf-8").count('data-dhlab="meshcat"') == 1


def test_the_page_asks_for_no_widgets(page):
    page.see("limb", 0)
    others = [url for url in page.asked if not url.startswith(("file:", "blob:", "data:"))]
    assert not [url for url in others if "require.js" not in url and "mathjax" not in url]
    assert not [said for said in page.messages if "dhlab" in said]


def test_a_slider_moves_the_robot_in_all_its_pictures(page):
    limb = models.upper_limb()
    shown = page.see("limb", 0)
    before = q_of(shown)
    assert before == pytest.approx(limb.clip(limb.home + 0.3), abs=1e-9)
    picture = shown.pixels()
    drag(page, "θ₁ of arm", 0.1)
    q = q_of(shown)
    assert q[0] < before[0] - 0.3
    assert np.array_equal(q[1:], before[1:])
    assert furthest(shown, at(limb, q)) < 1e-6
    assert np.abs(shown.pixels().astype(int) - picture).mean() > 0.1
    assert furthest(page.see("again", 1), limb) < 1e-6


def test_a_lesson_goes_on_and_asks(page):
    bar = page.page.locator(".dhlab-bar")
    bar.scroll_into_view_if_needed()
    page.page.wait_for_function(f"() => {PAGE}?.views.length > 2")
    bar.locator("[data-action=next]").click()
    clock = f"[...{PAGE}.players.values()].find(({{ stops }}) => stops.length)"
    page.page.wait_for_function(f"() => {clock}.at === 1 && !{clock}.playing", timeout=60_000)
    bar.locator("[data-action=next]").click()
    choices = bar.locator(".dhlab-choice")
    choices.first.wait_for()
    choices.first.click()
    page.page.wait_for_function(f"() => {clock}.at === 2")


def test_pictures_far_away_give_their_graphics_memory_back(browser, tmp_path, monkeypatch):
    monkeypatch.delenv("DHLAB_VIEW", raising=False)
    views = [View(f"view {k}", height=400).add(cube(1)) for k in range(12)]
    outputs = [
        nbformat.v4.new_output("display_data", {WIDGET: {"model_id": view.widget.model_id}})
        for view in views
    ]
    state = {STATE: json.loads(json.dumps(ipywidgets.Widget.get_manager_state()))}
    cells = [nbformat.v4.new_code_cell("", outputs=[output]) for output in outputs]
    notebook = nbformat.v4.new_notebook(cells=cells, metadata={"widgets": state})
    file = tmp_path / "many.html"
    file.write_text(LivingExporter().from_notebook_node(notebook)[0], "utf-8")
    opened = browser.new_page(viewport={"width": 800, "height": 600})
    page = Page(opened, file)
    for k in (*range(12), 0):
        shown = page.see(f"view {k}", k)
        assert page.evaluate("() => document.querySelectorAll('.dhlab-live canvas').length") <= 8
        assert len(np.unique(shown.pixels().reshape(-1, 3), axis=0)) > 50
    lent = {f"log: THREE.WebGLRenderer: Context {what}." for what in ("Lost", "Restored")}
    assert not [said for said in page.messages if "context" in said.lower() and said not in lent]
    opened.close()


def test_a_notebook_that_jupyterlab_saved_becomes_a_page_too(reopened, lab, browser, tmp_path):  # noqa: F811
    notebook, limb = reopened
    html, _ = LivingExporter().from_filename(str(lab.root / notebook.name))
    file = tmp_path / "saved.html"
    file.write_text(html, "utf-8")
    opened = browser.new_page(viewport={"width": 1280, "height": 900})
    page = Page(opened, file)
    shown = page.see("limb", 0)
    assert furthest(shown, limb) < 1e-6
    drag(page, "θ₁ of arm", 0.1)
    assert furthest(shown, at(models.upper_limb(), q_of(shown))) < 1e-6
    opened.close()
