"""How a robot reads in a notebook: one stable text, and a table in HTML."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dhlab.scene.robot import Robot


def robot_text(robot: Robot) -> str:
    """Return the tree of robots in text: who carries whom, joints, where."""
    components = robot.components
    variables = "1 variable" if robot.n == 1 else f"{robot.n} variables"
    lines = [
        f"Robot {robot.name!r}: {variables} in {len(components)} component"
        + "s" * (len(components) != 1)
    ]
    lines += _branch(robot, "")
    return "\n".join(lines)


def _branch(robot: Robot, indent: str) -> list[str]:
    joints = robot.chain.joints
    what = f"{joints.upper()}, {robot.chain.convention} DH" if joints else "complex"
    lines = [f"{indent}  {robot.name}: {what}"]
    for at, child in robot.joints_at:
        where = "base" if at == 0 else f"joint {at}"
        lines += [f"{indent}    on {where} of {robot.name}:"] if joints else []
        lines += _branch(child, indent + ("    " if joints else "  "))
    return lines


def robot_html(robot: Robot) -> str:
    """Return the tables of all components in HTML, each under the robot's name."""
    from html import escape

    parts = [f"<p><b>{escape(robot.name)}</b>: {robot.n} variables</p>"]
    parts += [
        f"<p>{escape(component.name)}</p>{component.chain._repr_html_()}"
        for component in robot.components
    ]
    return "".join(parts)
