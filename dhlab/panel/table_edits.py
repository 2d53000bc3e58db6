"""Edits of a robot's tables: one number at a time, checked, and undone."""

from typing import Any

import numpy as np

from dhlab.errors import DhlabError, InputError
from dhlab.kinematics.chain import Chain
from dhlab.scene.component import Component
from dhlab.scene.dimensions import PARAMETERS, check_row
from dhlab.scene.handle import CHANGES
from dhlab.scene.robot import Robot

HISTORY = 200
LETTERS = {"alpha": "α", "a": "a", "d": "d", "theta": "θ"}
UNITS = {"alpha": "degrees, such as 90 or -45.5", "theta": "degrees, such as 90 or -45.5"}
METRES = "metres, such as 0.25"

State = tuple[tuple[Component, Chain, Any], ...]


class TableEdits:
    """What a user does to the tables of a robot, and how it is undone.

    Parameters
    ----------
    robot : Robot
    """

    def __init__(self, robot: Robot) -> None:
        self._robot = robot
        self._undo: list[State] = []
        self._redo: list[State] = []

    @property
    def can_undo(self) -> bool:
        """Whether there is something to undo."""
        return bool(self._undo)

    @property
    def can_redo(self) -> bool:
        """Whether there is something to do again."""
        return bool(self._redo)

    def edit(self, component: Component, row: int, parameter: str, text: str) -> None:
        """Set one number of a table, or the variable that stands in its place.

        Parameters
        ----------
        component : Component
        row : int
            From 1.
        parameter : {'alpha', 'a', 'd', 'theta'}
        text : str
            As it was typed: angles in degrees, lengths in metres.

        Raises
        ------
        InputError, LimitError
            The text is no number, or the robot cannot be so; nothing has changed.
        """
        check_row((row, None), component.chain, f"table of '{component.name}'")
        value = read_number(text, row, parameter)
        with CHANGES:
            before = self._state()
            if parameter == variable_of(component.chain, row):
                q = component.q.copy()
                q[row - 1] = value
                component.q = q
            else:
                component.chain = component.chain.replace(row, **{parameter: value})
            self._undo = [*self._undo, before][-HISTORY:]
            self._redo = []

    def undo(self) -> None:
        """Go back to before the last edit; nothing if there is none."""
        self._swap(self._undo, self._redo)

    def redo(self) -> None:
        """Do again what was undone; nothing if there is nothing."""
        self._swap(self._redo, self._undo)

    def _swap(self, source: list[State], target: list[State]) -> None:
        if not source:
            return
        with CHANGES:
            target.append(self._state())
            for component, chain, q in source.pop():
                component.set(chain=chain, q=q)

    def _state(self) -> State:
        return tuple((c, c.chain, c.q) for c in self._robot.components)


def variable_of(chain: Chain, row: int) -> str:
    """Return the parameter that the joint varies.

    Examples
    --------
    >>> variable_of(Chain([(0, 0, 0, 0)], "p"), 1)
    'd'
    """
    return "theta" if chain.kinds[row - 1] == "r" else "d"


def read_number(text: str, row: int, parameter: str) -> float:
    """Read a number as it was typed, an angle in degrees, and give it in radians or metres.

    Examples
    --------
    >>> read_number("90°", 1, "alpha") == np.pi / 2
    True
    >>> read_number("ninety", 2, "alpha")
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: row 2, α: 'ninety' is no number; type degrees, such as 90 or -45.5
    """
    if parameter not in PARAMETERS:
        raise InputError(f"no parameter {parameter!r}; use {', '.join(PARAMETERS)}")
    angle = parameter in UNITS
    plain = text.strip().replace("\u2212", "-").removesuffix("°" if angle else "m").strip()
    wanted = UNITS.get(parameter, METRES)
    try:
        value = float(plain)
    except ValueError:
        hint = " (a decimal point, not a comma)" if "," in plain else ""
        raise InputError(
            f"row {row}, {LETTERS[parameter]}: {text!r} is no number; type {wanted}{hint}"
        ) from None
    if not np.isfinite(value):
        raise InputError(f"row {row}, {LETTERS[parameter]}: {text!r} is not finite; type {wanted}")
    return float(np.radians(value)) if angle else value


def explained(error: DhlabError) -> str:
    """Say what is wrong in a sentence for the page."""
    text = str(error)
    return text[:1].upper() + text[1:] + ("" if text.endswith(".") else ".")
