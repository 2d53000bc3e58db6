"""Trees: a table is a chain, a hand is several; and a picture is not the robot."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from dhlab.kinematics.dh import deg
from dhlab.lessons.lesson import Lesson
from dhlab.lessons.moves import configure, move_to
from dhlab.lessons.step import Choice, Step
from dhlab.models.limb import hand as make_hand
from dhlab.models.limb import upper_limb
from dhlab.scene.csys import csys
from dhlab.scene.robot import Robot


def branching() -> Lesson:
    """Make a lesson: one table cannot branch; a palm carries the base of each finger."""
    hand = make_hand().set(opacity=0.5)
    F = csys(name="F", size=0.02)
    bases = {robot.name: robot.world_pose for robot in hand.attached}
    return Lesson(
        "Where a chain branches",
        [
            Step(
                "To the index",
                "Each finger is a chain with a table of its own. Its *base* is a fixed pose in "
                "the palm.",
                move_to(F, bases["index"]),
                question=Choice(
                    "A hand has five fingers of four joints. How many rows has its table?",
                    ["20, one below the other", "it is not one table: five, and five bases"],
                    answer=1,
                    because="In a table every row hangs on the row before. A palm carries five "
                    "things at once.",
                ),
            ),
            Step(
                "Back to the palm",
                "To get to the next finger, go back to the palm first: the fingers do not hang on "
                "each other.",
                move_to(F, np.eye(4)),
            ),
            Step("To the thumb", "Another base, another table.", move_to(F, bases["thumb"])),
            Step(
                "One moves, the others stay",
                "The index bends: only what hangs on it moves.",
                configure(hand, _bent(hand)),
            ),
        ],
        handles=[hand],
        product=F,
    )


def sticks_or_bodies() -> Lesson:
    """Make a lesson: sticks, default bodies and the user's bodies are one mechanism."""
    limbs = [upper_limb(), upper_limb(), upper_limb()]
    for k, (limb, look) in enumerate(zip(limbs, ("stick", "solid", "user"), strict=True)):
        limb.name = look
        limb.set(look=look)
        limb.set(base=limb.base @ _sideways(k))
    q = limbs[0].home.copy()
    q[1], q[3] = q[1] + 40 * deg, q[3] + 30 * deg
    q = limbs[0].clip(q)
    return Lesson(
        "Sticks, or bodies?",
        [
            Step(
                "One table, three looks",
                "A stick picture shows frames and joints, and no metal. All three have the same "
                "tables and take the same $q$.",
                *(configure(limb, q) for limb in limbs),
                question=Choice(
                    "The three arms look different: sticks, plain bodies, shaped bodies. They are "
                    "given the same $q$. Where will their hands be?",
                    ["the sticks reach elsewhere: they are shorter", "at the same place of each"],
                    answer=1,
                    because="Bodies are drawn *on* frames. Kinematics knows frames alone.",
                ),
            ),
        ],
        handles=limbs,
    )


def _bent(hand: Robot) -> NDArray[np.float64]:
    q = hand.home.copy()
    q[5:8] -= 40 * deg
    return hand.clip(q)


def _sideways(k: int) -> NDArray[np.float64]:
    T = np.eye(4)
    T[0, 3] = 0.35 * (k - 1)
    return T
