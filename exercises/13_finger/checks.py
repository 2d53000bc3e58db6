"""Checks of exercise 13: forward kinematics of a finger and of the thumb."""

import numpy as np
from numpy import pi

from dhlab import Chain, arrow, csys, deg, dh, models, robot
from dhlab.diagnosis import ForwardTask
from dhlab.grading import Question

CURLED = np.array([0, -25, -35, -30]) * deg
GRIP = np.array([-20, 40, 25, 30]) * deg
THUMB = models.thumb().own.chain


def numbers(rng):
    """Lengths of the finger's three bones, in millimetres: no two are equal."""
    low = [44, 31, 19]
    return {name: int(n) for name, n in zip("abc", low + rng.integers(0, 12, 3), strict=True)}


def questions(given):
    """The questions, for a student's finger."""
    return [
        Question(
            "finger_tip",
            ForwardTask(chain(given)),
            points=4,
            examples=[(CURLED,), (np.array([0.3, -0.8, -0.4, -1.1]),)],
            inputs=configurations,
            hint="One link_transform for each row, with q[0] to q[3] in the theta column.",
        ),
        Question(
            "thumb_in_hand",
            ForwardTask(THUMB),
            points=4,
            examples=[(GRIP,), (np.array([-0.7, 0.3, 1.1, 0.5]),)],
            inputs=configurations,
            hint="The base from the left, the four rows, the tip from the right.",
        ),
    ]


def configurations(rng):
    """Further configurations: home, bent at right angles, and any."""
    return [
        (np.zeros(4),),
        (np.array([0, -pi / 2, -pi / 2, -pi / 2]),),
        *((q,) for q in any_of(rng)),
    ]


def any_of(rng):
    """Three configurations without anything special."""
    return rng.uniform(-1.5, 1.5, (3, 4))


def chain(given):
    """The finger, from the frame of its root to its tip."""
    a, b, c = (given[name] / 1000 for name in "abc")
    rows = [dh(pi, 0, 0, 0), dh(-pi / 2, 0, 0, 0), dh(0, a, 0, 0), dh(0, b, 0, 0)]
    return Chain(rows, "rrrr", grasper=(c, 0, 0))


def pictures(given):
    """The finger, curled, with its lengths; the thumb in the hand."""
    c = chain(given)
    finger = robot(
        c.rows, c.joints, grasper=c.grasper, q=CURLED, name="finger", opacity=0.45, radius=0.006,
        grasper_size=0,
    )  # fmt: skip
    at = [*c.frames(CURLED)[1:, :3, 3], c.tip(CURLED)[:3, 3]]
    lengths = [
        arrow(p + side, q + side, f"{given[name]} mm", heads="both", head=0.005, name=name)
        for name, p, q in zip("abc", at, at[1:], strict=False)
        for side in [0.014 * np.cross(q - p, (0, 1, 0)) / np.linalg.norm(q - p) * -1]
    ]
    hand = models.hand().set(look="user", q=[*GRIP, *np.zeros(16)])
    for component in (hand.own, *hand.components):
        for part in component.parts.values():
            part.opacity = 0.25
    thumb = robot(
        THUMB.rows, THUMB.joints, base=THUMB.base, grasper=THUMB.grasper, q=GRIP, name="thumb",
        look="stick", radius=0.01,
    )  # fmt: skip
    root = csys(THUMB.base, name="B", size=0.025)
    return {
        "finger": [csys(name="R", size=0.025), finger, *lengths],
        "thumb": [csys(name="H", size=0.035), hand, root, thumb],
    }
