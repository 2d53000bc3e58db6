"""Tasks about a chain: its pose for a configuration, and its Denavit-Hartenberg table."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from dhlab.diagnosis.chain_slips import Table, chain_slips, evaluate_tables, table_of
from dhlab.diagnosis.gauge import Match, match
from dhlab.diagnosis.matrix import judge_matrices
from dhlab.diagnosis.slips import NOTHING, Explanation, verdict_of
from dhlab.diagnosis.values import TOLERANCE, Unreadable, numbers
from dhlab.diagnosis.verdict import Case, Verdict
from dhlab.errors import InputError
from dhlab.kinematics.chain import Chain


@dataclass(frozen=True, eq=False)
class ForwardTask:
    """A function from a configuration to the pose of the tip.

    Parameters
    ----------
    chain : Chain
        What is right. Each case has one argument, the configuration, shape (n,).
    tolerance : float

    Examples
    --------
    >>> arm = Chain([(0, 0, 0, 0), (1, 0.3, 0, 0)], "rr", grasper=(0.2, 0, 0))
    >>> no_tool = arm.replace(grasper=(0, 0, 0))
    >>> cases = [((q,), no_tool.tip(q)) for q in ([0.3, 1.2], [-1.0, 0.4])]
    >>> [m.key for m in ForwardTask(arm).judge(cases).mistakes]
    ['no-tool']
    """

    chain: Chain
    tolerance: float = TOLERANCE

    def judge(self, cases: Sequence[Case]) -> Verdict:
        """Judge an answer by what came for several configurations."""
        if not cases:
            return NOTHING
        models = [table_of(self.chain, np.asarray(inputs[0], float)) for inputs, _ in cases]
        slips = chain_slips(self.chain)
        return judge_matrices(cases, models, slips, 4, self.tolerance, evaluate_tables)


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

    def _judge(self, value: Any) -> Verdict:
        try:
            came = self._read(value)
        except (Unreadable, InputError) as refusal:
            return Verdict(False, str(refusal))
        if came.joints != self.chain.joints:
            return Verdict(False, _letters_seen(came.joints, self.chain.joints))
        found = self._match(self.chain, came)
        if found is not None:
            return Verdict(True, _choice(found))
        return verdict_of(_table_seen(self.chain, came), self._explain(came))

    def _match(self, wanted: Chain, came: Chain) -> Match | None:
        return match(wanted, came, self.base_free, self.tool_free, self.zero_free)

    def _explain(self, came: Chain) -> list[Explanation]:
        model = table_of(self.chain, self.chain.home)
        found: list[Explanation] = []
        for slip in chain_slips(self.chain, table=True):
            wrong: Table = slip.change(model)
            chain = wrong.chain(self.chain)
            if chain is not None and self._match(chain, came):
                found.append((slip.mistake,))
        return list({e[0].key: e for e in found}.values())

    def _read(self, value: Any) -> Chain:
        given = dict(value) if isinstance(value, Mapping) else {"rows": value}
        rows = numbers(given.pop("rows", None), [(-1, 4)], "the table")
        n = self.chain.n
        if len(rows) != n:
            less = "fewer" if len(rows) < n else "more"
            raise Unreadable(f"The table has {less} rows than the mechanism has joints.")
        known = {"joints", "convention", "base", "grasper", "offset"}
        fields = {name: given[name] for name in known & given.keys() if given[name] is not None}
        if (np.abs(rows[:, [0, 3]]) > 2 * np.pi + 1e-9).any():
            raise Unreadable(
                "An angle of the table is more than a full turn: are these degrees? "
                "What is a quarter turn in radians?"
            )
        own = ("joints", "convention", "base", "grasper")
        defaults = {name: getattr(self.chain, name) for name in own}
        if not self.zero_free:
            defaults["offset"] = self.chain.offset
        return Chain(rows.tolist(), **(defaults | fields))


def _letters_seen(came: str, wanted: str) -> str:
    k = next(i for i, (a, b) in enumerate(zip(came, wanted, strict=True)) if a != b)
    return f"Joint {k + 1} has the wrong letter: does it turn or slide?"


def _choice(found: Match) -> str:
    """Say which of the right choices the student made."""
    turned = [str(i + 1) for i, s in enumerate(found.signs) if s < 0]
    zeros = [str(i + 1) for i, o in enumerate(found.offsets) if abs(o) > 1e-4]
    parts = []
    if turned:
        parts.append(f"z of joint {', '.join(turned)} points the other way than in our table")
    if zeros:
        parts.append(f"joint {', '.join(zeros)} counts from another zero")
    return f"One of several right tables: {'; '.join(parts)}." if parts else ""


def _table_seen(wanted: Chain, came: Chain) -> str:
    """Name the first link between two axes that is not the mechanism's."""
    for i, (a, b) in enumerate(zip(_links(wanted), _links(came), strict=True)):
        if abs(a[0] - b[0]) > 1e-5:
            return f"The axes of joints {i + 1} and {i + 2} enclose another angle than they should."
        if abs(a[1] - b[1]) > 1e-5:
            return f"The axes of joints {i + 1} and {i + 2} are not as far apart as they should be."
    return (
        "Neighbouring axes enclose the right angles at the right distances, but the tip does not "
        "move as it should: look at the signs, at d, and at what stands before and behind."
    )


def _links(chain: Chain) -> list[tuple[float, float]]:
    """Cosine between neighbouring axes, regardless of their senses, and their distance."""
    down = chain if chain.convention == "modified" else chain.to_modified()
    pairs = zip(down.rows[1:], down.joints, down.joints[1:], strict=False)
    return [(abs(np.cos(r.alpha)), abs(r.a) if a == b == "r" else 0.0) for r, a, b in pairs]
