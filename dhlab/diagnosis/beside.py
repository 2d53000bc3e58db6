"""What a robot has beside its table: how far its joints go, and where it stands."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from dhlab.diagnosis.paths import Part, joints_of
from dhlab.diagnosis.renaming import Naming
from dhlab.diagnosis.slips import verdict_of
from dhlab.diagnosis.values import Floats, Unreadable, numbers
from dhlab.diagnosis.verdict import Mistake, Verdict, mistake
from dhlab.diagnosis.zeros import Zeros
from dhlab.kinematics.chain import Chain

NEAR = 1e-4
COUNTED = "In which unit, and from which zero, does each joint count?"


@dataclass(frozen=True, eq=False)
class Beside:
    """What is asked beside the table.

    Attributes
    ----------
    limits : bool
        Whether the limits are.
    q : ndarray, shape (n,), or None [rad or m]
        Where the robot is to stand.
    """

    limits: bool
    q: Floats | None

    def off(
        self,
        wanted: Sequence[Part],
        values: Sequence[Mapping[str, Any]],
        named: Naming,
        zero_free: bool,
    ) -> tuple[int, Verdict] | None:
        """Find the first part that is off, and what is said of it.

        Parameters
        ----------
        wanted : sequence of Part
        values : sequence of mapping
            What came.
        named : Naming
            Of all joints. What it leaves open is chosen so that as much fits as can.
        zero_free : bool
        """
        limits, came = np.zeros((0, 2)), np.zeros(0)
        if self.limits:
            told = zip(values, wanted, strict=True)
            limits = np.vstack([_limits(value, part.chain.n) for value, part in told])
        if self.q is not None:
            came = configuration(values, wanted)
        ways = [named]
        if zero_free:
            kinds = "".join(part.chain.joints for part in wanted)
            named = self._by_limits(wanted, limits, kinds, named)
            ways = [named, self._by_pose(came, kinds, named)]
        wrong = [self._off(wanted, limits, came, way) for way in ways]
        return wrong[0] if all(wrong) else None

    def _off(
        self, wanted: Sequence[Part], limits: Floats, came: Floats, named: Naming
    ) -> tuple[int, Verdict] | None:
        """Compare part after part by one renaming."""
        for i, (part, own) in enumerate(zip(wanted, joints_of(wanted), strict=True)):
            signs, offsets = named.signs[own], named.zeros.offsets[own]
            wrong = _limits_off(part.chain, limits[own], signs, offsets) if self.limits else None
            if wrong is None and self.q is not None:
                wrong = _stands_off(part.chain, came[own], signs * self.q[own] + offsets)
            if wrong is not None:
                return i, wrong
        return None

    def _by_limits(
        self, wanted: Sequence[Part], limits: Floats, kinds: str, named: Naming
    ) -> Naming:
        """Choose open zeros, and full turns, so that limits fit."""
        zeros = named.zeros
        if self.limits:
            asked = named.signs[:, None] * np.vstack([part.chain.limits for part in wanted])
            for i, (told, ends) in enumerate(zip(limits, np.sort(asked), strict=True)):
                zeros = _fitted(zeros, i, _shifts(told, ends), kinds[i] == "r")
        return Naming(named.signs, zeros)

    def _by_pose(self, came: Floats, kinds: str, named: Naming) -> Naming:
        """Choose zeros that are still open so that it stands as it should."""
        zeros = named.zeros
        if self.q is not None:
            for i, at in enumerate((came - named.signs * self.q).tolist()):
                zeros = zeros.at(i, at, kinds[i] == "r")
        return Naming(named.signs, zeros)


def _shifts(limits: Floats, wanted: Floats) -> list[float]:
    """By how much each of two limits, shape (2,), is shifted, where both are finite."""
    ends = np.isfinite(wanted) & np.isfinite(limits)
    shifts: list[float] = (limits[ends] - wanted[ends]).tolist()
    return shifts


def _fitted(zeros: Zeros, joint: int, shifts: Sequence[float], turning: bool) -> Zeros:
    """Choose a zero that both limits tell; or full turns that at least one of them tells."""
    if shifts and np.ptp(shifts) <= NEAR * (1 + np.abs(shifts).max()):
        return zeros.at(joint, shifts[0], turning)
    ways = [zeros.turned(joint, shift) for shift in shifts] if turning else []
    fits = (abs(w.offsets[joint] - s) <= NEAR for w, s in zip(ways, shifts, strict=False))
    return next((way for way, fit in zip(ways, fits, strict=True) if fit), zeros)


def configuration(values: Sequence[Mapping[str, Any]], wanted: Sequence[Part]) -> Floats:
    """Read where the joints of all parts stand, shape (n,), or `Unreadable`."""
    return np.concatenate(
        [
            numbers(value.get("q"), [(part.chain.n,)], "the configuration")
            for value, part in zip(values, wanted, strict=True)
        ]
    )


def _limits(value: Mapping[str, Any], n: int) -> Floats:
    told = value.get("limits")
    if told is None:
        return np.tile([-np.inf, np.inf], (n, 1))
    try:
        limits = np.array(told, dtype=np.float64)
    except Exception:  # whatever came may answer with any error
        raise Unreadable("The limits are not made of numbers.") from None
    if limits.shape != (n, 2) or np.isnan(limits).any():
        raise Unreadable(f"The limits need a lower and an upper one for each of {n} joints.")
    return limits


def _limits_off(chain: Chain, came: Floats, signs: Floats, offsets: Floats) -> Verdict | None:
    """Compare limits, shape (n, 2), after the joints' renaming; those that came may be infinite."""
    wanted = np.sort(signs[:, None] * chain.limits, axis=1) + offsets[:, None]
    off = ~np.isclose(came, wanted, rtol=NEAR, atol=NEAR)
    if not off.any():
        return None
    joint, end = np.argwhere(off)[0].tolist()
    word = ("lower", "upper")[end]
    which = f"{word} limit of joint {joint + 1} is not the one asked for."
    flipped = ", ".join(str(i + 1) for i in np.flatnonzero(signs < 0))
    seen = f"The table is right. The {which}"
    if flipped:
        seen = (
            f"The tip moves as it should if joint {flipped} counts the other way than in our "
            f"table; then the {which}"
        )
    turning = np.array([k == "r" for k in chain.kinds])[:, None]
    ways: list[tuple[Mistake, Floats]] = [
        (
            mistake("limits-degrees", "the limits are given in degrees", COUNTED),
            np.where(turning, np.degrees(wanted), wanted),
        ),
        (
            mistake("limits-missing", "no limits are given", "How far can each joint go?"),
            np.broadcast_to([-np.inf, np.inf], wanted.shape),
        ),
        *(_sense_ways(chain) if flipped else _zero_ways(chain, wanted)),
    ]
    found = [(m,) for m, made in ways if np.allclose(came, made, rtol=NEAR, atol=NEAR)]
    return verdict_of(seen, found)


def _zero_ways(chain: Chain, wanted: Floats) -> list[tuple[Mistake, Floats]]:
    """Limits as they are where a table is ours but for its zeros."""
    other = "the limits are those of joints that count the other way"
    return [
        (mistake("limits-sign", other, COUNTED), -wanted[:, ::-1]),
        (
            mistake("limits-zero", "the limits count from another zero", COUNTED),
            np.sort(chain.limits, axis=1),
        ),
    ]


def _sense_ways(chain: Chain) -> list[tuple[Mistake, Floats]]:
    """Limits as they are where a table has turned axes over."""
    question = "Which way does each joint turn by its table, and which way is meant?"
    over = "an axis of the table is turned over, and its limits are not"
    return [(mistake("limits-sense", over, question), np.sort(chain.limits, axis=1))]


def _stands_off(chain: Chain, came: Floats, wanted: Floats) -> Verdict | None:
    """Compare configurations, shape (n,): of joints that turn, up to full turns."""
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
