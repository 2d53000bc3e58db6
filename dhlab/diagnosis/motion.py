"""A polynomial motion in numbers, and what may go wrong in it."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from math import degrees, radians
from typing import Literal, TypeAlias

import numpy as np

from dhlab.diagnosis.product import After
from dhlab.diagnosis.slips import Slip
from dhlab.diagnosis.values import Floats
from dhlab.diagnosis.verdict import mistake
from dhlab.kinematics.polynomials import cubics, evaluate, quintics

Answer: TypeAlias = Literal["q", "v", "a", "motion", "coefficients"]


@dataclass(frozen=True, eq=False)
class Motion:
    """A polynomial between two configurations, and what was done to it.

    `q0, qt, v0, vt` have shape (n,), the instants `at` (m,). Coefficients hold for the time since
    `clock`, the highest power first. The `weights` of what is asked for say how much it counts: a
    coefficient as much as what it gives at the end.
    """

    q0: Floats
    qt: Floats
    v0: Floats
    vt: Floats
    start: float
    duration: float
    at: Floats
    degree: int
    answer: Answer
    clock: float
    weights: Floats
    profile: Callable[["Motion"], Floats] | None = None
    edits: tuple[After, ...] = ()
    backwards: bool = False
    speed: float = 1.0
    slopes: Callable[["Motion", Floats, Floats], tuple[Floats, Floats, Floats]] | None = None
    after: tuple[After, ...] = ()

    def then(self, change: After) -> "Motion":
        """Do something to the finished numbers."""
        return replace(self, after=(*self.after, change))


def evaluate_motions(motions: Sequence[Motion]) -> list[Floats]:
    """What is asked of each motion: (m, n), (3, m, n) or coefficients (powers, n)."""
    return [_value(m) for m in motions]


def _value(m: Motion) -> Floats:
    c = (m.profile or _polynomial)(m)
    for edit in m.edits:
        c = edit(c)
    if m.answer == "coefficients":
        c = shifted_time(c, m.start - m.clock)
        out = c[::-1] if m.backwards else c
    else:
        c = c[::-1] if m.backwards else c
        u = (m.at - m.clock) * m.speed
        q, v, a = (m.slopes or _slopes)(m, c, u)
        out = np.array([q, v, a]) if m.answer == "motion" else {"q": q, "v": v, "a": a}[m.answer]
    for change in m.after:
        out = change(out)
    return out


def shifted_time(c: Floats, start: float) -> Floats:
    """Coefficients in t of a polynomial in ``t - start``, shape (powers, n)."""
    out = np.zeros_like(c)
    for row in c:
        out = np.vstack([out[1:], np.zeros_like(row)]) - start * out
        out[-1] += row
    return out


def _polynomial(m: Motion) -> Floats:
    h = np.array([m.duration])
    if m.degree == 3:
        return cubics(h, m.q0, m.qt, m.v0, m.vt)
    rest = np.zeros_like(m.q0)
    return quintics(h, m.q0, m.qt, m.v0, m.vt, rest, rest)


def _slopes(m: Motion, c: Floats, u: Floats) -> tuple[Floats, Floats, Floats]:
    return evaluate(np.broadcast_to(c, (len(u), *c.shape)), u)


def motion_slips(m: Motion) -> list[Slip[Motion]]:
    """All slips for such a motion."""
    return [*_ends(m), *_profiles(m), *_coefficients(m), *_time(m), *_derivatives(m), *_units()]


def _ends(m: Motion) -> Iterator[Slip[Motion]]:
    question = "Where does the motion begin, and how far does it go?"
    yield Slip(
        mistake("exchanged-ends", "the first and the last configuration change places", question),
        lambda m: replace(m, q0=m.qt, qt=m.q0),
    )
    yield Slip(
        mistake("no-start", "the first configuration is not added", question),
        lambda m: replace(m, q0=np.zeros_like(m.q0), qt=m.qt - m.q0),
    )
    yield Slip(
        mistake("end-for-way", "the last configuration stands for the way to it", question),
        lambda m: replace(m, qt=m.qt + m.q0),
    )
    slope = "What are the velocities at both ends, and which conditions say so?"
    for name, word in (("v0", "first"), ("vt", "last")):
        if getattr(m, name).any():
            yield Slip(
                mistake(f"no-{name}", f"the {word} velocity is taken for 0", slope),
                lambda m, name=name: replace(  # type: ignore[misc]
                    m, **{name: np.zeros_like(m.q0)}
                ),
            )
            yield Slip(
                mistake(f"sign-{name}", f"the {word} velocity has the wrong sign", slope),
                lambda m, name=name: replace(m, **{name: -getattr(m, name)}),  # type: ignore[misc]
            )


def _profiles(m: Motion) -> Iterator[Slip[Motion]]:
    question = "What is the derivative of your polynomial at both ends?"
    ways: list[tuple[str, str, tuple[float, float]]] = [
        ("line", "the end velocities are not zero: the way is a straight line in time", (0, 1)),
        ("last-velocity", "the last velocity is not zero: a parabola from rest", (1, 0)),
        ("first-velocity", "the first velocity is not zero: a parabola to rest", (-1, 2)),
    ]
    if not m.v0.any() and not m.vt.any():
        for key, when, (square, line) in ways:

            def low(m: Motion, square: float = square, line: float = line) -> Floats:
                c = np.zeros((m.degree + 1, len(m.q0)))
                way, h = m.qt - m.q0, m.duration
                c[-3:] = square * way / h**2, line * way / h, m.q0
                return c

            yield Slip(
                mistake(key, when, question),
                lambda m, low=low: replace(m, profile=low),  # type: ignore[misc]
            )
    other = 5 if m.degree == 3 else 3
    if m.answer != "coefficients":
        yield Slip(
            mistake(
                "other-degree",
                f"the polynomial has degree {other} instead of {m.degree}",
                "How many conditions are given, and how many coefficients meet them?",
            ),
            lambda m: replace(m, degree=other),
        )


def _coefficients(m: Motion) -> Iterator[Slip[Motion]]:
    question = "Put both ends into your polynomial and its derivative: which condition fails?"
    for k in range(m.degree - 1 if m.degree == 3 else 3):
        power = m.degree - k

        def negated(c: Floats, k: int = k) -> Floats:
            return np.where(np.arange(len(c))[:, None] == k, -c, c)

        yield Slip(
            mistake(f"sign-c{power}", f"the coefficient of t^{power} has the wrong sign", question),
            _edit(negated),
        )
    if m.degree == 3 and not m.v0.any() and not m.vt.any():
        for key, when, powers, factors in (
            ("factors-exchanged", "the factors 2 and 3 are exchanged", (3, 2), (-3, 2)),
            ("powers-exchanged", "the powers of the duration are exchanged", (2, 3), (-2, 3)),
            ("powers-lost", "the powers of the duration are left out", (0, 0), (-2, 3)),
        ):

            def cubic(
                m: Motion,
                powers: tuple[int, int] = powers,
                factors: tuple[int, int] = factors,
            ) -> Floats:
                way, h = m.qt - m.q0, m.duration
                high = [f * way / h**p for f, p in zip(factors, powers, strict=True)]
                return np.array([*high, np.zeros_like(way), m.q0])

            when = f"{when} in the coefficients of t^3 and t^2"
            yield Slip(
                mistake(key, when, question),
                lambda m, cubic=cubic: replace(m, profile=cubic),  # type: ignore[misc]
            )
    yield Slip(
        mistake(
            "reversed-coefficients",
            "the coefficients stand in the reverse order",
            "Which power does the first coefficient belong to?",
        ),
        lambda m: replace(m, backwards=True),
    )


def _edit(change: After) -> Callable[[Motion], Motion]:
    return lambda m: replace(m, edits=(*m.edits, change))


def _time(m: Motion) -> Iterator[Slip[Motion]]:
    question = "What is the time that the polynomial counts, when the motion begins?"
    if m.start and m.clock == m.start:
        yield Slip(
            mistake("time-not-shifted", "the time is not counted from the start", question),
            lambda m: replace(m, clock=0.0),
        )
        yield Slip(
            mistake(
                "time-shifted-back", "the start is added to the time, not subtracted", question
            ),
            lambda m: replace(m, clock=-m.start),
        )
        yield Slip(
            mistake("time-backwards", "the time is subtracted from the start", question),
            lambda m: replace(m, speed=-m.speed),
        )
    elif m.start:
        yield Slip(
            mistake("time-shifted", "the time is counted from the start", question),
            lambda m: replace(m, clock=m.start),
        )
    if m.start:
        yield Slip(
            mistake("end-for-duration", "the last instant stands for the duration", question),
            lambda m: replace(m, duration=m.start + m.duration),
        )
    if m.answer != "coefficients":
        yield Slip(
            mistake(
                "time-in-parts",
                "the time is divided by the duration, but the coefficients are not made for that",
                question,
            ),
            lambda m: replace(m, speed=1 / m.duration),
        )


def _derivatives(m: Motion) -> Iterator[Slip[Motion]]:
    if m.answer == "coefficients":
        return
    question = "What is the derivative of t^3, and that of the polynomial's inner function?"
    if m.answer != "q":
        yield Slip(
            mistake("powers-not-multiplied", "t^3 is differentiated without its factor", question),
            lambda m: replace(m, slopes=_without_factors),
        )
        yield Slip(
            mistake("inner-derivative", "derivatives are not divided by the duration", question),
            lambda m: replace(m, slopes=_without_duration),
        )
    names = ("position", "velocity", "acceleration")
    told = "Which of position, velocity and acceleration is asked for?"
    if m.answer == "motion":
        for i, j in ((0, 1), (0, 2), (1, 2)):
            order = np.arange(3)
            order[[i, j]] = j, i
            yield Slip(
                mistake(f"exchanged-{i}{j}", f"{names[i]} and {names[j]} are exchanged", told),
                lambda m, order=order: m.then(lambda x: x[order]),  # type: ignore[misc]
            )
        return
    for other, name in zip("qva", names, strict=True):
        if other != m.answer:
            yield Slip(
                mistake(f"{name}", f"the {name} is given", told),
                lambda m, other=other: replace(m, answer=other),  # type: ignore[misc]
            )


def _without_factors(m: Motion, c: Floats, u: Floats) -> tuple[Floats, Floats, Floats]:
    q, _, _ = _slopes(m, c, u)
    return q, _slopes(m, c[:-1], u)[0], _slopes(m, c[:-2], u)[0]


def _without_duration(m: Motion, c: Floats, u: Floats) -> tuple[Floats, Floats, Floats]:
    q, v, a = _slopes(m, c, u)
    return q, v * m.duration, a * m.duration**2


def _units() -> Iterator[Slip[Motion]]:
    question = "In which unit are the joint variables asked for?"
    for key, when, factor in (
        ("degrees", "angles are given in degrees", degrees(1)),
        ("radians", "angles in radians are turned into radians once more", radians(1)),
        ("millimetres", "lengths are in millimetres", 1e3),
        ("thousandth", "lengths are divided by 1000", 1e-3),
    ):
        yield Slip(
            mistake(key, when, question),
            lambda m, factor=factor: m.then(lambda x: x * factor),  # type: ignore[misc]
        )
