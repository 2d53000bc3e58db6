"""Panels in a real JupyterLab: dragged, typed into, played along with, looked at."""

import numpy as np
import pytest
from playwright.sync_api import TimeoutError

SETUP = """
import gc
import ipywidgets
import numpy as np
from dhlab import Panel, View, animate, models, side_by_side
limb = models.upper_limb()
def open_widgets():
    gc.collect()
    return len(ipywidgets.widgets.widget._instances)
"""
SHOW = "view = View('limb').add(limb); panel = Panel(limb)\nside_by_side(view, panel)"
LATEST = "[...document.querySelectorAll('.dhlab-panel')].filter(p => p.offsetParent).at(-1)"
TEXTS = f"[...{LATEST}.querySelectorAll('.widget-readout')].map(readout => readout.textContent)"
PUBLICATIONS = """() => {
  globalThis.published = [];
  globalThis[Symbol.for("dhlab.page")].subscribe((changes) => published.push([...changes]));
}"""
COUNT_MESSAGES = """() => {
  globalThis.messages = { panel: 0, back: 0 };
  const { kernel } = jupyterapp.shell.currentWidget.sessionContext.session;
  kernel.anyMessage.connect((_, { msg, direction }) => {
    if (msg.header.msg_type !== "comm_msg") return;
    if (direction === "send") messages.back += 1;
    else if (msg.content.data.method === "update") messages.panel += 1;
  });
}"""
GIVE_UP = """() => {
  globalThis.patient = AbortSignal.timeout;
  AbortSignal.timeout = () => {
    const controller = new AbortController();
    queueMicrotask(() => controller.abort());
    return controller.signal;
  };
}"""
PRESS_FIVE_TIMES = """handle => {
  for (let i = 0; i < 5; i++) {
    handle.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowRight", cancelable: true }));
  }
}"""

WORLD = """
poses = {"": np.eye(4)}
for path, node in view.nodes.items():
    poses[path] = poses[path.rpartition("/")[0]] @ node.matrix
"""
MARKED = """
q0, q1 = limb.clip(limb.home - 0.5), limb.clip(limb.home + 0.5)
move = lambda t: q0 + t * (q1 - q0)
limb.show_csys = True
animate(np.linspace(0, 1, 5), {limb: move}, trace=True)
view.flush(); panel.flush()
"""
LABELS = """Object.fromEntries([...view.scene.nodes.values()]
  .filter(({ shape }) => shape?.kind === "label").map(({ path }) => [path, view.pose(path)]))"""
TRACES = """[...view.scene.nodes.values()].filter(({ path }) => path.includes(".traces/"))
  .map(({ path, shape }) => {
    const drawn = stage.tree.group(path).children[0].geometry.drawRange.count / 6;
    return [path, drawn, [...shape.segments.subarray(6 * drawn - 3, 6 * drawn)]];
  })"""
SAME_FRAME = """async (handle) => {
  const view = globalThis[Symbol.for("dhlab.page")].views.findLast(({ name }) => name === "limb");
  const stage = view.stages.at(-1);
  const { render } = stage.viewer.renderer.info;
  const frame = () => new Promise(requestAnimationFrame);
  while (!stage.settled) await frame();
  await new Promise((go) => setTimeout(go)); // an event of its own, as one of the mouse is
  const poses = () => [...view.scene.paths.keys()].map((path) => [path, view.pose(path)]);
  const [before, drawn] = [poses(), render.frame];
  handle.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowRight", cancelable: true }));
  const after = poses();
  await frame();
  return { before, after, frames: render.frame - drawn };
}"""


class Sliders:
    """The newest panel of a page, as a user has it."""

    def __init__(self, notebook):
        self.notebook = notebook
        self.page = notebook.page
        self.page.wait_for_function(f"() => {LATEST}?.querySelector('.noUi-handle')")
        self.page.wait_for_timeout(300)

    @property
    def root(self):
        return self.page.locator(".dhlab-panel").last

    def texts(self):
        """What the readouts say."""
        return self.page.evaluate(TEXTS)

    def values(self):
        return np.array([float(text.replace("−", "-")) for text in self.texts()])

    def handle(self, index):
        return self.root.locator(".dhlab-joint .noUi-handle").nth(index)

    def grab(self, index):
        box = self.handle(index).bounding_box()
        place = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        self.page.mouse.move(*place)
        self.page.mouse.down()
        return place

    def drag(self, index, pixels, steps=12):
        x, y = self.grab(index)
        for way in np.linspace(0, pixels, steps):
            self.page.mouse.move(x + way, y)
            self.page.wait_for_timeout(15)
        self.page.mouse.up()

    def type(self, index, text):
        self.root.locator(".dhlab-joint .widget-readout").nth(index).click()
        self.page.keyboard.press("Control+a")
        self.page.keyboard.insert_text(text)
        self.page.keyboard.press("Enter")

    def press(self, name):
        self.root.get_by_role("button", name=name, exact=True).click()

    def wait_until_heard(self, index):
        """Wait until the kernel has a joint where its slider stands."""
        shown = self.values()[index]
        self.notebook.wait_until(f"abs(np.degrees(limb.q[{index}]) - {shown}) < 0.051")

    def wait_for(self, values, seconds=5):
        """Wait until the readouts say these values [deg], to the last digit shown."""
        wanted = np.asarray(values).tolist()
        script = f"""wanted => {TEXTS}.every(
          (text, index) => Math.abs(text.replace("−", "-") - wanted[index]) < 0.051)"""
        try:
            self.page.wait_for_function(script, arg=wanted, timeout=1000 * seconds)
        except TimeoutError as error:
            raise AssertionError(f"{self.texts()} are not {wanted}") from error


