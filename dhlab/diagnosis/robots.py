"""The task of building a robot: one chain, or several that hang on each other."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from dhlab.diagnosis.beside import Beside, configuration
from dhlab.diagnosis.gauge import Match
from dhlab.diagnosis.hanging import parts_told, read_parts
from dhlab.diagnosis.paths import Part, parts_of, tips
from dhlab.diagnosis.renaming import Freedom, Naming, apart, joined, namings
from dhlab.diagnosis.seen import pose_seen
from dhlab.diagnosis.slips import NOTHING, verdict_of
from dhlab.diagnosis.tables import TableTask, choice
from dhlab.diagnosis.values import Unreadable
from dhlab.diagnosis.verdict import Case, Verdict, mistake
from dhlab.errors import InputError
from dhlab.kinematics.chain import Chain
from dhlab.kinematics.mechanism import Mechanism

OTHERWISE = (
    "One of several right robots: all tips move as they should, though frames inside stand "
    "otherwise than in our tables."
)
HANGS = mistake(
    "attached-elsewhere",
    "a part hangs on another frame, or on another part, than it should",
    "Which frame carries it when all joints are at rest, and which when they move?",
)


ORDER = mistake(
    "parts-order",
    "the parts are joined in another order than asked for",
    "Whose joints come first in q?",
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
        What a table may choose, see `TableTask`; of a robot with several tips not base and tool
        both.
    limits : bool
        Whether the limits of the joints are asked for.
    q : array_like, shape (n,), optional [rad or m]
        The configuration the robot is to be in, told in the variables of `robot`.
    ordered : bool
        Whether parts must come in the order of `robot`; else they are told by their names.

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
    ordered: bool = False

    def __post_init__(self) -> None:
        """Refuse what cannot be told apart."""
        ends = len(tips(self._wanted()))
        if self.base_free and self.tool_free and ends > 1:
            raise InputError(
                f"RobotTask: the robot has {ends} tips, and base_free and tool_free are both "
                "given; choose one of them."
            )

    def judge(self, cases: Sequence[Case]) -> Verdict:
        """Judge a robot; with several cases, all of them."""
        if not cases:
            return NOTHING
        verdicts = [self._judge(value) for _, value in cases]
        return next((v for v in verdicts if not v.right), verdicts[0])

    def _judge(self, value: Any) -> Verdict:
        if not isinstance(value, Mapping) or not value.keys() & {"rows", "components"}:
            return Verdict(False, "A robot is asked for: what does `robot(...)` give you?")
        wanted = self._wanted()
        try:
            values = parts_told(value, self._names())
            verdict = self._compared(wanted, value, values)
        except Unreadable as refusal:
            return Verdict(False, str(refusal))
        told = value["components"] if self._names() else values
        if (
            verdict.right
            and self.ordered
            and any(a is not b for a, b in zip(told, values, strict=True))
        ):
            return verdict_of("Each part is right, and hangs where it should.", [(ORDER,)])
        return verdict

    def _compared(
        self, wanted: Sequence[Part], value: Mapping[str, Any], values: Sequence[Mapping[str, Any]]
    ) -> Verdict:
        try:
            came = read_parts(value, values, wanted, self.zero_free)
        except Unreadable:
            tables = self._tables(wanted, values)
            if tables.right:
                raise
            return tables
        found = namings(wanted, came, self._free)
        named = next(found, None)
        if named is None:
            return self._elsewhere(wanted, came, values)
        wrong = self._beside(wanted, values, named)
        if wrong is not None and all(self._beside(wanted, values, other) for other in found):
            return wrong
        return Verdict(True, self._choices(wanted, came, values))

    def _elsewhere(
        self, wanted: Sequence[Part], came: Sequence[Part], values: Sequence[Mapping[str, Any]]
    ) -> Verdict:
        """Judge what moves otherwise: a table is wrong, or one hangs where it should not."""
        tables = self._tables(wanted, values)
        if not tables.right:
            return tables
        named = joined(self._matched(wanted, values))
        off = apart(wanted, came, named, self._free, named.back(configuration(values, wanted)))
        if off is None:
            return self._beside(wanted, values, named) or tables
        i, T, goal = off
        seen = pose_seen(T, goal, f"the tip of {values[i].get('name', self._names()[i])}")
        moved = any((a.on, a.at) != (b.on, b.at) for a, b in zip(wanted, came, strict=True))
        return verdict_of(f"Each part is right by itself. {seen}", [(HANGS,)] if moved else [])

    def _tables(self, wanted: Sequence[Part], values: Sequence[Mapping[str, Any]]) -> Verdict:
        """Judge the table of each part by itself."""
        choices = []
        for i, (task, value) in enumerate(zip(self._tasks(wanted), values, strict=True)):
            verdict = task.judge([((), value)])
            if not verdict.right:
                return self._of_part(i, verdict)
            choices.append(verdict.seen)
        return Verdict(True, " ".join(filter(None, choices)))

    def _choices(
        self, wanted: Sequence[Part], came: Sequence[Part], values: Sequence[Mapping[str, Any]]
    ) -> str:
        """Say which of the right robots it is; nothing of the one that has our tables."""
        if all(_is_ours(a.chain, b.chain) for a, b in zip(wanted, came, strict=True)):
            return ""
        right = self._matched(wanted, values)
        return OTHERWISE if len(right) < len(wanted) else " ".join(filter(None, map(choice, right)))

    def _matched(self, wanted: Sequence[Part], values: Sequence[Mapping[str, Any]]) -> list[Match]:
        """Return the renamings of the parts whose table is right by itself."""
        found = [t.matching(v) for t, v in zip(self._tasks(wanted), values, strict=True)]
        return [match for match in found if match is not None]

    def _beside(
        self, wanted: Sequence[Part], values: Sequence[Mapping[str, Any]], named: Naming
    ) -> Verdict | None:
        """Judge limits and where it stands, where they are asked for."""
        asked = Beside(self.limits, None if self.q is None else np.array(self.q, np.float64))
        wrong = asked.off(wanted, values, named, self.zero_free)
        return None if wrong is None else self._of_part(*wrong)

    def _of_part(self, i: int, verdict: Verdict) -> Verdict:
        names = self._names()
        return replace(verdict, seen=f"{names[i]}: {verdict.seen}") if names else verdict

    def _tasks(self, wanted: Sequence[Part]) -> list[TableTask]:
        return [TableTask(part.chain, *self._free) for part in wanted]

    @property
    def _free(self) -> Freedom:
        return Freedom(self.base_free, self.tool_free, self.zero_free)

    def _wanted(self) -> list[Part]:
        if isinstance(self.robot, Chain):
            return [Part(self.robot, -1, 0, self.robot.base)]
        parts = parts_of(self.robot.branches)
        if len(parts) == 1:  # a chain with all that stands before it
            parts = [part._replace(chain=part.chain.replace(base=part.base)) for part in parts]
        return parts

    def _names(self) -> list[str]:
        """Names of the parts; none where the robot is one chain."""
        if isinstance(self.robot, Chain):
            return []
        names = [b.name.split("/")[-1] for b in self.robot.branches if b.chain.n]
        return names if len(names) > 1 else []


def _is_ours(wanted: Chain, came: Chain) -> bool:
    """Whether a table that came tells the same frames as ours."""
    told = ("joints", "convention", "rows", "base", "grasper", "offset")
    return all(np.array_equal(getattr(wanted, name), getattr(came, name)) for name in told)
