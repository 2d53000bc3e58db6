"""Mechanisms of the textbooks, made of their tables: each function gives a fresh robot."""

from dhlab.models.limb import arm, finger, hand, thumb, upper_limb

__all__ = ["arm", "finger", "hand", "thumb", "upper_limb"]
