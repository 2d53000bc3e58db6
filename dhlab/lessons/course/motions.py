"""Motions: straight in the joints is not straight in space; a motion needs its times."""

from __future__ import annotations

from dhlab.kinematics.dh import deg
from dhlab.lessons.course.chains import planar_arm
from dhlab.lessons.course.frames import point
from dhlab.lessons.lesson import Lesson
from dhlab.lessons.moves import configure
from dhlab.lessons.step import Choice, Step

START, END = (20 * deg, 100 * deg), (100 * deg, 20 * deg)


def joints_or_space() -> Lesson:
    """Make a lesson: joints that move evenly carry the tip along a curve."""
    arm = planar_arm().set(q=list(START))
    tips = [arm.frames(q)["arm/grasper"][:3, 3] for q in (START, END)]
    marks = [point(name, tuple(tip)) for name, tip in zip(("from", "to"), tips, strict=True)]
    return Lesson(
        "From here to there",
        [
            Step(
                "Every joint evenly",
                "Each joint goes evenly from its first angle to its last. The tip leaves on a "
                "curve: between two configurations the tip's way is whatever the chain makes of "
                "it.",
                configure(arm, END),
                question=Choice(
                    "Both joints move evenly from the first configuration to the last. What is the "
                    "way of the tip?",
                    ["a straight line", "a curve"],
                    answer=1,
                    because="The tip's position is made of sines and cosines of the angles.",
                ),
                seconds=3.0,
            ),
            Step(
                "And back",
                "A *path* says where, a *trajectory* says when as well. The rest of this notebook "
                "is about the when.",
                configure(arm, START),
                seconds=2.0,
            ),
        ],
        handles=[arm, *marks],
    )
