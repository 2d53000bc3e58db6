"""From a slider's drag to the picture: dhlab beside a bare pair of sliders and other viewers.

The viewers take turns: each is opened, dragged a few times and closed, several times over. All
pages are in one browser, and one clock looks at what they hand to WebGL (`clock.js`). dhlab shows
the whole limb, the others 32 small boxes, one for each frame of it, for which dhlab's kinematics
works out the poses.
"""

from collections.abc import Iterator

from contenders import dhlab, meshcat, swift, viser
from dragging import Seen, summary
from peers import PeerMissingError
from rows import Row, Skipped

ROUNDS = 3
DRAGS = 10
FRAME = 16.7
SHOWN = {
    "meshcat": "meshcat, ipywidgets",
    "viser": "viser, its slider",
    "swift": "Swift, its slider, 60 Hz",
}


def measure() -> Iterator[Row | Skipped]:
    from page import open_lab

    drags: dict[str, list[Seen]] = {}
    missing: dict[str, str] = {}
    with open_lab() as desk:
        for _ in range(ROUNDS):
            for contender in (dhlab, meshcat, viser, swift):
                if contender.__name__ in missing:
                    continue
                try:
                    with contender(desk) as handles:
                        for name, handle in handles.items():
                            handle.drag()
                            seen = [handle.drag() for _ in range(DRAGS)]
                            drags.setdefault(name, []).extend(seen)
                except PeerMissingError as error:
                    missing[contender.__name__] = str(error)
    seen = {name: summary(those) for name, those in drags.items()}
    yield from times(seen)
    yield from traffic(seen)
    yield from (Skipped(name, reason) for name, reason in missing.items())


def times(seen: dict[str, Seen]) -> Iterator[Row]:
    """From the drag to the pose and to the picture."""
    bare, panel, plain = seen["bare"], seen["panel"], seen["plain"]
    yield Row(
        "panel: animation frames, that of the drag counted", panel.frames, target="<= 1", unit=""
    )
    others = {"a bare pair of sliders": bare}
    others |= {shown: seen[name] for name, shown in SHOWN.items() if name in seen}
    for name, other in others.items():
        yield Row("panel: drag to the frame that shows it", panel.posed, other.posed, name)
    later = "through the kernel: later than a bare pair"
    yield Row(f"{later}, in the page", plain.arrived - bare.arrived, target=f"<= {FRAME}")
    yield Row(f"{later}, the frame", plain.posed - bare.posed, target=f"<= {FRAME}")
    for name, other in others.items():
        yield Row("through the kernel: drag to that frame", plain.posed, other.posed, name)
    for name, other in others.items():
        if name in SHOWN.values():
            yield Row("panel: drag to the last pixel", panel.drawn, other.drawn, name)


def traffic(seen: dict[str, Seen]) -> Iterator[Row]:
    """What crosses the page's sockets, both ways, in the half second after a drag."""
    others = {"bare": "a bare pair of sliders", **SHOWN}
    for name, shown in others.items():
        if name not in seen:
            continue
        for own, what in (("panel", "panel"), ("plain", "through the kernel")):
            here, there = seen[own], seen[name]
            yield Row(f"{what}: messages of a drag", here.messages, there.messages, shown, "")
            yield Row(f"{what}: bytes of a drag", here.size, there.size, shown, "B")