@pytest.fixture(scope="module")
def notebook(open_notebook):
    notebook = open_notebook(SETUP, SHOW, width=1280, height=900)
    notebook.run_cell(0)
    notebook.run_cell(1)
    notebook.view("limb")
    return notebook


@pytest.fixture
def sliders(notebook):
    notebook.execute("limb.q = limb.home; panel._moves.history.clear(); panel.flush()")
    sliders = Sliders(notebook)
    sliders.wait_for(np.degrees(notebook.value("limb.q")))
    return sliders


@pytest.mark.parametrize("width", [1280, 1920])
def test_picture_and_27_sliders_are_in_sight_at_once(notebook, sliders, width):
    notebook.page.set_viewport_size({"width": width, "height": 900})
    notebook.page.wait_for_timeout(500)
    picture = notebook.page.locator(".dhlab-beside > *").first.bounding_box()
    assert picture["width"] > 300
    assert picture["height"] == pytest.approx(480, abs=2)
    for index in range(27):
        row = sliders.root.locator(".dhlab-joint").nth(index).bounding_box()
        assert picture["x"] + picture["width"] <= row["x"]
        assert picture["y"] <= row["y"]
        assert row["y"] + row["height"] <= picture["y"] + picture["height"]
        assert row["x"] + row["width"] <= width
        assert sliders.handle(index).is_visible()
    notebook.page.set_viewport_size({"width": 1280, "height": 900})


def test_a_dragged_slider_moves_its_joint_here_and_there(notebook, sliders):
    before = notebook.value("limb.q")
    sliders.drag(0, 25)
    sliders.wait_until_heard(0)
    after = notebook.value("limb.q")
    assert after[0] > before[0] + 0.3
    assert np.array_equal(after[1:], before[1:])
    assert np.degrees(after[0]) == pytest.approx(sliders.values()[0], abs=0.051)
    shown = notebook.view("limb").pose("arm/1")
    assert shown == pytest.approx(notebook.value("limb.frames()['arm/1']"), abs=1e-6)


def test_one_drag_is_one_step_back(notebook, sliders):
    before = notebook.value("limb.q")
    sliders.drag(0, 20)
    sliders.drag(4, 15)
    sliders.press("Undo")
    sliders.press("Undo")
    sliders.wait_for(np.degrees(before))
    assert np.array_equal(notebook.value("limb.q"), before)
    assert notebook.value("panel._moves.history.can_undo").item() is False


def test_a_slider_moves_the_picture_while_the_kernel_is_busy(notebook, sliders):
    shown = notebook.view("limb")
    with notebook.busy():
        before = shown.pose("arm/1")
        sliders.drag(0, -20)
        during = shown.pose("arm/1")
        assert np.abs(during - before).max() > 0.1
    sliders.wait_until_heard(0)
    assert notebook.value("limb.frames()['arm/1']") == pytest.approx(during, abs=2e-3)


def test_what_a_busy_kernel_hears_late_does_not_pull_the_picture_back(notebook, sliders):
    shown = notebook.view("limb")
    node = "view.scene.nodes.get(view.scene.paths.get('arm/1'))"
    with notebook.busy():
        sliders.drag(0, -30)
        held, dragged = shown.evaluate(f"[{node}.heldUntil, {node}.shown.value]")
        shown.wait_until(f"performance.now() > {held}")
        shown.evaluate(f"""(() => {{
            const node = {node};
            globalThis.seen = [];
            stage.moved = (moved) => {{
                if (moved === node) seen.push(node.shown.value);
                Object.getPrototypeOf(stage).moved.call(stage, moved);
            }};
        }})()""")
    sliders.wait_until_heard(0)
    shown.wait_until(f"{node}.heldUntil === 0 && Math.abs({node}.value - {dragged}) < 1e-9")
    seen = shown.evaluate("seen")
    shown.evaluate("delete stage.moved")
    assert np.abs(np.array(seen) - dragged).max(initial=0) < 1e-9


