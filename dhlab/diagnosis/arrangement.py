"""The task of placing coordinate systems: what was drawn, by name."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import islice, product
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from dhlab.diagnosis.matrix import MatrixTask
from dhlab.diagnosis.product import Product, evaluate_products, given
from dhlab.diagnosis.product_slips import product_slips
from dhlab.diagnosis.seen import pose_seen
from dhlab.diagnosis.slips import (
    ALTERNATIVES,
    COARSE,
    NEARLY,
    NOTHING,
    Explanation,
    Slip,
    explain,
    verdict_of,
)
from dhlab.diagnosis.values import TOLERANCE, Floats, Unreadable, close, inverted, numbers
from dhlab.diagnosis.verdict import Case, Mistake, Verdict, mistake
from dhlab.errors import InputError

Pose: TypeAlias = ArrayLike | Callable[..., ArrayLike] | MatrixTask
Poses: TypeAlias = dict[str, Floats]


class ArrangementTask:
    """Coordinate systems in a scene: which is the first to be out of place, and why.

    Parameters
    ----------
    frames : mapping of str to pose
        Each frame that is asked for, parents first: a pose in its parent, what gives it from the
        inputs, or a `MatrixTask` that tells its moves.
    parents : mapping of str to str, optional
        In which of the frames a frame is given; without one it is the world.
    tolerance : float

    Notes
    -----
    What comes is a mapping from names to poses in the world; other names in it do not count.

    Examples
    --------
    >>> from dhlab.kinematics.transforms import rotz, rp2t, transl
    >>> frames = {"A": transl((1, 0, 0)), "B": rp2t(rotz(0.5), (0, 2, 0))}
    >>> task = ArrangementTask(frames, parents={"B": "A"})
    >>> drawn = {"A": frames["A"], "B": frames["A"] @ frames["B"]}
    >>> task.judge([((), drawn)]).right
    True
    >>> verdict = task.judge([((), drawn | {"B": frames["B"]})])
    >>> print(verdict.text)
    Frame B is off, along x alone. This is exactly what you get when B is placed in the world by
    its pose in A. In which frame is each pose given, and in which is it drawn?
    """

    def __init__(
        self,
        frames: Mapping[str, Pose],
        parents: Mapping[str, str] | None = None,
        tolerance: float = TOLERANCE,
    ) -> None:
        if not frames:
            raise InputError("an arrangement needs at least one frame")
        self.frames, self.parents, self.tolerance = dict(frames), dict(parents or {}), tolerance
        names = list(self.frames)
        for child, parent in self.parents.items():
            if child not in names or parent not in names[: names.index(child)]:
                raise InputError(f"parent '{parent}' of '{child}' must be a frame before it")

    def reference(self, *inputs: Any) -> Poses:
        """Poses in the world that are right for these inputs."""
        world: Poses = {}
        for name, P in self._products(inputs).items():
            T = evaluate_products([P])[0]
            world[name] = world[self.parents[name]] @ T if name in self.parents else T
        return world

    def judge(self, cases: Sequence[Case]) -> Verdict:
        """Judge an arrangement, or those that came for several inputs."""
        if not cases:
            return NOTHING
        try:
            came = [self._read(value) for _, value in cases]
        except Unreadable as refusal:
            return Verdict(False, str(refusal))
        wanted = [self.reference(*inputs) for inputs, _ in cases]
        out = [n for n in self.frames if not self._all_close(came, wanted, n)]
        if not out:
            return Verdict(True, "")
        hung = [self._hung(c, w) for c, w in zip(came, wanted, strict=True)]
        causes = [n for n in out if not self._all_close(came, hung, n)]
        if len(out) == len(self.frames) > 1 and self._moved_alike(came, wanted):
            return self._as_a_whole(came, wanted, causes[0])
        inputs = [case[0] for case in cases]
        found = [f for n in causes[:2] if (f := self._explain(n, inputs, came, wanted))]
        if not found and all(self._all_close(came, wanted, n, COARSE) for n in out):
            return Verdict(False, NEARLY)
        seen = self._seen(came, hung, out, causes)
        return verdict_of(seen, _together(found))

    def _products(self, inputs: Sequence[Any]) -> dict[str, Product]:
        products = {}
        for name, pose in self.frames.items():
            factors = pose.factors if isinstance(pose, MatrixTask) else (given(name, pose),)
            products[name] = Product(tuple(f.at(inputs) for f in factors))
        return products

    def _read(self, value: Any) -> Poses:
        if not isinstance(value, Mapping):
            raise Unreadable("A scene with named coordinate systems is asked for.")
        missing = [name for name in self.frames if name not in value]
        if missing:
            raise Unreadable(f"Not in the scene: {', '.join(missing)}. Does each have its name?")
        return {n: numbers(value[n], [(4, 4)], f"the pose of {n}") for n in self.frames}

    def _hung(self, came: Poses, wanted: Poses) -> Poses:
        """Where each frame belongs, seen from where its parent came."""
        return {n: self._parent(came, n) @ self._in_parent(wanted, n) for n in self.frames}

    def _parent(self, poses: Poses, name: str) -> Floats:
        return poses[self.parents[name]] if name in self.parents else np.eye(4)

    def _in_parent(self, poses: Poses, name: str) -> Floats:
        return inverted(self._parent(poses, name)) @ poses[name]

    def _all_close(
        self, came: Sequence[Poses], there: Sequence[Poses], name: str, times: float = 1
    ) -> bool:
        pairs = zip(came, there, strict=True)
        return all(close(a[name], b[name], times * self.tolerance) for a, b in pairs)

    def _moved_alike(self, came: Sequence[Poses], wanted: Sequence[Poses]) -> bool:
        """Whether all frames are right among each other."""
        first = next(iter(self.frames))
        for c, w in zip(came, wanted, strict=True):
            move = c[first] @ inverted(w[first])
            if not all(close(c[n], move @ w[n], 3 * self.tolerance) for n in self.frames):
                return False
        return True

    def _as_a_whole(self, came: Sequence[Poses], wanted: Sequence[Poses], first: str) -> Verdict:
        seen = pose_seen(came[0][first], wanted[0][first], "the whole arrangement")
        return Verdict(False, f"All frames are right among each other. {seen}")

    def _seen(
        self,
        came: Sequence[Poses],
        hung: Sequence[Poses],
        out: Sequence[str],
        causes: Sequence[str],
    ) -> str:
        first = causes[0]
        k = next(
            k
            for k, (c, h) in enumerate(zip(came, hung, strict=True))
            if not close(c[first], h[first], self.tolerance)
        )
        seen = pose_seen(came[k][first], hung[k][first], f"frame {first}")
        carried = [n for n in out if n not in causes]
        if carried:
            seen += f" {_names(carried)} only {'goes' if len(carried) == 1 else 'go'} with it."
        if len(causes) > 1:
            verb = "is" if len(causes) == 2 else "are"
            seen += f" {_names(causes[1:])} {verb} out of place too."
        return seen

    def _explain(
        self,
        name: str,
        inputs: Sequence[Sequence[Any]],
        came: Sequence[Poses],
        wanted: Sequence[Poses],
    ) -> list[Explanation]:
        models = [
            Placed(self._products(i)[name], self._parent(c, name), c, w)
            for i, c, w in zip(inputs, came, wanted, strict=True)
        ]
        others = list(self.frames)
        if name not in self.parents:  # of one in the world's origin nothing else is to be said
            others = [n for n in others if any(not close(w[n], np.eye(4)) for w in wanted)]
        slips = arrangement_slips(models[0], name, self.parents.get(name), others)
        values = [c[name] for c in came]
        return explain(models, values, slips, evaluate_placed, self.tolerance)


@dataclass(frozen=True, eq=False)
class Placed:
    """A frame as a product in its parent, and how it is put into the world."""

    product: Product
    parent: Floats
    came: Poses
    wanted: Poses
    put: "Callable[[Placed, Floats], Floats] | None" = None


def evaluate_placed(models: Sequence[Placed]) -> list[Floats]:
    """Poses in the world, each (4, 4)."""
    poses = evaluate_products([m.product for m in models])
    return [m.put(m, T) if m.put else m.parent @ T for m, T in zip(models, poses, strict=True)]


def arrangement_slips(
    model: Placed, name: str, parent: str | None, names: Sequence[str]
) -> list[Slip[Placed]]:
    """All slips in placing one frame among others."""
    return [*_in_product(model.product, name), *_in_place(name, parent, names)]


def _in_product(P: Product, name: str) -> Iterator[Slip[Placed]]:
    for slip in product_slips(P.moves, None, rotation=False):
        yield Slip(
            _of(slip.mistake, name),
            lambda m, change=slip.change: replace(  # type: ignore[misc]
                m, product=change(m.product)
            ),
            alone=slip.alone,
            about=slip.about,
        )


def _of(m: Mistake, name: str) -> Mistake:
    return replace(m, text=f"{m.text.removesuffix('.')} (frame {name}).")


def _in_place(name: str, parent: str | None, names: Sequence[str]) -> Iterator[Slip[Placed]]:
    question = "In which frame is each pose given, and in which is it drawn?"
    ways: list[tuple[str, str, Callable[[Placed, Floats], Floats]]] = []
    if parent is not None:
        ways += [
            (
                "in-world",
                f"{name} is placed in the world by its pose in {parent}",
                lambda m, T: T,
            ),
            (
                "wrong-side",
                f"the pose of {name} in {parent} is multiplied on the left of that of {parent}",
                lambda m, T: T @ m.parent,
            ),
            (f"at-{parent}", f"{name} stays where {parent} is", lambda m, T: m.parent),
        ]
    else:
        ways.append(("not-moved", f"{name} stays in the world's origin", lambda m, T: np.eye(4)))
    for other in names:
        if other != name:
            ways.append(
                (
                    f"as-{other}",
                    f"{name} is placed where {other} belongs",
                    lambda m, T, other=other: m.wanted[other],  # type: ignore[misc]
                )
            )
        if other not in (name, parent):
            ways.append(
                (
                    f"parent-{other}",
                    f"{name} is placed by its pose in {parent or 'the world'}, but in {other}",
                    lambda m, T, other=other: m.came[other] @ T,  # type: ignore[misc]
                )
            )
    for key, when, put in ways:
        yield Slip(
            mistake(key, when, question),
            lambda m, put=put: replace(m, put=put),  # type: ignore[misc]
        )


def _together(found: Sequence[Sequence[Explanation]]) -> list[Explanation]:
    """Explanations of one frame with those of another."""
    if not found:
        return []
    many = islice(product(*found), ALTERNATIVES + 1)
    return [tuple(m for e in choice for m in e) for choice in many]


def _names(names: Sequence[str]) -> str:
    head = ", ".join(names[:-1])
    return f"{head} and {names[-1]}" if head else names[-1]
