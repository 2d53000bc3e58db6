"""The task of finding a Denavit-Hartenberg table."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from dhlab.diagnosis.chain_slips import table_slips
from dhlab.diagnosis.gauge import TOLERANCE, Match, match
from dhlab.diagnosis.reading import read_chain
from dhlab.diagnosis.slips import NEARLY, NOTHING, verdict_of
from dhlab.diagnosis.table_search import explain_table, invariants, joint_counts
from dhlab.diagnosis.values import Unreadable
from dhlab.diagnosis.verdict import Case, Verdict, mistake
from dhlab.kinematics.chain import Chain

ROUNDED = 1e-3
"""A table whose axes lie as near as this is the right one, but for 3.14 or 1.571 in it."""


@dataclass(frozen=True, eq=False)
class TableTask:
    """A Denavit-Hartenberg table: any one that moves the tip as the mechanism does.

    What comes is an array of rows alpha, a, d, theta, or a mapping with `rows` and, where they
    differ from the mechanism's, `joints`, `convention`, `base`, `grasper`, `offset`.

    Parameters
    ----------
    chain : Chain
        The mechanism, by one of its tables.
    base_free, tool_free : bool
        Whether a constant pose may be left out before the first and behind the last frame.
    zero_free : bool
        Whether joints may count from another zero.

    Examples
    --------
    >>> arm = Chain([(0, 0, 0, 0), (1, 0.3, 0, 0), (0, 0.2, 0, 0)], "rrr")
    >>> rows = [list(row) for row in arm.rows]
    >>> TableTask(arm).judge([((), rows)]).right
    True
    >>> rows[1][0] = -1
    >>> [[m.key for m in group] for group in TableTask(arm).judge([((), rows)]).either]
    [['sign-alpha-2'], ['sign-a-2']]
    """

    chain: Chain
    base_free: bool = False
    tool_free: bool = False
    zero_free: bool = True

    def judge(self, cases: Sequence[Case]) -> Verdict:
        """Judge a table; with several cases, all of them."""
        if not cases:
            return NOTHING
        verdicts = [self._judge(value) for _, value in cases]
        return next((v for v in verdicts if not v.right), verdicts[0])

    def matching(self, value: Any) -> Match | None:
        """How a table that came moves as the mechanism does; None where it does not.

        Raises
        ------
        Unreadable
            If what came is no table.
        """
        return self._match(self.chain, read_chain(value, self.chain, self.zero_free))

    def _judge(self, value: Any) -> Verdict:
        try:
            came = read_chain(value, self.chain, self.zero_free)
        except Unreadable as refusal:
            return Verdict(False, str(refusal))
        if came.n != self.chain.n:
            return self._other_length(came)
        if came.joints != self.chain.joints:
            return Verdict(False, _letters_seen(came.joints, self.chain.joints))
        found = self._match(self.chain, came)
        if found is not None:
            return Verdict(True, choice(found))
        explanations = explain_table(self.chain, came, table_slips(self.chain), self._matches)
        if not explanations and self._match(self.chain, came, ROUNDED) is not None:
            return Verdict(False, NEARLY)
        return verdict_of(self._seen(came), explanations)

    def _match(self, wanted: Chain, came: Chain, tolerance: float = TOLERANCE) -> Match | None:
        free = self.base_free, self.tool_free, self.zero_free
        return match(wanted, came, *free, tolerance=tolerance)

    def _matches(self, wanted: Chain, came: Chain) -> bool:
        return self._match(wanted, came) is not None

    def _other_length(self, came: Chain) -> Verdict:
        less = "fewer" if came.n < self.chain.n else "more"
        seen = f"The table has {less} rows than the mechanism has joints."
        question = "To which joint does each row belong?"
        counts = joint_counts(self.chain, came, self._matches)
        return verdict_of(seen, [(mistake(key, how, question),) for key, how in counts])

    def _seen(self, came: Chain) -> str:
        """Name the first axis that does not lie where the mechanism has it."""
        off = np.abs(invariants(self.chain) - invariants(came)) > 1e-4
        if off.any():
            i = int(np.flatnonzero(off.any(axis=0))[0])
            what = int(np.flatnonzero(off[:, i])[0])
            between = f"joints {i + 1} and {i + 2}"
            return (
                f"The axes of {between} enclose another angle than they should.",
                f"The axes of {between} are not as far apart as they should be.",
                f"Along the axis of joint {i + 1}, its neighbours are not as far apart as they "
                "should be.",
            )[what]
        if not self.zero_free and match(self.chain, came, self.base_free, self.tool_free):
            return "The robot moves as it should, but joints count from another zero."
        alike = (i for i in range(self.chain.n) if not self._begins_alike(came, i + 1))
        first = next(alike, self.chain.n)
        if first == self.chain.n:
            return (
                "All axes lie where they should, but the tip does not: look at the last row, and "
                "at the tool behind it (the grasper)."
            )
        if first == 0:
            return "The axis of joint 1 does not lie where it should: what stands before it?"
        return (
            f"Up to joint {first} the table moves as it should, but the axis of joint {first + 1} "
            f"does not lie where it should: look at rows {first} and {first + 1}."
        )

    def _begins_alike(self, came: Chain, joints: int) -> bool:
        """Whether the first joints move what follows them as they should."""
        wanted, begun = _beginning(self.chain, joints), _beginning(came, joints)
        return match(wanted, begun, self.base_free, True, self.zero_free) is not None


def _beginning(chain: Chain, joints: int) -> Chain:
    return chain.replace(
        rows=chain.rows[:joints],
        joints=chain.joints[:joints],
        offset=chain.offset[:joints],
        limits=None,
        grasper=(0, 0, 0),
    )


def _letters_seen(came: str, wanted: str) -> str:
    k = next(i for i, (a, b) in enumerate(zip(came, wanted, strict=True)) if a != b)
    return f"Joint {k + 1} has the wrong letter: does it turn or slide?"


def choice(found: Match) -> str:
    """Say which of the right choices the student made."""
    turned = [str(i + 1) for i, s in enumerate(found.signs) if s < 0]
    zeros = [str(i + 1) for i, o in enumerate(found.offsets) if abs(o) > 1e-4]
    parts = []
    if turned:
        parts.append(f"z of joint {', '.join(turned)} points the other way than in our table")
    if zeros:
        parts.append(f"joint {', '.join(zeros)} counts from another zero")
    return f"One of several right tables: {'; '.join(parts)}." if parts else ""
