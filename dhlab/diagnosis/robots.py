"""The task of building a robot: one chain, or several that hang on each other."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from dhlab.diagnosis.gauge import Match
from dhlab.diagnosis.hanging import components, read_configuration, read_parts
from dhlab.diagnosis.paths import Naming, Part, apart, parts_of, renaming
from dhlab.diagnosis.seen import pose_seen
from dhlab.diagnosis.slips import NOTHING, verdict_of
from dhlab.diagnosis.tables import TableTask
from dhlab.diagnosis.values import Floats, Unreadable, numbers
from dhlab.diagnosis.verdict import Case, Mistake, Verdict, mistake
from dhlab.kinematics.chain import Chain
from dhlab.kinematics.mechanism import Mechanism

NEAR = 1e-4
OTHERWISE = "Frames inside stand otherwise than in our tables, and all tips move as they should."
HANGS = mistake(
    "attached-elsewhere",
    "a part hangs on another frame, or on another part, than it should",
    "Which frame carries it when all joints are at rest, and which when they move?",
)


@dataclass(frozen=True, eq=False)
class RobotTask:
    """A robot, as plain data: its table, its ends, and where asked for its limits and its pose.

    What comes is a mapping with `rows`, `joints`, `convention`, `base`, `grasper`, `offset`,
    `limits`, `q`; of a robot of several also `components`, a mapping each, which tells too what it
    hangs on: `on`, the number of a component or -1, `at`, the frame there, `stand`, the pose of its
    base in that frame. As for a `TableTask`, every right table is accepted; where the frames
    between the parts stand is free, as long as all tips move alike.

    Parameters
    ----------
    robot : Chain or Mechanism
    base_free, tool_free, zero_free : bool
        What a table may choose, see `TableTask`.
    limits : bool
        Whether the limits of the joints are asked for.
    q : array_like, shape (n,), optional [rad or m]
        The configuration the robot is to be in, told in the variables of `robot`.

    Examples
    --------
    >>> arm = Chain([(0, 0, 0, 0), (1, 0.3, 0, 0)], "rr", limits=[(-1, 1), (0, 2)])
    >>> came = {"rows": arm.rows, "joints": "rr", "limits": [(-1, 1), (0, 1.5)]}
    >>> RobotTask(arm).judge([((), came)]).right
    True
    >>> RobotTask(arm, limits=True).judge([((), came)]).text
    'The table is right. The upper limit of joint 2 is not the one asked for.'
    """

    robot: Chain | Mechanism
    base_free: bool = False
    tool_free: bool = False
    zero_free: bool = True
    limits: bool = False
    q: Sequence[float] | None = None

    def judge(self, cases: Sequence[Case]) -> Verdict:
        """Judge a robot; with several cases, all of them."""
        if not cases:
            return NOTHING
        verdicts = [self._judge(value) for _, value in cases]
        return next((v for v in verdicts if not v.right), verdicts[0])

    def _judge(self, value: Any) -> Verdict:
        if not isinstance(value, Mapping) or not value.keys() & {"rows", "components"}:
            return Verdict(False, "A robot is asked for: what does `robot(...)` give you?")
        try:
            wanted = self._wanted()
            if len(wanted) == 1:
                return self._simple(wanted[0].chain.replace(base=wanted[0].base), value)
            return self._complex(wanted, value)
        except Unreadable as refusal:
            return Verdict(False, str(refusal))

    def _simple(self, chain: Chain, value: Mapping[str, Any]) -> Verdict:
        parts = value.get("components")
        if isinstance(parts, list | tuple) and len(parts) > 1:
            return Verdict(False, "One chain is asked for; this robot has several.")
        verdict, _ = self._part(chain, value, self._q_of(0, chain.n))
        return verdict

    def _complex(self, wanted: Sequence[Part], value: Mapping[str, Any]) -> Verdict:
        names = self._names()
        values = components(value, names)
        verdict, found = self._each(wanted, values)
        try:
            came = read_parts(value, values, wanted, self.zero_free)
        except Unreadable as refusal:
            return Verdict(False, str(refusal)) if verdict.right else verdict
        elsewhere = None
        if verdict.right:
            guess = _joined(found)
            q = guess.back(read_configuration(values, wanted))
            elsewhere = apart(wanted, came, guess, q)
            if elsewhere is None:
                return verdict
        named = renaming(wanted, came, self.base_free, self.tool_free, self.zero_free)
        if named is not None:
            return self._otherwise(wanted, values, named)
        if elsewhere is None:
            return verdict
        i, T, goal = elsewhere
        seen = pose_seen(T, goal, f"the tip of {values[i].get('name', names[i])}")
        return verdict_of(f"Each part is right by itself. {seen}", [(HANGS,)])

    def _each(
        self, wanted: Sequence[Part], values: Sequence[Mapping[str, Any]]
    ) -> tuple[Verdict, list[Match]]:
        """Judge each part by itself."""
        choices, found = [], []
        for i, (part, value) in enumerate(zip(wanted, values, strict=True)):
            joints = self._joints(wanted, i)
            verdict, match = self._part(part.chain, value, self._q_of(joints.start, joints.stop))
            if not verdict.right or match is None:
                return replace(verdict, seen=f"{self._names()[i]}: {verdict.seen}"), []
            choices.append(verdict.seen)
            found.append(match)
        return Verdict(True, " ".join(filter(None, choices))), found

    def _otherwise(
        self, wanted: Sequence[Part], values: Sequence[Mapping[str, Any]], named: Naming
    ) -> Verdict:
        """Judge limits and where it stands of a robot whose tips move as they should."""
        for i, (part, value) in enumerate(zip(wanted, values, strict=True)):
            joints = self._joints(wanted, i)
            q = self._q_of(joints.start, joints.stop)
            for check in self._checks(part.chain, value, q, named.of(joints)):
                wrong = check()
                if wrong is not None:
                    return replace(wrong, seen=f"{self._names()[i]}: {wrong.seen}")
        return Verdict(True, OTHERWISE)

    def _joints(self, wanted: Sequence[Part], i: int) -> slice:
        start = sum(part.chain.n for part in wanted[:i])
        return slice(start, start + wanted[i].chain.n)

    def _names(self) -> list[str]:
        if isinstance(self.robot, Chain):
            return ["robot"]
        return [_last(b.name) for b in self.robot.branches if b.chain.n]

    def _wanted(self) -> list[Part]:
        if isinstance(self.robot, Chain):
            return [Part(self.robot, -1, 0, self.robot.base)]
        return parts_of(self.robot.branches)

    def _q_of(self, start: int, stop: int) -> Floats | None:
        return None if self.q is None else np.array(self.q[start:stop], dtype=np.float64)

    def _part(self, chain: Chain, value: Any, q: Floats | None) -> tuple[Verdict, Match | None]:
        """Judge one chain: its table, then its limits and where it stands."""
        task = TableTask(chain, self.base_free, self.tool_free, self.zero_free)
        verdict = task.judge([((), value)])
        if not verdict.right:
            return verdict, None
        match = task.matching(value)
        if match is None:
            return verdict, None
        for check in self._checks(chain, value, q, match):
            wrong = check()
            if wrong is not None:
                return wrong, match
        return verdict, match

    def _checks(
        self, chain: Chain, value: Mapping[str, Any], q: Floats | None, match: Match
    ) -> Iterator[Callable[[], Verdict | None]]:
        if self.limits:
            yield lambda: _limits_off(chain, value.get("limits"), match)
        if q is not None:
            yield lambda: _stands_off(chain, value.get("q"), match.renamed(q - match.zeros[0]))


def _last(name: str) -> str:
    return name.split("/")[-1]


def _joined(found: Sequence[Match]) -> Naming:
    """Return the renamings of the parts as one of the whole robot."""
    offsets = [m.renamed(-m.zeros[0]) for m in found]
    return Naming(np.concatenate([m.signs for m in found]), np.concatenate(offsets), np.eye(4))


def _limits_off(chain: Chain, value: Any, match: Match) -> Verdict | None:
    """Compare limits after the joints' renaming; those that came may be infinite."""
    wanted = np.sort(_renamed_ends(chain.limits, match), axis=1)
    came = _limits(value, chain.n)
    off = ~np.isclose(came, wanted, rtol=NEAR, atol=NEAR)
    if not off.any():
        return None
    joint, end = np.argwhere(off)[0].tolist()
    word = ("lower", "upper")[end]
    seen = f"The table is right. The {word} limit of joint {joint + 1} is not the one asked for."
    turning = np.array([k == "r" for k in chain.kinds])[:, None]
    question = "In which unit, and from which zero, does each joint count?"
    ways: list[tuple[Mistake, Floats]] = [
        (
            mistake("limits-degrees", "the limits are given in degrees", question),
            np.where(turning, np.degrees(wanted), wanted),
        ),
        (
            mistake("limits-missing", "no limits are given", "How far can each joint go?"),
            np.broadcast_to([-np.inf, np.inf], wanted.shape),
        ),
        (
            mistake(
                "limits-sign", "the limits are those of joints that count the other way", question
            ),
            -wanted[:, ::-1],
        ),
        (
            mistake("limits-zero", "the limits count from another zero", question),
            np.sort(chain.limits, axis=1),
        ),
    ]
    found = [(m,) for m, made in ways if np.allclose(came, made, rtol=NEAR, atol=NEAR)]
    return verdict_of(seen, found)


