"""Checks of exercise 11: a table in the other convention."""

from collections.abc import Mapping

from dhlab import Chain, csys, deg, dh, robot
from dhlab.diagnosis import MatrixTask, TableTask, slide, turn
from dhlab.grading import Question


def numbers(rng):
    """Two arms, the first by its standard table, the second by its modified one."""
    lengths = rng.choice([0.2, 0.22, 0.24, 0.26, 0.28, 0.32, 0.34, 0.36], 6, replace=False)
    d1, a2, a3, d, a, b = lengths
    twist = int(rng.choice([-90, 90]))
    return {
        "standard": [[twist, 0.1, d1, 0], [0, a2, 0, 40], [55, a3, 0, -30]],
        "modified": [[-twist, 0, 0, 30], [0, a, d, 50], [90, b, 0, 20]],
    }


class RowsTask(TableTask):
    """The rows alone: the convention is the one asked for."""

    def judge(self, cases):
        """Judge the rows of whatever table comes."""
        rows = [(a, v.get("rows") if isinstance(v, Mapping) else v) for a, v in cases]
        return super().judge(rows)


def questions(given):
    """The questions, for a student's arms."""
    first, second = arms(given)
    alpha, a = first.rows[-1][:2]
    return [
        Question(
            "to_modified",
            RowsTask(first.to_modified(), tool_free=True),
            points=3,
            hint="Which joint axes do the alpha and a of a standard row lie between?",
        ),
        Question(
            "behind",
            MatrixTask(turn("x", alpha), slide((a, 0, 0)), size=4),
            points=2,
            hint="Which two numbers of the standard table are in no row of yours?",
        ),
        Question(
            "to_standard",
            RowsTask(second.to_standard(), base_free=True, tool_free=True),
            points=3,
            hint="The same shift, the other way round.",
        ),
    ]


def arms(given):
    """Both arms as chains, each in the convention that its table is given in."""
    return [
        Chain([dh(p * deg, a, d, q * deg) for p, a, d, q in given[name]], "rrr", convention=name)
        for name in ("standard", "modified")
    ]


def pictures(given):
    """Each arm with the frames of the convention that its table is given in, and without."""
    first, second = arms(given)
    return {
        "standard": drawn(first, True),
        "modified": drawn(second, True),
        "first": drawn(first, False),
        "second": drawn(second, False),
    }


def drawn(chain, frames):
    """One arm, pale."""
    arm = robot(
        chain.rows, chain.joints, convention=chain.convention, name="arm", opacity=0.35,
        radius=0.02, frame_size=0.13, show_csys=frames,
    )  # fmt: skip
    return [csys(name="0", size=0.13), arm]
