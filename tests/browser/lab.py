"""Notebooks in a real JupyterLab, driven and looked into by tests.

`Window` finds the views of a page, `Notebook` also runs code in its kernel; `Shown` looks into one
view of a page: poses as three.js has them, pixels, buttons. A view is found through the page's own
object, ``globalThis[Symbol.for("dhlab.page")].views`` (see ``dhlab/view/static/page.js``).
"""

import base64
import json
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from io import BytesIO
from itertools import count
from pathlib import Path
from time import monotonic
from typing import Any

import nbformat
import numpy as np
from numpy.typing import NDArray
from PIL import Image
from playwright.sync_api import Page

PAGE = 'globalThis[Symbol.for("dhlab.page")]'
NUMBERS = count(1)

EXECUTE = """async (code) => {
  const { kernel } = jupyterapp.shell.currentWidget.sessionContext.session;
  const cell = { cellId: crypto.randomUUID() }; // as a cell of the page names itself
  const future = kernel.requestExecute({ code, stop_on_error: false }, false, cell);
  const said = [];
  future.onIOPub = ({ header, content }) => {
    if (header.msg_type === "stream") said.push(content.text);
    if (header.msg_type === "error") said.push(content.traceback.join("\\n"));
  };
  const { content } = await future.done;
  return [content.status, said.join("")];
}"""

START = f"(code) => ({{ ended: ({EXECUTE})(code) }})"
ENDED = "({ ended }) => ended"

HOLD = """
import contextlib, pathlib, time
from dhlab.scene.handle import CHANGES
with contextlib.nullcontext() if {hears} else CHANGES:
    pathlib.Path({begun!r}).touch()
    while not pathlib.Path({over!r}).exists():
        time.sleep(0.01)
"""
PATIENCE = 60  # seconds that a kernel may take to come to what it is asked

READY = """() => {
  const panel = globalThis.jupyterapp?.shell.currentWidget;
  return panel?.sessionContext?.session?.kernel?.status === "idle" && panel.content.widgets.length;
}"""

RUN_ALL = "async () => { await jupyterapp.commands.execute('notebook:run-all-cells'); }"

RUN_CELL = """async (index) => {
  const { content, context } = jupyterapp.shell.currentWidget;
  content.activeCellIndex = index;
  await jupyterapp.commands.execute("notebook:run-cell");
  const json = content.model.cells.get(index).toJSON();
  return json.outputs;
}"""

ADD_CELL = """(source) => {
  const { model } = jupyterapp.shell.currentWidget.content;
  const index = model.cells.length;
  model.sharedModel.insertCell(index, { cell_type: "code", source, metadata: {} });
  return index;
}"""


@dataclass(frozen=True)
class Lab:
    """A running server and the folder that it serves."""

    url: str
    root: Path

    def write(self, *cells: str) -> str:
        """Write a notebook; return its name."""
        name = f"test_{next(NUMBERS)}.ipynb"
        notebook = nbformat.v4.new_notebook(
            cells=[nbformat.v4.new_code_cell(cell) for cell in cells],
            metadata={"kernelspec": {"name": "python3", "display_name": "Python 3"}},
        )
        nbformat.write(notebook, self.root / name)
        return name

    def request(self, method: str, path: str) -> Any:
        """Ask the server's own interface."""
        request = urllib.request.Request(f"{self.url}/api/{path}", method=method)
        with urllib.request.urlopen(request, timeout=20) as answer:
            text = answer.read()
        return json.loads(text) if text else None

    def stop_kernels(self) -> None:
        """Shut all kernels down."""
        for session in self.request("GET", "sessions"):
            self.request("DELETE", f"sessions/{session['id']}")


class Window:
    """A page that shows views, whatever serves it."""

    def __init__(self, page: Page) -> None:
        self.page = page
        self.messages: list[str] = []
        page.on("console", lambda said: self.messages.append(f"{said.type}: {said.text}"))
        page.on("pageerror", lambda error: self.messages.append(f"error: {error}"))

    def evaluate(self, script: str, argument: Any = None) -> Any:
        """Value of JavaScript in the page."""
        return self.page.evaluate(script, argument)

    def views(self) -> int:
        """How many views the page holds."""
        return int(self.evaluate(f"{PAGE}?.views.length ?? 0"))

    def view(self, name: str = "view", stage: int = -1, seconds: float = 30) -> "Shown":
        """Return the newest view of this name once it stands in the page."""
        shown = Shown(self, name, stage)
        script = f"() => {shown.stage} !== undefined"
        self.page.wait_for_function(script, timeout=1000 * seconds)
        return shown


