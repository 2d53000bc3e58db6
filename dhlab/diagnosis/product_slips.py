"""What may go wrong in a product of turns and slides."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from dhlab.diagnosis.after import after_slips, hand_of, negated_origin, transposed
from dhlab.diagnosis.product import Move, Product
from dhlab.diagnosis.slips import Slip
from dhlab.diagnosis.turn_slips import turn_slips
from dhlab.diagnosis.values import Floats
from dhlab.diagnosis.verdict import Mistake, mistake

ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth")


def product_slips(
    moves: Sequence[Move], about: str | None, rotation: bool, names: Sequence[str] | None = None
) -> list[Slip[Product]]:
    """All slips for a product of this make.

    Parameters
    ----------
    moves : sequence of Move
        The factors of one case: their kinds and axes count, not their numbers.
    about : {'moving', 'fixed'} or None
        How the task tells the order.
    rotation : bool
        Whether only the rotation is asked for.
    names : sequence of str, optional
        What the factors are called in a sentence.
    """
    names = names or tuple(_name(m, k, moves) for k, m in enumerate(moves))
    slips = [  # the order of the factors last: until then each is at its place
        *turn_slips(moves, names),
        *_axes(moves, names),
        *_slides(moves, names),
        *_inverses(moves, names, rotation),
        *_counts(moves, names),
        *_order(moves, about, names),
    ]
    origin = any(m.kind != "turn" for m in moves)
    slips += [
        Slip(m, lambda p, change=change: p.then(change), about=hand_of(m))  # type: ignore[misc]
        for m, change in after_slips(rotation, origin)
    ]
    return slips


def _name(move: Move, k: int, moves: Sequence[Move]) -> str:
    if move.kind == "given":
        return move.name
    same = [i for i, m in enumerate(moves) if m.kind == move.kind and m.axis == move.axis]
    what = "slide" if move.kind == "slide" else f"turn about {_axis(move)}"
    return f"the {what}" if len(same) == 1 else f"the {ORDINALS[same.index(k) % 8]} {what}"


def _axis(move: Move) -> str:
    return move.axis if isinstance(move.axis, str) else "the slanted axis"


def _order(
    moves: Sequence[Move], about: str | None, names: Sequence[str]
) -> Iterator[Slip[Product]]:
    if len(moves) > 1:
        yield Slip(_reversed(about), lambda p: replace(p, moves=p.moves[::-1]))
    if len(moves) > 2:
        for k in range(len(moves) - 1):
            yield Slip(
                mistake(
                    f"swapped-{k + 1}-{k + 2}",
                    f"{names[k]} and {names[k + 1]} change places",
                    "Which factor stands leftmost: the one done first or the one done last?",
                ),
                lambda p, k=k: replace(p, moves=_swapped(p.moves, k)),  # type: ignore[misc]
            )


def _reversed(about: str | None) -> Mistake:
    if about is None:
        return mistake(
            "reversed-order",
            "the factors are multiplied in the reverse order",
            "Read your product from the right: what happens to the frame first?",
        )
    other = "fixed" if about == "moving" else "moving"
    side = "right" if about == "moving" else "left"
    return mistake(
        "fixed-moving",
        f"the moves are made about the {other} axes, with the factors in reverse order, "
        f"instead of the {about} ones",
        f"A move about {about} axes is multiplied on which side? (Try one on the {side}.)",
    )


def _swapped(moves: tuple[Move, ...], k: int) -> tuple[Move, ...]:
    return (*moves[:k], moves[k + 1], moves[k], *moves[k + 2 :])


def _axes(moves: Sequence[Move], names: Sequence[str]) -> Iterator[Slip[Product]]:
    for k, move in enumerate(moves):
        if move.kind == "turn" and isinstance(move.axis, str):
            for axis in "xyz".replace(move.axis, ""):
                yield Slip(
                    mistake(
                        f"axis-{k + 1}-{axis}",
                        f"{names[k]} is made about {axis}",
                        "Which column of a rotation matrix stays 0, 0, 1 or the like?",
                    ),
                    lambda p, k=k, axis=axis: p.changed(k, axis=axis),  # type: ignore[misc]
                )


def _slides(moves: Sequence[Move], names: Sequence[str]) -> Iterator[Slip[Product]]:
    for k, move in enumerate(moves):
        if move.kind == "slide":
            yield Slip(
                mistake(
                    f"slide-sign-{k + 1}",
                    f"{names[k]} goes the opposite way",
                    "From which origin to which does the vector point?",
                ),
                lambda p, k=k: p.changed(k, vector=-p.moves[k].vector),  # type: ignore[misc]
            )
            if np.count_nonzero(move.vector) == 1:
                yield from _slid_along(k, names[k])


def _slid_along(k: int, name: str) -> Iterator[Slip[Product]]:
    for step in (1, 2):
        yield Slip(
            mistake(
                f"slide-axis-{k + 1}-{step}",
                f"{name} is made along another axis",
                "Along which axis of the frame does this length lie?",
            ),
            lambda p, step=step: p.changed(  # type: ignore[misc]
                k, vector=np.roll(p.moves[k].vector, step)
            ),
        )


def _inverses(
    moves: Sequence[Move], names: Sequence[str], rotation: bool
) -> Iterator[Slip[Product]]:
    question = "Do the inner letters of neighbouring factors meet and cancel?"
    for k, move in enumerate(moves):
        if move.kind != "given":
            continue
        when = f"{names[k]} is inverted, where it is needed as it is"
        if move.inverse:
            when = f"{names[k]} is used as it is, where its inverse is needed"
        if len(moves) > 1 or move.inverse:  # else the inverse of the whole says the same
            yield Slip(
                mistake(f"inverted-{k + 1}", when, question),
                lambda p, k=k: p.changed(k, inverse=not p.moves[k].inverse),  # type: ignore[misc]
            )
        if move.inverse and not rotation:
            for key, change, how in (
                ("transposed", transposed, "the whole matrix is transposed"),
                ("negated", negated_origin, "its origin is only negated, not rotated"),
            ):
                when = f"the inverse of {names[k]} is not one: {how}"
                yield Slip(
                    mistake(f"{key}-{k + 1}", when, "What does a pose times its inverse give?"),
                    lambda p, k=k, change=change: p.changed(  # type: ignore[misc]
                        k, inverse=False, flawed=change
                    ),
                )


def _counts(moves: Sequence[Move], names: Sequence[str]) -> Iterator[Slip[Product]]:
    for k in range(len(moves)):
        question = "How many factors does the way from the first frame to the last have?"
        if len(moves) > 1:
            yield Slip(
                mistake(f"left-out-{k + 1}", f"{names[k]} is left out", question),
                lambda p, k=k: p.changed(k, flawed=_nothing),  # type: ignore[misc]
            )
        yield Slip(
            mistake(f"twice-{k + 1}", f"{names[k]} is made twice", question),
            lambda p, k=k: p.changed(k, flawed=_squared),  # type: ignore[misc]
            alone=True,
        )


def _nothing(T: Floats) -> Floats:
    return np.eye(4)


def _squared(T: Floats) -> Floats:
    return T @ T
