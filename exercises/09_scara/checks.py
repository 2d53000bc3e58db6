"""Checks of exercise 9: a SCARA as a robot."""

from dhlab import Chain, arrow, csys, deg, dh, robot
from dhlab.diagnosis import RobotTask
from dhlab.grading import Question
from dhlab.grading.drawing import joint_axes

STROKE = 0.2


def numbers(rng):
    """Lengths of the SCARA: height of its arms, the arms, the tool."""
    arms = rng.choice([0.25, 0.275, 0.3, 0.325, 0.35], 2, replace=False)
    h, tool = rng.choice([0.38, 0.42, 0.44, 0.46]), rng.choice([0.08, 0.1, 0.12])
    return {"h": h, "l1": arms[0], "l2": arms[1], "tool": tool}


def questions(given):
    """The question, for a student's lengths."""
    return [
        Question(
            "scara",
            RobotTask(chain(given), zero_free=False),
            points=6,
            kind="robot",
            hint="Four rows, four letters, and where {T} is in the frame of the last joint.",
        )
    ]


def chain(given):
    """The SCARA; its third variable counts downwards."""
    rows = [
        dh(0, 0, given["h"], 0),
        dh(0, given["l1"], 0, 0),
        dh(180 * deg, given["l2"], 0, 0),
        dh(0, 0, 0, 0),
    ]
    limits = [(-2, 2), (-2.5, 2.5), (0, STROKE), (-6, 6)]
    return Chain(rows, "rrpr", grasper=(0, 0, given["tool"]), limits=limits)


def pictures(given):
    """The SCARA with its axes and lengths, all joints at 0."""
    c = chain(given)
    h, l1, reach = given["h"], given["l1"], given["l1"] + given["l2"]
    arm = robot(
        c.rows, c.joints, grasper=c.grasper, limits=c.limits, name="arm", opacity=0.4,
        radius=0.022, grasper_size=0,
    )  # fmt: skip
    lengths = [
        ((-0.08, 0, 0), (-0.08, 0, h), h, "height"),
        ((0, 0, h + 0.07), (l1, 0, h + 0.07), l1, "first arm"),
        ((l1, 0, h + 0.07), (reach, 0, h + 0.07), given["l2"], "second arm"),
        ((reach + 0.09, 0, h), (reach + 0.09, 0, h - given["tool"]), given["tool"], "tool"),
    ]
    drawn = [
        arrow(p, q, f"{length:.3g} m", heads="both", head=0.025, name=name)
        for p, q, length, name in lengths
    ]
    axes = joint_axes(arm, 0.16, {3: (0.3, 0.16), 4: (0.36, 0.1)})
    axes[2].set(label="axis 3 (slides)")
    axes[3].set(label="axis 4", label_at=-0.08)
    tip = csys(c.tip(c.home), name="T", size=0.1)
    return {"drawing": [csys(name="0", size=0.14), tip, arm, *axes, *drawn]}
