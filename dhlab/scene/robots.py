"""The factories of robots: a chain from its table, several robots on one base."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from dhlab.kinematics.chain import Chain
from dhlab.kinematics.dh import Convention
from dhlab.scene.handle import CHANGES
from dhlab.scene.robot import Robot, check_robots


def robot(
    rows: Sequence[ArrayLike],
    joints: str | Sequence[str],
    *,
    name: str | None = None,
    base: ArrayLike | None = None,
    grasper: ArrayLike | None = None,
    limits: ArrayLike | None = None,
    offset: ArrayLike | None = None,
    convention: Convention = "modified",
    q: ArrayLike | None = None,
    look: str = "solid",
    color: str | ArrayLike | None = None,
    opacity: float = 1.0,
    edges: bool = False,
    radius: float | None = None,
    grasper_size: float | None = None,
    frame_size: float | None = None,
    show_csys: bool = False,
    visible: bool = True,
) -> Robot:
    """Make a robot from its Denavit-Hartenberg table.

    Parameters
    ----------
    rows : sequence of n rows (alpha, a, d, theta) [rad, m, m, rad]
        As `dh` makes them. The variable's column (theta of a revolute, d of a prismatic joint)
        is its home value.
    joints : str or sequence of str
        A letter per joint: 'r' revolute, 'p' or 'd' prismatic.
    name : str, optional
        Unique in the mechanism it is attached to.
    base : array_like, shape (4, 4) or (3,), optional
        Pose of the base, or its origin alone [m].
    grasper : array_like, shape (4, 4) or (3,), optional
        Pose of the grasper (tool) in the last joint's frame, or its origin alone [m].
    limits : array_like, shape (n, 2) [rad or m], optional
        Lower and upper limit of each variable; none unless given.
    offset : array_like, shape (n,) [rad or m], optional
        Added to the variables, as tables of industrial arms want it.
    convention : {'modified', 'standard'}
        How the table is to be read (Craig's, or the distal one).
    q : array_like, shape (n,), optional
        First configuration; the home values unless given.
    look : {'solid', 'stick', 'user'}
    color : str or 3 floats, optional
        ``"#rrggbb"`` or red, green, blue in [0, 1]; from the palette unless given.
    opacity : float in [0, 1]
    edges : bool
    radius : float [m], optional
        Of the drawn joints; what suits the reach unless given.
    grasper_size : float [m], optional
        Opening of the drawn gripper; 0 draws a fingertip.
    frame_size : float [m], optional
        Length of the axes of local coordinate systems.
    show_csys, visible : bool

    Returns
    -------
    r : Robot

    Raises
    ------
    InputError
        A row, letter, pose or limit that cannot be; the message says which.
    LimitError
        The first configuration is outside the limits.

    Examples
    --------
    >>> from dhlab import dh
    >>> r = robot([dh(0, 0, 0, 0), dh(0, 2, 0, 0)], "rr", name="planar", grasper=(1, 0, 0))
    >>> r
    Robot 'planar': 2 variables in 1 component
      planar: RR, modified DH
    >>> robot([dh(0, 0, 0, 0)], "x")
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: joint 1: no joint type 'x'; use 'r' or 'p'

    References
    ----------
    Pajak, section 2.2.
    """
    chain = Chain(
        rows=rows,
        joints=joints,
        convention=convention,
        base=np.eye(4) if base is None else base,
        grasper=np.eye(4) if grasper is None else grasper,
        limits=limits,
        offset=offset,
    )
    made = Robot(chain, name)
    return made.set(
        q=chain.home if q is None else q,
        look=look,
        color=color,
        opacity=opacity,
        edges=edges,
        radius=radius,
        grasper_size=grasper_size,
        frame_size=frame_size,
        show_csys=show_csys,
        visible=visible,
    )


def robot_complex(
    *robots: Robot,
    name: str | None = None,
    base: ArrayLike | None = None,
    radius: float | None = None,
    color: str | ArrayLike | None = None,
    model: str = "plain",
    visible: bool = True,
) -> Robot:
    """Join robots to one mechanism on a common base.

    The robots stay where they are in the world; from then on their bases are poses in the
    base of the complex, and moving that moves all. The keywords describe the complex itself, not
    its components.

    Parameters
    ----------
    *robots : Robot
        In the order of the complex's configuration.
    name : str, optional
    base : array_like, shape (4, 4) or (3,), optional
        Pose of the common base, or its origin alone [m].
    radius : float [m], optional
        Of the bodies drawn from the base to the components' bases.
    color : str or 3 floats, optional
        Of these bodies.
    model : {'plain', 'configex'}
        'configex' marks with spheres where components are joined.
    visible : bool

    Returns
    -------
    R : Robot

    Raises
    ------
    AttachError
        A robot is attached already, or given twice.
    InputError
        Two robots have one name, or there are none.

    Examples
    --------
    >>> from dhlab import dh
    >>> left = robot([dh(0, 0, 0, 0)], "r", name="left")
    >>> right = robot([dh(0, 0, 0, 1)], "r", name="right", base=(1, 0, 0))
    >>> pair = robot_complex(left, right, base=(0, 0, 1))
    >>> pair.q
    array([0., 1.])
    >>> right.base[:3, 3]
    array([ 1.,  0., -1.])

    References
    ----------
    Pajak, section 3.2.
    """
    check_robots(robots, "robot_complex")
    with CHANGES:
        made = Robot(Chain(rows=(), joints="", base=np.eye(4) if base is None else base), name)
        made.own.set(radius=radius, color=color)
        made.set(model=model, visible=visible)
        made.carry(robots)
    return made
