"""Labels of things that stand in one place can still be read."""

import pytest

from .test_view import SETUP

EMPTY = "pic = View('pic', height=400, grid=False)\npic"
WAYS = """Object.fromEntries([...view.scene.paths.keys()].filter((path) => path.endsWith("label")
  || path.endsWith("name")).map((path) => {
    const sprite = stage.tree.group(path).children[0].children[0];
    return [path, 0.5 - sprite.center.y];
  }))"""


@pytest.fixture(scope="module")
def notebook(open_notebook):
    notebook = open_notebook(SETUP, EMPTY)
    notebook.run_cell(0)
    notebook.run_cell(1)
    return notebook


@pytest.fixture
def ways(notebook):
    """How far each label stands above its own place, in its own height, for some frames."""
    shown = notebook.view("pic")

    def ways_(*poses):
        frames = ", ".join(f"csys({pose}, name='{'ABC'[k]}')" for k, pose in enumerate(poses))
        notebook.execute(f"pic.clear(); pic.flush(); pic.add({frames}); pic.flush()")
        names = [f"{letter}/name" for letter in "ABC"[: len(poses)]]
        shown.wait_until(" && ".join(f"view.scene.paths.has('{name}')" for name in names))
        shown.click("isometric")
        shown.settle()
        return shown.evaluate(WAYS)

    return ways_


def test_a_label_alone_stands_in_its_place(ways):
    found = ways("transl((0, 0, 0))", "transl((2, 0, 0))")
    assert len(found) == 8
    assert all(way == 0 for way in found.values())


def test_labels_of_frames_in_one_place_stand_one_below_the_other(ways):
    found = ways(*3 * ["transl((0, 0, 0))"])
    assert len(found) == 12
    for label in ("x/label", "y/label", "z/label", "name"):
        first, second, third = (found[f"{frame}/{label}"] for frame in "ABC")
        assert first == 0
        assert -1 < second < -0.6
        assert third == pytest.approx(2 * second, rel=1e-3)


def test_labels_are_back_in_their_place_when_frames_part(ways):
    assert any(ways("transl((0, 0, 0))", "transl((0, 0, 0))").values())
    assert not any(ways("transl((0, 0, 0))", "transl((0, 0, 1.6))").values())


def test_a_third_label_does_not_come_back_onto_the_first(ways):
    found = ways("transl((0, 0, 0))", "transl((0, 0, 0.02))", "transl((0, 0, 0.01))")
    first, second, third = (found[f"{frame}/name"] for frame in "ABC")
    assert first == 0
    assert 0.4 < second < 0.7
    assert third > second + 0.5
