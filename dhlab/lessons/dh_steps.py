"""A robot's table walked through: a csys that travels from frame to frame, one number a step."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from dhlab.arrays import as_number
from dhlab.kinematics.chain import Chain
from dhlab.kinematics.transforms import inverse
from dhlab.lessons.lesson import Lesson
from dhlab.lessons.moves import Slide, Turn, move_to, slide, turn
from dhlab.lessons.step import Step
from dhlab.scene.csys import Csys
from dhlab.scene.robot import Robot

Parameter = Literal["alpha", "a", "d", "theta"]

ORDER: dict[str, tuple[Parameter, ...]] = {
    "modified": ("alpha", "a", "theta", "d"),
    "standard": ("theta", "d", "a", "alpha"),
}
"""The order in which the four numbers of a row move the frame."""

COLUMNS: tuple[Parameter, ...] = ("alpha", "a", "d", "theta")
NAMES = {"alpha": "twist", "a": "length", "d": "offset", "theta": "angle"}
LETTERS = {"alpha": r"\alpha", "a": "a", "d": "d", "theta": r"\theta"}
ALONG = {"alpha": "x", "a": "x", "d": "z", "theta": "z"}
PALE = 0.35
STILL = 0.6
"""Seconds of a step whose number is 0: there is nothing to see but that."""


def dh_lesson(robot: Robot, *, opacity: float = PALE, size: float | None = None) -> Lesson:
    """Make a lesson of any robot's table: four steps per joint, base and grasper besides.

    A csys {F} travels from the world over the base and every joint's frame to the grasper, and on
    to the next component of a complex or connected robot, at the robot's present configuration.
    In the modified convention a joint is twist, length, angle, offset; in the standard one angle,
    offset, length, twist.

    Parameters
    ----------
    robot : Robot
        The top of its mechanism. It is made pale, so that the frames are seen.
    opacity : float in [0, 1]
        How pale.
    size : float [m], optional
        Length of the axes of {F}; what suits the robot unless given.

    Returns
    -------
    lesson : Lesson

    Examples
    --------
    >>> from dhlab import models
    >>> lesson = dh_lesson(models.scara())
    >>> [step.title for step in lesson.steps[:5]]
    ['Base', 'Joint 1: twist', 'Joint 1: length', 'Joint 1: angle', 'Joint 1: offset']

    References
    ----------
    Craig, Introduction to Robotics, section 3.4 and eq. 3.6.
    """
    length = _suitable_size(robot) if size is None else as_number(size, "size", above=0)
    traveller = Csys("F")
    traveller.set(size=length)
    several = len(robot.components) > 1
    steps: list[Step] = []
    for member in robot.robots():
        prefix = f"{member.name}, " if several else ""
        steps += _base_steps(member, robot, traveller, prefix)
        for i in range(1, member.own.n + 1):
            steps += _joint_steps(member, i, traveller, prefix)
        steps += _grasper_steps(member, traveller, prefix)
    robot.set(opacity=opacity)
    title = f"The table of '{robot.name}', one number at a time"
    return Lesson(title, steps, handles=[robot, traveller], keep=3, product=traveller)


def _suitable_size(robot: Robot) -> float:
    origins = np.array([pose[:3, 3] for pose in robot.frames().values()])
    return float(0.16 * max(np.ptp(origins, axis=0).max(), 2.5 * robot.components[0].radius))


def _base_steps(member: Robot, top: Robot, F: Csys, prefix: str) -> Iterator[Step]:
    """Step to the frame that carries a robot, unless it is the world, and to its base."""
    base = member.world_pose
    carrier = base @ inverse(member.base)
    if member is not top:
        text = (
            f"On to **{member.name}**. Its base is given in the frame that carries it, so "
            "$\\{F\\}$ goes back to that frame first."
        )
        yield Step(f"{prefix}back to what carries it", text, move_to(F, carrier), seconds=STILL * 2)
    text = (
        "The base says where the chain begins: its pose in the frame that carries it. It is no "
        "row of the table."
    )
    if np.array_equal(member.base, np.eye(4)):
        text += " Here the two frames are one."
    yield Step(f"{prefix}base" if prefix else "Base", text, move_to(F, base))


def _grasper_steps(member: Robot, F: Csys, prefix: str) -> Iterator[Step]:
    chain = member.chain
    taken = any(at == chain.n for at, _ in member.joints_at)
    if chain.n == 0 or taken:
        return
    end = _frame(member, chain.n) @ chain.grasper
    text = (
        "The grasper, or tool, is a fixed pose in the last joint's frame. It is no row of the "
        "table either."
    )
    yield Step(f"{prefix}grasper" if prefix else "Grasper", text, move_to(F, end))


def _frame(member: Robot, i: int) -> NDArray[np.float64]:
    """Pose in the world of a robot's own frame `i`, 0 for the base, shape (4, 4)."""
    if i == 0:
        return member.world_pose
    carrier = member.world_pose @ inverse(member.base)
    frame: NDArray[np.float64] = carrier @ member.chain.frames(member.own.q)[i - 1]
    return frame


