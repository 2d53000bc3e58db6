"""How the upper limb looks: its parts as meshes, each in the coordinates of the frame it follows.

The forefinger is the paper's, prongs and tongues like hinges; the other parts are made in its
style, after a jointed wooden figure. All lengths are in metres.

References
----------
Pajak, The Matlab toolbox for modeling complex mechanisms, section 4.3.
"""

from collections.abc import Sequence
from functools import cache

import numpy as np
from numpy.typing import NDArray

from dhlab.kinematics.transforms import rotx, roty, rotz, rp2t, transl
from dhlab.shapes import (
    Mesh,
    arc,
    cuboid,
    loft,
    polyhedron,
    prism,
    sphere,
    srevolution,
    tube,
)

WOOD = "#e4bd92"
DARK_WOOD = "#b4875c"

BACK_OF_HAND = (
    (0.000, 0.020),
    (0.020, 0.040),
    *((0.102, 0.032), (0.102, 0.025), (0.084, 0.025), (0.084, 0.019), (0.102, 0.019)),
    *((0.102, 0.003), (0.084, 0.003), (0.084, -0.003), (0.102, -0.003), (0.102, -0.0105)),
    *((0.096, -0.0105), (0.096, -0.017), (0.080, -0.017), (0.080, -0.023), (0.096, -0.023)),
    (0.096, -0.0295),
    *((0.091, -0.0295), (0.091, -0.0355), (0.077, -0.0355), (0.077, -0.0405), (0.091, -0.0405)),
    (0.091, -0.046),
    (0.020, -0.042),
    (0.000, -0.020),
)
"""Corners (x, y) of the palm's upper face: wrist, thumb side, a slot for each finger, wrist."""

BEVELS = {
    **dict.fromkeys((2, 6, 10, 12, 16, 18, 22), (0.003, -0.0125)),  # between the fingers
    **dict.fromkeys((1, 23), (0.004, -0.008)),  # along the thumb's and the little finger's side
}
"""Sides of the palm that are no single wall: how far out they go to half height, then back in."""

UPPER_ARM = (
    (0.000, 0.0480, 0.0480, 0.0000),
    (0.025, 0.0485, 0.0485, 0.0000),
    (0.055, 0.0460, 0.0465, 0.0005),
    (0.080, 0.0445, 0.0430, 0.0015),
    (0.105, 0.0445, 0.0400, 0.0025),
    (0.135, 0.0445, 0.0385, 0.0030),
    (0.165, 0.0420, 0.0375, 0.0025),
    (0.195, 0.0375, 0.0355, 0.0015),
    (0.225, 0.0340, 0.0340, 0.0005),
    (0.250, 0.0315, 0.0330, 0.0000),
)
"""Sections from shoulder to elbow: place, half depth, half width, shift to the front."""

FOREARM = (
    (0.000, 0.0345, 0.0360, 0.0000),
    (0.020, 0.0370, 0.0385, 0.0000),
    (0.045, 0.0395, 0.0415, 0.0000),
    (0.070, 0.0400, 0.0415, 0.0000),
    (0.095, 0.0385, 0.0390, 0.0000),
    (0.120, 0.0350, 0.0350, 0.0000),
)
"""Sections from the elbow to where the forearm turns; it is round there."""

LOWER_FOREARM = (
    (0.120, 0.0350, 0.0350, 0.0000),
    (0.140, 0.0315, 0.0325, 0.0000),
    (0.165, 0.0270, 0.0295, 0.0000),
    (0.190, 0.0230, 0.0270, 0.0000),
    (0.215, 0.0200, 0.0255, 0.0000),
    (0.238, 0.0185, 0.0255, 0.0000),
)
"""Sections from where the forearm turns to the wrist."""


@cache
def phalanx(length: float, radius: float) -> Mesh:
    """Segment of a finger along x: a tongue at its own joint, prongs around the next.

    Parameters
    ----------
    length : float [m]
        From joint to joint.
    radius : float [m]
        Half the thickness of the finger; the paper's forefinger has 0.01.
    """
    return _tongue(radius).merged(_body(length, radius), *_prongs(length, radius))


@cache
def fingertip(length: float, radius: float) -> Mesh:
    """Last segment of a finger along x: a tongue at its joint, round at its end.

    Parameters
    ----------
    length, radius : float [m]
    """
    outline = arc((length - radius, radius), (length - radius, -radius), radius)
    tip = prism(outline, 2 * radius).transformed(transl((0, 0, -radius)))
    return _tongue(radius).merged(_body(length, radius), tip)


@cache
def thumb_root(length: float, radius: float) -> Mesh:
    """First segment of the thumb: a barrel about its own axis, prongs around the next.

    Parameters
    ----------
    length, radius : float [m]
    """
    barrel = tube((0, 0, -0.0125), (0, 0, 0.0125), radius)
    second_joint = rp2t(rotx(-np.pi / 2), (length, 0, 0))
    return barrel.merged(*(opposed(p).transformed(second_joint) for p in _prongs(0, radius)))