@pytest.mark.parametrize("index", [0, 12])  # of the arm, and of a finger of the complex hand
def test_a_slider_moves_all_bodies_in_the_same_frame_while_the_kernel_is_busy(
    notebook, sliders, index
):
    notebook.execute("limb.q = limb.clip(limb.home - 0.1); view.flush(); panel.flush()")
    sliders.wait_for(np.degrees(notebook.value("limb.q")))
    handle = sliders.handle(index).element_handle()
    shown = notebook.view("limb")
    shown.evaluate("stage.element.scrollIntoView({ block: 'center' })")
    # what a hand has moved stays for a moment where the hand left it
    shown.wait_until("[...view.scene.nodes.values()].every((node) => !node.heldUntil)")
    with notebook.busy():
        seen = notebook.page.evaluate(SAME_FRAME, handle)
    assert seen["frames"] == 1
    assert seen["before"] != seen["after"]
    sliders.wait_until_heard(index)
    paths, page = zip(*seen["after"], strict=True)
    notebook.execute(WORLD)
    python = notebook.value(f"[poses[path] for path in {paths!r}]")
    assert np.abs(np.reshape(page, (-1, 4, 4)) - python).max() < 1e-6


def test_labels_and_traces_follow_while_the_kernel_is_busy(notebook, sliders):
    shown = notebook.view("limb")
    player = "view.scene.players[0]"
    grasper = "[...view.scene.paths.keys()].find((path) => path.endsWith('/{}/1/2/3/4/grasper'))"
    with notebook.busy(MARKED):
        shown.wait_until(f"{player}?.time === 1 && !{player}.playing", seconds=60)
        for step in (1, 3, 4):
            shown.evaluate(f"{player}.seek({step / 4})")
            traces = shown.evaluate(TRACES)
            assert len(traces) == 5
            for path, drawn, end in traces:
                finger = path.rpartition(" ")[2]
                tip = shown.pose(shown.evaluate(grasper.format(finger)))[:3, 3]
                assert drawn == step
                assert end == pytest.approx(tip, abs=1e-6)
        before = shown.evaluate(LABELS)
        sliders.handle(0).evaluate(PRESS_FIVE_TIMES)
        after = shown.evaluate(LABELS)
        assert len(before) > 27
        moved = [path for path in before if not np.allclose(before[path], after[path], atol=1e-4)]
        assert len(moved) > 27
        assert shown.evaluate(TRACES) == traces
    sliders.wait_until_heard(0)
    notebook.execute(WORLD)
    python = notebook.value(f"[poses[path] for path in {list(after)}]")
    assert np.abs(np.reshape(list(after.values()), (-1, 4, 4)) - python).max() < 1e-6
    notebook.execute("limb.clear_traces(); limb.show_csys = False; view.flush()")


def test_a_drag_to_the_end_is_the_limit_bit_for_bit(notebook, sliders):
    sliders.drag(2, 400)
    notebook.wait_until("limb.q[2] == limb.limits[2, 1]")


def test_a_typed_value_moves_the_joint(notebook, sliders):
    sliders.type(3, "133.25")
    notebook.wait_until("limb.q[3] == np.radians(133.25)")


def test_a_typed_value_beyond_the_limits_ends_at_the_limit(notebook, sliders):
    sliders.type(0, "1000")
    notebook.wait_until("limb.q[0] == np.pi / 2")


def test_clicking_into_values_and_out_again_moves_nothing(notebook, sliders):
    notebook.execute("limb.q = limb.clip(limb.home + 0.0123456)")
    before = notebook.value("limb.q")
    for index in (0, 3, 7, 11):
        sliders.root.locator(".dhlab-joint .widget-readout").nth(index).click()
    sliders.root.locator(".dhlab-buttons").click(position={"x": 450, "y": 5})
    notebook.page.wait_for_timeout(300)
    assert np.array_equal(notebook.value("limb.q"), before)


def test_keys_move_a_slider_by_its_steps(notebook, sliders):
    sliders.handle(0).focus()
    sliders.handle(0).evaluate(PRESS_FIVE_TIMES)
    notebook.page.wait_for_timeout(1200)
    assert notebook.value("limb.q")[0] == pytest.approx(np.radians(0.5))
    assert notebook.value("len(panel._moves.history._past)") == 1


