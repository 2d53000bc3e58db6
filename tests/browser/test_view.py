"""Views in a real JupyterLab: what three.js has and what the canvas shows."""

from time import monotonic

import numpy as np
import pytest

SETUP = """
import numpy as np
from numpy import pi
from dhlab import *
from dhlab.view import View
rng = np.random.default_rng(7)

def world(view):
    poses = {}
    for path, node in view.nodes.items():
        parent = path.rpartition("/")[0]
        poses[path] = poses[parent] @ node.matrix if parent else node.matrix
    return poses

box = cube(0.2, name="box", color="#d55e00")
main = View("main", height=400, grid=False).add(box)
"""
ORANGE = np.array([0xD5, 0x5E, 0x00])
WIDGETS = "__import__('ipywidgets').widgets.widget._instances.values()"
FRAMES = "stage.viewer.renderer.info.render.frame"


@pytest.fixture(scope="module")
def notebook(open_notebook):
    notebook = open_notebook(SETUP, "main")
    notebook.run_cell(0)
    notebook.run_cell(1)
    return notebook


@pytest.fixture
def shown(notebook):
    """The view `main`, with its cube alone, at the origin, seen as at first."""
    notebook.execute("main.clear(); main.add(box); box.move(np.eye(4)); main.flush()")
    shown = notebook.view("main")
    shown.wait_until("view.scene.nodes.size === 1")
    shown.evaluate("stage.look(stage.camera.direction, false)")
    return shown


def near(pixels, color, tolerance=60):
    """Where a picture has about a colour, whatever the light."""
    ink = np.array(color) / np.linalg.norm(color)
    length = np.linalg.norm(pixels, axis=-1) + 1e-9
    hue = np.linalg.norm(pixels / length[..., None] - ink, axis=-1)
    return (hue < tolerance / 255) & (length > 60)


def middle(mask):
    """Centre of the true pixels: column, row."""
    rows, columns = np.nonzero(mask)
    return np.array([columns.mean(), rows.mean()])


def same_poses(shown, view="main"):
    """How far the page's poses are from Python's, at most."""
    paths = shown.paths()
    python = shown.notebook.value(f"[world({view})[path] for path in {paths!r}]")
    page = np.array([shown.pose(path) for path in paths])
    return np.abs(page - python).max()


def test_a_view_draws_its_scene(shown):
    pixels = shown.pixels()
    cube = near(pixels, ORANGE)
    assert 0.05 < cube.mean() < 0.6
    assert len(np.unique(pixels.reshape(-1, 3), axis=0)) > 50
    height, width = cube.shape
    assert np.abs(middle(cube) - [width / 2, height / 2]).max() < 0.1 * width


def test_a_move_in_python_moves_the_picture(notebook, shown):
    before = middle(near(shown.pixels(), ORANGE))
    notebook.execute("box.move((0.05, 0, 0.02))")
    shown.wait_until("view.pose('box')[3] > 0.049")
    assert same_poses(shown) < 1e-7
    after = middle(near(shown.pixels(), ORANGE))
    assert after[0] > before[0] + 10
    assert after[1] < before[1] - 5


def test_colour_opacity_and_visibility_are_seen(notebook, shown):
    notebook.execute("box.color = '#0072b2'")
    shown.wait_until("view.scene.nodes.get(view.scene.paths.get('box')).style.color[2] > 0.6")
    assert near(shown.pixels(), [0, 0x72, 0xB2]).mean() > 0.05
    notebook.execute("box.visible = False; main.flush()")
    shown.wait_until("!view.scene.nodes.get(view.scene.paths.get('box')).visible")
    assert near(shown.pixels(), [0, 0x72, 0xB2]).mean() < 0.001
    notebook.execute("box.set(visible=True, color='#d55e00'); main.flush()")
    shown.wait_until("view.scene.nodes.get(view.scene.paths.get('box')).visible")
    assert near(shown.pixels(), ORANGE).mean() > 0.05


