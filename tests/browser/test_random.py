"""Two hundred random operations: the page shows what Python has, and what a fresh view shows."""

import json
from pathlib import Path

import numpy as np
import pytest

SETUP = f"""
import json, sys
sys.path.insert(0, {str(Path(__file__).parents[2])!r})
from tests.worlds import World
from dhlab.view import View

def said(view):
    poses, said = {{}}, {{}}
    for path, node in view.nodes.items():
        parent = path.rpartition("/")[0]
        poses[path] = poses[parent] @ node.matrix if parent else node.matrix
        look = [*node.style.color, node.style.opacity, node.visible]
        said[path] = [poses[path].ravel().tolist(), look, node.shape and node.shape.digest]
    return json.dumps(said)
"""
SEEN = """Object.fromEntries([...view.scene.nodes.values()].map((node) => {
    const group = stage.tree.group(node.path);
    const { color, opacity } = node.style;
    const look = [...color, opacity, node.visible];
    return [node.path, [view.pose(node.path, stage), look, node.digest, group.visible]];
}))"""
REST = "view.scene.players.every((player) => !player.playing)"


def rest(shown, sequence):
    """Wait for a batch and for the end of all motions; return the page's scene by path."""
    shown.wait_until(f"view.scene.sequence === {sequence} && {REST}", seconds=60)
    return shown.evaluate(SEEN)


def assert_same(page, python):
    """Compare paths, poses, colours, opacities, visibility and shapes."""
    assert page.keys() == python.keys()
    for path, (pose, look, shape) in python.items():
        there, shown_look, digest, visible = page[path]
        assert np.allclose(there, pose, atol=1e-6), path
        assert np.allclose(shown_look, look, atol=1e-6), path
        assert (digest, visible) == (shape, look[-1]), path


def picture(shown):
    """The picture as it is fitted at first."""
    shown.evaluate("stage.element.scrollIntoView({ block: 'center' })")
    shown.evaluate("stage.look(stage.camera.direction, false)")
    shown.settle()
    return shown.pixels().astype(int)


@pytest.mark.parametrize("seed", [1, 2])
def test_after_a_hundred_random_operations_the_page_shows_what_a_fresh_one_would(
    open_notebook, seed
):
    notebook = open_notebook(
        f"{SETUP}\nview = View('live', height=300, grid=False); world = World({seed}, paged=view)",
        "view",
        "fresh = View('fresh', height=300, grid=False).add(*world.shown)\nfresh",
    )
    notebook.run_cell(0)
    notebook.run_cell(1)
    live = notebook.view("live")
    for _ in range(4):
        notebook.execute("for _ in range(25):\n    world.act()\n    view.flush()")
        page = rest(live, int(notebook.value("view.widget._wire.sequence")))
        assert_same(page, json.loads(notebook.execute("print(said(world.live))")))
    notebook.run_cell(2)
    fresh = notebook.view("fresh")
    assert rest(fresh, 0).keys() == page.keys()
    assert_same(rest(fresh, 0), json.loads(notebook.execute("print(said(world.live))")))
    assert np.abs(picture(live) - picture(fresh)).mean() < 0.5
    assert not [text for text in notebook.messages if "dhlab" in text]
