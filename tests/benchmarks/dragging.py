"""One slider of one page, and what follows when it is dragged by a few pixels."""

import math
from dataclasses import dataclass, field
from pathlib import Path
from time import monotonic
from typing import NamedTuple

from playwright.sync_api import Frame, Locator, Page, WebSocket
from rows import median

CLOCK = Path(__file__).with_name("clock.js")
STEP = 2
"""Pixels of one drag, always the same way: no pose comes twice."""

THUMB = """(grip) => {
  const { type, value, min, max } = grip;
  return type === "range" ? (value - min) / (max - min) : 0.5;
}"""
"""Where to take hold of a slider, as a part of its width."""


class Seen(NamedTuple):
    """What one drag did.

    Attributes
    ----------
    arrived : float
        Until the page has the new state, where one can know that; else NaN [ms].
    posed : float
        Until something with a new pose is handed to WebGL, or a frame shows a new text [ms].
    drawn : float
        Until the last picture with a new pose is drawn to its last pixel [ms].
    frames : int
        Animation frames begun until it was posed; 1 is the frame of the drag itself. Known where
        slider and picture are in one frame of the page.
    messages, size : int
        What crossed the page's sockets, both ways, and its bytes.
    """

    arrived: float
    posed: float
    drawn: float
    frames: int
    messages: int
    size: int


@dataclass
class Traffic:
    """What crosses the sockets of a page, both ways; there before the page is opened."""

    page: Page
    sizes: list[int] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.page.on("websocket", self._watch)

    def _watch(self, socket: WebSocket) -> None:
        socket.on("framesent", self._note)
        socket.on("framereceived", self._note)

    def _note(self, frame: str | bytes) -> None:
        self.sizes.append(len(frame.encode() if isinstance(frame, str) else frame))


@dataclass
class Handle:
    """A slider that can be dragged, and where its effect is seen.

    Attributes
    ----------
    page : Page
    traffic : Traffic
    grip : Locator
        What the hand takes hold of.
    picture : Frame
        The frame of the page in which the effect is seen.
    """

    page: Page
    traffic: Traffic
    grip: Locator
    picture: Frame

    def drag(self) -> Seen:
        """Take hold of the slider, move it once, and let it go."""
        mouse = self.page.mouse
        box = self.grip.bounding_box()
        x = box["x"] + self.grip.evaluate(THUMB) * box["width"]
        y = box["y"] + box["height"] / 2
        mouse.move(x, y)
        mouse.down()
        self._start()
        before = len(self.traffic.sizes)
        mouse.move(x + STEP, y)
        wait_until(self.picture, "benchClock.posed !== null")
        self.page.wait_for_timeout(300)  # for what is still on its way, to be counted
        sizes = self.traffic.sizes[before:]
        began = self.page.evaluate("benchClock.began")
        at = self.picture.evaluate(
            "[benchClock.arrived, benchClock.posed, benchClock.drawn, benchClock.frame]"
        )
        arrived, posed, drawn = (math.nan if time is None else time - began for time in at[:3])
        mouse.up()
        self.page.wait_for_timeout(300)
        return Seen(arrived, posed, drawn, at[3], len(sizes), sum(sizes))

    def _start(self) -> None:
        """Start the clock when nothing moves any more."""
        for _ in range(20):
            for frame in {self.page.main_frame, self.picture}:
                frame.evaluate("benchClock.start()")
            self.page.wait_for_timeout(200)
            if self.picture.evaluate("benchClock.posed === null"):
                return
        raise RuntimeError("the picture does not stand still")


def wait_until(frame: Frame, expression: str, seconds: float = 30) -> None:
    """Look now and then whether JavaScript is true, without a hand in the page's own frames."""
    end = monotonic() + seconds
    while not frame.evaluate(expression):
        if monotonic() > end:
            raise RuntimeError(f"in {seconds} s it did not come true: {expression}")
        frame.page.wait_for_timeout(100)


def summary(drags: list[Seen]) -> Seen:
    """Median of each number of some drags."""
    return Seen(*map(median, zip(*drags, strict=True)))
