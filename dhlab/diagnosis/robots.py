"""The task of building a robot: one chain, or several that hang on each other."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from dhlab.diagnosis.gauge import Match
from dhlab.diagnosis.seen import pose_seen
from dhlab.diagnosis.slips import NOTHING, verdict_of
from dhlab.diagnosis.tables import TableTask
from dhlab.diagnosis.values import Floats, Unreadable, numbers
from dhlab.diagnosis.verdict import Case, Mistake, Verdict, mistake
from dhlab.kinematics.chain import Chain
from dhlab.kinematics.mechanism import Branch, Mechanism

NEAR = 1e-4
HANGS = mistake(
    "attached-elsewhere",
    "a part hangs on another frame, or on another part, than it should",
    "Which frame carries it when all joints are at rest, and which when they move?",
)


@dataclass(frozen=True, eq=False)
class RobotTask:
    """A robot, as plain data: its table, its ends, and where asked for its limits and its pose.

    What comes is a mapping with `rows`, `joints`, `convention`, `base`, `grasper`, `offset`,
    `limits`, `q`; of a robot of several also `components`, a mapping each, and `frames`, the poses
    in the world at `q` by their names. As for a `TableTask`, every right table is accepted.

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
            branches = self._branches()
            if len(branches) == 1:
                return self._simple(branches[0].chain, value)
            return self._complex(branches, value)
        except Unreadable as refusal:
            return Verdict(False, str(refusal))

    def _simple(self, chain: Chain, value: Mapping[str, Any]) -> Verdict:
        parts = value.get("components")
        if isinstance(parts, list | tuple) and len(parts) > 1:
            return Verdict(False, "One chain is asked for; this robot has several.")
        verdict, _ = self._part(chain, value, self._q_of(0, chain.n))
        return verdict

    def _complex(self, branches: Sequence[Branch], value: Mapping[str, Any]) -> Verdict:
        parts = _parts(value, [_last(b.name) for b in branches])
        choices, found, start = [], [], 0
        for branch, part in zip(branches, parts, strict=True):
            n = branch.chain.n
            verdict, match = self._part(branch.chain, part, self._q_of(start, n))
            start += n
            if not verdict.right:
                return replace(verdict, seen=f"{_last(branch.name)}: {verdict.seen}")
            choices.append(verdict.seen)
            found.append(match)
        hung = self._hung(value, parts, found)
        return hung or Verdict(True, " ".join(filter(None, choices)))

    def _branches(self) -> Sequence[Branch]:
        if isinstance(self.robot, Chain):
            return [Branch("robot", self.robot)]
        return [b for b in self.robot.branches if b.chain.n]

    def _q_of(self, start: int, n: int) -> Floats | None:
        return None if self.q is None else np.array(self.q[start : start + n], dtype=np.float64)

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

    def _hung(
        self, value: Mapping[str, Any], parts: Sequence[Any], found: Sequence[Match | None]
    ) -> Verdict | None:
        """Compare where the parts end, for the configuration that came: do they hang rightly."""
        if isinstance(self.robot, Chain):
            return None
        q = []
        for match, part in zip(found, parts, strict=True):
            if match is None:
                return None
            there = numbers(part.get("q"), [match.signs.shape], "the configuration")
            q.append(match.signs * (there - match.offsets - match.zeros[1]) + match.zeros[0])
        frames = value.get("frames")
        if not isinstance(frames, Mapping):
            raise Unreadable("The robot tells no frames: is it made by `robot_complex`?")
        names = {
            _last(branch.name): str(part.get("name"))
            for branch, part in zip(self._branches(), parts, strict=True)
        }
        for name, wanted in self.robot.frames(np.concatenate(q)).items():
            if not name.endswith("/grasper"):
                continue
            end = [names[name.split("/")[-2]], "grasper"]
            came = [T for key, T in frames.items() if str(key).split("/")[-2:] == end]
            if len(came) != 1:
                raise Unreadable(f"There is no single {'/'.join(end)} among the robot's frames.")
            T = numbers(came[0], [(4, 4)], f"the pose of {'/'.join(end)}")
            if np.abs(T - wanted).max() > NEAR * (1 + np.abs(wanted).max()):
                seen = pose_seen(T, wanted, f"the tip of {end[0]}")
                return verdict_of(f"Each part is right by itself. {seen}", [(HANGS,)])
        return None


def _last(name: str) -> str:
    return name.split("/")[-1]


def _parts(value: Mapping[str, Any], names: Sequence[str]) -> list[Any]:
    """Components that came, in the order of these names; by their place where names differ."""
    parts = value.get("components")
    if not isinstance(parts, list | tuple) or not all(isinstance(p, Mapping) for p in parts):
        raise Unreadable(f"A robot of {len(names)} chains is asked for: which ones are joined?")
    if len(parts) != len(names):
        less = "fewer" if len(parts) < len(names) else "more"
        raise Unreadable(f"The robot has {less} chains than the one asked for.")
    by_name = {str(part.get("name")): part for part in parts}
    if set(by_name) == set(names):
        return [by_name[name] for name in names]
    return list(parts)


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
