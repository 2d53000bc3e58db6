"""What may go wrong in the turns of a product: their angles, their sines and cosines."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import combinations
from math import degrees, pi, radians

import numpy as np

from dhlab.diagnosis.product import Move, Product
from dhlab.diagnosis.slips import Slip
from dhlab.diagnosis.values import Floats
from dhlab.diagnosis.verdict import mistake

HAND = "Point your right thumb along the axis: which way do the fingers curl?"


def turn_slips(moves: Sequence[Move], names: Sequence[str]) -> Iterator[Slip[Product]]:
    """All slips in the turns of a product; `names` are what its factors are called."""
    turns = [k for k, m in enumerate(moves) if m.kind == "turn"]
    for k in turns:
        yield Slip(
            mistake(f"sign-{k + 1}", f"{names[k]} goes the wrong way round", HAND),
            lambda p, k=k: p.changed(k, angle=-p.moves[k].angle),  # type: ignore[misc]
            about=f"angle {k}",
        )
        yield Slip(
            mistake(
                f"sine-cosine-{k + 1}",
                f"sine and cosine are exchanged in {names[k]}",
                "What must the matrix be when its angle is 0?",
            ),
            lambda p, k=k: p.changed(k, angle=pi / 2 - p.moves[k].angle),  # type: ignore[misc]
            about=f"angle {k}",
        )
        if isinstance(moves[k].axis, str):
            yield Slip(
                mistake(
                    f"both-sines-{k + 1}",
                    f"both sines in {names[k]} have the same sign",
                    "Where does the turn carry each axis? Its picture is a column of the matrix.",
                ),
                lambda p, k=k: p.changed(k, flawed=_both_sines),  # type: ignore[misc]
            )
            yield from _cosines(k, moves[k], names[k])
    yield from _counted_from_the_start(moves, names)
    for i, j in combinations(turns, 2):
        yield Slip(
            mistake(
                f"angles-exchanged-{i + 1}-{j + 1}",
                f"the angles of {names[i]} and {names[j]} are exchanged",
                "Which angle belongs to which axis?",
            ),
            lambda p, i=i, j=j: p.changed(  # type: ignore[misc]
                i, angle=p.moves[j].angle
            ).changed(j, angle=p.moves[i].angle),
            alone=True,
        )
    units = "In which unit do angles count here, in degrees or in radians?"
    if len(turns) > 1:
        yield Slip(
            mistake("sign-all", "every angle has the wrong sign", HAND),
            lambda p: _all_angles(p, -1),
        )
    if turns:
        yield Slip(
            mistake("degrees", "angles in radians are taken for degrees", units),
            lambda p: _all_angles(p, radians(1)),
        )
        yield Slip(
            mistake("radians", "degrees are put in where radians belong", units),
            lambda p: _all_angles(p, degrees(1)),
        )


def _both_sines(T: Floats) -> Floats:
    """Turn about a coordinate axis whose two sines have one sign."""
    return T * np.where(np.triu(T, 1) != 0, -1, 1)


def _counted_from_the_start(moves: Sequence[Move], names: Sequence[str]) -> Iterator[Slip[Product]]:
    """Angles about parallel axes, each taken as if it were counted from where the first begins."""
    for k, move in enumerate(moves):
        earlier = []
        for i in range(k - 1, -1, -1):
            if moves[i].kind != "slide" and moves[i].axis != move.axis:
                break
            if moves[i].kind == "turn":
                earlier.append(i)
        if move.kind == "turn" and earlier:
            yield Slip(
                mistake(
                    f"from-start-{k + 1}",
                    f"the angle of {names[k]} is counted from where the ones before it began",
                    "From where is each angle counted: from the ground, or from the link before?",
                ),
                lambda p, k=k, earlier=earlier: p.changed(  # type: ignore[misc]
                    k, angle=p.moves[k].angle - sum(p.moves[i].angle for i in earlier)
                ),
                alone=True,
            )


def _cosines(k: int, move: Move, name: str) -> Iterator[Slip[Product]]:
    for i, axis in enumerate("xyz"):
        if axis != move.axis:
            signs = np.ones((4, 4))
            signs[i, i] = -1
            yield Slip(
                mistake(
                    f"cosine-sign-{k + 1}",
                    f"one cosine in {name} has the wrong sign",
                    "What must the matrix be when its angle is 0?",
                ),
                lambda p, signs=signs: p.changed(  # type: ignore[misc]
                    k, flawed=lambda T: signs * T
                ),
                alone=True,
            )


def _all_angles(p: Product, factor: float) -> Product:
    return replace(p, moves=tuple(replace(m, angle=m.angle * factor) for m in p.moves))
