"""A lesson in a cell: its picture, and beside it the bar that goes through its steps."""

import os
from importlib.resources import files
from pathlib import Path
from typing import Any
from uuid import uuid4

import anywidget
import ipywidgets
import traitlets
from IPython import get_ipython

from dhlab.arrays import as_number
from dhlab.lessons.lesson import Lesson
from dhlab.panel.link import STATIC
from dhlab.view import assets, html
from dhlab.view.lesson_html import rendered
from dhlab.view.outputs import outputs_of
from dhlab.view.view import WIDGET, View

HEIGHT = 540


class LessonBar(anywidget.AnyWidget):
    """The bar: steps, words, questions; it plays in the page and tells where it is.

    Attributes
    ----------
    lesson : dict
        What the bar shows.
    answers : dict
        Predictions by step.
    at : int
        From the page: the step it went to.
    said : list
        From the page: step and value of a prediction, and its number.
    """

    _esm = assets.bundle("lesson", STATIC)
    _css = (files("dhlab.view") / "static" / "lesson.css").read_text(encoding="utf-8")

    own_id = traitlets.Unicode().tag(sync=True)
    lesson: "traitlets.Dict[str, Any]" = traitlets.Dict().tag(sync=True)
    answers: "traitlets.Dict[str, Any]" = traitlets.Dict().tag(sync=True)
    at = traitlets.Int(0).tag(sync=True, echo_update=False)
    said: traitlets.List[Any] = traitlets.List().tag(sync=True, echo_update=False)

    def __init__(self, lesson: Lesson) -> None:
        own_id = uuid4().hex
        told = rendered(lesson)
        answers = told.pop("answers")
        super().__init__(model_id=own_id, own_id=own_id, lesson=told, answers=answers, at=lesson.at)
        self._lesson = lesson
        self.observe(self._went, "at")
        self.observe(self._answered, "said")
        lesson.watch(self)

    def lesson_changed(self, lesson: Lesson) -> None:
        """Tell the page of predictions that it has not made itself."""
        self.answers = {str(k): record for k, record in lesson.answers.items()}

    def close(self) -> None:
        """Take the bar out of the page and out of ipywidgets' registry."""
        if hasattr(self, "_lesson"):
            self._lesson.unwatch(self)
        layout = self.layout
        super().close()
        if layout is not None:
            layout.close()

    def _went(self, change: Any) -> None:
        self._lesson.follow(change.new)

    def _answered(self, change: Any) -> None:
        step, value, _ = change.new
        self._lesson.answer(step, value)


class LessonView:
    """A lesson's picture and its bar, beside each other.

    Parameters
    ----------
    lesson : Lesson
    height : int [pixel]
        Of both.
    **options
        Of the `View`.

    Examples
    --------
    >>> from dhlab.lessons import course
    >>> LessonView(course.order_matters())
    LessonView of 'The same two turns, in either order', 3 steps
    """

    def __init__(self, lesson: Lesson, *, height: int = HEIGHT, **options: Any) -> None:
        if not isinstance(lesson, Lesson):
            raise TypeError(f"a lesson view shows a Lesson, not a {type(lesson).__name__}")
        self.lesson = lesson
        self.height = int(as_number(height, "height", above=0))
        self.view = View(lesson.name, height=self.height, **options).add(*lesson.handles)
        self._parts: list[Any] = []

    def save_html(self, path: str | os.PathLike[str], title: str | None = None) -> Path:
        """Save the lesson as one page that needs no kernel, no server and no network.

        Parameters
        ----------
        path : str or path
            Ends in ``.html``.
        title : str, optional
            The lesson's own unless given.

        Returns
        -------
        path : Path
        """
        self.view.flush()
        options = {"height": self.height, **self.view.options}
        title = self.lesson.title if title is None else title
        nodes, told = self.view.nodes, rendered(self.lesson)
        return html.save(path, title, self.view.handles, nodes, options, lesson=told)

    def close(self) -> None:
        """Take view and bar out of the page."""
        for part in self._parts:
            part.close()
        self._parts = []

    def __repr__(self) -> str:
        return f"LessonView of {self.lesson.title!r}, {len(self.lesson.steps)} steps"

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> dict[str, Any]:
        """What a cell that ends in this shows: picture and bar, or else a line of text."""
        bundle: dict[str, Any] = {"text/plain": repr(self)}
        shell = get_ipython()
        picture = {} if shell is None else self.view._repr_mimebundle_()
        if WIDGET not in picture:
            return bundle
        self.close()
        bar = LessonBar(self.lesson)
        hosts = [_host("stage", self.view.widget), _host("bar", bar)]
        box = ipywidgets.HBox(hosts, _dom_classes=("dhlab-lesson",))
        box.layout.height = f"{self.height + 2}px"
        self._parts = [box.layout, box, *(part for h in hosts for part in (h.layout, h)), bar]
        bundle = {**picture, **bundle, WIDGET: box._repr_mimebundle_()[WIDGET]}
        outputs_of(shell).note(self)
        return bundle


def _host(name: str, widget: Any) -> ipywidgets.Box:
    return ipywidgets.Box((widget,), _dom_classes=(f"dhlab-{name}-host",))


def lesson_mimebundle(lesson: Lesson, include: Any = None, exclude: Any = None) -> dict[str, Any]:
    """Return what a cell that ends in a lesson shows: a view of its own with the bar."""
    return {**LessonView(lesson)._repr_mimebundle_(), "text/plain": repr(lesson)}
