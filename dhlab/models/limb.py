"""The paper's upper limb: its tables as data, and the robots made of them."""

from numpy import pi

from dhlab.errors import InputError
from dhlab.kinematics.dh import dh
from dhlab.kinematics.transforms import roty, rp2t
from dhlab.models import limb_look as look
from dhlab.scene.block import Block, block_complex
from dhlab.scene.robot import Robot
from dhlab.scene.robots import robot, robot_complex
from dhlab.shapes import Mesh

FINGERS = {  # name: (l2, l3, l4, base, radius, spread)                        [m], [rad]
    "index": (0.050, 0.030, 0.025, (0.095, 0.022, 0), 0.010, (-pi / 9, 0)),
    "middle": (0.055, 0.035, 0.025, (0.095, 0.000, 0), 0.010, (-pi / 18, pi / 18)),
    "ring": (0.050, 0.030, 0.025, (0.090, -0.020, 0), 0.009, (0, pi / 9)),
    "little": (0.040, 0.025, 0.023, (0.085, -0.038, 0), 0.008, (0, pi / 5)),
}
"""What differs between the long fingers (paper, sections 4.1 and 4.2, table 3)."""


def finger(name: str = "index") -> Robot:
    """One long finger, a 4R chain (table 1); it spreads, then flexes three times.

    Parameters
    ----------
    name : {'index', 'middle', 'ring', 'little'}

    Returns
    -------
    finger : Robot
        Its base is where the hand has it; x points along the finger, z to the back of the hand.

    Raises
    ------
    InputError
        There is no such finger.

    Examples
    --------
    >>> index = finger()
    >>> index.q = [0, -pi / 2, -pi / 2, -pi / 2]
    >>> index.frames()["index/grasper"][:3, 3].round(6) + 0
    array([ 0.065,  0.022, -0.025])
    >>> finger("thumb")
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: no finger 'thumb'; there are 'index', 'middle', 'ring', 'little'

    References
    ----------
    Pajak, The Matlab toolbox for modeling complex mechanisms, tables 1 and 3, section 4.2.
    """
    if name not in FINGERS:
        raise InputError(f"no finger {name!r}; there are {', '.join(map(repr, FINGERS))}")
    l2, l3, l4, base, radius, spread = FINGERS[name]
    made = robot(
        [
            dh(pi, 0, 0, 0),  # alpha_{i-1}, a_{i-1}, d_i, theta_i
            dh(-pi / 2, 0, 0, -pi / 16),
            dh(0, l2, 0, -pi / 8),
            dh(0, l3, 0, -pi / 8),
        ],
        "rrrr",
        name=name,
        base=base,
        grasper=(l4, 0, 0),
        grasper_size=0,
        radius=radius,
        limits=[spread] + 3 * [(-pi / 2, 0)],
    )
    made.set_part(_wood(look.phalanx(l2, radius)), joint=2)
    made.set_part(_wood(look.phalanx(l3, radius)), joint=3)
    made.set_part(_wood(look.fingertip(l4, radius)), joint=4)
    return made


def thumb() -> Robot:
    """The thumb, a 4R chain whose first link has a length (table 2).

    Returns
    -------
    thumb : Robot
        Its base is where the hand has it, turned by pi/2 about y.

    Examples
    --------
    Its second angle turns it from the palm (-z) to the fingers (x):

    >>> t = thumb()
    >>> t.frames([0, 0, 0, 0])["thumb/2"][:3, 0].round(6) + 0
    array([ 0.,  0., -1.])
    >>> t.frames([0, pi / 2, 0, 0])["thumb/2"][:3, 0].round(6) + 0
    array([1., 0., 0.])

    References
    ----------
    Pajak, The Matlab toolbox for modeling complex mechanisms, tables 2 and 3, section 4.2.
    """
    l1, l2, l3, l4, radius = 0.015, 0.050, 0.040, 0.030, 0.012
    made = robot(
        [
            dh(pi, 0, 0, -pi / 8),
            dh(-pi / 2, l1, 0, pi / 4),
            dh(0, l2, 0, pi / 4),
            dh(0, l3, 0, pi / 4),
        ],
        "rrrr",
        name="thumb",
        base=rp2t(roty(pi / 2), (0.040, 0.030, -0.015)),
        grasper=(l4, 0, 0),
        grasper_size=0,
        radius=radius,
        limits=[(-pi / 2, 0)] + 3 * [(0, pi / 2)],
    )
    made.set_part(_wood(look.thumb_root(l1, radius)), joint=1)
    made.set_part(_wood(look.opposed(look.phalanx(l2, radius))), joint=2)
    made.set_part(_wood(look.opposed(look.phalanx(l3, radius))), joint=3)
    made.set_part(_wood(look.opposed(look.fingertip(l4, radius))), joint=4)
    return made


