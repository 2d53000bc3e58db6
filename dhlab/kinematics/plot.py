"""A picture of a motion, by matplotlib, which is imported only when it is asked for."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def plot_motion(
    t: NDArray[np.float64],
    motion: Sequence[NDArray[np.float64]],
    axes: "Sequence[Axes] | None" = None,
) -> "Sequence[Axes]":
    """Plot configuration, velocity and acceleration over time.

    Parameters
    ----------
    t : ndarray, shape (m,) [s]
    motion : sequence of 3 ndarray, shape (m, n)
        Configurations, velocities, accelerations.
    axes : sequence of 3 matplotlib axes, or None
        Where to plot; None: a new figure.

    Returns
    -------
    axes : sequence of 3 matplotlib axes
    """
    if axes is None:
        axes = _new_axes()
    labels = [f"joint {i + 1}" for i in range(motion[0].shape[1])]
    units = ("[rad or m]", "[rad/s or m/s]", "[rad/s² or m/s²]")
    for ax, curves, letter, unit in zip(axes, motion, "qva", units, strict=True):
        ax.plot(t, curves, label=labels)
        ax.set_ylabel(f"{letter} {unit}")
        ax.grid(visible=True)
    axes[0].legend(loc="upper left", bbox_to_anchor=(1, 1), fontsize="small")
    axes[-1].set_xlabel("t [s]")
    return axes


def _new_axes() -> "Sequence[Axes]":
    try:
        from matplotlib import pyplot
    except ImportError:
        raise ImportError("a plot needs matplotlib: pip install 'dhlab[plot]'") from None
    axes: Sequence[Axes] = pyplot.subplots(3, sharex=True, layout="constrained")[1]
    return axes
