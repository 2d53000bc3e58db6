"""Notebooks as living pages, as far as they can be read without a browser."""

import json
import logging
import re
from base64 import b64decode
from pathlib import Path
from zlib import decompress

import ipywidgets
import nbformat
import numpy as np
import pytest
from traitlets.utils.importstring import import_item

from dhlab import Panel, TableEditor, View, dh, robot
from dhlab.lessons import course
from dhlab.panel.lesson_view import LessonBar
from dhlab.panel.living import STATE, WIDGET, LivingExporter, LivingPage
from dhlab.panel.saved import Saved
from dhlab.view.html import page
from dhlab.view.wire import Wire

ROOT = Path(__file__).parents[2]
HOSTILE = "</script><img src=x onerror=alert(1)>"


@pytest.fixture(autouse=True)
def no_widgets(monkeypatch):
    monkeypatch.delenv("DHLAB_VIEW", raising=False)
    ipywidgets.Widget.close_all()
    yield
    ipywidgets.Widget.close_all()


@pytest.fixture
def arm():
    table = [dh(0, 0, 0.2, 0.5), dh(0, 0.4, 0, 0.1), dh(0, 0.1, 0.05, 0)]
    limits = [(-1, 1), (-2, 0.5), (-np.inf, np.inf)]
    arm = robot(table, "rrp", name="arm", limits=limits, offset=[0.25, 0, 0])
    arm.q = (0.3, -0.7, 0.02)
    return arm


def saved(*widgets, **data):
    """A notebook with an output for each widget, saved with the state of all that are open."""
    outputs = [
        nbformat.v4.new_output(
            "display_data", {WIDGET: {"model_id": w.model_id}, "text/plain": "x", **data}
        )
        for w in widgets
    ]
    cell = nbformat.v4.new_code_cell("shown", outputs=outputs)
    state = json.loads(json.dumps(ipywidgets.Widget.get_manager_state()))
    return nbformat.v4.new_notebook(cells=[cell], metadata={"widgets": {STATE: state}})


def living(notebook):
    """Data of the outputs of a notebook that was made living."""
    LivingPage().preprocess(notebook, {})
    return [output.data for output in notebook.cells[0].outputs]


def told(html):
    """What an output says it shows."""
    return json.loads(re.search(r'<script type="application/json">(.*?)</script>', html)[1])


def carried(html):
    """What a page carries, by name."""
    blocks = re.findall(r'data-dhlab="(\w+)">([^<]*)</script>', html)
    return {name: decompress(b64decode(text)) for name, text in blocks}


def test_a_view_brings_its_scene_as_it_is_and_the_viewer(arm):
    view = View("bench", height=300, grid=False).add(arm)
    (data,) = living(saved(view.widget))
    assert WIDGET not in data
    options = {"name": "bench", "height": 300, "background": "light", "grid": False}
    part = told(data["text/html"])
    assert part["options"] == {**options, "controls": False}
    blocks = carried(data["text/html"])
    assert blocks[part["scene"]] == Wire(view.nodes).snapshot()
    assert b"WebGLRenderer" in blocks["meshcat"]
    assert b"class Connection" in blocks["viewer"]


def test_a_panels_sliders_are_those_of_a_page_that_is_saved_from_python(arm):
    view, panel = View("arm").add(arm), Panel(arm)
    box = ipywidgets.HBox((view.widget, panel.widget), _dom_classes=("dhlab-beside",))
    arm.q = (0.5, -0.2, 0.01)
    panel.flush()
    view.flush()
    (data,) = living(saved(box))
    part = told(data["text/html"])
    assert part["kind"] == "beside"
    about = re.search(r'id="about">(.*?)</script>', page("arm", [arm], b"", view.options))[1]
    ours, theirs = (told["robots"][0]["joints"] for told in (part["parts"][1], json.loads(about)))
    assert [joint.pop("value") for joint in ours] == pytest.approx(
        [joint.pop("value") for joint in theirs], abs=1e-10
    )
    assert ours == theirs


def test_a_lesson_brings_its_bar_with_the_answers(arm):
    lesson = course.order_matters()
    lesson.answer(2, 0)
    bar = LessonBar(lesson)
    (data,) = living(saved(bar))
    part = told(data["text/html"])
    assert part["lesson"]["title"] == lesson.title
    assert len(part["lesson"]["steps"]) == 3
    assert part["lesson"]["answers"]["2"]["predicted"] == 0
    bar.close()


def test_what_all_outputs_share_is_there_once_and_nothing_is_left_of_the_widgets(arm):
    views = [View(f"v{k}").add(arm) for k in range(3)]
    notebook = saved(*(view.widget for view in views))
    first, *others = living(notebook)
    assert len(carried(first["text/html"])) == 2 + 3
    assert not any(carried(other["text/html"]) for other in others)
    assert "widgets" not in notebook.metadata


