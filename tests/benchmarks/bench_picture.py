"""From running a cell to its first picture, the first and the second time in a page.

Beside it: a cell with a bare ipywidgets slider, until that is in the page.
"""

from collections.abc import Iterator

from rows import Row, median

PAGES = 3
IMPORTS = "import ipywidgets\nfrom dhlab import View, models\nlimb = models.upper_limb()"
SLIDER = "ipywidgets.FloatSlider()"
TIME = """async ([source, seen]) => {
  const { content } = jupyterapp.shell.currentWidget;
  const index = content.model.cells.length;
  content.model.sharedModel.insertCell(index, { cell_type: "code", source, metadata: {} });
  content.activeCellIndex = index;
  await new Promise((resolve) => setTimeout(resolve, 500));
  const test = eval(seen);
  const count = test();
  const began = performance.now();
  jupyterapp.commands.execute("notebook:run-cell");
  while (!(test() > count)) {
    if (performance.now() - began > 60000) throw new Error("nothing was shown");
    await new Promise(requestAnimationFrame);
  }
  return performance.now() - began;
}"""
SLIDERS = "() => document.querySelectorAll('.widget-slider .noUi-handle').length"
DRAWN = """() => {
  const views = globalThis[Symbol.for("dhlab.page")]?.views ?? [];
  const drawn = ({ stages }) =>
    stages.some((stage) => stage.settled && stage.viewer.renderer.info.render.frame > 0);
  return views.filter(drawn).length;
}"""


def measure() -> Iterator[Row]:
    from page import open_lab

    names = ("whole", "first", "second", "slider")
    times: dict[str, list[float]] = {name: [] for name in names}
    with open_lab() as desk:
        for _ in range(PAGES):
            notebook = desk.open("")
            notebook.run_cell(0)
            cells = f"{IMPORTS}\nView().add(limb)", "View().add(limb)"
            times["whole"].append(notebook.evaluate(TIME, [cells[0], DRAWN]))
            times["second"].append(notebook.evaluate(TIME, [cells[1], DRAWN]))
            notebook.page.close()
            notebook = desk.open(IMPORTS)
            notebook.run_cell(0)
            times["slider"].append(notebook.evaluate(TIME, [SLIDER, SLIDERS]))
            times["first"].append(notebook.evaluate(TIME, [cells[1], DRAWN]))
            notebook.page.close()
    whole, first, second, slider = (median(times[name]) for name in names)
    beside = slider, "first bare slider"
    yield Row("cell with its imports to first picture", whole, *beside)
    yield Row("cell to first picture, all imported", first, *beside)
    yield Row("cell to picture, the second in a page", second, *beside)
