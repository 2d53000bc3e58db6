"""Frames a second of the limb's planned motion: kernel idle, kernel busy, and no kernel at all.

Beside it, in the same page and in turns: the picture drawn over and over with nothing in motion,
which is what the machine can do.
"""

from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory

from rows import Row, median

from dhlab import View, animate
from dhlab.models import upper_limb

ROUNDS = 4
SECONDS = 4
MOTION = (
    "import numpy as np\n"
    f"t = np.linspace(0, {SECONDS}, 101)\n"
    "middle, reach = limb.limits.mean(1), 0.4 * np.ptp(limb.limits, axis=1)\n"
    "animate(t, {limb: lambda t: middle + reach * np.sin(3 * t)})"
)
CELLS = (
    "from dhlab import View, animate, models\nlimb = models.upper_limb()",
    "View('limb').add(limb)",
)
BURN = (
    "import threading\nburning = True\n"
    "def burn():\n    while burning:\n        sum(range(10_000))\n"
    "threading.Thread(target=burn, daemon=True).start()"
)
PLAY = """async (still) => {
  const page = globalThis[Symbol.for("dhlab.page")];
  const stage = page.views.at(-1).stages.at(-1);
  const player = [...page.players.values()].at(-1);
  const frame = () => new Promise(requestAnimationFrame);
  while (player.playing) await frame();
  const { info } = stage.viewer.renderer;
  const gl = stage.viewer.renderer.getContext();
  const before = info.render.frame;
  const began = performance.now();
  const end = began + 1000 * (player.end - player.start);
  if (!still) player.play();
  while (still ? performance.now() < end : player.playing) {
    if (still) stage.changed();
    await frame();
  }
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  return (1000 * (info.render.frame - before)) / (performance.now() - began);
}"""

SCRIPT = """async () => {
  const page = globalThis[Symbol.for("dhlab.page")];
  const stage = page.views.at(-1).stages.at(-1);
  const player = [...page.players.values()].at(-1);
  const gl = stage.viewer.renderer.getContext();
  const times = [];
  for (let k = 1; k <= 60; k++) {
    await new Promise(requestAnimationFrame);
    const began = performance.now();
    player.seek(player.start + (k / 61) * (player.end - player.start));
    stage.changed();
    stage.render();
    times.push(performance.now() - began);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  }
  return times;
}"""
"""Milliseconds that the page's own thread takes for each frame: the rest is the graphics card's."""


def measure() -> Iterator[Row]:
    from page import open_lab

    rates: dict[str, list[float]] = {name: [] for name in ("still", "idle", "busy", "gone", "open")}
    with open_lab() as desk, TemporaryDirectory() as folder:
        notebook = desk.open(*CELLS)
        for index in range(len(CELLS)):
            notebook.run_cell(index)
        notebook.view("limb").settle()
        notebook.execute(MOTION)
        file = saved_page(Path(folder))
        for _ in range(ROUNDS):
            rates["still"].append(notebook.evaluate(PLAY, True))
            rates["idle"].append(notebook.evaluate(PLAY, False))
            with notebook.busy(BURN):
                rates["busy"].append(notebook.evaluate(PLAY, False))
            notebook.execute("burning = False")
        script = median(notebook.evaluate(SCRIPT))
        notebook.page.close()
        page = desk.browser.new_page(viewport={"width": 1280, "height": 1200})
        page.goto(file.as_uri())
        page.wait_for_function("globalThis[Symbol.for('dhlab.page')]?.players.size === 1")
        for _ in range(ROUNDS):
            rates["open"].append(page.evaluate(PLAY, True))
            rates["gone"].append(page.evaluate(PLAY, False))
        page.close()
    still, idle, busy, gone, alone = (median(rates[name]) for name in rates)
    again = "the same picture over again"
    yield Row("planned motion, kernel idle", idle, still, again, "fps", ">= 0.8")
    yield Row("planned motion, kernel busy on a core", busy, idle, "kernel idle", "fps", ">= 0.5")
    yield Row(
        "  JavaScript of one frame of it", script, 1000 / 60, "a frame at 60 fps", target="<= 0.5"
    )
    yield Row("planned motion in a saved page", gone, alone, again, "fps", ">= 0.8")


def saved_page(folder: Path) -> Path:
    """Save the same motion of the same limb as a page without a kernel."""
    limb = upper_limb()
    view = View("limb").add(limb)
    exec(MOTION, {"limb": limb, "animate": animate})
    return view.save_html(folder / "limb.html")
