"""Checks of exercise 14: a hand of five fingers."""

from numpy import pi

from dhlab import csys, deg, dh, models, robot, robot_complex, roty, rp2t
from dhlab.diagnosis import RobotTask
from dhlab.grading import Question

FINGERS = ("index", "middle", "ring", "little")
SPREAD = {"index": (-20, 0), "middle": (-10, 10), "ring": (0, 20), "little": (0, 36)}
PAPER = {
    "index": (50, 30, 25, 95, 22),
    "middle": (55, 35, 25, 95, 0),
    "ring": (50, 30, 25, 90, -20),
    "little": (40, 25, 23, 85, -38),
}


def numbers(rng):
    """Each finger's bones and place [mm], and how far it spreads [degrees]."""
    fingers = {}
    for name in FINGERS:
        a, b, c, x, y = PAPER[name]
        a, b, c = (int(length + rng.integers(-4, 5)) for length in (a, b, c))
        fingers[name] = {"a": a, "b": b, "c": c, "x": x, "y": y, "spread": list(SPREAD[name])}
    return fingers


def questions(given):
    """The questions, for a student's hand."""
    index, hand = finger(given, "index"), whole(given)
    return [
        Question(
            "index",
            RobotTask(index.own.chain, limits=True),
            points=3,
            kind="robot",
            hint="robot(rows, 'rrrr', name=..., base=..., grasper=..., limits=...)",
        ),
        Question(
            "hand",
            RobotTask(hand.mechanism, limits=True, ordered=True),
            points=4,
            kind="robot",
            hint="robot_complex(thumb(), finger('index'), ...): five fingers on one base.",
        ),
    ]


def finger(given, name):
    """One long finger."""
    f = given[name]
    rows = [
        dh(pi, 0, 0, 0),
        dh(-pi / 2, 0, 0, 0),
        dh(0, f["a"] / 1000, 0, 0),
        dh(0, f["b"] / 1000, 0, 0),
    ]
    low, high = f["spread"]
    return robot(
        rows, "rrrr", name=name, base=(f["x"] / 1000, f["y"] / 1000, 0),
        grasper=(f["c"] / 1000, 0, 0), grasper_size=0, radius=0.008,
        limits=[(low * deg, high * deg), *3 * [(-pi / 2, 0)]],
    )  # fmt: skip


def thumb():
    """The thumb of the paper, at rest."""
    rows = [dh(pi, 0, 0, 0), dh(-pi / 2, 0.015, 0, 0), dh(0, 0.05, 0, 0), dh(0, 0.04, 0, 0)]
    return robot(
        rows, "rrrr", name="thumb", base=rp2t(roty(pi / 2), (0.04, 0.03, -0.015)),
        grasper=(0.03, 0, 0), grasper_size=0, radius=0.009,
        limits=[(-pi / 2, 0), *3 * [(0, pi / 2)]],
    )  # fmt: skip


def whole(given):
    """All five on one base."""
    fingers = [finger(given, name) for name in FINGERS]
    return robot_complex(thumb(), *fingers, name="hand", radius=0.008)


def pictures(given):
    """The paper's hand, to see what is what; the student's hand, pale."""
    wooden = models.hand().set(look="user", q=models.hand().clip([0.0] * 20))
    hand = whole(given).set(opacity=0.3, color="#9fa8b3")
    return {
        "wood": [csys(name="H", size=0.04), wooden],
        "hand": [csys(name="H", size=0.04), hand],
    }
