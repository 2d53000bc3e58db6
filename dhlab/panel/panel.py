"""A robot's variables on sliders."""

import weakref
from collections.abc import Callable
from typing import Any

import ipywidgets
import numpy as np
from IPython import get_ipython

from dhlab.errors import InputError
from dhlab.panel.board import BUTTONS, Board
from dhlab.panel.code import config_code
from dhlab.panel.moves import Moves
from dhlab.panel.slider import JointSlider
from dhlab.scene.handle import CHANGES, Handle
from dhlab.scene.robot import Robot
from dhlab.view.outputs import outputs_of
from dhlab.view.pace import Pace


class Panel:
    """Sliders for all variables of a robot, a group for each of its components.

    Sliders and robot follow each other both ways: whatever moves the robot moves the sliders. A
    cell that ends in a panel shows it.

    Parameters
    ----------
    robot : Robot
        Simple, complex or connected; the groups are its `components`.
    seed : int, optional
        For `random`: the same seed, the same configurations.

    Examples
    --------
    >>> from dhlab.kinematics.dh import dh
    >>> from dhlab.scene.robots import robot
    >>> arm = robot([dh(0, 0, 0, 0), dh(0, 0.3, 0, 0)], "rr", name="arm")
    >>> panel = Panel(arm)
    >>> panel
    Panel of 'arm': arm (2)
    >>> panel.sliders[1].value = 90
    >>> arm.q.round(4)
    array([0.    , 1.5708])
    >>> arm.q = (0.5, 0)
    >>> [round(slider.value, 2) for slider in panel.sliders]
    [28.65, 0.0]
    >>> Panel([1, 2])
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: a panel needs a robot, got [1, 2]
    """

    def __init__(self, robot: Robot, *, seed: int | None = None) -> None:
        if not isinstance(robot, Robot):
            raise InputError(f"a panel needs a robot, got {robot!r}")
        self._robot = robot
        self._moves = Moves(robot, seed)
        self._factors = np.empty(0)
        self._board: Board | None = None
        self._closing: weakref.finalize[..., Panel] | None = None
        self._pace = Pace(_weakly(self.flush))
        robot.watch(self)

    @property
    def robot(self) -> Robot:
        """The robot that the sliders move."""
        return self._robot

    @property
    def widget(self) -> ipywidgets.VBox:
        """The Jupyter widget, to lay it out beside others."""
        return self._open().box

    @property
    def sliders(self) -> tuple[JointSlider, ...]:
        """One slider for each variable, in the order of ``robot.q``."""
        return self._open().sliders

    @property
    def code(self) -> str:
        """The configuration as Python code that gives it back bit for bit."""
        return config_code(self._robot.components)

    def home(self) -> None:
        """Go to the configuration of the tables."""
        self._moves.home()

    def zero(self) -> None:
        """Set every variable to 0 whose limits allow it; the others stay."""
        self._moves.zero()

    def random(self) -> None:
        """Go to any configuration within the limits; without limits, within the sliders' span."""
        spans = [slider.reading.span for slider in self.sliders]
        self._moves.random(np.reshape(spans, (-1, 2)))

    def undo(self) -> None:
        """Go back to before the user's last move; nothing if there is none."""
        self._moves.undo()

    def redo(self) -> None:
        """Do again what was undone; nothing if there is nothing."""
        self._moves.redo()

    def copy(self) -> None:
        """Put `code` on the clipboard of whoever looks at the page."""
        self._open().copy(self.code)

    def close(self) -> None:
        """Close the widgets and the pictures of them; the panel can be shown again."""
        with CHANGES:
            self._pace.stop()
            self._board = None
            if self._closing is not None:
                self._closing()

    def handle_changed(self, handle: Handle) -> None:
        """Follow the robot; the robot calls this, with `CHANGES` held."""
        if self._board is not None:
            q = self._robot.q
            if len(q) == len(self._factors):
                self._board.follow((q * self._factors).tolist())
            self._pace.ask()

    def flush(self) -> None:
        """Tell the page now what waits to be told."""
        with CHANGES:
            if self._board is not None:
                self._fit(self._board)
                self._board.tell()

    def __repr__(self) -> str:
        groups = ", ".join(f"{c.name} ({c.n})" for c in self._robot.components)
        return f"Panel of '{self._robot.name}': {groups or 'no joints'}"

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> dict[str, Any]:
        """What a cell that ends in this panel shows: the sliders, or else a line of text."""
        bundle: dict[str, Any] = {"text/plain": repr(self)}
        shell = get_ipython()
        if getattr(shell, "kernel", None) is not None:
            bundle.update(self.widget._repr_mimebundle_() | bundle)
            outputs_of(shell).note(self)
        return bundle

    def _open(self) -> Board:
        """Return the widgets, made when they are first wanted."""
        with CHANGES:
            if self._board is None:
                actions = {key: _weakly(getattr(self, key)) for key in BUTTONS}
                self._board = Board(actions, _weakly(self._slid), _weakly(self._dragged))
                self._closing = weakref.finalize(self, self._board.close)
                self._closing.atexit = False
            self._fit(self._board)
            return self._board

    def _fit(self, board: Board) -> None:
        """Make the groups anew if the robot has become another; the lock is held."""
        components = self._robot.components
        if not board.fits(components):
            board.fill(components)
            if len(board.sliders) != len(self._factors):
                self._moves.history.clear()
            self._factors = np.array([slider.reading.shown(1.0) for slider in board.sliders])
        board.buttons["undo"].disabled = not self._moves.history.can_undo
        board.buttons["redo"].disabled = not self._moves.history.can_redo

    def _slid(self, index: int, shown: float) -> None:
        """Set one variable as its slider was set."""
        self._set_joint(index, shown, None)

    def _dragged(self, drag: list[Any]) -> None:
        """Follow a hand on a slider: number and newest place of it."""
        number, grasp, index, shown = drag
        self._set_joint(index, shown, grasp, answered=number)

    def _set_joint(
        self, index: int, shown: float, grasp: int | None, answered: int | None = None
    ) -> None:
        with CHANGES:
            board = self._open()
            board.answer(answered)
            try:
                value = board.sliders[index].reading.meant(shown)
                self._moves.set_joint(index, value, grasp)
            finally:
                self._pace.ask()


def _weakly(method: Callable[..., None]) -> Callable[..., None]:
    """Call a method of an object for as long as there is one."""
    reference = weakref.WeakMethod(method)

    def call(*arguments: Any) -> None:
        living = reference()
        if living is not None:
            living(*arguments)

    return call
