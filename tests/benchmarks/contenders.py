"""Pages with a slider and a limb: dhlab in JupyterLab, and others beside it.

Each is a context that gives sliders by name. Where a viewer has no sliders of its own, it has
those of ipywidgets, as its users do it.
"""

import socket
from collections.abc import Iterator
from contextlib import closing, contextmanager
from typing import TYPE_CHECKING

from dragging import CLOCK, Handle, Traffic, wait_until
from meshcat_server import meshcat_server
from peers import running
from playwright.sync_api import Browser, Frame, Page

if TYPE_CHECKING:
    from page import Desk

SIZE = {"width": 1000, "height": 480}
DHLAB = (
    "import ipywidgets\n"
    "from dhlab import Panel, View, models, side_by_side\n"
    "def slider(name):\n"
    "    options = dict(min=-1, max=1, step=0.001, readout_format='.3f')\n"
    "    return ipywidgets.FloatSlider(**options).add_class(name)\n"
    "one, other, plain = map(slider, ('bare', 'shown', 'plain'))\n"
    "one.observe(lambda change: setattr(other, 'value', change.new), 'value')\n"
    "limb = models.upper_limb()\n"
    "def follow(change):\n"
    "    q = limb.q.copy()\n"
    "    q[0] = change.new\n"
    "    limb.q = q\n"
    "plain.observe(follow, 'value')",
    "display(ipywidgets.VBox([one, other, plain]))\n"
    "side_by_side(View('limb').add(limb), Panel(limb))",
)
MESHCAT = (
    "import contextlib, io, ipywidgets, meshcat, numpy as np\n"
    "from limb_boxes import BOX, frames_of\n"
    "plain = ipywidgets.FloatSlider(min=-1, max=1, step=0.001).add_class('plain')\n"
    "with contextlib.redirect_stdout(io.StringIO()):\n"
    "    picture = meshcat.Visualizer(zmq_url={url!r})\n"
    "for name in frames_of(0.0):\n"
    "    picture[name].set_object(meshcat.geometry.Box([BOX, BOX, BOX]))\n"
    "def place(value):\n"
    "    for name, pose in frames_of(value).items():\n"
    "        picture[name].set_transform(pose)\n"
    "plain.observe(lambda change: place(change.new), 'value')\n"
    "place(0.0)",
    "display(plain)\npicture.jupyter_cell()",
)
LISTEN = """() => {
  benchClock.watch(document.querySelector(".shown .widget-readout"));
  const { scene } = globalThis[Symbol.for("dhlab.page")].views.at(-1);
  const about = ["added", "removed", "reshaped", "painted", "changed", "playersChanged"];
  const deaf = Object.fromEntries(about.map((event) => [event, () => {}]));
  scene.observers.add({ ...deaf, moved: () => benchClock.arrive() });
}"""
Handles = dict[str, Handle]


@contextmanager
def dhlab(desk: "Desk") -> Iterator[Handles]:
    """The limb beside its panel, with a plain slider that Python listens to, and a bare pair."""
    page, traffic = new_page(desk.browser)
    try:
        notebook = desk.open(*DHLAB, page=page)
        for index in range(len(DHLAB)):
            notebook.run_cell(index)
        notebook.view("limb").settle()
        page.evaluate(LISTEN)
        grips = {"panel": ".dhlab-joint", "plain": ".plain", "bare": ".bare"}
        yield {
            name: Handle(
                page, traffic, page.locator(f"{place} .noUi-handle").first, page.main_frame
            )
            for name, place in grips.items()
        }
    finally:
        page.close()


@contextmanager
def meshcat(desk: "Desk") -> Iterator[Handles]:
    """meshcat-python in a cell, and a slider of ipywidgets that Python listens to."""
    with meshcat_server() as url:
        page, traffic = new_page(desk.browser)
        try:
            cells = MESHCAT[0].format(url=url), MESHCAT[1]
            notebook = desk.open(*cells, page=page)
            for index in range(len(cells)):
                notebook.run_cell(index)
            inner = page.locator("iframe").first.element_handle().content_frame()
            stand_still(inner)
            grip = page.locator(".plain .noUi-handle").first
            yield {"meshcat": Handle(page, traffic, grip, inner)}
        finally:
            page.close()


@contextmanager
def viser(desk: "Desk") -> Iterator[Handles]:
    """viser with a slider of its own."""
    with closing(socket.socket()) as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    with running("viser", str(port)) as url:
        yield from _alone(desk, "viser", url, "[role=slider]")


@contextmanager
def swift(desk: "Desk") -> Iterator[Handles]:
    """Swift with a slider of its own."""
    with running("swift") as url:
        yield from _alone(desk, "swift", url, "input.slider")


def _alone(desk: "Desk", name: str, url: str, grip: str) -> Iterator[Handles]:
    page, traffic = new_page(desk.browser)
    try:
        page.set_viewport_size(SIZE)
        page.goto(url)
        page.wait_for_selector(grip, timeout=60_000)
        stand_still(page.main_frame)
        yield {name: Handle(page, traffic, page.locator(grip).first, page.main_frame)}
    finally:
        page.close()


def new_page(browser: Browser) -> tuple[Page, Traffic]:
    """Open a page with the clock in it, whose sockets are listened to."""
    page = browser.new_page(viewport={"width": 1280, "height": 900})
    page.add_init_script(path=CLOCK)
    return page, Traffic(page)


def stand_still(picture: Frame) -> None:
    """Wait until a picture is there and nothing in it has moved for a second."""
    now = "performance.timeOrigin + performance.now()"
    wait_until(picture, f"benchClock.last && {now} - benchClock.last > 1000", 60)