def test_a_change_by_code_moves_the_sliders_in_one_message(notebook, sliders):
    notebook.page.evaluate(COUNT_MESSAGES)
    notebook.execute("limb.q = limb.clip(limb.home + 0.2)")
    sliders.wait_for(np.degrees(notebook.value("limb.q")))
    notebook.page.wait_for_timeout(300)
    assert notebook.page.evaluate("messages") == {"panel": 1, "back": 0}


def test_the_sliders_follow_a_motion_and_end_where_it_ends(notebook, sliders):
    notebook.page.evaluate(PUBLICATIONS)
    notebook.execute(
        "q0, q1 = limb.home, limb.clip(limb.home - 0.5)\n"
        "move = lambda t: q0 + t * (q1 - q0)\n"
        "animate(np.linspace(0, 1, 21), {limb: move}, delay=0.1)"
    )
    seen = set()
    for _ in range(20):
        seen.add(tuple(sliders.texts()))
        notebook.page.wait_for_timeout(80)
    assert len(seen) > 3
    sliders.wait_for(np.degrees(notebook.value("move(1.0)")), seconds=15)
    assert np.array_equal(notebook.value("limb.q"), notebook.value("move(1.0)"))
    assert notebook.page.evaluate("published.length") > 3


def test_a_motion_that_no_view_shows_moves_the_sliders_to_its_end(notebook, sliders):
    notebook.execute("other = models.upper_limb()")
    notebook.run("Panel(other)")
    alone = Sliders(notebook)
    notebook.execute("animate([0, 9], {other: lambda t: other.home - t / 100 * (other.home > 0)})")
    alone.wait_for(np.degrees(notebook.value("other.q")))
    notebook.page.evaluate("jupyterapp.commands.execute('notebook:delete-cell')")


def test_the_sliders_follow_though_anywidget_has_given_up_waiting_for_them(notebook, sliders):
    notebook.page.evaluate(GIVE_UP)
    notebook.messages.clear()
    notebook.execute("late = models.upper_limb()")
    notebook.run("Panel(late)")
    alone = Sliders(notebook)
    notebook.page.evaluate("() => { AbortSignal.timeout = globalThis.patient; }")
    assert any("Failed to initialize model" in text for text in notebook.messages)
    notebook.execute("late.q = late.clip(late.home + 0.2)")
    alone.wait_for(np.degrees(notebook.value("late.q")))
    notebook.page.evaluate("jupyterapp.commands.execute('notebook:delete-cell')")


def test_a_group_folds_and_unfolds_while_the_kernel_is_busy(notebook, sliders):
    rows = sliders.root.locator(".dhlab-rows").nth(1)
    title = sliders.root.locator(".dhlab-title").nth(1)
    with notebook.busy():
        title.click()
        rows.wait_for(state="hidden")
        title.click()
        rows.wait_for(state="visible")


def test_the_copied_code_gives_the_configuration_back(notebook, sliders):
    notebook.page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    sliders.press("Random")
    sliders.press("Copy q")
    notebook.page.wait_for_timeout(500)
    text = notebook.page.evaluate("navigator.clipboard.readText()")
    notebook.execute(text)
    assert np.array_equal(notebook.value("q"), notebook.value("limb.q"))


def test_a_page_that_is_loaded_again_shows_the_present_robot(notebook, sliders):
    notebook.execute("limb.q = limb.clip(limb.home + 0.3)")
    notebook.page.evaluate("jupyterapp.commands.execute('docmanager:save')")
    notebook.page.wait_for_timeout(500)
    notebook.open()
    again = Sliders(notebook)
    again.wait_for(np.degrees(notebook.value("limb.q")), seconds=20)
    notebook.execute("limb.q = limb.home")
    again.wait_for(np.degrees(notebook.value("limb.home")))
    again.drag(0, 25)
    notebook.wait_until("limb.q[0] > 0.2")


def test_a_cell_run_again_leaves_neither_widgets_nor_links_behind(notebook, sliders):
    notebook.run_cell(1)
    notebook.view("limb")
    Sliders(notebook)
    before = notebook.value("open_widgets()")
    links = "globalThis[Symbol.for('dhlab.hands')].size"
    at_first = notebook.page.evaluate(links)
    for _ in range(5):
        notebook.run_cell(1)
        notebook.page.wait_for_timeout(300)
    Sliders(notebook)
    assert notebook.value("open_widgets()") <= before
    notebook.page.wait_for_function(f"{links} <= {at_first}")
    late = "[anywidget] Failed to initialize model."  # closed while its module was loading
    errors = [text for text in notebook.messages if text.startswith("error")]
    assert not [text for text in errors if late not in text]
