"""A robot's Denavit-Hartenberg tables to be edited: every edit moves the robot at once."""

import weakref
from contextlib import suppress
from importlib.resources import files
from typing import Any
from uuid import uuid4

import anywidget
import numpy as np
import traitlets
from IPython import get_ipython

from dhlab.errors import DhlabError, InputError
from dhlab.panel.link import STATIC
from dhlab.panel.panel import _weakly
from dhlab.panel.table_code import table_code
from dhlab.panel.table_edits import TableEdits, explained, variable_of
from dhlab.scene.component import Component
from dhlab.scene.dimensions import COLORS, PARAMETERS
from dhlab.scene.handle import CHANGES, Handle
from dhlab.scene.robot import Robot
from dhlab.view import assets
from dhlab.view.outputs import outputs_of
from dhlab.view.pace import Pace
from dhlab.view.prose import formula


class TableWidget(anywidget.AnyWidget):
    """The tables in the page.

    What it is made with goes to the page with it: a page that is slow to load a widget's module
    does not hear what it is told in the meantime.

    Parameters
    ----------
    **state
        `tables` and `steps`, as they are at first.

    Attributes
    ----------
    tables : list of dict
        One a component: what its cells show.
    note : dict
        What is wrong with the last input: component, row, column, text and the explanation.
    code : list
        Number and Python code for the clipboard.
    """

    _esm = assets.bundle("table", STATIC)
    _css = (files("dhlab.panel") / "static" / "table.css").read_text(encoding="utf-8")

    own_id = traitlets.Unicode().tag(sync=True)
    tables: "traitlets.List[Any]" = traitlets.List().tag(sync=True)
    note: "traitlets.Dict[str, Any]" = traitlets.Dict().tag(sync=True)
    steps: "traitlets.List[bool]" = traitlets.List([False, False]).tag(sync=True)
    code: "traitlets.List[Any]" = traitlets.List().tag(sync=True)

    def __init__(self, **state: Any) -> None:
        own_id = uuid4().hex
        super().__init__(model_id=own_id, own_id=own_id, **state)