def _renamed_ends(limits: Floats, match: Match) -> Floats:
    out: Floats = match.renamed((limits - match.zeros[0][:, None]).T).T
    return out


def _limits(value: Any, n: int) -> Floats:
    if value is None:
        return np.tile([-np.inf, np.inf], (n, 1))
    try:
        limits = np.array(value, dtype=np.float64)
    except Exception:  # whatever came may answer with any error
        raise Unreadable("The limits are not made of numbers.") from None
    if limits.shape != (n, 2) or np.isnan(limits).any():
        raise Unreadable(f"The limits need a lower and an upper one for each of {n} joints.")
    return limits


def _stands_off(chain: Chain, value: Any, wanted: Floats) -> Verdict | None:
    """Compare configurations: of joints that turn, up to full turns."""
    came = numbers(value, [(chain.n,)], "the configuration")
    turning = np.array([k == "r" for k in chain.kinds])
    off = came - wanted
    off = np.where(turning, np.angle(np.exp(1j * off)), off)
    if np.abs(off).max(initial=0) <= NEAR:
        return None
    joint = int(np.flatnonzero(np.abs(off) > NEAR)[0]) + 1
    seen = f"The table is right, but joint {joint} does not stand where it is asked to."
    question = "What does the table say where the robot stands, and in which unit?"
    ways = [
        (mistake("degrees", "angles are given in degrees", question), np.degrees(wanted)),
        (mistake("sign-all", "every joint goes the wrong way", question), -wanted),
        (mistake("home", "the robot stands at the table's own values", question), chain.home),
    ]
    found = [(m,) for m, made in ways if np.allclose(came, made, rtol=NEAR, atol=NEAR)]
    return verdict_of(seen, found)
