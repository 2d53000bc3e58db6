"""Industrial robots: their tables as data, and how they look."""

from numpy import pi

from dhlab.kinematics.dh import deg, dh
from dhlab.models import industrial_look as look
from dhlab.scene.block import Block, BlockComplex, block_complex
from dhlab.scene.robot import Robot
from dhlab.scene.robots import robot, robot_complex
from dhlab.shapes import Mesh


def puma() -> Robot:
    """Unimation PUMA 560, the 6R arm of the textbooks.

    Frame 0 lies in the shoulder, as in Craig's figure; at home the upper arm is upright and the
    forearm points forward.

    Returns
    -------
    puma : Robot

    Examples
    --------
    With all angles 0 the upper arm is level and the forearm hangs down:

    >>> puma().frames([0, 0, 0, 0, 0, 0])["puma/6"][:3, 3].round(4)
    array([ 0.4521,  0.1491, -0.4331])

    References
    ----------
    Craig, Introduction to Robotics, figure 3.21 (table); Fu, Gonzalez and Lee, Robotics,
    figure 2.11 (lengths and limits, put into Craig's frames).
    """
    return robot(
        [
            dh(0, 0, 0, 0),  # alpha_{i-1}, a_{i-1}, d_i, theta_i
            dh(-pi / 2, 0, 0, -pi / 2),
            dh(0, 0.43180, 0.14909, 0),
            dh(-pi / 2, 0.02032, 0.43307, 0),
            dh(pi / 2, 0, 0, 0),
            dh(-pi / 2, 0, 0, 0),
        ],
        6 * "r",
        name="puma",
        grasper=(0, 0, 0.05625),
        limits=[
            (-160 * deg, 160 * deg),
            (-225 * deg, 45 * deg),
            (-225 * deg, 45 * deg),
            (-110 * deg, 170 * deg),
            (-100 * deg, 100 * deg),
            (-266 * deg, 266 * deg),
        ],
    )


def industrial_arm(name: str = "arm") -> Robot:
    """A 6R arm of the 60 kg class that reaches 2.05 m; its grasper's frame is the flange.

    The angles count as on a data sheet: with all of them 0 the upper arm is upright and the
    forearm level; an `offset` of -pi/2 on joint 2 puts that into Craig's frames.

    Parameters
    ----------
    name : str

    Returns
    -------
    arm : Robot
        ``arm.look = "user"`` shows castings and motors in the colour of the robot.

    Examples
    --------
    >>> arm = industrial_arm()
    >>> arm.frames()["arm/grasper"][:3, 3].round(4)
    array([1.27, 0.  , 1.57])
    >>> arm.q = [0, 160 * deg, 0, 0, 0, 0]
    Traceback (most recent call last):
    ...
    dhlab.errors.LimitError: joint 2 of 'arm': 2.7925 rad (160.0 deg) is outside [-1.5708, 2.6180]

    References
    ----------
    Lengths and working ranges of ABB's IRB 4600-60/2.05 (product specification).
    """
    size = look.ARM_LENGTHS
    made = robot(
        [
            dh(0, 0, size["height"], 0),
            dh(-pi / 2, size["shoulder"], 0, 0),
            dh(0, size["upper"], 0, 0),
            dh(-pi / 2, size["elbow"], size["fore"], 0),
            dh(pi / 2, 0, 0, 0),
            dh(-pi / 2, 0, 0, 0),
        ],
        6 * "r",
        name=name,
        offset=(0, -pi / 2, 0, 0, 0, 0),
        grasper=(0, 0, look.FLANGE),
        limits=[
            (-180 * deg, 180 * deg),
            (-90 * deg, 150 * deg),
            (-180 * deg, 75 * deg),
            (-400 * deg, 400 * deg),
            (-125 * deg, 120 * deg),
            (-400 * deg, 400 * deg),
        ],
    )
    links = (look.arm_base, look.column, look.upper_arm, look.elbow)
    for joint, link in enumerate((*links, look.forearm, look.wrist, look.flange)):
        made.set_part(_part(link()), joint=joint)
    return made


def gripper(name: str = "gripper") -> Robot:
    """A gripper with two jaws, to be connected to the flange of an arm.

    Each jaw slides along y of the flange; its variable is the distance of its pad from the
    middle. The grasper's frame of the gripper lies between the pads.

    Parameters
    ----------
    name : str

    Returns
    -------
    gripper : Robot
        Two prismatic joints, 'left' (towards y) and 'right'.

    Examples
    --------
    >>> arm, hand = industrial_arm(), gripper()
    >>> hand.base = arm.grasper
    >>> arm.connect(hand).n
    8
    """
    jaws = []
    for side, turn in (("left", -pi / 2), ("right", pi / 2)):
        jaw = robot(
            [dh(turn, 0, 0.06, 0)],
            "p",
            name=side,
            base=(0, 0, 0.11),
            limits=[(0.01, 0.12)],
            grasper_size=0,
            radius=0.02,
            color=look.FINISHES["dark"],
        )
        jaw.set_part(_part(look.jaw(side)), joint=1)
        jaws.append(jaw)
    made = robot_complex(*jaws, name=name, radius=0.03, color=look.FINISHES["dark"])
    made.grasper = (0, 0, look.GRIP)
    made.set_part(_part(look.gripper_body()))
    return made


def scara(name: str = "scara") -> Robot:
    """A table-top SCARA, RRPR, that reaches 0.6 m; its tool is a suction cup.

    Parameters
    ----------
    name : str

    Returns
    -------
    scara : Robot
        Its third variable counts downwards, 0 to 0.21 m.

    Examples
    --------
    >>> scara().frames([0, 0, 0.1, 0])["scara/grasper"][:3, 3].round(4) + 0
    array([0.6  , 0.   , 0.167])

    References
    ----------
    Lengths and stroke of Adept's Cobra 600.
    """
    made = robot(
        [
            dh(0, 0, 0.387, 0),
            dh(0, 0.325, 0, 0),
            dh(pi, 0.275, 0, 0),
            dh(0, 0, 0, 0),
        ],
        "rrpr",
        name=name,
        grasper=(0, 0, 0.12),
        grasper_size=0,
        limits=[
            (-105 * deg, 105 * deg),
            (-150 * deg, 150 * deg),
            (0, 0.21),
            (-360 * deg, 360 * deg),
        ],
    )
    links = (look.scara_base, look.scara_inner, look.scara_outer, look.scara_quill)
    for joint, link in enumerate((*links, look.suction_cup)):
        made.set_part(_part(link()), joint=joint)
    return made


def _part(bodies: dict[str, Mesh]) -> BlockComplex:
    """Make the blocks of one link, a block for each finish."""
    blocks = (Block(mesh, name=f, color=look.FINISHES[f]) for f, mesh in bodies.items())
    return block_complex(*blocks)
