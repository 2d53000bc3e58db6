"""Pieces that the tests of the views share."""

from collections.abc import Callable, Iterator
from itertools import count
from typing import Any

import numpy as np
import pytest

from dhlab.scene.handle import CHANGES, Handle
from dhlab.scene.node import Node, Style
from dhlab.shapes import cube
from dhlab.view import RecordingBackend, View

NUMBERS = count()


class Box(Handle):
    """A handle with a pose, a colour and a lid, to be watched."""

    kind = "box"

    def __init__(self, name: str | None = None) -> None:
        super().__init__(name)
        self.shape = cube(1)
        self.pose = np.eye(4)
        self.color = (0.5, 0.5, 0.5)
        self.has_lid = True
        self.described = 0

    def change(self, **values: Any) -> None:
        with CHANGES:
            vars(self).update(values)
            self._changed()

    def shift(self, x: float) -> None:
        self.change(pose=np.eye(4) + x * np.eye(4, k=3))

    def _nodes(self, path: str) -> dict[str, Node]:
        self.described += 1
        nodes = {path: Node(pose=self.pose)}
        nodes[f"{path}/body"] = Node(shape=self.shape, style=Style(color=self.color))
        if self.has_lid:
            nodes[f"{path}/lid"] = Node()
            nodes[f"{path}/lid/knob"] = Node(shape=cube(0.1))
        return nodes


class FakeComm:
    """A channel without a page: it keeps what is sent, and says what a page would say."""

    def __init__(self, comm_id: str, opened: dict[str, Any]) -> None:
        self.comm_id = comm_id
        self.opened = opened
        self.sent: list[tuple[dict[str, Any], list[Any]]] = []
        self.is_closed = False
        self._callback: Callable[[Any], None] = lambda message: None

    def send(self, data: dict[str, Any], buffers: Any = None) -> None:
        self.sent.append((data, list(buffers or [])))

    def on_msg(self, callback: Callable[[Any], None]) -> None:
        self._callback = callback

    def close(self) -> None:
        self.is_closed = True

    def receive(self, content: dict[str, Any]) -> None:
        data = {"method": "custom", "content": content}
        self._callback({"content": {"data": data}, "buffers": []})

    @property
    def batches(self) -> list[tuple[dict[str, Any], bytes]]:
        return [
            (data["content"], buffers[0])
            for data, buffers in self.sent
            if data["method"] == "custom"
        ]


@pytest.fixture
def comms(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[FakeComm]]:
    """The channels that widgets open during a test; all are closed after it."""
    import ipywidgets

    opened: list[FakeComm] = []

    def create(**options: Any) -> FakeComm:
        opened.append(FakeComm(options.get("comm_id", f"comm-{next(NUMBERS)}"), options))
        return opened[-1]

    monkeypatch.setattr("ipywidgets.comm.create_comm", create)
    monkeypatch.delenv("DHLAB_VIEW", raising=False)
    ipywidgets.Widget.close_all()
    yield opened
    ipywidgets.Widget.close_all()


@pytest.fixture
def recorded() -> tuple[View, RecordingBackend]:
    """A view and what it sends; it sends when it is looked at."""
    backend = RecordingBackend()
    return View("test", backend=backend), backend


@pytest.fixture
def box() -> Box:
    return Box("crate")
