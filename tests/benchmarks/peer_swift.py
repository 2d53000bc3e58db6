"""A scene of Swift with the limb's frames and a slider; run by an interpreter that has Swift.

It prints where its page is, and ends when its input does. Swift looks for what a slider did when
it draws, so it draws all the time, sixty times a second.
"""

import threading
import webbrowser

import swift
from limb_boxes import BOX, COLOR, frames_of, wait_for_end
from spatialgeometry import Cuboid
from spatialmath import SE3


def main() -> None:
    url: list[str] = []
    webbrowser.open_new_tab = lambda address: url.append(address) or announce(address)
    scene = swift.Swift()
    scene.launch(rate=60)
    color = [part / 255 for part in COLOR]
    boxes = [Cuboid([BOX, BOX, BOX], color=color) for _ in frames_of(0.0)]

    def poses(q):
        return [SE3(pose, check=False) for pose in frames_of(q[0]).values()]

    assembly = scene.add_assembly(poses, boxes, q0=[0.0])

    def place(value):
        assembly.q = [value]

    scene.add_ui(swift.Slider(place, min=-1, max=1, step=0.001, value=0, label="joint 1"))
    scene.run(dt=1 / 60)


def announce(url: str) -> None:
    """Say where the page is: it is opened by whoever started this."""
    threading.Thread(target=wait_for_end, args=(url,), daemon=True).start()


if __name__ == "__main__":
    main()