def hand() -> Robot:
    """The right hand: thumb, index, middle, ring and little finger on a common base.

    Returns
    -------
    hand : Robot
        20 variables. In its base x points to the fingers, y to the thumb, z out of the back.

    Examples
    --------
    >>> hand().n
    20

    References
    ----------
    Pajak, The Matlab toolbox for modeling complex mechanisms, section 4.2.
    """
    fingers = [finger(name) for name in FINGERS]
    made = robot_complex(thumb(), *fingers, name="hand", radius=0.010, model="configex")
    palm = _wood(look.palm(), name="palm")
    hinge = Block(look.thumb_hinge(0.012), name="thumb_hinge", color=look.DARK_WOOD)
    made.set_part(block_complex(palm, hinge))
    return made


def arm() -> Robot:
    """Right upper arm and forearm, a 7R chain from shoulder to wrist (table 4).

    Returns
    -------
    arm : Robot
        At home it hangs along -z with the forearm bent to the front, -y, palm down.

    Examples
    --------
    >>> a = arm()
    >>> a.frames()["arm/4"][:3, 3].round(6) + 0
    array([ 0.  ,  0.  , -0.25])
    >>> a.frames()["arm/7"][:3, 3].round(6) + 0
    array([ 0.  , -0.25, -0.25])

    References
    ----------
    Pajak, The Matlab toolbox for modeling complex mechanisms, table 4.
    """
    made = robot(
        [
            dh(0, 0, 0, 0),
            dh(pi / 2, 0, 0, -pi / 2),
            dh(pi / 2, 0, 0, 0),
            dh(0, 0.25, 0, pi),
            dh(pi / 2, 0, 0.25, 0),
            dh(-pi / 2, 0, 0, pi / 2),
            dh(pi / 2, 0, 0, pi),
        ],
        7 * "r",
        name="arm",
        radius=0.020,
        limits=[
            (-pi / 2, pi / 2),
            (-pi, -pi / 2),
            (-pi / 4, pi),
            (pi / 2, 5 * pi / 4),
            (-pi / 2, pi),
            (pi / 4, 3 * pi / 4),
            (3 * pi / 4, 3 * pi / 2),
        ],
    )
    made.set_part(Block(look.shoulder(), color=look.DARK_WOOD), joint=0)
    made.set_part(_wood(look.upper_arm()), joint=3)
    made.set_part(_wood(look.forearm()), joint=4)
    made.set_part(_wood(look.lower_forearm()), joint=5)
    made.set_part(Block(look.wrist(), color=look.DARK_WOOD), joint=6)
    return made


def upper_limb() -> Robot:
    """The right upper limb: the arm with the hand at its wrist.

    Returns
    -------
    limb : Robot
        27 variables in 6 components: arm 7, then thumb, index, middle, ring, little 4 each.
        ``limb.look = "user"`` shows it as a wooden figure.

    Examples
    --------
    >>> limb = upper_limb()
    >>> [(part.name, len(part.q)) for part in limb.components][:2]
    [('arm', 7), ('thumb', 4)]
    >>> limb.n
    27

    References
    ----------
    Pajak, The Matlab toolbox for modeling complex mechanisms, section 4.3.
    """
    return arm().connect(hand())


def _wood(mesh: Mesh, name: str | None = None) -> Block:
    return Block(mesh, name=name, color=look.WOOD)