def opposed(part: Mesh) -> Mesh:
    """Give a segment turned half about x: the thumb bends the other way than the fingers.

    Parameters
    ----------
    part : Mesh
    """
    return part.transformed(rp2t(rotx(np.pi), (0, 0, 0)))


@cache
def palm() -> Mesh:
    """Palm in the hand's base: 78 vertices in three layers of 26, and 37 faces."""
    upper = np.array(BACK_OF_HAND)
    n = len(upper)
    out, back = np.array([BEVELS.get(side, (0, 0)) for side in range(n)]).T
    middle = _offset(upper, out)
    layers = (upper, 0.015), (_offset(middle, back), -0.015), (middle, 0)
    vertices = np.vstack([np.column_stack([xy, np.full(n, z)]) for xy, z in layers])
    faces: list[Sequence[int]] = [range(n)[::-1], range(n, 2 * n)]
    for i in range(n):
        j = (i + 1) % n
        above, below = (i, j, j + 2 * n, i + 2 * n), (i + 2 * n, j + 2 * n, j + n, i + n)
        faces += [above, below] if i in BEVELS else [(*above[:3], *below[2:], above[3])]
    return polyhedron(vertices, faces)


@cache
def thumb_hinge(radius: float) -> Mesh:
    """Two lugs under the palm that hold the barrel of the thumb, in the hand's base.

    Parameters
    ----------
    radius : float [m]
    """
    near, far = (tube((x, 0.03, -0.015), (x + 0.009, 0.03, -0.015), radius) for x in (0.018, 0.053))
    return near.merged(far)


@cache
def shoulder() -> Mesh:
    """Plate on the side of the body that the arm's ball turns on, in the arm's base."""
    profile = [
        (0, 0.046),
        (0.045, 0.046),
        (0.052, 0.049),
        (0.055, 0.055),
        (0.055, 0.065),
        (0, 0.065),
    ]
    return srevolution(profile, 48).transformed(rp2t(roty(np.pi / 2), (0, 0, 0)))


@cache
def upper_arm() -> Mesh:
    """Upper arm in joint frame 3: along x from the shoulder, its front to y."""
    return _muscle(UPPER_ARM, 0.048, 0.030)


@cache
def forearm() -> Mesh:
    """Half of the forearm in joint frame 4: along -y from the elbow."""
    return _muscle(FOREARM, 0.035, 0.020).transformed(rp2t(rotz(-np.pi / 2), (0, 0, 0)))


@cache
def lower_forearm() -> Mesh:
    """Half of the forearm in joint frame 5, which turns with the hand: along z to the wrist."""
    to_the_wrist = np.array([[0, 1, 0], [0, 0, 1], [1, 0, 0]])
    return _muscle(LOWER_FOREARM, 0.020, 0.010).transformed(rp2t(to_the_wrist, (0, 0, -0.25)))


@cache
def wrist() -> Mesh:
    """Flat ball between forearm and palm, in joint frame 6."""
    ball = sphere(0.0215)
    return Mesh(ball.vertices * (1, 0.7, 1), ball.faces)


def _tongue(r: float) -> Mesh:
    return cuboid(2 * r, r, r / 2).transformed(transl((0, 0, -r / 4)))


def _body(length: float, r: float) -> Mesh:
    return cuboid(length - 2 * r, 2 * r, 2 * r).transformed(transl((length / 2, 0, -r)))


def _prongs(x: float, r: float) -> tuple[Mesh, Mesh]:
    """Two plates around a joint at x; their bevel, to -y, lets the finger bend."""
    pentagon = r * np.array([(-1, -1), (0, -1), (1, 0), (1, 1), (-1, 1)])
    prong = prism(pentagon, 0.7 * r)
    return prong.transformed(transl((x, 0, -r))), prong.transformed(transl((x, 0, 0.3 * r)))


def _offset(outline: NDArray[np.float64], out: NDArray[np.float64]) -> NDArray[np.float64]:
    """Move each side of a clockwise outline outwards by its own distance."""
    along = np.roll(outline, -1, axis=0) - outline
    normal = np.column_stack([-along[:, 1], along[:, 0]])
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    reach = np.einsum("ij,ij->i", normal, outline) + out
    before = np.roll(normal, 1, axis=0), np.roll(reach, 1)
    corners: NDArray[np.float64] = np.linalg.solve(
        np.stack([before[0], normal], axis=1), np.stack([before[1], reach], axis=1)[..., None]
    )[..., 0]
    return corners


def _muscle(table: Sequence[Sequence[float]], start: float, end: float) -> Mesh:
    """Give a body along x through oval sections, with a dome of some length at either end."""
    rows = np.array(table)
    turn = np.linspace(0, 2 * np.pi, 32, endpoint=False)
    rise = np.radians([80, 64, 48, 32, 16])
    first = [(rows[0, 0] - start * np.sin(a), *(np.cos(a) * rows[0, 1:])) for a in rise]
    last = [(rows[-1, 0] + end * np.sin(a), *(np.cos(a) * rows[-1, 1:])) for a in rise[::-1]]
    return loft(
        [
            np.column_stack([np.full(32, x), front + a * np.cos(turn), b * np.sin(turn)])
            for x, a, b, front in [*first, *rows, *last]
        ]
    )
