"""One notebook in JupyterLab, Notebook 7 and Voila, with no network but this machine's own."""

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest

from dhlab import models

from .fronts import CELLS, PLAYER, Seat
from .lab import READY, RUN_ALL, Lab
from .servers import free_port, serving, serving_notebooks, surroundings
from .test_saved import at, furthest


@contextmanager
def jupyterlab(folder: Path, lab: Lab) -> Iterator[str]:
    yield f"{lab.url}/lab/workspaces/fronts/tree/{lab.write(*CELLS)}"
    lab.stop_kernels()


@contextmanager
def notebook_7(folder: Path, lab: Lab) -> Iterator[str]:
    with serving_notebooks(folder / "home", folder / "root", "notebook") as server:
        yield f"{server.url}/notebooks/{server.write(*CELLS)}"


@contextmanager
def voila(folder: Path, lab: Lab) -> Iterator[str]:
    home, port = folder / "home", free_port()
    home.mkdir()
    server = Lab(f"http://127.0.0.1:{port}", home)
    name = server.write(*CELLS)
    command = [sys.executable, "-m", "voila", "--no-browser", f"--port={port}", str(home)]
    with serving(command, server.url, home, home, surroundings(home)):
        yield f"{server.url}/voila/render/{name}"


@pytest.fixture(scope="module", params=[jupyterlab, notebook_7, voila])
def seat(request, browser, lab, tmp_path_factory):
    """The notebook, run, in one front end; the page reaches nothing beyond this machine."""
    folder = tmp_path_factory.mktemp("front")
    with request.param(folder, lab) as address:
        page = browser.new_page(viewport={"width": 1280, "height": 900})
        page.route(lambda url: not url.startswith("http://127.0.0.1:"), lambda r: r.abort())
        seat = Seat(page)
        page.goto(address, timeout=120_000)
        if request.param is not voila:
            page.wait_for_function(READY, timeout=120_000)
            page.evaluate(RUN_ALL)
        seat.wait_for_it()
        yield seat
        page.close()


def test_picture_and_sliders_are_drawn(seat):
    assert furthest(seat.shown, at(models.upper_limb(), seat.q)) < 1e-6
    assert len(np.unique(seat.shown.pixels().reshape(-1, 3), axis=0)) > 200
    assert len(seat.sliders.values()) == 27
    assert not [said for said in seat.messages if "dhlab" in said]


def test_a_dragged_slider_moves_the_robot_in_the_page_and_in_python(seat):
    before, picture = seat.q, seat.shown.pixels()
    seat.drag(0, 25)
    seat.wait_for_agreement(before)
    after = seat.q
    assert after[0] > before[0] + 0.3
    assert np.array_equal(after[1:], before[1:])
    assert furthest(seat.shown, at(models.upper_limb(), after)) < 1e-6
    assert np.abs(seat.shown.pixels().astype(int) - picture).mean() > 0.1


def test_a_dragged_slider_moves_the_robot_while_the_kernel_is_busy(seat):
    before = seat.q
    with seat.busy():
        seat.drag(0, -20)
        pose = seat.shown.pose("arm/1")
        assert np.array_equal(seat.q, before)
    seat.wait_for_agreement(before)
    limb = at(models.upper_limb(), seat.q)
    assert limb.q[0] < before[0] - 0.1
    assert limb.frames()["arm/1"] == pytest.approx(pose, abs=2e-3)
    assert furthest(seat.shown, limb) < 1e-6


def test_a_planned_motion_plays_and_ends_in_its_last_state(seat):
    seat.press("Move")
    seat.shown.wait_until(f"{PLAYER}?.playing && {PLAYER}.time > 0.1", seconds=30)
    seat.shown.wait_until(f"{PLAYER}.time === 1.5 && !{PLAYER}.playing", seconds=60)
    seat.wait_for_agreement()
    limb = models.upper_limb()
    assert np.array_equal(seat.q, limb.clip(limb.home - 0.4))
    assert furthest(seat.shown, at(limb, seat.q)) < 1e-6
