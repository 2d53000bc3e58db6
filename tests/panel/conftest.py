"""Pieces that the tests of the panels share."""

import numpy as np
import pytest
from numpy import pi

from dhlab import dh, models, robot
from dhlab.panel import Panel
from tests.view.conftest import FakeComm, comms

__all__ = ["FakeComm", "comms"]


class Page:
    """What a page is told by a panel and what it says: the other end of the channels."""

    def __init__(self, comms, panel):
        self._comms = comms
        self.panel = panel
        self.opened = len(comms)

    @property
    def told(self):
        """Messages with state since the last `forget`, as (widget's channel, state)."""
        return [
            (comm, data)
            for comm in self._comms
            for data, _ in comm.sent
            if data["method"] in ("update", "custom")
        ]

    @property
    def link(self):
        return self.panel._board.link

    @property
    def values(self):
        """Last values told: number, answered drag, and each slider's."""
        number, answered, *shown = np.frombuffer(self.link.values)
        return int(number), int(answered), shown

    def forget(self):
        for comm in self._comms:
            comm.sent.clear()

    def drag(self, number, grasp, index, value):
        self.link.set_state({"drag": [number, grasp, index, value]})

    def release(self, index, value):
        """Let go of a slider, or type a value: the slider itself tells its value."""
        self.panel.sliders[index].set_state({"value": value})


@pytest.fixture
def limb():
    return models.upper_limb()


@pytest.fixture
def scara():
    """An arm with a revolute joint in limits and two prismatic ones, one without limits."""
    rows = [dh(0, 0, 0, 0), dh(0, 0.4, 0.1, 0), dh(0, 0.3, 0.0, 0)]
    limits = [(-pi / 2, pi / 2), (0, 0.25), (-np.inf, np.inf)]
    return robot(rows, "rpp", name="scara", limits=limits)


@pytest.fixture
def page(comms, limb):
    """A page that shows the panel of a limb."""
    panel = Panel(limb, seed=1)
    panel.widget  # noqa: B018
    return Page(comms, panel)
