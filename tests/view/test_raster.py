"""The small still picture that an output holds beside its widget."""

from base64 import b64decode
from io import BytesIO

import numpy as np
import pytest
from PIL import Image

from dhlab import block_complex, csys, cube, models, polyline, sphere
from dhlab.view.raster import HEIGHT, WIDTH, still_picture, thumbnail, to_png
from dhlab.view.still import still

PAPER = np.array([0xF2, 0xF5, 0xF9])


def read(png):
    image = Image.open(BytesIO(png))
    assert image.size == (WIDTH, HEIGHT)
    return np.asarray(image.convert("RGB")).astype(int)


def near(picture, color, tolerance=40):
    return np.abs(picture - np.asarray(color)).max(axis=2) < tolerance


def test_nothing_is_paper():
    assert near(read(thumbnail({})), PAPER, 8).all()


@pytest.mark.parametrize("look", ["solid", "stick", "user"])
def test_it_covers_what_matplotlib_covers(look):
    limb = models.upper_limb()
    limb.look = look
    nodes = limb.describe()
    painted = read(still(nodes, width=WIDTH, height=HEIGHT))
    ours, theirs = (~near(picture, PAPER, 25) for picture in (read(thumbnail(nodes)), painted))
    assert theirs.sum() > 500
    assert (ours & theirs).sum() > 0.8 * (ours | theirs).sum()
    differs = np.abs(read(thumbnail(nodes)) - painted).max(axis=2)[ours & theirs]
    assert np.median(differs) < 25


def test_of_two_faces_that_run_through_each_other_the_nearer_is_seen():
    one = cube(1, name="one", color=(0.9, 0.1, 0.1), edges=False)
    other = cube(1, name="other", color=(0.1, 0.1, 0.9), edges=False, pose=(0.02, -0.02, 0))
    picture = read(thumbnail({**one.describe(), **other.describe()}))
    red, blue = (picture[..., k] - picture[..., 2 - k] > 60 for k in (0, 2))
    assert blue.sum() > 10 * red.sum() > 0


def test_what_is_half_transparent_lets_what_is_behind_shine_through():
    inner = cube(0.5, name="inner", color=(1, 0, 0), edges=False, pose=(0, 0, 0.2))
    glass = cube(1, name="glass", color=(0, 0, 1), edges=False, opacity=0.4)
    picture = read(thumbnail({**inner.describe(), **glass.describe()}))
    mixed = picture[HEIGHT // 2, WIDTH // 2]
    assert mixed[0] > 80
    assert mixed[2] > 60


def test_lines_have_their_width_and_colour():
    line = polyline([(0, 0, 0), (1, 0, 0)], name="line", color=(0, 0.6, 0))
    picture = read(thumbnail(line.describe()))
    green = picture[..., 1] - picture[..., 0] > 60
    columns = green.any(axis=0)
    assert columns.mean() > 0.5
    assert 1 <= green[:, columns].sum(axis=0).mean() <= 8


def test_the_dark_background_is_dark():
    assert read(thumbnail(csys().describe(), "dark"))[0, 0].max() < 60


def test_it_is_small():
    assert len(thumbnail(models.upper_limb().describe())) < 12_000


def test_a_scene_that_would_take_long_has_none():
    many = block_complex(*(sphere(0.1, name=f"s{k}") for k in range(500)))
    assert thumbnail(many.describe()) is None
    assert still_picture(many.describe(), "light") == {}


def test_a_notebook_holds_it_as_text():
    text = still_picture(cube(1).describe(), "light")["image/png"]
    assert b64decode(text) == thumbnail(cube(1).describe())


def test_colours_beyond_256_become_the_nearest():
    rng = np.random.default_rng(3)
    picture = rng.integers(0, 256, (40, 50, 3), dtype=np.uint8)
    again = np.asarray(Image.open(BytesIO(to_png(picture))).convert("RGB"))
    assert again.shape == picture.shape
    assert np.abs(again.astype(int) - picture).mean() < 40
    few = np.repeat(np.repeat(picture[:4, :4], 5, axis=0), 5, axis=1)
    exact = np.asarray(Image.open(BytesIO(to_png(few))).convert("RGB"))
    assert np.abs(exact.astype(int) - few).max() <= 4