class Notebook(Window):
    """A notebook that is open in a page of JupyterLab."""

    def __init__(self, lab: Lab, page: Page, name: str) -> None:
        super().__init__(page)
        self.lab = lab
        self.name = name
        self.open()

    def open(self) -> None:
        """Open the notebook, or load its page again, and wait for the kernel."""
        workspace = f"{self.name.removesuffix('.ipynb')}-{next(NUMBERS)}"
        self.page.goto(f"{self.lab.url}/lab/workspaces/{workspace}/tree/{self.name}")
        self.page.wait_for_function(READY, timeout=60_000)

    def run_cell(self, index: int) -> list[dict[str, Any]]:
        """Run a cell of the notebook; return its outputs."""
        outputs: list[dict[str, Any]] = self.page.evaluate(RUN_CELL, index)
        errors = [output for output in outputs if output["output_type"] == "error"]
        if errors:
            raise AssertionError("\n".join(errors[0]["traceback"]))
        return outputs

    def run(self, code: str) -> list[dict[str, Any]]:
        """Run code in a new cell at the end; return its outputs."""
        return self.run_cell(self.page.evaluate(ADD_CELL, code))

    def execute(self, code: str) -> str:
        """Run code in the kernel without a cell; return what it prints, show nothing."""
        status, said = self.page.evaluate(EXECUTE, f"{code}\nNone")
        if status != "ok":
            raise AssertionError(said)
        return str(said)

    @contextmanager
    def busy(self, code: str = "", *, hears: bool = False) -> Iterator[None]:
        """Let the kernel run code, and then keep it busy for as long as the block runs.

        JupyterLab may send what widgets say to a subshell, a thread beside the running cell: that
        is kept waiting too, unless the kernel `hears` and tells of changes meanwhile.
        """
        number = next(NUMBERS)
        begun, over = (self.lab.root / f"{what}_{number}" for what in ("begun", "over"))
        hold = HOLD.format(begun=str(begun), over=str(over), hears=hears)
        running = self.page.evaluate_handle(START, f"{code}\n{hold}")
        try:
            limit = monotonic() + PATIENCE
            while not begun.exists():
                if monotonic() > limit:
                    raise AssertionError(f"the kernel has not come to its code in {PATIENCE} s")
                self.page.wait_for_timeout(20)
            yield
        finally:
            over.touch()
        status, said = running.evaluate(ENDED)
        if status != "ok":
            raise AssertionError(said)

    def wait_until(self, condition: str, seconds: float = 30) -> None:
        """Wait until a Python expression is true: what the page has told comes in its own time."""
        limit = monotonic() + seconds
        while not self.value(f"bool({condition})"):
            if monotonic() > limit:
                raise AssertionError(f"not within {seconds} s: {condition}")
            self.page.wait_for_timeout(100)

    def value(self, expression: str) -> Any:
        """Value of a Python expression, arrays as arrays."""
        code = f"import json as _j, numpy as _n\nprint(_j.dumps(_n.asarray({expression}).tolist()))"
        return np.asarray(json.loads(self.execute(code)))


class Shown:
    """One output of one view in a page."""

    def __init__(self, notebook: Window, name: str, stage: int) -> None:
        self.notebook = notebook
        self.connection = f"{PAGE}?.views.filter(v => v.name === {json.dumps(name)}).at(-1)"
        self.stage = f"{self.connection}?.stages.at({stage})"

    def evaluate(self, script: str) -> Any:
        """Value of JavaScript in which `view` and `stage` are this output."""
        return self.notebook.evaluate(
            f"() => {{ const view = {self.connection}; const stage = {self.stage}; "
            f"return ({script}); }}"
        )

    def wait_until(self, script: str, seconds: float = 10) -> None:
        """Wait until JavaScript about `view` and `stage` is true."""
        self.notebook.page.wait_for_function(
            f"() => {{ const view = {self.connection}; const stage = {self.stage}; "
            f"return view && stage && ({script}); }}",
            timeout=1000 * seconds,
        )

    def settle(self) -> None:
        """Wait until the camera stands still and the picture is drawn, half a second at least."""
        self.notebook.page.wait_for_timeout(500)
        self.wait_until("stage.settled")

    def pose(self, path: str) -> NDArray[np.float64]:
        """Pose of a node in the world as three.js has it, shape (4, 4)."""
        numbers = self.evaluate(f"view.pose({json.dumps(path)}, stage)")
        if numbers is None:
            raise AssertionError(f"the page has no node {path!r}")
        return np.array(numbers, dtype=float).reshape(4, 4)

    def paths(self) -> list[str]:
        """Paths of all nodes in the page."""
        return list(self.evaluate("[...view.scene.paths.keys()]"))

    def pixels(self) -> NDArray[np.uint8]:
        """The picture as it is drawn now, without bars, shape (height, width, 3)."""
        kept = "stage.studio.picture().then((kept) => kept.toDataURL('image/png'))"
        url = str(self.evaluate(kept))
        png = base64.b64decode(url.removeprefix("data:image/png;base64,"))
        return np.asarray(Image.open(BytesIO(png)).convert("RGB"))

    def click(self, action: str) -> None:
        """Press a button of the toolbar or of the player."""
        self.evaluate(f"stage.element.querySelector('[data-action={action}]').click()")
