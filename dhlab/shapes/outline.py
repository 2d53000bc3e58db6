"""What makes an outline a flat, simple polygon, and what is wrong where it is none."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

FLATNESS = 1e-3
"""How far a corner may lie off its face's plane, as a part of the face's size: coordinates
written with three digits still make a flat face, and nobody sees the difference."""

SLENDER = 1e-9
"""A face or a turn narrower than this part of its size counts as a straight line."""

PLUMP = 1e6
"""A body whose lengths differ by a smaller factor has no slender face."""


def is_plump(*lengths: float) -> bool:
    """Whether a body of such lengths, all above 0, surely has no slender face."""
    return max(lengths) < PLUMP * min(lengths) < float("inf")


def fault_of(outline: NDArray[np.float64], names: Sequence[object]) -> str | None:
    """What keeps an outline from being a flat, simple polygon, in words, or None.

    Parameters
    ----------
    outline : ndarray, shape (k, 3) [m]
    names : sequence of k
        What the corners are called in the words.
    """
    for i, p in enumerate(outline):
        if (outline[i - 1] == p).all():
            return f"has its corners {names[i - 1]} and {names[i]} at the same point"
    centred = outline - outline.mean(axis=0)
    axes = np.linalg.svd(centred, full_matrices=False)[2]
    spread = centred @ axes.T
    length, width, _ = np.ptp(spread, axis=0)
    if width <= SLENDER * length:
        return "has no area: its corners lie on one line"
    height = np.abs(spread[:, 2])
    if height.max() > FLATNESS * length:
        worst = int(height.argmax())
        return f"is not flat: its corner {names[worst]} lies {height[worst]:.3g} off its plane"
    crossing = crossing_sides(spread[:, :2])
    if crossing is None:
        return None
    one, other = (f"{names[i]}-{names[(i + 1) % len(names)]}" for i in crossing)
    return f"crosses itself: its sides {one} and {other} meet"


def crossing_sides(points: NDArray[np.float64], closed: bool = True) -> tuple[int, int] | None:
    """Two sides of a plane outline that meet where they should not, or None.

    Parameters
    ----------
    points : ndarray, shape (k, 2) [m]
    closed : bool
        Whether the last point is joined to the first.

    Returns
    -------
    sides : tuple of 2 ints or None
        Side i goes from point i to the next.
    """
    k = len(points)
    ends = np.roll(points, -1, axis=0)
    along = ends - points
    reach = points[None, :, :] - points[:, None, :]
    left = along[:, None, 0] * reach[..., 1] - along[:, None, 1] * reach[..., 0]
    left[np.abs(left) <= 1e-12 * np.ptp(points, axis=0).max() ** 2] = 0
    parted = left * np.roll(left, -1, axis=1) > 0
    low, high = np.minimum(points, ends), np.maximum(points, ends)
    apart = (low[:, None] > high[None, :]).any(axis=2)
    meet = ~(parted | parted.T | apart | apart.T)
    here = np.arange(k)
    meet[here, here] = False
    folded = np.einsum("ki,ki->k", along, np.roll(along, -1, axis=0)) < 0
    after = (here + 1) % k
    meet[here, after] = folded & (left[here, (here + 2) % k] == 0)
    meet[after, here] = False
    if not closed:
        meet[-1, :] = meet[:, -1] = False
    pairs = np.argwhere(meet)
    return None if len(pairs) == 0 else (int(pairs[0][0]), int(pairs[0][1]))
