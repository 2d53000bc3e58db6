"""How the picture is drawn: lines, labels, what hides what, and the bars around it."""

import numpy as np
import pytest

from .test_view import ORANGE, SETUP, middle, near

LIGHT_BLUE = np.array([0x56, 0xB4, 0xE9])
EMPTY = "pic = View('pic', height=400, grid=False)\npic"


@pytest.fixture(scope="module")
def notebook(open_notebook):
    notebook = open_notebook(SETUP, EMPTY)
    notebook.run_cell(0)
    notebook.run_cell(1)
    notebook.execute(
        "from dhlab.scene.handle import Handle\n"
        "from dhlab.scene.node import Node, Style\n"
        "from dhlab.shapes import Label, Lines\n"
        "class Drawn(Handle):\n"
        "    def __init__(self, nodes): super().__init__('drawn'); self.nodes = nodes\n"
        "    def _nodes(self, path):\n"
        "        return {path: Node()} | {f'{path}/{k}': n for k, n in self.nodes.items()}\n"
        "def draw(*others, **nodes):\n"
        "    pic.clear(); pic.flush(); pic.add(Drawn(nodes), *others); pic.flush()\n"
    )
    return notebook


@pytest.fixture
def draw(notebook):
    """Draw nodes, given in Python, in an empty view."""
    shown = notebook.view("pic")

    def draw_(nodes, count, look="front"):
        notebook.execute(f"draw({nodes})")
        shown.wait_until(f"view.scene.nodes.size === {count + 1}")
        shown.click(look)
        shown.settle()
        return shown

    return draw_