def _joint_steps(member: Robot, i: int, F: Csys, prefix: str) -> Iterator[Step]:
    """Four steps from frame i-1 to frame i."""
    chain, q = member.chain, member.own.q
    values = dict(zip(COLUMNS, chain.rows[i - 1], strict=True))
    variable: Parameter = "theta" if chain.kinds[i - 1] == "r" else "d"
    values[variable] = float(q[i - 1] + chain.offset[i - 1])
    table = _table(chain, q)
    moves: list[Turn | Slide] = []
    for parameter in ORDER[chain.convention]:
        moves.append(_move(F, parameter, values[parameter]))
        about = {
            "table": table | {"row": i - 1, "cell": COLUMNS.index(parameter)},
            "product": _product(moves, i, _frame(member, i - 1), chain.convention),
            "joint": i,
            "parameter": parameter,
        }
        yield Step(
            f"{prefix}{'joint' if prefix else 'Joint'} {i}: {NAMES[parameter]}",
            _text(chain.convention, parameter, values[parameter], i, parameter == variable),
            moves[-1],
            seconds=None if values[parameter] else STILL,
            about=about,
        )


def _move(F: Csys, parameter: Parameter, value: float) -> Turn | Slide:
    axis = ALONG[parameter]
    letter = {"alpha": "α", "theta": "θ"}.get(parameter, parameter)
    if parameter in ("alpha", "theta"):
        return turn(F, axis, value, label=f"{letter} = {np.degrees(value):.4g}°")
    vector = value * np.eye(3)["xyz".index(axis)]
    return slide(F, vector, label=f"{letter} = {value:.4g} m")


def _latex(move: Turn | Slide, parameter: Parameter) -> str:
    """Return a factor; of a number that is 0 too it says which axis it goes by."""
    if isinstance(move, Turn):
        return move.latex
    axis = ALONG[parameter]
    return f"D_{axis}({move.vector['xyz'.index(axis)]:.4g})"


def _product(
    moves: list[Turn | Slide], i: int, start: NDArray[np.float64], convention: str
) -> dict[str, Any]:
    """Return the product from frame i-1 on, as far as it has come."""
    factors = [
        {"latex": _latex(move, parameter), "matrix": move.motion.tolist()}
        for move, parameter in zip(moves, ORDER[convention], strict=False)
    ]
    return {
        "label": rf"T_{{{i - 1},{i}}}",
        "of": moves[0].what.name,
        "relative": start.tolist(),
        "factors": factors,
        "added": len(factors) - 1,
    }


def _table(chain: Chain, q: NDArray[np.float64]) -> dict[str, Any]:
    """Return the table to show: angles in degrees, the variables at their present values."""
    link = "i-1" if chain.convention == "modified" else "i"
    rows = []
    for row, kind, offset, value in zip(chain.rows, chain.kinds, chain.offset, q, strict=True):
        alpha, a, d, theta = row
        now = float(value + offset)
        d, theta = (d, now) if kind == "r" else (now, theta)
        rows.append(
            [f"{np.degrees(alpha):z.4g}°", f"{a:z.4g}", f"{d:z.4g}", f"{np.degrees(theta):z.4g}°"]
        )
    return {
        "columns": [rf"\alpha_{{{link}}}", f"a_{{{link}}}", "d_i", r"\theta_i"],
        "rows": rows,
        "convention": chain.convention,
        "variables": [3 if kind == "r" else 2 for kind in chain.kinds],
    }


def _text(convention: str, parameter: Parameter, value: float, i: int, variable: bool) -> str:
    """Return what a step says: which axis, how far, and why."""
    modified = convention == "modified"
    link = i - 1 if modified and parameter in ("alpha", "a") else i
    symbol = f"{LETTERS[parameter]}_{{{link}}}"
    axis = ALONG[parameter]
    turned = parameter in ("alpha", "theta")
    amount = rf"{np.degrees(value):.4g}^\circ" if turned else rf"{value:.4g}\,\mathrm{{m}}"
    verb = "Turn about" if turned else "Slide along"
    text = f"**{verb} the ${axis}$-axis** of $\\{{F\\}}$ by ${symbol} = {amount}$."
    text += f"\n\n{_why(modified, parameter, i)}"
    if variable:
        text += f" This is the variable of joint {i}."
    if value == 0:
        text += " Here it is 0: nothing moves."
    return text


def _why(modified: bool, parameter: Parameter, i: int) -> str:
    """Say what a parameter is there for."""
    match parameter:
        case "alpha":
            axis = i if modified else i + 1
            return (
                f"The twist brings $z$ into the direction of axis {axis}: it is measured about "
                "$x$, which lies along the common normal."
            )
        case "a":
            return (
                "The length is the distance of the two axes along their common normal, which is "
                "$x$; where the axes meet it is 0."
            )
        case "d":
            return f"The offset is measured along axis {i}, from one common normal to the next."
        case "theta":
            return f"The angle is measured about axis {i}, from one common normal to the next."
