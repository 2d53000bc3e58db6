"""What a user does to a robot through a panel, and how it is undone."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dhlab.panel.history import History
from dhlab.scene.component import Component
from dhlab.scene.handle import CHANGES
from dhlab.scene.robot import Robot


class Moves:
    """Moves of a user's hand on a robot: one joint, or all at once; each can be undone.

    A drag tells its grasp, but the slider that is dragged tells its value too, by another way that
    may be shorter. `_hand` is the joint of the last move and its grasp, 0 while only the slider
    has told: so that one drag is one move whichever comes first. `_told` is where a grasp last
    brought which joint: a hand lets go late, and what has moved the robot since then stays.

    Parameters
    ----------
    robot : Robot
    seed : int or None
        For `random`: the same seed, the same configurations.
    """

    __slots__ = ("_generator", "_hand", "_robot", "_told", "history")

    def __init__(self, robot: Robot, seed: int | None = None) -> None:
        self._robot = robot
        self._generator = np.random.default_rng(seed)
        self._hand: tuple[int, int] | None = None
        self._told: tuple[int, float] | None = None
        self.history = History()

    def set_joint(self, index: int, value: float, grasp: int | None = None) -> None:
        """Set one variable of the robot.

        Parameters
        ----------
        index : int
            Its place in the robot's configuration, from 0.
        value : float [rad or m]
        grasp : int, optional
            Number of the grasp that a drag belongs to: one grasp is undone at once. 0: the hand
            lets go. None: the slider was set; while a hand is on it, by that hand.
        """
        with CHANGES:
            component, own = self._joint(index)
            changed = bool(component.q[own] != value)
            if grasp == 0 and self._told == (index, value):
                changed = False
            if grasp is not None:
                self._told = index, value
            if changed and self._begins(index, grasp):
                self.history.add(self._robot.q)
                self._hand = (index, grasp or 0)
            elif grasp and self._hand == (index, 0):
                self._hand = (index, grasp)
            if grasp == 0:
                self._hand = None
            if changed:
                q = component.q.copy()
                q[own] = value
                component.q = component.clip(q)

    def go(self, q: ArrayLike) -> None:
        """Set all variables, as near to `q` as the limits allow."""
        with CHANGES:
            before, wanted = self._robot.q, self._robot.clip(q)
            self._hand = None
            if not np.array_equal(before, wanted):
                self.history.add(before)
                self._robot.q = wanted

    def home(self) -> None:
        """Go to the configuration of the tables."""
        self.go(self._robot.home)

    def zero(self) -> None:
        """Set every variable to 0 whose limits allow it; the others stay."""
        lower, upper = self._robot.limits.T
        self.go(np.where((lower <= 0) & (upper >= 0), 0.0, self._robot.q))

    def random(self, spans: NDArray[np.float64]) -> None:
        """Go to any configuration within spans, shape (n, 2) [rad or m]."""
        self.go(self._generator.uniform(*spans.T))

    def undo(self) -> None:
        """Go back to before the last move; nothing if there is none."""
        with CHANGES:
            self._restore(self.history.undo(self._robot.q))

    def redo(self) -> None:
        """Do again what was undone; nothing if there is nothing."""
        with CHANGES:
            self._restore(self.history.redo(self._robot.q))

    def _begins(self, index: int, grasp: int | None) -> bool:
        """Whether a change begins a move: it does not come of the hand that is on the slider."""
        if self._hand is None or self._hand[0] != index:
            return True
        held = self._hand[1]
        return held == 0 or bool(grasp and grasp != held)

    def _restore(self, q: NDArray[np.float64] | None) -> None:
        self._hand = None
        if q is not None:
            self._robot.q = self._robot.clip(q)

    def _joint(self, index: int) -> tuple[Component, int]:
        """Find the component of a variable, and its place in it."""
        for component in self._robot.components:
            if index < component.n:
                return component, index
            index -= component.n
        raise IndexError(index)
