"""The task of writing one link of a Denavit-Hartenberg table as a function."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import permutations

import numpy as np

from dhlab.diagnosis.chain_slips import NAMES
from dhlab.diagnosis.matrix import judge_matrices
from dhlab.diagnosis.product import Move, Product
from dhlab.diagnosis.product_slips import product_slips
from dhlab.diagnosis.slips import NOTHING, Slip
from dhlab.diagnosis.values import TOLERANCE
from dhlab.diagnosis.verdict import Case, Verdict, mistake
from dhlab.kinematics.dh import Convention, as_convention
from dhlab.kinematics.transforms import pose_of


@dataclass(frozen=True, eq=False)
class LinkTask:
    """A function from alpha, a, d, theta to the pose of one frame in the one before.

    Parameters
    ----------
    convention : {'modified', 'standard'}
    tolerance : float

    Examples
    --------
    >>> from dhlab.kinematics.dh import link_transform
    >>> rows = [(0.3, 0.2, 0.5, 1.0), (-0.7, 0.4, 0.1, 0.6)]
    >>> cases = [(row, link_transform(row, "standard")) for row in rows]
    >>> [m.key for m in LinkTask().judge(cases).mistakes]
    ['convention']
    """

    convention: Convention = "modified"
    tolerance: float = TOLERANCE

    def judge(self, cases: Sequence[Case]) -> Verdict:
        """Judge an answer by what came for several rows."""
        if not cases:
            return NOTHING
        standard = as_convention(self.convention) == "standard"
        models = [_product(inputs, standard) for inputs, _ in cases]
        order = ("theta", "d", "alpha", "a") if standard else ("alpha", "a", "theta", "d")
        names = [f"the factor of {name}" for name in order]
        slips = [*_arguments(standard)]
        slips += _in_other_places(product_slips(models[0].moves, None, False, names))
        slips += [_other_convention(standard), _plain_origin(standard)]
        return judge_matrices(cases, models, slips, 4, self.tolerance)


def _product(row: Sequence[float], standard: bool) -> Product:
    alpha, a, d, theta = (float(x) for x in row)
    link = (Move("turn", "x", alpha, np.zeros(3)), Move("slide", "x", 0.0, np.array([a, 0, 0])))
    joint = (Move("turn", "z", theta, np.zeros(3)), Move("slide", "z", 0.0, np.array([0, 0, d])))
    return Product((*joint, *link) if standard else (*link, *joint))


def _row(p: Product, standard: bool) -> tuple[float, ...]:
    first, second = p.moves[:2], p.moves[2:]
    link, joint = (second, first) if standard else (first, second)
    return (link[0].angle, link[1].vector.sum(), joint[1].vector.sum(), joint[0].angle)


def _arguments(standard: bool) -> Iterator[Slip[Product]]:
    question = "In which order does the function take alpha, a, d and theta?"
    for order in permutations(range(4)):
        if order != (0, 1, 2, 3):
            names = ", ".join(NAMES[k] for k in order)

            def permuted(p: Product, order: tuple[int, ...] = order) -> Product:
                row = _row(p, standard)
                return replace(p, moves=_product([row[k] for k in order], standard).moves)

            key = "columns-" + "".join(map(str, order))
            when = f"the four numbers are taken in the order {names}"
            yield Slip(mistake(key, when, question), permuted)


def _other_convention(standard: bool) -> Slip[Product]:
    other = "modified" if standard else "standard"
    m = mistake(
        "convention",
        f"the link is that of the {other} convention",
        "Which comes first in your convention: the link or the joint?",
    )
    return Slip(m, lambda p: replace(p, moves=(*p.moves[2:], *p.moves[:2])))


def _plain_origin(standard: bool) -> Slip[Product]:
    """Both slides along the axes of the frame before, as if nothing were turned."""
    slide, axis, turn = ("a", "x", "theta") if standard else ("d", "z", "alpha")
    m = mistake(
        "origin-plain",
        f"the slide {slide} is made along the {axis} axis that was there before the turn by {turn}",
        f"Where does the {axis} axis point once the frame has turned by {turn}?",
    )

    def plain(p: Product) -> Product:
        _, a, d, _ = _row(p, standard)
        return p.then(lambda T: pose_of(T[:3, :3], np.array([a, 0, d])))

    return Slip(m, plain)


def _in_other_places(slips: Sequence[Slip[Product]]) -> list[Slip[Product]]:
    """Leave out what is no slip of its own.

    Turn and slide along one axis may change places: then the reverse order
    of the factors is that of the other convention. And angles that are exchanged are columns.
    """
    others = ("swapped-1-2", "swapped-3-4", "reversed-order", "angles-exchanged-")
    return [s for s in slips if not s.mistake.key.startswith(others)]
