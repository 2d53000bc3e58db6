"""A scene of viser with the limb's frames and a slider; run by an interpreter that has viser.

It prints where its page is, and ends when its input does.
"""

import sys

import viser
import viser.transforms
from limb_boxes import BOX, COLOR, frames_of, wait_for_end


def main() -> None:
    server = viser.ViserServer(host="127.0.0.1", port=int(sys.argv[1]), verbose=False)
    poses = frames_of(0.0)
    boxes = [
        server.scene.add_box(f"/{name}", color=COLOR, dimensions=(BOX, BOX, BOX)) for name in poses
    ]
    slider = server.gui.add_slider("joint 1", min=-1.0, max=1.0, step=0.001, initial_value=0.0)

    def place(value: float) -> None:
        with server.atomic():
            for box, pose in zip(boxes, frames_of(value).values(), strict=True):
                box.wxyz = viser.transforms.SO3.from_matrix(pose[:3, :3]).wxyz
                box.position = pose[:3, 3]

    place(0.0)
    slider.on_update(lambda _: place(slider.value))
    wait_for_end(f"http://127.0.0.1:{server.get_port()}")


if __name__ == "__main__":
    main()
