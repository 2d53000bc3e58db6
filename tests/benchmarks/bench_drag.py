"""From a slider's drag to the picture, beside a bare slider that moves another through the kernel.

Both are in one page and are dragged in turns. The picture's time ends when the frame is drawn to
its last pixel, the other's when the second slider's value is written into the page.
"""

from collections.abc import Iterator

from rows import Row, median

DRAGS = 40
CELLS = (
    "import ipywidgets\n"
    "from dhlab import Panel, View, models, side_by_side\n"
    "one, other = (ipywidgets.FloatSlider(max=1, step=0.001, readout_format='.3f') for _ in 'ab')\n"
    "one.observe(lambda change: setattr(other, 'value', change.new), 'value')\n"
    "box = ipywidgets.VBox([one, other]).add_class('bare')\n"
    "limb = models.upper_limb()",
    "display(box)\nside_by_side(View('limb').add(limb), Panel(limb))",
)
PREPARE = """() => {
  const clock = (globalThis.bench = { began: 0, pose: [], picture: [], slider: [] });
  document.addEventListener("pointermove", () => (clock.began = performance.now()), true);
  const note = (what) => clock.began && clock[what].push(performance.now() - clock.began);
  const view = globalThis[Symbol.for("dhlab.page")].views.at(-1);
  const stage = view.stages.at(-1);
  const node = view.scene.nodes.get(view.scene.paths.get("arm/1"));
  const gl = stage.viewer.renderer.getContext();
  const render = stage.render.bind(stage);
  const moved = stage.moved.bind(stage);
  let news = false;
  stage.moved = (about) => {
    moved(about);
    if (about !== node || !clock.began || news) return;
    note("pose");
    news = true;
  };
  const finish = () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  clock.draw = () => {
    const began = performance.now();
    render();
    finish();
    return performance.now() - began;
  };
  stage.render = () => {
    render();
    if (!news) return;
    news = false;
    finish();
    note("picture");
    clock.began = 0;
  };
  const readout = document.querySelectorAll(".bare .widget-readout")[1];
  new MutationObserver(() => (note("slider"), (clock.began = 0))).observe(readout, {
    childList: true, characterData: true, subtree: true,
  });
}"""


def measure() -> Iterator[Row]:
    from page import open_lab

    with open_lab() as desk:
        notebook = desk.open(*CELLS)
        for index in range(len(CELLS)):
            notebook.run_cell(index)
        notebook.view("limb").settle()
        page = notebook.page
        joint = page.locator(".dhlab-joint .noUi-handle").first
        bare = page.locator(".bare .noUi-handle").first
        page.wait_for_timeout(1000)
        notebook.evaluate(PREPARE)
        drawings = []
        for count in range(DRAGS):
            for handle in (joint, bare):
                drag(page, handle, 3 if count % 2 else -3)
            drawings.append(notebook.evaluate("bench.draw()"))
        times = notebook.evaluate("[bench.pose, bench.picture, bench.slider]")
    for name, seen in zip(("pose", "picture", "slider"), times, strict=True):
        if len(seen) < 0.8 * DRAGS:
            raise RuntimeError(f"{len(seen)} of {DRAGS} drags were seen on the {name}")
    pose, picture, slider, drawing = map(median, [*times, drawings])
    beside = slider, "slider-kernel-slider"
    yield Row("drag to the new pose in three.js", pose, *beside)
    yield Row("drag to the picture, drawn to its last pixel", picture, *beside)
    yield Row("  of this: drawing (no graphics card here)", drawing, *beside)


def drag(page, handle, pixels: float) -> None:
    """Take hold of a slider, move it once and let it go."""
    box = handle.bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.wait_for_timeout(100)
    page.evaluate("bench.began = 0")
    page.mouse.move(x + pixels, y)
    page.wait_for_timeout(300)
    page.mouse.up()
    page.wait_for_timeout(200)