def test_two_outputs_and_two_views_follow_one_handle(notebook, shown):
    notebook.run("main")
    notebook.run("other = View('other', height=200).add(box)\nother")
    first, second = notebook.view("main", stage=0), notebook.view("main", stage=1)
    other = notebook.view("other")
    notebook.execute("box.move((0.3, 0.1, 0))")
    for output in (first, second, other):
        output.wait_until("Math.abs(view.pose('box', stage)[3] - 0.3) < 1e-6")
        assert np.allclose(output.pose("box")[:3, 3], [0.3, 0.1, 0])
        assert near(output.pixels(), ORANGE).mean() > 0.005


def test_the_viewer_is_in_the_page_once(notebook, shown):
    script = 'globalThis[Symbol.for("dhlab.page")].libraries.size'
    assert notebook.evaluate(script) == 1
    assert not [text for text in notebook.messages if "Multiple instances" in text]
    assert notebook.value("sum(type(w).__name__ == 'Library' for w in " + WIDGETS + ")") == 1


def test_the_page_does_the_kinematics_of_any_robot_itself(notebook, shown):
    notebook.execute(
        "table = [dh(pi/2, 0.1, 0.2, 0.3), dh(-pi/3, 0.2, 0.1, -0.2), dh(0.4, -0.1, 0.3, 1.1)]\n"
        "modified = robot(table, 'rpr', name='modified')\n"
        "standard = robot(table, 'rrp', name='standard', convention='standard', base=(0.5, 0, 0))\n"
        "finger = robot(table, 'rrr', name='finger', base=rp2t(rotx(1), (0, 0.1, 0)))\n"
        "standard.connect(finger)\n"
        "main.add(modified, standard); main.flush()"
    )
    shown.wait_until("view.scene.paths.has('standard')")
    worst = 0.0
    for _ in range(10):
        notebook.execute(
            "modified.q = rng.uniform(-2, 2, 3); standard.q = rng.uniform(-2, 2, 6); main.flush()"
        )
        goal = float(notebook.value("modified.q[0]"))
        shown.wait_until(
            f"[...view.scene.nodes.values()].some(n => n.joint && n.value === {goal!r})"
        )
        worst = max(worst, same_poses(shown))
    assert worst < 1e-6


def test_ten_thousand_changes_end_at_once_and_the_last_is_seen(notebook, shown):
    began = monotonic()
    notebook.execute("for k in range(10_000): box.move((k / 1e5, 0, 0))")
    ended = monotonic()
    shown.wait_until("view.pose('box')[3] > 0.099989", seconds=0.5)
    assert ended - began < 8
    assert shown.evaluate("view.scene.nodes.size") == 1


def test_the_last_change_is_seen_while_the_cell_still_runs(notebook, shown):
    with notebook.busy("for k in range(100): box.move((k / 100, 0, 0))", hears=True):
        shown.wait_until("Math.abs(view.pose('box')[3] - 0.99) < 1e-6", seconds=30)


def test_changes_from_another_thread_are_seen(notebook, shown):
    notebook.execute(
        "import threading\n"
        "def work():\n    for k in range(200): box.move((k / 200, 0, 0))\n"
        "worker = threading.Thread(target=work); worker.start()\n"
        "for k in range(200): box.color = (k / 200, 0.5, 0.5)\n"
        "worker.join(); box.color = '#d55e00'"
    )
    shown.wait_until("Math.abs(view.pose('box')[3] - 0.995) < 1e-6")
    assert same_poses(shown) < 1e-7
    shown.wait_until("view.scene.nodes.get(view.scene.paths.get('box')).style.color[2] === 0")


def test_a_handle_as_the_last_expression_shows_itself(notebook, shown):
    notebook.run("alone = cube(0.3, name='alone', color='#d55e00')\nalone")
    alone = notebook.view("alone")
    alone.settle()
    assert near(alone.pixels(), ORANGE).mean() > 0.02
    notebook.execute("alone.move((0.1, 0, 0))")
    alone.wait_until("view.pose('alone')[3] > 0.099")


def test_the_buttons_place_the_camera(notebook, shown):
    for action, axis in {"front": [0, -1, 0], "side": [1, 0, 0], "top": [0, 0, 1]}.items():
        shown.click(action)
        shown.wait_until(
            f"stage.camera.direction.dot({{x: {axis[0]}, y: {axis[1]}, z: {axis[2]}}}) > 0.99"
        )
        shown.settle()
        mask = near(shown.pixels(), ORANGE, tolerance=120)
        rows, columns = np.nonzero(mask)
        width, height = np.ptp(columns), np.ptp(rows)
        assert abs(width - height) < 0.1 * height, action
        assert mask[rows.min() : rows.max(), columns.min() : columns.max()].mean() > 0.9


