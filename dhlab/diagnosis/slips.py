"""The search: do what each misconception does to what was asked, and see what fits.

A *model* is what was asked, in numbers, for one case: the factors of a product, a table with its
joint values. A `Slip` makes a wrong model from a right one. An explanation is the fewest slips,
one or two, whose models give what came in every case.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Any, Generic, TypeVar

import numpy as np

from dhlab.diagnosis.values import EXACT, TOLERANCE, Floats, Unreadable, close
from dhlab.diagnosis.verdict import Case, Mistake, Verdict

M = TypeVar("M")

ALTERNATIVES = 6
"""More explanations than these explain nothing."""

COARSE = 10
"""An answer within so many tolerances is the right one, but for 3.14 or 0.707 in it."""

NOTHING = Verdict(False, "There is no answer to judge.")
NEARLY = "Nearly: is some number rounded too far, such as pi or a root? Keep all its digits."


@dataclass(frozen=True)
class Slip(Generic[M]):
    """One misconception: its name, and what it does to a model.

    One that is `alone` is not looked for together with another: it is a slip of the pen, and with
    any other would explain too much. It is named with another one only beside a pair that does
    the same. Nor are two that are `about` one thing, such as one angle, looked for together.
    """

    mistake: Mistake
    change: Callable[[M], M]
    alone: bool = False
    about: str = ""


Evaluate = Callable[[Sequence[M]], Sequence[Floats]]
Explanation = tuple[Mistake, ...]
Chained = tuple[Slip[M], ...]


def explain(
    models: Sequence[M],
    values: Sequence[Floats],
    slips: Sequence[Slip[M]],
    evaluate: Evaluate[M],
    tolerance: float = TOLERANCE,
) -> list[Explanation]:
    """Find the fewest slips that give the values that came; single ones also where it is rounded.

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
        Room for rounding.

    Returns
    -------
    explanations : list of tuples of Mistake
        All explanations with the fewest slips; none where nothing fits.
    """
    right = evaluate(models)
    telling = int(np.argmax([_distance(v, r) for v, r in zip(values, right, strict=True)]))
    order = [telling, *(k for k in range(len(models)) if k != telling)]

    def fitting(chains: Sequence[Chained[M]], room: float = EXACT) -> Sequence[Chained[M]]:
        for k in order:
            if not chains:
                break
            made = np.array(evaluate(_all_changed(models[k], chains)))
            near = np.abs(made - values[k]) <= room * (1 + np.abs(made))
            fits = np.flatnonzero(near.reshape(len(chains), -1).all(axis=1))
            chains = [chains[i] for i in fits.tolist()]
        return chains

    singles = [(s,) for s in slips]
    found: Sequence[Chained[M]] = fitting(singles)
    if not found and not _tells_little(values, right):
        found = fitting(_pairs(slips))
        found = [*found, *(fitting(_pairs_of_the_pen(slips)) if found else ())]
    found = found or fitting(singles, tolerance)
    return unique(tuple(s.mistake for s in chain) for chain in found)


def judge_arrays(
    cases: Sequence[Case],
    models: Sequence[M],
    slips: Sequence[Slip[M]],
    evaluate: Evaluate[M],
    read: Callable[[Any], Floats],
    seen: Callable[[Floats, Floats], str],
    tolerance: float = TOLERANCE,
) -> Verdict:
    """Judge answers that are arrays by models of what is right.

    Parameters
    ----------
    cases : sequence of Case
    models : sequence
        What was asked, one model per case.
    slips : sequence of Slip
    evaluate : callable
        From several models to their values.
    read : callable
        From whatever came to an array, or `Unreadable`.
    seen : callable
        From what came and what is wanted to a sentence.
    tolerance : float
        How far a number may be from the right one: room for rounding.
    """
    if not cases:
        return NOTHING
    came, refusals = [], []
    for _, value in cases:
        try:
            came.append(read(value))
        except Unreadable as refusal:
            refusals.append(str(refusal))
    if refusals:
        return Verdict(False, refusals[0] + how_many(len(refusals), len(cases), "not so"))
    pairs = list(zip(came, evaluate(models), strict=True))
    wrong = [pair for pair in pairs if not close(*pair, tolerance)]
    if not wrong:
        return Verdict(True, "")
    explanations = explain(models, came, slips, evaluate, tolerance)
    if not explanations and all(close(*pair, COARSE * tolerance) for pair in wrong):
        return Verdict(False, NEARLY)
    return verdict_of(seen(*wrong[0]) + how_many(len(wrong), len(cases)), explanations)


def how_many(wrong: int, cases: int, is_what: str = "right") -> str:
    """Sentence that says for how many inputs it is otherwise, where for some."""
    if wrong == cases:
        return ""
    head = f" For {cases - wrong} of {cases} inputs it is {is_what}"
    return f"{head}: what is special about the {'other' if wrong == 1 else 'others'}?"


def verdict_of(seen: str, explanations: Sequence[Explanation]) -> Verdict:
    """Verdict on a wrong answer, from what is seen and what explains it."""
    if not explanations or len(explanations) > ALTERNATIVES:
        return Verdict(False, seen)
    mistakes = tuple(dict.fromkeys(m for group in explanations for m in group))
    return Verdict(False, seen, mistakes, tuple(explanations) if len(explanations) > 1 else ())


def _pairs(slips: Sequence[Slip[M]]) -> list[Chained[M]]:
    pairs = combinations([s for s in slips if not s.alone], 2)
    return [(a, b) for a, b in pairs if not a.about or a.about != b.about]


def _pairs_of_the_pen(slips: Sequence[Slip[M]]) -> list[Chained[M]]:
    return [pair for pair in combinations(slips, 2) if any(s.alone for s in pair)]


def _all_changed(model: M, chains: Sequence[Chained[M]]) -> list[M]:
    """What each chain of slips makes of a model; what they begin with in common is made once."""
    once: dict[int, M] = {}
    out = []
    for first, *rest in chains:
        if id(first) not in once:
            once[id(first)] = first.change(model)
        changed = once[id(first)]
        for slip in rest:
            changed = slip.change(changed)
        out.append(changed)
    return out


def _tells_little(values: Sequence[Floats], right: Sequence[Floats]) -> bool:
    """Whether less than three numbers are wrong, or one in all cases: that tells no two slips."""
    if any(v.shape != right[0].shape for v in (*values, *right)):
        return False
    off = [np.abs(v - r) > EXACT * (1 + np.abs(r)) for v, r in zip(values, right, strict=True)]
    return int(np.any(off, axis=0).sum()) == 1 or int(np.sum(off)) < 3


def _distance(a: Floats, b: Floats) -> float:
    return float(np.abs(a - b).max()) if a.shape == b.shape else np.inf


def unique(explanations: Iterable[Explanation]) -> list[Explanation]:
    """Each set of mistakes once, whatever the order of the two."""
    return list({frozenset(m.key for m in e): e for e in explanations}.values())