@pytest.mark.parametrize("width", [2, 6])
def test_lines_have_their_width_in_pixels(draw, width):
    shown = draw(
        "a=Node(shape=Lines([[0, 0, 0], [0, 0, 1], [1, 0, 1]], [[0, 1]]), "
        f"style=Style(color=(0.84, 0.37, 0), line_width={width}))",
        1,
    )
    pixels = shown.pixels()
    row = near(pixels, ORANGE)[pixels.shape[0] // 2]
    assert abs(row.sum() - width) <= 1


def test_lines_keep_their_width_however_far_away_they_are(draw, notebook):
    shown = draw(
        "a=Node(shape=Lines([[0, 0, -9], [0, 0, 9]], [[0, 1]]), "
        "style=Style(color=(0.84, 0.37, 0), line_width=5)), "
        "b=Node(shape=Lines([[1, 0, 0], [1, 1, 0]], [[0, 1]]))",
        2,
    )
    for distance in (1, 5):
        shown.evaluate(
            "(stage.viewer.camera.position.multiplyScalar("
            f"{distance} / stage.viewer.camera.position.length()), stage.viewer.controls.update())"
        )
        pixels = shown.pixels()
        rows = near(pixels, ORANGE)[150:250]
        assert abs(np.median(rows.sum(axis=1)) - 5) <= 1


def test_edges_behind_a_body_are_hidden_and_those_in_front_are_drawn(draw, notebook):
    notebook.execute(
        "plate = cuboid(1, 0.02, 1, name='plate', color='#56b4e9', edges=True, "
        "edge_color='#000000', line_width=2)\n"
        "behind = cuboid(0.5, 0.02, 0.5, name='behind', color='#d55e00').move((0, 0.5, 0.25))"
    )
    notebook.execute("draw(plate, behind)")
    shown = notebook.view("pic")
    shown.wait_until("view.scene.nodes.size === 3")
    shown.click("front")
    shown.settle()
    pixels = shown.pixels()
    assert near(pixels, ORANGE).sum() == 0
    plate = near(pixels, LIGHT_BLUE)
    rows, columns = np.nonzero(plate)
    inside = plate[rows.min() + 4 : rows.max() - 4, columns.min() + 4 : columns.max() - 4]
    assert inside.mean() > 0.999
    dark = pixels.max(axis=-1) < 90
    edge = dark[:, columns.min() - 3 : columns.min() + 3]
    assert edge.any(axis=1)[rows.min() + 5 : rows.max() - 5].mean() > 0.99


def test_what_is_half_opaque_lets_through_what_is_behind(draw, notebook):
    notebook.execute("plate.opacity = 0.5; draw(plate, behind)")
    shown = notebook.view("pic")
    shown.wait_until("view.scene.nodes.size === 3")
    shown.click("front")
    shown.settle()
    height, width, _ = shown.pixels().shape
    through = shown.pixels()[height // 2, width // 2].astype(int)
    notebook.execute("behind.visible = False; pic.flush()")
    shown.settle()
    alone = shown.pixels()[height // 2, width // 2].astype(int)
    assert through[0] > 80
    assert alone[2] - through[2] > 40
    notebook.execute("behind.visible = True")


@pytest.mark.parametrize("look", ["front", "top", "isometric"])
def test_labels_face_the_camera_and_keep_their_size(draw, look):
    shown = draw(
        "a=Node(shape=Label('HHHH', size=40), style=Style(color=(0.84, 0.37, 0))), "
        "b=Node(shape=Lines([[-1, -1, -1], [1, 1, 1]], [[0, 1]]))",
        2,
        look,
    )
    for distance in (2, 6):
        shown.evaluate(
            "(stage.viewer.camera.position.multiplyScalar("
            f"{distance} / stage.viewer.camera.position.length()), stage.viewer.controls.update())"
        )
        rows, columns = np.nonzero(near(shown.pixels(), ORANGE))
        assert 24 <= np.ptp(rows) <= 34
        assert 90 <= np.ptp(columns) <= 140


def test_a_subscript_is_written_low(draw):
    shown = draw(
        "a=Node(shape=Label('x_{12}', size=60), style=Style(color=(0.84, 0.37, 0))), "
        "b=Node(shape=Lines([[-1, -1, -1], [1, 1, 1]], [[0, 1]]))",
        2,
    )
    letters = near(shown.pixels(), ORANGE)
    _, columns = np.nonzero(letters)
    half = (columns.min() + columns.max()) / 2
    left = letters[:, : int(half) - 8]
    right = letters[:, int(half) + 8 :]
    assert np.nonzero(right)[0].max() > np.nonzero(left)[0].max() + 5


def test_a_label_is_text_whatever_it_says(draw, notebook):
    notebook.messages.clear()
    text = "<img src=x onerror=console.error(1)>"
    shown = draw(f"a=Node(shape=Label({text!r}))", 1)
    assert shown.evaluate("stage.element.querySelectorAll('img').length") == 0
    assert not [message for message in notebook.messages if message.startswith("error")]


def test_the_first_camera_sees_x_to_the_right_and_z_up(notebook):
    notebook.run(
        "first = View('first', height=400, grid=False)\n"
        "first.add(*[cube(0.1, name=n, color=c).move(p) for n, c, p in "
        "[('o', '#d55e00', (0, 0, 0)), ('x', '#009e73', (1, 0, 0)), ('z', '#0072b2', (0, 0, 1))]])"
    )
    shown = notebook.view("first")
    shown.settle()
    pixels = shown.pixels()
    origin = middle(near(pixels, ORANGE))
    x = middle(near(pixels, [0, 0x9E, 0x73])) - origin
    z = middle(near(pixels, [0, 0x72, 0xB2])) - origin
    assert x[0] > 100
    assert abs(x[1]) < 0.5 * x[0]
    assert z[1] < -100
    assert abs(z[0]) < 0.1 * abs(z[1])
    notebook.execute("first.close()")


@pytest.mark.parametrize(
    ("size", "caption"), [(0.05, "grid 0.01 m"), (0.6, "grid 0.1 m"), (2, "grid 0.5 m")]
)
def test_the_grid_suits_the_scene(notebook, size, caption):
    notebook.run(f"ground = View('ground', height=300).add(cube({size}, name='c'))\nground")
    shown = notebook.view("ground")
    shown.settle()
    assert shown.evaluate("stage.caption.textContent") == caption
    assert shown.evaluate("stage.surroundings.ground.level") == 0
    notebook.execute("ground.close()")


def test_the_grid_lies_below_a_scene_that_reaches_below_zero(notebook):
    notebook.run(
        "ground = View('ground', height=300).add(cube(0.6, name='c').move((0, 0, -0.3)))\nground"
    )
    shown = notebook.view("ground")
    shown.settle()
    assert shown.evaluate("stage.caption.textContent") == "grid 0.1 m, floor at z = \u22120.3 m"
    notebook.execute("ground.close()")


def test_the_control_bar_of_meshcat_is_shown_only_when_asked_for(notebook):
    for controls, display in ((False, "none"), (True, "")):
        notebook.run(f"bar = View('bar', height=200, controls={controls}).add(box)\nbar")
        shown = notebook.view("bar")
        assert shown.evaluate("stage.viewer.gui.domElement.style.display") == display
        notebook.execute("bar.close()")


def test_keys_work_while_the_view_has_the_focus(notebook, draw):
    shown = draw("a=Node(shape=Lines([[-1, 0, 0], [1, 1, 1]], [[0, 1]]))", 1)
    shown.evaluate("stage.element.focus()")
    notebook.page.keyboard.press("2")
    shown.wait_until("stage.camera.direction.z > 0.99")
    notebook.page.keyboard.press("1")
    shown.wait_until("stage.camera.direction.y < -0.99")


def test_the_wheel_zooms_only_where_the_view_has_the_focus(notebook, draw):
    shown = draw("a=Node(shape=Lines([[-1, 0, 0], [1, 1, 1]], [[0, 1]]))", 1)
    away = "stage.viewer.camera.position.distanceTo(stage.viewer.controls.target)"
    box = notebook.page.locator(".dhlab-view").first.bounding_box()
    notebook.page.mouse.move(box["x"] + box["width"] / 2, box["y"] + 150)
    shown.evaluate("document.activeElement.blur()")
    before = shown.evaluate(away)
    notebook.page.mouse.wheel(0, -100)
    shown.settle()
    assert shown.evaluate(away) == before
    notebook.page.mouse.down()
    notebook.page.mouse.up()
    notebook.page.mouse.wheel(0, -100)
    shown.wait_until(f"{away} < {before}")


def test_dragging_turns_the_camera_and_what_comes_later_does_not_turn_it_back(notebook, draw):
    shown = draw("a=Node(shape=Lines([[-1, 0, 0], [1, 1, 1]], [[0, 1]]))", 1)
    box = notebook.page.locator(".dhlab-view").first.bounding_box()
    notebook.page.mouse.move(box["x"] + 200, box["y"] + 200)
    notebook.page.mouse.down()
    notebook.page.mouse.move(box["x"] + 320, box["y"] + 230, steps=4)
    notebook.page.mouse.up()
    position = "stage.viewer.camera.position.toArray()"
    turned = shown.evaluate(position)
    assert abs(turned[0]) > 0.1
    notebook.execute("far = cube(0.1, name='far').move((9, 0, 0)); pic.add(far); pic.flush()")
    shown.wait_until("view.scene.paths.has('far')")
    shown.settle()
    assert np.allclose(shown.evaluate(position), turned)
    shown.click("fit")
    shown.settle()
    assert not np.allclose(shown.evaluate(position), turned)


def test_full_screen_and_back(notebook, draw):
    shown = draw("a=Node(shape=Lines([[-1, 0, 0], [1, 1, 1]], [[0, 1]]))", 1)
    height = shown.evaluate("stage.canvas.clientHeight")
    notebook.page.locator(".dhlab-view [data-action=full]").first.click()
    shown.wait_until(f"document.fullscreenElement && stage.canvas.clientHeight > {height}")
    notebook.page.evaluate("() => document.exitFullscreen()")
    shown.wait_until(f"stage.canvas.clientHeight === {height}")
