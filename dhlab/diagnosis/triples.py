"""The task of taking a rotation apart into three angles."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import permutations
from math import pi
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from dhlab.arrays import as_array
from dhlab.diagnosis.seen import rotation_seen
from dhlab.diagnosis.slips import COARSE, NEARLY, NOTHING, Slip, explain, how_many, verdict_of
from dhlab.diagnosis.values import TOLERANCE, Floats, Unreadable, close, numbers
from dhlab.diagnosis.verdict import Case, Verdict, mistake
from dhlab.errors import InputError
from dhlab.kinematics.angles import eul2r, r2eul, r2rpy, rpy2r

NAMES = {"rpy": ("roll", "pitch", "yaw"), "euler": ("alpha", "beta", "gamma")}
SINGULAR = 1e-6


class AnglesTask:
    """Three angles of a rotation; every triple that makes the rotation is right.

    Parameters
    ----------
    rotation : array_like, shape (3, 3) or (4, 4), or callable
        The rotation, or what gives it from the inputs.
    kind : {'rpy', 'euler'}
        Roll, pitch, yaw about the fixed axes x, y, z; or the angles about the moving z, y, z.
    tolerance : float

    Examples
    --------
    >>> task = AnglesTask(lambda R: R)
    >>> cases = [((rpy2r(*rpy),), rpy) for rpy in [(0.1, 0.2, 0.3), (1.0, -0.4, 2.0)]]
    >>> task.judge(cases).right
    True
    >>> second = [(inputs, (r + pi, pi - p, y + pi)) for inputs, (r, p, y) in cases]
    >>> task.judge(second).text
    'One of several right triples: with the pitch beyond a quarter turn.'
    >>> [m.key for m in task.judge([(i, rpy[::-1]) for i, rpy in cases]).mistakes]
    ['order-210']
    """

    def __init__(
        self,
        rotation: ArrayLike | Callable[..., ArrayLike],
        kind: Literal["rpy", "euler"] = "rpy",
        tolerance: float = TOLERANCE,
    ) -> None:
        if kind not in NAMES:
            raise InputError(f"no angles {kind!r}; use 'rpy' or 'euler'")
        self.kind, self.tolerance = kind, tolerance
        self.rotation = rotation if callable(rotation) else _rotation(rotation)

    def judge(self, cases: Sequence[Case]) -> Verdict:
        """Judge an answer by what came for several inputs."""
        if not cases:
            return NOTHING
        wanted = [self._wanted(inputs) for inputs, _ in cases]
        try:
            came = [self._read(value) for _, value in cases]
        except Unreadable as refusal:
            return Verdict(False, str(refusal))
        pairs = list(zip(evaluate_triples(came), wanted, strict=True))
        wrong = [k for k, pair in enumerate(pairs) if not close(*pair, self.tolerance)]
        if not wrong:
            return Verdict(True, _choice(came, wanted))
        explanations = explain(
            came, wanted, triple_slips(self.kind), evaluate_triples, self.tolerance
        )
        if not explanations and all(close(*pairs[k], COARSE * self.tolerance) for k in wrong):
            return Verdict(False, NEARLY)
        seen = rotation_seen(*pairs[wrong[0]], "the rotation that your angles make")
        return verdict_of(seen + how_many(len(wrong), len(cases)), explanations)

    def _wanted(self, inputs: Sequence[Any]) -> Floats:
        return _rotation(self.rotation(*inputs)) if callable(self.rotation) else self.rotation

    def _read(self, value: Any) -> "Triple":
        return Triple(numbers(value, [(3,)], also=[(3, 1), (1, 3)]).ravel(), self.kind)


@dataclass(frozen=True, eq=False)
class Triple:
    """Three angles as they came, and how they are to be read.

    `otherwise`: about fixed axes what is meant about moving ones, and the other way.
    """

    angles: Floats
    kind: str
    otherwise: bool = False
    transpose: bool = False

    def with_angle(self, k: int, change: Callable[[float], float]) -> "Triple":
        """Triple with one angle changed."""
        angles = self.angles.copy()
        angles[k] = change(angles[k])
        return replace(self, angles=angles)


def evaluate_triples(triples: Sequence[Triple]) -> list[Floats]:
    """Rotations that triples make, each (3, 3)."""
    return [_made(t) for t in triples]


def triple_slips(kind: str) -> list[Slip[Triple]]:
    """All slips; each takes back what was done to a triple, so that it makes the rotation."""
    return [*_orders(kind), *_units(), *_single(kind), *_readings(kind)]


def _made(t: Triple) -> Floats:
    if t.kind == "euler":
        R = eul2r(*(t.angles[::-1] if t.otherwise else t.angles))
    else:
        R = rpy2r(*-t.angles).T if t.otherwise else rpy2r(*t.angles)
    return R.T if t.transpose else R


def _orders(kind: str) -> Iterator[Slip[Triple]]:
    names = NAMES[kind]
    for order in permutations(range(3)):
        if order != (0, 1, 2):
            back = np.argsort(order)
            yield Slip(
                mistake(
                    "order-" + "".join(map(str, order)),
                    f"the angles are given in the order {', '.join(names[k] for k in order)}",
                    f"In which order are {', '.join(names)} asked for?",
                ),
                lambda t, back=back: replace(t, angles=t.angles[back]),  # type: ignore[misc]
            )


def _units() -> Iterator[Slip[Triple]]:
    question = "What do the functions of numpy that give an angle give it in?"
    for key, when, change in (
        ("degrees", "the angles are given in degrees", np.radians),
        ("radians", "angles in radians are turned into radians once more", np.degrees),
    ):
        yield Slip(
            mistake(key, when, question),
            lambda t, change=change: replace(t, angles=change(t.angles)),  # type: ignore[misc]
        )


def _single(kind: str) -> Iterator[Slip[Triple]]:
    hand = "Point your right thumb along the axis: which way do the fingers curl?"
    quadrant = "In which quadrants can the angle lie, and which does the function give?"
    yield Slip(
        mistake("sign-all", "every angle has the wrong sign", hand),
        lambda t: replace(t, angles=-t.angles),
    )
    for k, angle in enumerate(NAMES[kind]):
        name = f"the {angle}" if kind == "rpy" else angle
        for key, when, question, change in (
            (f"sign-{angle}", f"{name} has the wrong sign", hand, lambda x: -x),
            (
                f"quadrant-{angle}",
                f"{name} lies half a turn off, as arctan gives it in place of arctan2",
                quadrant,
                lambda x: x + pi,
            ),
            (
                f"arctan2-{angle}",
                f"sine and cosine are exchanged in {name}",
                "Which of the two comes first in arctan2?",
                lambda x: pi / 2 - x,
            ),
            (
                f"supplement-{angle}",
                f"{name} is on the other side of a quarter turn than the other two need",
                "Which two values of an angle have the same sine?",
                lambda x: pi - x,
            ),
        ):
            yield Slip(
                mistake(key, when, question),
                lambda t, k=k, change=change: t.with_angle(k, change),  # type: ignore[misc]
                about=angle,
            )


def _readings(kind: str) -> Iterator[Slip[Triple]]:
    axes = "moving axes x, y, z" if kind == "rpy" else "fixed axes z, y, z"
    question = "Which of the three turns is made first, and about which frame's axes?"
    yield Slip(
        mistake("fixed-moving", f"the angles turn about the {axes}", question),
        lambda t: replace(t, otherwise=True),
    )
    other = "euler" if kind == "rpy" else "rpy"
    told = {"rpy": "roll, pitch and yaw", "euler": "the Euler angles about z, y, z"}
    yield Slip(
        mistake("convention", f"{told[other]} are given", "About which axes do the angles turn?"),
        lambda t: replace(t, kind=other, otherwise=False),
    )
    yield Slip(
        mistake(
            "inverse",
            "the transposed rotation is taken apart",
            "Which entry stands in which row and which column?",
        ),
        lambda t: replace(t, transpose=True),
    )


def _rotation(value: ArrayLike) -> Floats:
    R = as_array(value, (None, None), "rotation")
    if R.shape not in {(3, 3), (4, 4)}:
        raise InputError(f"a rotation must have shape (3, 3) or (4, 4), got {R.shape}")
    return R[:3, :3]


def _choice(came: Sequence[Triple], wanted: Sequence[Floats]) -> str:
    """Say which of the right triples the student gave, where it is not the usual one."""
    rpy = came[0].kind == "rpy"
    name = "pitch" if rpy else "beta"
    usual = np.array([r2rpy(R) if rpy else r2eul(R) for R in wanted])
    angles = np.array([t.angles for t in came])
    middle = usual[:, 1]
    locked = np.abs(np.cos(middle) if rpy else np.sin(middle)) < SINGULAR
    if locked.all():
        first, _, last = NAMES[came[0].kind]
        return f"One of several right triples: {first} and {last} turn about one line here."
    off = np.abs(np.angle(np.exp(1j * (angles - usual)))).max(axis=1) > 1e-4
    if (off & ~locked).all():
        where = "with the pitch beyond a quarter turn" if rpy else f"with {name} below zero"
        return f"One of several right triples: {where}."
    return ""
