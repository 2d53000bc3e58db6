"""The limb as other viewers show it here: a small box at each of its 32 frames."""

import sys

import numpy as np

from dhlab.kinematics.transforms import transl
from dhlab.models import upper_limb

BOX = 0.04
SHOULDER = 0.8  # [m] above the ground, which some of them draw
COLOR = (70, 130, 180)
limb = upper_limb()


def frames_of(first: float) -> dict[str, np.ndarray]:
    """Poses of all frames by name, joint 1 at `first` [rad], the others at home."""
    q = limb.home.copy()
    q[0] = first
    frames = limb.frames(q)
    return {name: transl((0, 0, SHOULDER)) @ pose for name, pose in frames.items()}


def wait_for_end(url: str) -> None:
    """Say where the page is, and return when whoever started this closes the input."""
    sys.stdout.write(url + "\n")
    sys.stdout.flush()
    sys.stdin.read()
