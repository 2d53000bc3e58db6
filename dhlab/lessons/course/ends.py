"""Base, tool, offset, limits, degrees."""

from __future__ import annotations

from dhlab.kinematics.dh import deg, dh
from dhlab.kinematics.transforms import rotx, rp2t, transl
from dhlab.lessons.course.chains import planar_arm
from dhlab.lessons.lesson import Lesson
from dhlab.lessons.moves import configure, move_to
from dhlab.lessons.step import Choice, Step
from dhlab.scene.blocks import cuboid
from dhlab.scene.csys import csys
from dhlab.scene.robots import robot

PALE = 0.35


def offset_forgotten() -> Lesson:
    """Make a lesson: the constant that is added to the variable."""
    right = planar_arm("right", -90 * deg).set(color="#0072b2", q=[0, 90 * deg])
    wrong = planar_arm("wrong").set(color="#d55e00", base=transl((0, -1.5, 0)), q=[0, 0])
    return Lesson(
        "The offset",
        [
            Step(
                "The controller says zero",
                "At $q = (0, 0)$ this arm stands with its forearm at $-90^\\circ$. `right` has "
                "the offset of $-90^\\circ$ in joint 2, `wrong` has none.",
                configure(right, [0, 0]),
                configure(wrong, [0, 0]),
            ),
            Step(
                "And 90",
                "The constant does not go into the table's $\\theta$ column, where the variable "
                "stands: a configuration *replaces* that number. It is an offset, added to the "
                "variable: $\\theta_2 = q_2 - 90^\\circ$.",
                configure(right, [0, 90 * deg]),
                configure(wrong, [0, 90 * deg]),
                question=Choice(
                    "The controller sends $q_2 = 90^\\circ$. How does the real arm stand, the one "
                    "whose forearm is at $-90^\\circ$ when $q_2 = 0$?",
                    ["straight", "bent upwards by $90^\\circ$", "as before: 90 is its zero"],
                    answer=0,
                    because="$\\theta_2 = 90^\\circ - 90^\\circ = 0$.",
                ),
            ),
        ],
        handles=[right, wrong],
    )


def base_and_tool() -> Lesson:
    """Make a lesson: base and tool are no rows of the table."""
    base = transl((0.4, 0, 0.7))
    tool = rp2t(rotx(90 * deg), (0.8, 0, 0))
    table = cuboid(1.0, 0.8, 0.7, name="table", color="#c9b28f", opacity=0.45).move((0.4, 0, 0))
    arm = planar_arm().set(base=base, q=[30 * deg, 40 * deg], opacity=PALE, grasper=tool)
    W, F = csys(name="W", size=0.5), csys(name="F", size=0.4)
    carrier = arm.frames()["arm/2"]
    return Lesson(
        "Before the first row, behind the last",
        [
            Step(
                "The base",
                "The arm stands on a table: its base is a pose in the world, $T_{W0}$. It is "
                "multiplied from the left, once, and no row of the table changes.",
                move_to(F, base),
                question=Choice(
                    "The arm is put on a table, 0.7 m high. What changes in its "
                    "Denavit-Hartenberg table?",
                    ["$d_1$ grows by 0.7", "nothing: the base is a pose of its own"],
                    answer=1,
                    because="$T_{WT} = T_{W0}\\; T_{0n}(q)\\; T_{nT}$. Rows are for joints.",
                ),
            ),
            Step(
                "The rows of the table",
                "From frame 0 to the last joint's frame $n$: only here are there variables.",
                move_to(F, carrier),
            ),
            Step(
                "The tool",
                "And the tool behind it, $T_{nT}$, multiplied from the right: a new tool, the "
                "same table.",
                move_to(F, carrier @ tool),
                question=Choice(
                    "On which side of $T_{0n}$ does the tool's pose in the last frame go?",
                    ["left", "right"],
                    answer=1,
                    because="It is told in frame $n$: $T_{0n}\\, T_{nT}$, and the names cancel.",
                ),
            ),
        ],
        handles=[arm, table, W],
        keep=1,
        product=F,
    )


def degrees_or_radians() -> Lesson:
    """Make a lesson: 90 is not 90 degrees."""
    meant = planar_arm("meant").set(color="#0072b2")
    typed = planar_arm("typed").set(color="#d55e00", base=transl((0, -1.5, 0)))
    return Lesson(
        "Ninety what?",
        [
            Step(
                "90 * deg, and 90",
                "`meant` got `90 * deg`, `typed` got `90`. 90 rad is 5156.6 degrees: 14 turns and "
                "$116.6^\\circ$. It went round and round, and came out somewhere.",
                configure(meant, [0, 90 * deg]),
                configure(typed, [0, 90.0]),
                question=Choice(
                    "Somebody types `q = [0, 90]` and means degrees. dhlab takes radians. Where "
                    "does the forearm end?",
                    ["at $90^\\circ$", "at $116.6^\\circ$, after 14 turns", "nowhere: an error"],
                    answer=1,
                    because="$90 \\cdot 180 / \\pi = 5156.6$, and $5156.6 = 14 \\cdot 360 + "
                    "116.6$. In a *table* dhlab warns of such a number.",
                ),
                seconds=3.0,
            ),
            Step(
                "Write the unit",
                "Radians everywhere in code, and `90 * deg` where you think in degrees.",
                configure(typed, [0, 90 * deg]),
            ),
        ],
        handles=[meant, typed],
    )


def limits_of_what() -> Lesson:
    """Make a lesson: limits are on the variable, not on theta."""
    rows = [dh(0, 0, 0, 0), dh(0, 1.0, 0, 0)]
    arm = robot(
        rows,
        "rr",
        name="arm",
        grasper=(0.8, 0, 0),
        radius=0.06,
        offset=[0, 90 * deg],
        limits=[(-180 * deg, 180 * deg), (-90 * deg, 45 * deg)],
    )
    return Lesson(
        "Limits of what?",
        [
            Step(
                "To the lower limit",
                "$q_2 = -90^\\circ$: with the offset of $90^\\circ$ that is $\\theta_2 = 0$, and "
                "the arm is straight.",
                configure(arm, [0, -90 * deg]),
            ),
            Step(
                "To the upper limit",
                "$q_2 = 45^\\circ$, so $\\theta_2 = 135^\\circ$. The limits are on the variable "
                "$q$, the number that is sent to the joint; $\\theta$ is what the table makes of "
                "it.",
                configure(arm, [0, 45 * deg]),
                question=Choice(
                    "Joint 2 has the offset $90^\\circ$ and limits $[-90^\\circ, 45^\\circ]$. How "
                    "far can the forearm bend, as an angle $\\theta_2$ from the upper arm?",
                    ["from $-90^\\circ$ to $45^\\circ$", "from $0^\\circ$ to $135^\\circ$"],
                    answer=1,
                    because="$\\theta_2 = q_2 + 90^\\circ$.",
                ),
            ),
        ],
        handles=[arm],
    )
