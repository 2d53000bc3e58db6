"""A picture without a browser: what is drawn is where it belongs."""

import re
from io import BytesIO

import matplotlib.image
import numpy as np
import pytest

from dhlab import InputError, csys, cube, models, polyline
from dhlab.view import View
from dhlab.view.still import still


def pixels(png):
    return matplotlib.image.imread(BytesIO(png), format="png")[..., :3]


def inked(image):
    """Rows and columns that differ from the background in the corner."""
    return np.argwhere(np.abs(image - image[0, 0]).max(axis=2) > 0.05)


def test_the_picture_has_the_size_asked_for():
    assert pixels(still(cube(1).describe(), width=90, height=50)).shape == (50, 90, 3)


def test_an_empty_scene_is_an_empty_picture():
    assert len(inked(pixels(still({}, width=60, height=40)))) == 0


@pytest.mark.parametrize("size", [0.01, 1, 300])
def test_all_of_the_scene_is_in_the_picture_whatever_its_size(size):
    image = pixels(still(cube(size, pose=(5 * size, 0, 0)).describe(), width=200, height=150))
    ink = inked(image)
    assert ink.min() > 0
    assert (ink.max(axis=0) < (149, 199)).all()
    assert np.ptp(ink, axis=0).max() > 90


def test_what_is_nearer_hides_what_is_behind():
    near, far = cube(1, color="#ff0000", pose=(0, -3, 0)), cube(1, color="#0000ff")
    nodes = near.describe("near") | far.describe("far")
    image = pixels(still(nodes, width=100, height=100, seen_from="front"))
    red, _, blue = image[50, 50]
    assert red > 0.3
    assert blue < 0.1
    image = pixels(still(nodes, width=100, height=100, seen_from=(0, 1, 0)))
    assert image[50, 50, 2] > 0.3


def test_what_is_hidden_is_not_painted():
    hidden = cube(1, visible=False)
    assert len(inked(pixels(still(hidden.describe(), width=60, height=40)))) == 0


def test_a_line_and_the_labels_of_a_frame_are_painted():
    line = polyline([(0, 0, 0), (1, 0, 0), (1, 0, 1)], color="#ff0000")
    assert len(inked(pixels(still(line.describe(), width=100, height=80)))) > 50
    plain = inked(pixels(still(csys(labels=False).describe(), width=200, height=160)))
    named = inked(pixels(still(csys(name="A").describe(), width=200, height=160)))
    assert len(named) > len(plain)


def test_every_look_of_the_limb_can_be_painted():
    limb = models.upper_limb()
    for look in ("solid", "stick", "user"):
        limb.look = look
        ink = inked(pixels(still(limb.describe(), width=240, height=160, background="dark")))
        assert len(ink) > 500


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"width": 3}, "width must be at least 16, got 3"),
        ({"background": "blue"}, "no background 'blue'; use 'light' or 'dark'"),
        ({"seen_from": "below"}, "seen_from must be a 3-vector or one of first, front"),
        ({"seen_from": (0, 0, 0)}, "seen_from must have a length"),
    ],
)
def test_a_picture_that_cannot_be_is_refused(options, message):
    with pytest.raises(InputError, match=message):
        still({}, **options)


def test_a_view_saves_its_picture(tmp_path):
    view = View("bench", background="dark").add(cube(1, color="#ff0000"))
    place = view.save_png(tmp_path / "bench.png", width=120, height=80, seen_from="front")
    image = pixels(place.read_bytes())
    assert place == tmp_path / "bench.png"
    assert image.shape == (80, 120, 3)
    assert image[0, 0].max() < 0.2
    assert image[40, 60, 0] > 0.4
    view.save_png(str(place), width=60, height=40)
    assert pixels(place.read_bytes()).shape == (40, 60, 3)


@pytest.mark.parametrize(
    ("path", "options", "what"),
    [
        ("", {}, "a picture needs a path such as 'limb.png', got ''"),
        (".", {}, "'.' is a folder; a picture needs the path of a file in it"),
        ("none/such.png", {}, "there is no folder 'none' for 'such.png'"),
        ("a.png", {"seen_from": "below"}, "seen_from must be a 3-vector or one of first, front"),
        ("a.png", {"width": 2}, "width"),
    ],
)
def test_a_picture_that_cannot_be_saved_is_refused(tmp_path, monkeypatch, path, options, what):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(InputError, match=re.escape(what)):
        View().add(cube(1)).save_png(path, **options)
    assert list(tmp_path.iterdir()) == []
