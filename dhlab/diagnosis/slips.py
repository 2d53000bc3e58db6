"""The search: do what each misconception does to what was asked, and see what fits.

A *model* is what was asked, in numbers, for one case: the factors of a product, a table with its
joint values. A `Slip` makes a wrong model from a right one. An explanation is the fewest slips,
one or two, whose models give what came in every case.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Generic, TypeVar

import numpy as np

from dhlab.diagnosis.values import TOLERANCE, Floats, close
from dhlab.diagnosis.verdict import Mistake, Verdict

M = TypeVar("M")

ALTERNATIVES = 6
"""More explanations than these explain nothing."""


@dataclass(frozen=True)
class Slip(Generic[M]):
    """One misconception: its name, and what it does to a model."""

    mistake: Mistake
    change: Callable[[M], M]


Evaluate = Callable[[Sequence[M]], Sequence[Floats]]
Explanation = tuple[Mistake, ...]


def explain(
    models: Sequence[M],
    values: Sequence[Floats],
    slips: Sequence[Slip[M]],
    evaluate: Evaluate[M],
    tolerance: float = TOLERANCE,
) -> list[Explanation]:
    """Find the fewest slips that give the values that came.

    Parameters
    ----------
    models : sequence
        What was asked, one model per case.
    values : sequence of ndarray
        What came, one array per case.
    slips : sequence of Slip
    evaluate : callable
        From several models to their values.
    tolerance : float

    Returns
    -------
    explanations : list of tuples of Mistake
        All explanations with the fewest slips; none where nothing fits.
    """
    right = [evaluate([m])[0] for m in models]
    telling = int(np.argmax([_distance(v, r) for v, r in zip(values, right, strict=True)]))
    order = [telling, *(k for k in range(len(models)) if k != telling)]
    for chains in (_singles(slips), _pairs(slips)):
        left = chains
        for k in order:
            if not left:
                break
            made = evaluate([_changed(models[k], chain) for chain in left])
            fits = [close(values[k], m, tolerance) for m in made]
            left = [chain for chain, fit in zip(left, fits, strict=True) if fit]
        if left:
            return _unique(tuple(s.mistake for s in chain) for chain in left)
    return []


def verdict_of(seen: str, explanations: Sequence[Explanation]) -> Verdict:
    """Verdict on a wrong answer, from what is seen and what explains it."""
    if not explanations or len(explanations) > ALTERNATIVES:
        return Verdict(False, seen)
    mistakes = tuple(dict.fromkeys(m for group in explanations for m in group))
    return Verdict(False, seen, mistakes, tuple(explanations) if len(explanations) > 1 else ())


def _singles(slips: Sequence[Slip[M]]) -> list[tuple[Slip[M], ...]]:
    return [(s,) for s in slips]


def _pairs(slips: Sequence[Slip[M]]) -> list[tuple[Slip[M], ...]]:
    return [(s, t) for i, s in enumerate(slips) for t in slips[i + 1 :]]


def _changed(model: M, chain: Iterable[Slip[M]]) -> M:
    for slip in chain:
        model = slip.change(model)
    return model


def _distance(a: Floats, b: Floats) -> float:
    return float(np.abs(a - b).max()) if a.shape == b.shape else np.inf


def _unique(explanations: Iterable[Explanation]) -> list[Explanation]:
    """Each set of mistakes once, whatever the order of the two."""
    return list({frozenset(m.key for m in e): e for e in explanations}.values())
