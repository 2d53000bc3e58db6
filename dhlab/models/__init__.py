"""Mechanisms of the textbooks, made of their tables: each function gives a fresh robot."""

from dhlab.models.industrial import gripper, industrial_arm, puma, scara
from dhlab.models.limb import arm, finger, hand, thumb, upper_limb

__all__ = [
    "arm",
    "finger",
    "gripper",
    "hand",
    "industrial_arm",
    "puma",
    "scara",
    "thumb",
    "upper_limb",
]