def test_the_top_view_has_x_to_the_right_and_y_up(notebook, shown):
    notebook.execute(
        "marks = [cube(0.05, name=n, color=c).move(p) for n, c, p in "
        "[('right', '#009e73', (0.4, 0, 0)), ('up', '#0072b2', (0, 0.4, 0))]]\n"
        "main.add(*marks); main.flush()"
    )
    shown.wait_until("view.scene.nodes.size === 3")
    shown.click("top")
    shown.settle()
    pixels = shown.pixels()
    centre = middle(near(pixels, ORANGE))
    right = middle(near(pixels, [0, 0x9E, 0x73])) - centre
    up = middle(near(pixels, [0, 0x72, 0xB2])) - centre
    assert right[0] > 50
    assert abs(right[1]) < 20
    assert up[1] < -50
    assert abs(up[0]) < 20


def test_the_background_can_be_dark(shown):
    light = shown.pixels()[5, 5].astype(int)
    shown.click("background")
    dark = shown.pixels()[5, 5].astype(int)
    shown.click("background")
    assert light.min() > 220
    assert dark.max() < 80
    assert np.abs(shown.pixels()[5, 5] - light).max() <= 2


def test_a_message_that_is_missing_is_made_good(notebook, shown):
    shown.evaluate("view.scene.sequence -= 3")
    notebook.execute("box.move((0.7, 0, 0)); main.flush()")
    shown.wait_until("Math.abs(view.pose('box')[3] - 0.7) < 1e-6")
    assert same_poses(shown) < 1e-7


def test_bad_messages_leave_the_picture_and_are_told_once(notebook, shown):
    before = shown.pixels()
    notebook.messages.clear()
    bad = """[
        {}, {joints: {count: 3, ids: 0, values: 0}}, {joints: {count: 1, ids: 0, values: 4}},
        {removes: [999]}, {puts: [{id: 7}]}, {format: 99}, {paints: [[1, 5, true]]},
        {poses: {count: 1, matrices: 0, ids: 0}},
        {curves: [[1, {clock: "x", count: 1, at: 0, width: 1}]]},
        {styles: [{color: [1, 2]}]}, {geometry: {a: {kind: "mesh", vertices: 1, triangles: 9}}},
        {puts: [{id: 50, path: "a/b/c", pose: 0, style: 0}], styles: [{}]},
    ]"""
    shown.evaluate(
        f"""{bad}.forEach((content, i) => {{
            const numbers = new Float64Array(12).fill(i % 2 ? NaN : 1e9);
            const header = {{kind: "batch", format: 1, seq: view.scene.sequence + 1, ...content}};
            if (i === 0) header.seq = "what";
            view.receive(header, [new DataView(numbers.buffer)]);
            view.receive(null, []);
        }})"""
    )
    assert shown.evaluate("view.scene.nodes.size") == 1
    assert np.abs(shown.pixels().astype(int) - before).mean() < 1
    told = [text for text in notebook.messages if "not understood" in text]
    assert len(told) == 1
    notebook.execute("box.move((0.1, 0, 0))")
    shown.wait_until("Math.abs(view.pose('box')[3] - 0.1) < 1e-6")


def test_a_view_out_of_sight_is_not_drawn_and_right_when_it_comes_back(notebook, shown):
    shown.evaluate("stage.element.style.display = 'none'")
    shown.settle()
    drawn = shown.evaluate(FRAMES)
    notebook.execute("for k in range(50): box.move((k / 100, 0, 0)); main.flush()")
    shown.wait_until("view.pose('box')[3] > 0.489")
    shown.settle()
    assert shown.evaluate(FRAMES) == drawn
    shown.evaluate("stage.element.style.display = ''")
    shown.wait_until(f"{FRAMES} > {drawn}")
    assert near(shown.pixels(), ORANGE).mean() > 0.01


