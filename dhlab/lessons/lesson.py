"""A lesson: ordered steps that move csys objects, blocks and robots, forwards and back."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Protocol, Self

from dhlab.arrays import as_name, as_number
from dhlab.errors import InputError
from dhlab.lessons.answers import Record, judge_choice, judge_place
from dhlab.lessons.drawn import axis_length, marks_of_step
from dhlab.lessons.guess import Guess
from dhlab.lessons.product import Product
from dhlab.lessons.step import Choice, Place, Step
from dhlab.lessons.timeline import Timeline, lay_out
from dhlab.scene.handle import CHANGES, Handle
from dhlab.scene.node import Clock, Node, Rest, Span
from dhlab.scene.placed import Placed
from dhlab.scene.robot import Robot


class LessonObserver(Protocol):
    """Who watches a lesson: its bar."""

    def lesson_changed(self, lesson: Lesson) -> None:
        """Take note: another step, or another answer."""


class Lesson:
    """Steps that are gone through forwards and back; going back undoes.

    The whole of it is sent ahead: a page plays it by itself.

    Parameters
    ----------
    title : str
    steps : sequence of Step
    handles : sequence of Csys, Block, BlockComplex, Robot
        What is shown besides what moves.
    keep : int, optional
        For how many further steps ghosts, arcs and arrows stay; to the end unless given.
    product : Csys or block, optional
        Whose pose is written as a product of matrices; the first csys that moves unless given.
    name : str
        Of the lesson, in files and pages.

    Raises
    ------
    InputError, TypeError
        No steps, or handles that cannot be shown.

    Examples
    --------
    >>> from dhlab import csys, deg
    >>> from dhlab.lessons import Lesson, Step, slide, turn
    >>> B = csys(name="B")
    >>> lesson = Lesson("A turn, then a slide", [
    ...     Step("Turn", "About its own $z$.", turn(B, "z", 90 * deg)),
    ...     Step("Slide", "Along its own $x$.", slide(B, (1, 0, 0)))])
    >>> lesson.go(2)
    Lesson 'A turn, then a slide', 2 steps, at step 2: Slide
    >>> B.pose[:3, 3].round(6)
    array([0., 1., 0.])
    >>> lesson.go(5)
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: lesson 'A turn, then a slide' has no step 5; it has 0 (the start) to 2
    """

    __slots__ = (
        "__weakref__",
        "_at",
        "_bars",
        "_guesses",
        "_marks",
        "_timeline",
        "_turn",
        "answers",
        "handles",
        "name",
        "product_of",
        "steps",
        "title",
    )

    def __init__(
        self,
        title: str,
        steps: Sequence[Step],
        *,
        handles: Sequence[Handle] = (),
        keep: int | None = None,
        product: Placed | None = None,
        name: str = "lesson",
    ) -> None:
        self.title = as_name(title, "title of a lesson")
        self.name = as_name(name, "name of a lesson")
        self.steps = _checked_steps(steps, title)
        moved = [move.what for step in self.steps for move in step.moves]
        shown = tuple(dict.fromkeys([*handles, *moved]))
        _check_handles(shown)
        csys = [what for what in moved if isinstance(what, Placed)]
        self.product_of = product if product is not None else next(iter(csys), None)
        self._timeline = lay_out(self.steps, shown)
        self._guesses = self._make_guesses()
        self.handles: tuple[Handle, ...] = (*shown, *self._guesses.values())
        self._marks = self._make_marks(keep)
        self.answers: dict[int, Record] = {}
        self._bars: list[Any] = []
        self._turn = 0
        self._at = 0
        self._stand(0)

    @property
    def at(self) -> int:
        """Number of the step that is shown: 0 the start, 1 after the first."""
        return self._at

    @property
    def clock(self) -> Clock:
        """The common time of all its motions; its `stops` are the ends of the steps."""
        return self._timeline.clock

    @property
    def timeline(self) -> Timeline:
        """Where everything stands at every instant."""
        return self._timeline

    def go(self, k: int) -> Self:
        """Show the state after step `k`, whatever came before.

        Parameters
        ----------
        k : int
            0 for the start.

        Returns
        -------
        lesson : the lesson itself

        Raises
        ------
        InputError
            There is no such step.
        """
        with CHANGES:
            self._check_number(k, first=0)
            self._turn += 1
            self._stand(k)
        return self

    def follow(self, k: int) -> None:
        """Note that a page went to step `k` by itself; it is not sent there again."""
        with CHANGES:
            self._check_number(k, first=0)
            if k != self._at:
                self._stand(k)

    def answer(self, k: int, value: Any) -> Record:
        """Note the prediction for step `k`, and judge it.

        Parameters
        ----------
        k : int
            A step with a question.
        value : int or array_like, shape (6,)
            Of a `Choice` the place of the answer, from 0; of a `Place` x, y, z [m], yaw, pitch,
            roll [rad].

        Returns
        -------
        record : dict
            `right`, and what was predicted in words; kept in `answers`.

        Raises
        ------
        InputError
            The step asks nothing, or the value is no answer.
        """
        self._check_number(k, first=1)
        question = self.steps[k - 1].question
        if question is None:
            asking = [str(n) for n, step in enumerate(self.steps, 1) if step.question]
            raise InputError(f"step {k} asks nothing; steps that do: {', '.join(asking) or 'none'}")
        if isinstance(question, Choice):
            record = judge_choice(question, value)
        else:
            record = judge_place(question, self._timeline.states[k][question.what], value)
        self.answers[k] = {"step": k, "title": self.steps[k - 1].title} | record
        self._tell()
        return self.answers[k]

    def save_answers(self, path: str | Path) -> Path:
        """Write what was predicted as JSON.

        Parameters
        ----------
        path : str or Path

        Returns
        -------
        path : Path
        """
        path = Path(path)
        kept = {"lesson": self.title, "answers": [self.answers[k] for k in sorted(self.answers)]}
        path.write_text(json.dumps(kept, indent=2, ensure_ascii=False) + "\n", "utf-8")
        return path

    def watch(self, bar: LessonObserver) -> None:
        """Tell a bar of every other step and every answer from now on."""
        if bar not in self._bars:
            self._bars.append(bar)

    def unwatch(self, bar: LessonObserver) -> None:
        """Tell a bar no more."""
        if bar in self._bars:
            self._bars.remove(bar)

    def describe(self) -> dict[str, Any]:
        """Return all that a bar shows, as plain data that JSON can hold."""
        product = None
        if self.product_of is not None:
            product = Product(self.product_of, self._timeline.states[0][self.product_of])
        return {
            "title": self.title,
            "clock": self.clock.key,
            "stops": list(self.clock.stops),
            "steps": [
                {
                    "title": step.title,
                    "text": step.text,
                    "moves": step.words,
                    "question": self._question(k),
                    "product": product and product.after(step, self._timeline.states[k - 1]),
                    **step.about,
                }
                for k, step in enumerate(self.steps, start=1)
            ],
        }

    def _question(self, k: int) -> dict[str, Any] | None:
        question = self.steps[k - 1].question
        if question is None:
            return None
        form = {"text": question.text, "because": question.because}
        if isinstance(question, Choice):
            return form | {
                "kind": "choice",
                "choices": list(question.choices),
                "answer": question.answer,
            }
        guess = self._guesses[k]
        return form | {
            "kind": "place",
            "guess": guess.name,
            "joints": list(guess.keys),
            "start": guess.q.tolist(),
            "limits": guess.limits.tolist(),
            "target": self._timeline.states[k][question.what].tolist(),
            "tolerance": list(question.tolerance),
        }

    def _stand(self, k: int) -> None:
        """Put everything where it is after step `k` and tell; the lock is held."""
        rest = Rest(self.clock.stops[k], self._turn)
        for track in self._timeline.tracks:
            curves = tuple(curve._replace(rest=rest) for curve in track.curves)
            track.what.rest_in_motion(curves, track.samples[self._timeline.instants[k]])
        for handle, marks in self._marks.items():
            handle.leave_marks(marks)
        self._at = k
        for track in self._timeline.tracks:
            track.what.tell()
        self._tell()

    def _tell(self) -> None:
        for bar in tuple(self._bars):
            bar.lesson_changed(self)

    def _make_guesses(self) -> dict[int, Guess]:
        guesses: dict[int, Guess] = {}
        for k, step in enumerate(self.steps, start=1):
            if isinstance(step.question, Place):
                what = step.question.what
                before = self._timeline.states[k - 1][what]
                stops = self.clock.stops
                span = Span(self.clock, stops[k - 1] - 1e-6, stops[k])
                name = f"{what.name}?" if not guesses else f"{what.name}? {k}"
                guesses[k] = Guess(name, axis_length(what), before, span)
        return guesses

    def _make_marks(self, keep: int | None) -> dict[Placed, dict[str, Node]]:
        marks: dict[Placed, dict[str, Node]] = {}
        stops = (*self.clock.stops, float("inf"))
        if keep is not None:
            keep = int(as_number(keep, "keep"))
        for k, step in enumerate(self.steps, start=1):
            last = float("inf") if keep is None else stops[min(k + keep, len(stops) - 1)]
            for handle, nodes in marks_of_step(step, k, self._timeline, last).items():
                own = marks.setdefault(handle, {"lesson": Node()})
                own |= {f"lesson/{path}": node for path, node in nodes.items()}
        return marks

    def _check_number(self, k: int, first: int) -> None:
        if isinstance(k, bool) or not isinstance(k, int) or not first <= k <= len(self.steps):
            start = "0 (the start)" if first == 0 else "1"
            raise InputError(
                f"lesson {self.title!r} has no step {k!r}; it has {start} to {len(self.steps)}"
            )

    def __repr__(self) -> str:
        count = len(self.steps)
        where = f"at step {self._at}: {self.steps[self._at - 1].title}" if self._at else "at start"
        return f"Lesson {self.title!r}, {count} step{'' if count == 1 else 's'}, {where}"


def _checked_steps(steps: Sequence[Step], title: str) -> tuple[Step, ...]:
    if not steps:
        raise InputError(f"lesson {title!r} needs at least one step, got none")
    for k, step in enumerate(steps, start=1):
        if not isinstance(step, Step):
            raise TypeError(f"lesson {title!r}: step {k} is a {type(step).__name__}, not a Step")
        question = step.question
        if isinstance(question, Place) and question.what not in {m.what for m in step.moves}:
            raise InputError(
                f"step {step.title!r} asks where '{question.what.name}' will be, and moves it not"
            )
    return tuple(steps)


def _check_handles(handles: Sequence[Handle]) -> None:
    for handle in handles:
        if not isinstance(handle, Placed | Robot):
            kind = type(handle).__name__
            raise TypeError(f"a lesson shows csys, blocks and robots, not a {kind}")
        if handle.parent is not None:
            parent, top = handle.parent.name, handle.root.name
            raise InputError(f"'{handle.name}' hangs on '{parent}'; a lesson shows '{top}'")
    names = [handle.name for handle in handles]
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None:
        raise InputError(f"two handles of a lesson are called {twice!r}; give them names")
