"""A view and a panel in one output: both in sight at once."""

from typing import Any

import ipywidgets
from IPython import get_ipython

from dhlab.errors import InputError
from dhlab.panel.panel import Panel
from dhlab.panel.table_editor import TableEditor
from dhlab.view.outputs import outputs_of
from dhlab.view.view import WIDGET, View


class Beside:
    """A view with a panel or a table editor to its right; `side_by_side` makes it."""

    def __init__(self, view: View, panel: Panel | TableEditor) -> None:
        self._view = view
        self._panel = panel
        self._box: ipywidgets.HBox | None = None

    @property
    def view(self) -> View:
        """What is shown on the left."""
        return self._view

    @property
    def panel(self) -> Panel | TableEditor:
        """What is shown on the right."""
        return self._panel

    def close(self) -> None:
        """Close the frame around view and panel; they stay as they are."""
        if self._box is not None:
            self._box.layout.close()
            self._box.close()
            self._box = None

    def __repr__(self) -> str:
        return f"{self._view!r} beside {self._panel!r}"

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> dict[str, Any]:
        """What a cell that ends in this shows: both, or else a line of text."""
        bundle: dict[str, Any] = {"text/plain": repr(self)}
        shell = get_ipython()
        if getattr(shell, "kernel", None) is not None:
            parts = [(p, p._repr_mimebundle_()) for p in (self._view, self._panel)]
            shown = [part for part, its in parts if WIDGET in its]
            bundle = {**parts[0][1], **bundle}
            self.close()
            self._box = ipywidgets.HBox(
                tuple(part.widget for part in shown), _dom_classes=("dhlab-beside",)
            )
            bundle[WIDGET] = self._box._repr_mimebundle_()[WIDGET]
            outputs_of(shell).note(self)
        return bundle


def side_by_side(view: View, panel: Panel | TableEditor) -> Beside:
    """Show a view and a panel, or a table editor, beside each other: the last line of a cell.

    Parameters
    ----------
    view : View
    panel : Panel or TableEditor

    Returns
    -------
    beside : Beside

    Raises
    ------
    InputError
        For anything else than a view and a panel.

    Examples
    --------
    >>> from dhlab.kinematics.dh import dh
    >>> from dhlab.scene.robots import robot
    >>> arm = robot([dh(0, 0, 0, 0)], "r", name="arm")
    >>> side_by_side(View().add(arm), Panel(arm))
    View('view': arm) beside Panel of 'arm': arm (1)
    >>> side_by_side(arm, Panel(arm))
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: side_by_side needs a view and a panel, got a Robot and a Panel
    """
    if not isinstance(view, View) or not isinstance(panel, Panel | TableEditor):
        given = f"a {type(view).__name__} and a {type(panel).__name__}"
        raise InputError(f"side_by_side needs a view and a panel, got {given}")
    return Beside(view, panel)