def test_in_a_hidden_tab_changes_wait_for_one_frame_and_it_is_right_when_it_comes(notebook, shown):
    """A browser gives a hidden tab no frames; this one is given none until it is seen again."""
    shown.settle()
    at_first = middle(near(shown.pixels(), ORANGE))
    shown.evaluate(
        "(globalThis.held = [], globalThis.give = requestAnimationFrame, "
        "globalThis.requestAnimationFrame = f => f && globalThis.held.push(f), 0)"
    )
    drawn = shown.evaluate(FRAMES)
    try:
        for _ in range(5):
            notebook.execute("for k in range(200): box.move((k / 4000, 0, 0)); main.flush()")
        shown.wait_until("view.pose('box')[3] > 0.0497")
        assert shown.evaluate(FRAMES) == drawn
        assert shown.evaluate("view.stages.length < 3 && globalThis.held.length < 20")
    finally:
        shown.evaluate(
            "(globalThis.requestAnimationFrame = give, globalThis.held.forEach(f => give(f)), 0)"
        )
    shown.wait_until(f"{FRAMES} > {drawn}")
    shown.settle()
    assert middle(near(shown.pixels(), ORANGE))[0] > at_first[0] + 10


def test_nothing_is_drawn_while_nothing_changes(notebook, shown):
    shown.settle()
    before = shown.evaluate(FRAMES)
    shown.settle()
    assert shown.evaluate(FRAMES) == before
    notebook.execute("box.move((0.01, 0, 0)); main.flush()")
    shown.wait_until("Math.abs(view.pose('box')[3] - 0.01) < 1e-6")
    shown.settle()
    assert before < shown.evaluate(FRAMES) <= before + 3


def test_a_closed_view_gives_its_graphics_memory_back(notebook, shown):
    notebook.run("closing = View('closing', height=100).add(box)\nclosing")
    closing = notebook.view("closing")
    closing.evaluate("(globalThis.closedContext = stage.canvas.getContext('webgl2'), 0)")
    count = notebook.views()
    notebook.execute("closing.close()")
    notebook.page.wait_for_function("() => globalThis.closedContext.isContextLost()")
    notebook.page.wait_for_function(
        f'() => globalThis[Symbol.for("dhlab.page")].views.length === {count - 1}'
    )


def test_a_view_follows_though_anywidget_has_given_up_waiting_for_it(notebook, shown):
    notebook.evaluate(
        """() => {
            globalThis.patient = AbortSignal.timeout;
            AbortSignal.timeout = () => {
                const controller = new AbortController();
                queueMicrotask(() => controller.abort());
                return controller.signal;
            };
        }"""
    )
    notebook.messages.clear()
    notebook.run("late = View('late', height=100).add(box)\nlate")
    late = notebook.view("late")
    notebook.evaluate("() => { AbortSignal.timeout = globalThis.patient; }")
    assert any("Failed to initialize model" in text for text in notebook.messages)
    notebook.execute("box.move((0.4, 0, 0)); late.flush()")
    late.wait_until("Math.abs(view.pose('box')[3] - 0.4) < 1e-6")
    notebook.execute("late.close()")


def test_a_page_loaded_again_and_a_second_page_show_the_present_scene(
    notebook, shown, open_notebook
):
    notebook.execute("box.move((0.2, 0.1, 0)); extra = cube(0.1, name='extra'); main.add(extra)")
    notebook.page.evaluate("() => jupyterapp.commands.execute('docmanager:save')")
    notebook.execute("box.move((0.25, 0.1, 0)); main.flush()")
    second_page = open_notebook(name=notebook.name)
    notebook.open()
    for page in (notebook, second_page):
        again = page.view("main", stage=0)
        again.wait_until("view.scene.paths.has('extra')")
        assert np.allclose(again.pose("box")[:3, 3], [0.25, 0.1, 0], atol=1e-7)
        again.settle()
        assert near(again.pixels(), ORANGE).mean() > 0.01
    notebook.execute("box.move((0.3, 0.1, 0)); main.remove(extra); main.flush()")
    for page in (notebook, second_page):
        again = page.view("main", stage=0)
        again.wait_until("!view.scene.paths.has('extra')")
        assert np.allclose(again.pose("box")[:3, 3], [0.3, 0.1, 0], atol=1e-7)