class TableEditor:
    """The Denavit-Hartenberg tables of a robot as editable cells.

    Angles are shown and typed in degrees, lengths in metres. An edit moves the robot at once; an
    input that cannot be is explained and changes nothing. The number whose cell has the focus is
    drawn as a dimension on the robot. The variable of a joint, in italics, is its present value.

    Parameters
    ----------
    robot : Robot
        Simple, complex or connected: a table for each of its components.

    Examples
    --------
    >>> from dhlab import dh, robot
    >>> arm = robot([dh(0, 0, 0, 0), dh(0, 0.3, 0, 0)], "rr", name="arm")
    >>> editor = TableEditor(arm)
    >>> editor.edit(2, "a", "0.5")
    >>> arm.chain.rows[1].a
    0.5
    >>> editor.edit(2, "alpha", "x")
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: row 2, α: 'x' is no number; type degrees, such as 90 or -45.5
    >>> editor.undo()
    >>> arm.chain.rows[1].a
    0.3
    """

    def __init__(self, robot: Robot) -> None:
        if not isinstance(robot, Robot):
            raise InputError(f"a table editor needs a robot, got {robot!r}")
        self._robot = robot
        self._edits = TableEdits(robot)
        self._widget: TableWidget | None = None
        self._copies = 0
        self._notes = 0
        self._pace = Pace(_weakly(self.flush))
        robot.watch(self)

    @property
    def robot(self) -> Robot:
        """The robot whose tables they are."""
        return self._robot

    @property
    def code(self) -> str:
        """The tables as Python code that makes the robots again."""
        return table_code(self._robot.components)

    @property
    def widget(self) -> TableWidget:
        """The Jupyter widget, to lay it out beside others."""
        with CHANGES:
            if self._widget is None:
                self._widget = TableWidget(**self._state())
                self._widget.on_msg(_weakly(self._hear))
                closing = weakref.finalize(self, _close, self._widget)
                closing.atexit = False
            return self._widget

    def edit(self, row: int, parameter: str, text: str, component: int = 0) -> None:
        """Set one number, as if it had been typed.

        Parameters
        ----------
        row : int
            From 1.
        parameter : {'alpha', 'a', 'd', 'theta'}
        text : str
            Degrees or metres.
        component : int
            Of ``robot.components``, from 0.

        Raises
        ------
        InputError, LimitError
            The input cannot be; nothing has changed.
        """
        self._edits.edit(self._component(component), row, parameter, text)

    def select(self, row: int | None, parameter: str | None = None, component: int = 0) -> None:
        """Draw a row's numbers as dimensions on the robot, one of them lit up; None for nothing."""
        drawn = self._component(component)
        if row is not None and drawn.dimensions != (row, parameter):
            drawn.set(dimensions=(row, parameter))
        for other in self._robot.components:
            if other.dimensions is not None and (row is None or other is not drawn):
                other.set(dimensions=None)

    def undo(self) -> None:
        """Go back to before the last edit."""
        self._edits.undo()
        self.flush()

    def redo(self) -> None:
        """Do again what was undone."""
        self._edits.redo()
        self.flush()

    def copy(self) -> None:
        """Put `code` on the clipboard of whoever looks at the page."""
        self._copies += 1
        self.widget.code = [self._copies, self.code]

    def close(self) -> None:
        """Close the widget; the editor can be shown again."""
        with CHANGES:
            self._pace.stop()
            if self._widget is not None:
                _close(self._widget)
            self._widget = None

    def handle_changed(self, handle: Handle) -> None:
        """Follow the robot; the robot calls this, with `CHANGES` held."""
        if self._widget is not None:
            self._pace.ask()

    def flush(self) -> None:
        """Tell the page now what the tables are."""
        with CHANGES:
            if self._widget is not None:
                for name, value in self._state().items():
                    setattr(self._widget, name, value)

    def _component(self, number: int) -> Component:
        components = self._robot.components
        if number not in range(len(components)):
            known = ", ".join(f"{k} ({c.name})" for k, c in enumerate(components))
            raise InputError(
                f"'{self._robot.name}' has no component {number!r}; choose from {known}"
            )
        return components[number]

    def _state(self) -> dict[str, Any]:
        """What the page shows; the lock is held."""
        return {
            "tables": [_table(component) for component in self._robot.components],
            "steps": [self._edits.can_undo, self._edits.can_redo],
        }

    def _hear(self, widget: Any, content: Any, buffers: Any) -> None:
        """Do what the page asks for: each word is a message of its own, so that none is lost."""
        what, *about = content["say"]
        if what in ("undo", "redo", "copy"):
            getattr(self, what)()
            return
        if what == "ready":
            self.widget.send_state(("tables", "steps"))
            return
        component, row, column, *text = about
        parameter = None if column is None else PARAMETERS[column]
        if what == "focus":
            with suppress(InputError):  # a page may be behind a robot that has become another
                self.select(row, parameter, component)
            return
        try:
            self.edit(row, str(parameter), text[0], component)
        except DhlabError as error:
            where = {"component": component, "row": row, "column": column, "typed": text[0]}
            self._notes += 1
            self.widget.note = where | {"text": explained(error), "number": self._notes}
        else:
            self.widget.note = {}
        self.flush()

    def __repr__(self) -> str:
        names = ", ".join(f"{c.name} ({c.n} rows)" for c in self._robot.components)
        return f"TableEditor of '{self._robot.name}': {names}"

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> dict[str, Any]:
        """What a cell that ends in this editor shows: the tables, or else a line of text."""
        bundle: dict[str, Any] = {"text/plain": repr(self)}
        shell = get_ipython()
        if getattr(shell, "kernel", None) is not None:
            told = self.widget._repr_mimebundle_()
            if told is not None:
                bundle = {**told[0], **bundle}
            outputs_of(shell).note(self)
        return bundle


def _close(widget: TableWidget) -> None:
    layout = widget.layout
    widget.close()
    layout.close()


def _table(component: Component) -> dict[str, Any]:
    chain = component.chain
    link = "i-1" if chain.convention == "modified" else "i"
    heads = [rf"\alpha_{{{link}}}", f"a_{{{link}}}", "d_i", r"\theta_i"]
    rows = []
    for i, (row, value) in enumerate(zip(chain.rows, component.q, strict=True), start=1):
        numbers = row._asdict() | {variable_of(chain, i): float(value)}
        rows.append([_shown(name, numbers[name]) for name in PARAMETERS])
    return {
        "name": component.name,
        "convention": chain.convention,
        "heads_html": [formula(head) for head in heads],
        "units": ["°", "m", "m", "°"],
        "colors": ["#" + "".join(f"{round(255 * x):02x}" for x in COLORS[p]) for p in PARAMETERS],
        "joints": chain.joints,
        "variables": [PARAMETERS.index(variable_of(chain, i)) for i in range(1, chain.n + 1)],
        "offsets": [bool(x) for x in chain.offset],
        "rows": rows,
        "selected": None if component.dimensions is None else component.dimensions[0],
    }


def _shown(parameter: str, value: float) -> str:
    shown = np.degrees(value) if parameter in ("alpha", "theta") else value
    text = f"{shown:z.4f}".rstrip("0").rstrip(".")
    return text or "0"
