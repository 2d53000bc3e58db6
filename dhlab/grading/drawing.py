"""What the drawings of exercises have in common: joint axes with their names."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from dhlab.scene.arrow import Arrow, arrow
from dhlab.scene.robot import Robot

AXIS_COLOR = "#8a4b00"


def joint_axes(
    robot: Robot, length: float, reach: Mapping[int, ArrayLike] | None = None
) -> list[Arrow]:
    """Make a line along each joint axis of a robot as it stands now, called "axis 1" and so on.

    Nothing but where the axis lies is shown: neither which way z points nor where a frame is.

    Parameters
    ----------
    robot : Robot
        One chain.
    length : float [m]
        From the joint to either end of the line.
    reach : mapping of int to (float, float), optional [m]
        For some joints how far the line goes to either side, so that axes which coincide can be
        told apart. The label stands at the other, higher end; of a level axis at the near one.

    Returns
    -------
    axes : list of Arrow

    Examples
    --------
    >>> from dhlab import robot
    >>> joint_axes(robot([(0, 0, 0, 0)], "r", name="arm"), 0.2)
    [Arrow 'axis 1' 'axis 1' from (0, 0, -0.2) to (0, 0, 0.2)]
    """
    axes = []
    frames = robot.frames()
    for i in range(1, robot.own.n + 1):
        T = frames[f"{robot.name}/{i}"]
        below, above = np.asarray((reach or {}).get(i, (length, length)), dtype=np.float64)
        towards = tuple((T[[2, 1, 0], 2] * (1, -1, 1)).round(9))  # up; to the front; to the right
        z = T[:3, 2] if towards >= (0, 0, 0) else -T[:3, 2]
        axes.append(
            arrow(
                T[:3, 3] - below * z,
                T[:3, 3] + above * z,
                f"axis {i}",
                heads="none",
                label_at=1.0 + 0.06 * (below + above + length) / (below + above),
                name=f"axis {i}",
                color=AXIS_COLOR,
            )
        )
    return axes
