"""When two robots of several chains are the same: one renaming of all joints moves all tips alike.

Path after path from the world to a tip is matched: each tells the senses of its joints, and which
sums of zeros it settles. Where the base is free, the other tips are seen from the first one.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from dhlab.diagnosis.gauge import Match, matches
from dhlab.diagnosis.paths import Part, Path, path, tips
from dhlab.diagnosis.values import Floats, inverted
from dhlab.diagnosis.zeros import Zeros

NEAR = 1e-3


class Freedom(NamedTuple):
    """What a table may choose: the constant pose before it, those behind its tips, its zeros."""

    base: bool = False
    tool: bool = False
    zero: bool = True


@dataclass(frozen=True, eq=False)
class Naming:
    """How all joints of a robot are renamed: ``q -> signs q + offsets``.

    Attributes
    ----------
    signs : ndarray, shape (n,)
        1 or -1.
    zeros : Zeros
        The offsets, and what of them is open.
    """

    signs: Floats
    zeros: Zeros

    def renamed(self, q: Floats) -> Floats:
        """Variables of the robot that came, shape (..., n)."""
        return self.signs * q + self.zeros.offsets

    def back(self, q: Floats) -> Floats:
        """Variables of the robot that was wanted, shape (..., n)."""
        return self.signs * (q - self.zeros.offsets)


def joined(found: Sequence[Match]) -> Naming:
    """Return the renamings of single chains as one of the whole robot."""
    offsets = np.concatenate([match.renamed(-match.zeros[0]) for match in found])
    signs = np.concatenate([match.signs for match in found])
    return Naming(signs, Zeros(offsets, np.zeros((len(offsets), 0))))


class Elsewhere(NamedTuple):
    """A tip that is not where it should be.

    Attributes
    ----------
    part : int
        Whose tip.
    came, wanted : ndarray, shape (4, 4)
        Where it came to be, and where it should be.
    """

    part: int
    came: Floats
    wanted: Floats


class _Way(NamedTuple):
    """A path of both robots, and which of its ends are free."""

    wanted: Path
    came: Path
    base_free: bool
    tool_free: bool


def namings(wanted: Sequence[Part], came: Sequence[Part], free: Freedom) -> Iterator[Naming]:
    """Find all renamings of the joints under which all tips move alike, one for each of senses.

    Where none is needed, that comes first, at once: most right answers are of this kind.

    Parameters
    ----------
    wanted, came : sequence of Part
    free : Freedom
        Not base and tool both, if there are several tips.
    """
    if [part.chain.joints for part in wanted] != [part.chain.joints for part in came]:
        return
    ways = _ways(wanted, came, free)
    if all(way.wanted.numbers == way.came.numbers for way in ways):
        n = sum(part.chain.n for part in wanted)
        plain = Naming(np.ones(n), Zeros.of(n, settled=True))
        if apart(wanted, came, plain, free) is None:
            yield plain
        for named in _search(ways, {}, Zeros.of(n, settled=not free.zero), free.zero):
            if apart(wanted, came, named, free) is None:
                yield named


def apart(
    wanted: Sequence[Part],
    came: Sequence[Part],
    named: Naming,
    free: Freedom,
    q: Floats | None = None,
) -> Elsewhere | None:
    """Find a tip that is elsewhere, if any: at `q`, or else at some of all configurations.

    Parameters
    ----------
    wanted, came : sequence of Part
    named : Naming
        Of the joints that came.
    free : Freedom
    q : ndarray, shape (n,), optional [rad or m]
        In the variables of `wanted`.
    """
    n = len(named.signs)
    some = np.random.default_rng(7).uniform(-2, 2, (8, n))
    rest = np.zeros((1, n))  # what stands before and behind is read off here
    q = np.vstack([rest, some] if q is None else [rest, q[None], some])
    base, found = np.eye(4), []
    for k, i in enumerate(tips(wanted)):
        A, B = path(wanted, i), path(came, i)
        goal, T = A.tip(q[:, list(A.numbers)]), B.tip(named.renamed(q)[:, list(B.numbers)])
        if free.base and k == 0:
            base = goal[0] @ inverted(T[0])
        T = base @ T
        if free.tool:
            T = T @ inverted(T[0]) @ goal[0]
        off = np.abs(T - goal).max(axis=(1, 2)) > NEAR * (1 + np.abs(goal).max(axis=(1, 2)))
        off[0] &= not off[1:].any()
        found += [(int(at), Elsewhere(i, T[at], goal[at])) for at in np.flatnonzero(off)[:1]]
    return min(found, key=lambda one: one[0])[1] if found else None


def _ways(wanted: Sequence[Part], came: Sequence[Part], free: Freedom) -> list[_Way]:
    """Paths that tell all: to each tip, or with a free base to one and from there to the others."""
    first, *others = ends = tips(wanted)
    if not free.base:
        return [_Way(path(wanted, i), path(came, i), False, free.tool) for i in ends]
    return [
        _Way(path(wanted, first), path(came, first), True, free.tool),
        *(_Way(path(wanted, i, first), path(came, i, first), free.tool, free.tool) for i in others),
    ]


def _search(
    ways: Sequence[_Way], senses: Mapping[int, float], zeros: Zeros, zero_free: bool
) -> Iterator[Naming]:
    """Match path after path; what one tells holds for the next."""
    if not ways:
        yield Naming(np.array([senses[i] for i in range(len(senses))]), zeros)
        return
    (A, B, base_free, tool_free), *rest = ways
    known = {k: senses[joint] for k, joint in enumerate(A.numbers) if joint in senses}
    for one in matches(A, B, base_free, tool_free, zero_free, senses=known):
        named = {**senses, **dict(zip(A.numbers, one.signs.tolist(), strict=True))}
        left = zeros.on(B, one.offsets, base_free, tool_free) if zero_free else zeros
        yield from _search(rest, named, left, zero_free)
