"""What binds a panel's sliders to the page: all values of a robot in one message."""

import secrets
from collections.abc import Sequence
from importlib.resources import files
from typing import Any
from uuid import uuid4

import anywidget
import numpy as np
import traitlets

from dhlab.view import assets

STATIC = files("dhlab.panel") / "static"


class Link(anywidget.AnyWidget):
    """Invisible widget that sets a panel's sliders in the page and hears of the user's hand.

    Attributes
    ----------
    values : bytes
        What the page is to show: number of the message, number of the last `drag` that is
        answered, then the value of each slider in its own unit, as float64.
    robots : list of dict
        What the sliders are of, for a page without a kernel that is made of the saved notebook.
    clocks : list of str
        For each slider the clock of the planned motion that it is in, or nothing.
    drag : list
        From the page, the newest only: number, number of the grasp that it belongs to, slider,
        value.
    """

    _esm = assets.bundle("link", STATIC)
    _css = (STATIC / "panel.css").read_text(encoding="utf-8")

    own_id = traitlets.Unicode().tag(sync=True)
    token = traitlets.Unicode().tag(sync=True)
    sliders = traitlets.List(traitlets.Unicode()).tag(sync=True)
    joints: traitlets.List[Any] = traitlets.List().tag(sync=True)
    robots: traitlets.List[Any] = traitlets.List().tag(sync=True)
    folds: traitlets.List[Any] = traitlets.List().tag(sync=True)
    values = traitlets.Bytes().tag(sync=True)
    clocks = traitlets.List(traitlets.Unicode()).tag(sync=True)
    drag: traitlets.List[Any] = traitlets.List().tag(sync=True, echo_update=False)

    def __init__(self, **options: Any) -> None:
        self._count = 0
        own_id = uuid4().hex
        super().__init__(model_id=own_id, own_id=own_id, **options)

    def tell(self, answered: int, shown: Sequence[float], clocks: Sequence[str]) -> None:
        """Tell the page the values of all sliders: one message."""
        self._count += 1
        with self.hold_sync():
            self.clocks = list(clocks)
            self.values = np.array([self._count, answered, *shown]).tobytes()


def make_token() -> str:
    """Make a name for a panel that no other has; its sliders carry it in the page."""
    return secrets.token_hex(6)
