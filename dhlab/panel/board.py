"""The widgets of a panel: buttons, a group of sliders for each component, and their link."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import ipywidgets

from dhlab.panel.group import Group, make_group
from dhlab.panel.link import Link, make_token
from dhlab.panel.slider import JointSlider
from dhlab.scene.component import Component

BUTTONS = {
    "home": ("Home", "to the configuration of the tables"),
    "zero": ("Zero", "every variable to 0 whose limits allow it"),
    "random": ("Random", "to any configuration within the limits"),
    "undo": ("Undo", "back to before your last move"),
    "redo": ("Redo", "forward again"),
    "copy": ("Copy q", "the configuration as Python code, to the clipboard"),
}


class Board:
    """All widgets of one panel; `box` shows them.

    Parameters
    ----------
    actions : mapping of str to callable
        What each of the `BUTTONS` does.
    moved : callable
        Called with number and value of a slider that a user or code has set.
    dragged : callable
        Called with the `drag` of the link.
    """

    def __init__(
        self,
        actions: Mapping[str, Callable[[], None]],
        moved: Callable[[int, float], None],
        dragged: Callable[[list[Any]], None],
    ) -> None:
        self._moved = moved
        self._dragged = dragged
        self.groups: tuple[Group, ...] = ()
        self.sliders: tuple[JointSlider, ...] = ()
        self.buttons = {
            key: ipywidgets.Button(description=label, tooltip=tip)
            for key, (label, tip) in BUTTONS.items()
        }
        for key, button in self.buttons.items():
            button.on_click(_pressed(actions[key]))
        bar = ipywidgets.HBox(tuple(self.buttons.values()), _dom_classes=("dhlab-buttons",))
        groups = ipywidgets.VBox(_dom_classes=("dhlab-groups",))
        self.box = ipywidgets.VBox((bar, groups), _dom_classes=("dhlab-panel",))
        self.link: Link | None = None
        self._answered = 0
        self._told: object = None

    def fits(self, components: Sequence[Component]) -> bool:
        """Whether the groups still are those of the components."""
        return tuple(group.component for group in self.groups) == tuple(components) and all(
            group.fits() for group in self.groups
        )

    def fill(self, components: Sequence[Component]) -> None:
        """Make groups for components, in place of those before."""
        folded = {group.component for group in self.groups if group.folded}
        old = list(self._fillings())
        token, first, groups = make_token(), 0, []
        for component in components:
            groups.append(make_group(component, token, first, folded=component in folded))
            first += component.n
        self.groups = tuple(groups)
        self.sliders = tuple(slider for group in groups for slider in group.sliders)
        self._answered, self._told = 0, None
        self.link = self._make_link(token)
        bar, middle = self.box.children[:2]
        middle.children = tuple(group.box for group in groups)
        self.box.children = (bar, middle, self.link)
        _close(old)

    def follow(self, shown: Iterable[float]) -> None:
        """Let the sliders hold values of the robot, each in its unit; nobody is told yet."""
        for slider, value in zip(self.sliders, shown, strict=True):
            slider.show(value)

    def tell(self) -> None:
        """Tell the page and the sliders' observers what the sliders hold, if it is news."""
        for slider in self.sliders:
            slider.tell()
        clocks = [clock for group in self.groups for clock in _clocks(group.component)]
        news = (self._answered, [slider.value for slider in self.sliders], clocks)
        if self.link is not None and news != self._told:
            self._told = news
            self.link.tell(*news)

    def answer(self, drag: int | None) -> None:
        """Note that the page waits for an answer, whatever comes of what it told.

        Parameters
        ----------
        drag : int or None
            Number of the drag to be answered, if it was one.
        """
        self._told = None
        self._answered = self._answered if drag is None else drag

    def copy(self, text: str) -> None:
        """Put a text on the clipboard of whoever looks at the page."""
        if self.link is not None:
            self.link.send({"text": text})

    def close(self) -> None:
        """Take all widgets out of the page and out of ipywidgets' registry."""
        bar, middle = self.box.children[:2]
        frame = (*self.buttons.values(), bar, middle, self.box)
        _close([*self._fillings(), *_with_parts(frame)])

    def _make_link(self, token: str) -> Link:
        for number, slider in enumerate(self.sliders):
            slider.observe(_set(number, self._moved), "value")
        link = Link(
            token=token,
            sliders=[slider.model_id for slider in self.sliders],
            joints=[row for group in self.groups for row in group.joints()],
            robots=[group.told() for group in self.groups],
            clocks=len(self.sliders) * [""],
            folds=[[g.title.model_id, g.rows.layout.model_id] for g in self.groups],
        )
        dragged = self._dragged
        link.observe(lambda change: dragged(change.new), "drag")
        return link

    def _fillings(self) -> Iterable[ipywidgets.Widget]:
        own = () if self.link is None else (self.link,)
        rows = (
            widget for g in self.groups for widget in (*g.rows.children, g.title, g.rows, g.box)
        )
        return _with_parts((*own, *rows))


def _clocks(component: Component) -> list[str]:
    """Clock of the planned motion of each joint, or nothing."""
    curves = component.curves
    return component.n * [""] if curves is None else [curve.clock.key for curve in curves]


def _pressed(action: Callable[[], None]) -> Callable[[Any], None]:
    return lambda button: action()


def _set(number: int, moved: Callable[[int, float], None]) -> Callable[[Any], None]:
    def tell(change: Any) -> None:
        if not change.owner.following:
            moved(number, change.new)

    return tell


def _with_parts(widgets: Iterable[ipywidgets.Widget]) -> Iterable[ipywidgets.Widget]:
    """Go through widgets, their layouts and their styles."""
    for widget in widgets:
        yield from (widget, widget.layout)
        if widget.has_trait("style"):
            yield widget.style


def _close(widgets: Iterable[ipywidgets.Widget]) -> None:
    for widget in widgets:
        widget.close()
