"""One notebook as a person has it in any front end: a picture, sliders, a button and a line.

The line is written by the kernel: what Python knows of the robot. So the tests need no way into
the kernel but the one that every front end has for widgets.
"""

import json
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
import psutil
from numpy.typing import NDArray

from .lab import Shown, Window
from .test_panel import Sliders

SETUP = """
import json
import os
import ipywidgets
import numpy as np
from IPython.display import display
from dhlab import Panel, View, animate, models, side_by_side

limb = models.upper_limb()
line = ipywidgets.Label()
line.add_class("told")

class Teller:
    def handle_changed(self, handle):
        line.value = json.dumps({"q": limb.q.tolist(), "process": os.getpid()})

teller = Teller()
limb.watch(teller)

def move(button):
    q0, q1 = limb.home, limb.clip(limb.home - 0.4)
    animate(np.linspace(0, 1.5, 31), {limb: lambda t: q0 + t / 1.5 * (q1 - q0)})

planned = ipywidgets.Button(description="Move")
planned.on_click(move)
"""
SHOW = """
teller.handle_changed(limb)
display(ipywidgets.HBox([planned, line]))
side_by_side(View("limb").add(limb), Panel(limb))
"""
TOLD = "document.querySelector('.told')?.textContent"
PLAYER = "view.scene.players.at(-1)"


CELLS = (SETUP, SHOW)


class Seat(Window):
    """The notebook in front of a person; `shown` is its picture."""

    shown: Shown
    sliders: Sliders

    def wait_for_it(self) -> None:
        """Return when picture, sliders and line are there."""
        self.shown = self.view("limb", seconds=120)
        self.shown.wait_until("stage.settled && view.scene.nodes.size > 60", seconds=60)
        self.page.wait_for_function(f"() => {TOLD}", timeout=30_000)
        self.sliders = Sliders(self)
        self.wait_for_agreement()

    @property
    def told(self) -> dict[str, Any]:
        """What Python knows."""
        known: dict[str, Any] = json.loads(self.page.locator(".told").last.inner_text())
        return known

    @property
    def q(self) -> NDArray[np.float64]:
        """Configuration in Python, shape (27,)."""
        return np.asarray(self.told["q"], dtype=float)

    def press(self, name: str) -> None:
        """Press a button of the notebook."""
        self.page.get_by_role("button", name=name, exact=True).click()

    def drag(self, index: int, pixels: float) -> None:
        """Drag a slider with the mouse."""
        self.sliders.handle(index).scroll_into_view_if_needed()
        self.sliders.drag(index, pixels)

    def wait_for_agreement(self, before: NDArray[np.float64] | None = None) -> None:
        """Return when the sliders show what Python knows, to the last digit, and not `before`."""
        given = None if before is None else before.tolist()
        self.page.wait_for_function(AGREE, arg=given, timeout=30_000)

    @contextmanager
    def busy(self) -> Iterator[None]:
        """Keep the kernel from doing anything."""
        kernel = psutil.Process(self.told["process"])
        kernel.suspend()
        try:
            yield
        finally:
            kernel.resume()


AGREE = f"""(before) => {{
  const rows = [...document.querySelectorAll(".dhlab-joint .widget-readout")];
  const shown = rows.map((row) => Number(row.textContent.replace("\\u2212", "-")));
  const {{ q }} = JSON.parse({TOLD});
  if (before?.every((angle, i) => angle === q[i])) return false;
  return q.length === shown.length && q.every(
    (angle, i) => Math.abs((180 / Math.PI) * angle - shown[i]) < 0.051);
}}"""
