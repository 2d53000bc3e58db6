"""One joint variable on a slider."""

from typing import Any

import ipywidgets
from traitlets import Bunch

from dhlab.scene.reading import Reading


class JointSlider(ipywidgets.FloatSlider):
    """A slider that shows a joint variable, in degrees, millimetres or metres.

    Setting `value` is what dragging it does: the robot moves. `show` is what the robot does: the
    slider follows, and the page is not told by this slider but by its panel, for all at once.

    Parameters
    ----------
    reading : Reading
        Unit, limits and span of the variable.
    value : float [rad or m]
        What to show first.
    **options
        Further words for the slider of ipywidgets.
    """

    def __init__(self, reading: Reading, value: float, **options: Any) -> None:
        self._muted = False
        self.reading = reading
        lower, upper = map(reading.shown, reading.span)
        super().__init__(
            value=reading.shown(value),
            min=lower,
            max=upper,
            step=reading.step,
            readout_format=f".{reading.decimals}f",
            continuous_update=False,
            **options,
        )
        self._told = self.value

    @property
    def following(self) -> bool:
        """Whether `value` is just being changed by the robot, not by a user or by code."""
        return self._muted

    def show(self, shown: float) -> None:
        """Hold a value of the robot, in the slider's unit; quick, and nobody is told."""
        self._trait_values["value"] = min(max(shown, self.min), self.max)

    def tell(self) -> None:
        """Tell those who observe `value` in Python what was shown since they were last told."""
        old, self._told = self._told, self.value
        if old != self._told:
            self._muted = True
            try:
                change = Bunch(name="value", old=old, new=self._told, owner=self, type="change")
                self.notify_change(change)
            finally:
                self._muted = False

    def send_state(self, key: Any = None) -> None:
        """Send state to the page, unless the panel does so for all sliders."""
        if not self._muted:
            super().send_state(key)

    def set_state(self, sync_data: dict[str, Any]) -> None:
        """Take state from the page; a value that reads as the present one was only looked at.

        A click into the typed value and out again sends it as it reads, rounded.
        """
        value = sync_data.get("value")
        if isinstance(value, int | float) and self._reads_the_same(value):
            sync_data = {k: v for k, v in sync_data.items() if k != "value"}
        super().set_state(sync_data)

    def _reads_the_same(self, shown: float) -> bool:
        """Whether a value may be the readout's of the present one, rounded in the page's way."""
        digits = self.reading.decimals
        unit, step = 10.0**-digits, self.reading.step
        rounding = 0.5 * (unit + step if step < unit else unit) + 1e-9
        return round(shown, digits) == shown and abs(shown - self.value) <= rounding