def test_widgets_of_others_stay_with_all_that_they_refer_to(arm):
    slider = ipywidgets.FloatSlider()
    notebook = saved(slider, View().add(arm).widget)
    data = living(notebook)
    assert data[0][WIDGET]["model_id"] == slider.model_id
    kept = notebook.metadata["widgets"][STATE]["state"]
    assert set(kept) == {slider.model_id, slider.layout.model_id, slider.style.model_id}


def test_what_needs_a_kernel_says_so(arm):
    text, button, editor = ipywidgets.Label("so it is"), ipywidgets.Button(), TableEditor(arm)
    box = ipywidgets.VBox((View().add(arm).widget, text, button, editor.widget))
    (data,) = living(saved(box))
    part = told(data["text/html"])
    assert part["kind"] == "column"
    assert [inner.get("words") for inner in part["parts"][1:]] == [
        "so it is",
        "(Button: needs a kernel)",
        "(The table of arm can be edited with a kernel.)",
    ]


def test_the_still_picture_stands_there_until_the_page_lives(arm):
    (data,) = living(saved(View().add(arm).widget, **{"image/png": "QUJD\n"}))
    assert '<img alt="" src="data:image/png;base64,QUJD">' in data["text/html"]


def test_names_and_texts_cannot_break_out(arm):
    arm.name = "arm"
    view = View(HOSTILE.replace("/", "")).add(arm)
    box = ipywidgets.HBox((view.widget, ipywidgets.Label(HOSTILE)))
    (data,) = living(saved(box, **{"image/png": f'"{HOSTILE}'}))
    assert "<img src=x" not in data["text/html"]
    assert told(data["text/html"])["parts"][1]["words"] == HOSTILE


@pytest.mark.parametrize("other", ["image/png", "text/plain"])
def test_a_widget_that_was_not_saved_gives_way_to_the_rest_of_its_output(other):
    output = nbformat.v4.new_output("display_data", {WIDGET: {"model_id": "gone"}, other: "x"})
    cell = nbformat.v4.new_code_cell("shown", outputs=[output])
    (data,) = living(nbformat.v4.new_notebook(cells=[cell]))
    assert data == {other: "x"}


def test_formulas_between_the_cells_need_no_renderer(arm):
    notebook = saved(View().add(arm).widget)
    notebook.cells.append(nbformat.v4.new_markdown_cell(r"About $\alpha$, not `$x$`."))
    living(notebook)
    assert "$x$" in notebook.cells[1].source
    assert r"\alpha" not in notebook.cells[1].source
    assert "<mi>α</mi>" in notebook.cells[1].source


def test_a_notebook_without_dhlab_is_left_alone():
    notebook = saved(ipywidgets.FloatSlider(), ipywidgets.HBox((ipywidgets.Label("a"),)))
    notebook.cells.append(nbformat.v4.new_markdown_cell(r"About $\alpha$."))
    before = json.dumps(notebook)
    living(notebook)
    assert json.dumps(notebook) == before


def test_a_damaged_state_is_left_alone_with_a_word(arm, caplog):
    panel = Panel(arm)
    notebook = saved(View().add(arm).widget, panel.widget)
    for model in notebook.metadata["widgets"][STATE]["state"].values():
        for buffer in model.get("buffers", ()):
            buffer["data"] = "no base64"
    before = json.dumps(notebook)
    preprocessor = LivingPage()
    preprocessor.log = logging.getLogger("nbconvert")
    preprocessor.preprocess(notebook, {})
    assert json.dumps(notebook) == before
    assert "the saved widgets cannot be read" in caplog.text


def test_a_part_that_refers_to_itself_has_an_end():
    state = {"a": {"model_name": "HBoxModel", "state": {"children": ["IPY_MODEL_a"]}}}
    assert Saved(state).part("a") is None


def test_the_exporter_writes_the_page(arm):
    html, _ = LivingExporter().from_notebook_node(saved(View("bench").add(arm).widget))
    assert html.count('data-dhlab="meshcat"') == 1
    assert "html-manager" not in html


@pytest.mark.parametrize("name", ["jupyter_nbconvert_config", "jupyter_server_config"])
def test_the_configuration_that_is_installed_names_the_living_page(name):
    config = json.loads((ROOT / "dhlab" / "jupyter" / f"{name}.json").read_text("utf-8"))
    (named,) = config["HTMLExporter"]["preprocessors"]
    assert import_item(named) is LivingPage
    assert f'"dhlab/jupyter/{name}.json"' in (ROOT / "pyproject.toml").read_text("utf-8")
