"""The limb with its look as a page without a kernel: its size, and the time until it is drawn.

Beside it: what meshcat-python saves of the same limb's frames, a small box at each. Pages are
opened from disk, in turns; a page is open when the last picture with something new in it is drawn
to its last pixel.
"""

import io
from collections.abc import Iterator
from contextlib import redirect_stdout
from pathlib import Path
from tempfile import TemporaryDirectory

from limb_boxes import BOX, frames_of
from meshcat_server import meshcat_server
from rows import Row, median

from dhlab import View
from dhlab.models import upper_limb

ROUNDS = 7


def measure() -> Iterator[Row]:
    from contenders import new_page, stand_still
    from page import open_browser

    with TemporaryDirectory() as folder, open_browser() as browser:
        files = ours(Path(folder)), theirs(Path(folder))
        times: tuple[list[float], list[float]] = [], []
        for _ in range(ROUNDS):
            for file, taken in zip(files, times, strict=True):
                page, _ = new_page(browser)
                page.goto(file.as_uri())
                stand_still(page.main_frame)
                taken.append(page.evaluate("benchClock.last - performance.timeOrigin"))
                page.close()
        sizes = [file.stat().st_size / 1e6 for file in files]
    beside = "meshcat's page of 32 boxes"
    yield Row("saved page of the limb, user look", sizes[0], unit="MB", target="<= 1.3")
    yield Row("the same", *sizes, beside, "MB")
    yield Row("saved page opened, until it is drawn", *map(median, times), beside)


def ours(folder: Path) -> Path:
    """The limb in its user look, sliders included."""
    limb = upper_limb()
    limb.look = "user"
    return View("limb").add(limb).save_html(folder / "dhlab.html")


def theirs(folder: Path) -> Path:
    """The frames of the limb as boxes, saved by meshcat-python."""
    import meshcat

    with meshcat_server() as url, redirect_stdout(io.StringIO()):
        picture = meshcat.Visualizer(zmq_url=url)
        for name, pose in frames_of(0.0).items():
            picture[name].set_object(meshcat.geometry.Box([BOX, BOX, BOX]))
            picture[name].set_transform(pose)
        file = folder / "meshcat.html"
        file.write_text(picture.static_html(), encoding="utf-8")
    return file
