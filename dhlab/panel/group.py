"""The sliders of one component robot, under its name and in its colour."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from math import isfinite
from typing import Any

import ipywidgets

from dhlab.kinematics.chain import Chain
from dhlab.panel.slider import JointSlider
from dhlab.scene.component import Component
from dhlab.scene.node import Color
from dhlab.scene.reading import Reading, component_readings, joint_label

UNIT_CLASSES = {"°": "dhlab-degrees", "mm": "dhlab-millimetres", "m": "dhlab-metres"}


@dataclass(frozen=True, eq=False)
class Group:
    """Widgets of one component, and what they were made for.

    Attributes
    ----------
    component : Component
    name, color, chain
        Of the component when the group was made.
    readings : tuple of Reading
    sliders : tuple of JointSlider
    title : ToggleButton
        Down: the sliders are shown.
    rows : VBox
        What the title folds away.
    box : VBox
        Title and rows.
    """

    component: Component
    name: str
    color: Color
    chain: Chain
    readings: tuple[Reading, ...]
    sliders: tuple[JointSlider, ...]
    title: ipywidgets.ToggleButton
    rows: ipywidgets.VBox
    box: ipywidgets.VBox

    @property
    def folded(self) -> bool:
        """Whether the sliders are folded away."""
        return not self.title.value

    def fits(self) -> bool:
        """Whether the component still is what the group was made for."""
        component = self.component
        if component.name != self.name or component.color != self.color:
            return False
        if component.chain is self.chain and all(r.bounded for r in self.readings):
            return True
        same_offset = (component.chain.offset == self.chain.offset).all()
        return bool(same_offset) and component_readings(component) == self.readings

    def joints(self) -> Iterator[list[Any]]:
        """Key, factor and offset of each joint: a slider shows ``factor * (x - offset)``.

        x is the joint's variable on the page, which has the offset in it.
        """
        keys, offsets = self.component.keys, self.chain.offset.tolist()
        for key, offset, r in zip(keys, offsets, self.readings, strict=True):
            yield [key, r.shown(1.0), offset]

    def told(self) -> dict[str, Any]:
        """Name, colour and joints, as plain data: `dhlab.panel.saved` makes sliders of them."""
        keys, chain = self.component.keys, self.chain
        numbers = zip(chain.offset.tolist(), chain.home.tolist(), strict=True)
        joints = [
            [key, r.kind, offset, home, [e if isfinite(e) else None for e in r.limits], r.span]
            for key, r, (offset, home) in zip(keys, self.readings, numbers, strict=True)
        ]
        return {"name": self.name, "color": _hex(self.color), "joints": joints}


def make_group(component: Component, token: str, first: int, *, folded: bool = False) -> Group:
    """Make the widgets of one component.

    Parameters
    ----------
    component : Component
    token : str
        Name of the panel in the page.
    first : int
        Number of the component's first slider in the panel, from 0.
    folded : bool

    Returns
    -------
    Group
    """
    readings = component_readings(component)
    color = _hex(component.color)
    sliders = _sliders(component, readings, color, f"dhlab-joint-{token}-{{}}", first)
    notes = (_note(i, r) for i, r in enumerate(readings, start=1) if r.kind == "p")
    rows = ipywidgets.VBox(
        (*sliders, *(note for note in notes if note is not None)),
        layout={"display": "none" if folded else None},
        _dom_classes=("dhlab-rows",),
    )
    title = ipywidgets.ToggleButton(
        not folded, description=component.name, tooltip="fold", _dom_classes=("dhlab-title",)
    )
    title.observe(_folding(rows.layout), "value")
    box = ipywidgets.VBox(
        (title, rows),
        layout={"border_left": f"4px solid {color}"},
        _dom_classes=("dhlab-group",),
    )
    made_for = (component, component.name, component.color, component.chain)
    return Group(*made_for, readings, sliders, title, rows, box)


def _sliders(
    component: Component, readings: tuple[Reading, ...], color: str, mark: str, first: int
) -> tuple[JointSlider, ...]:
    style = ipywidgets.SliderStyle(handle_color=color)
    return tuple(
        JointSlider(
            r,
            float(value),
            description=_description(joint_label(r.kind, i + 1), r),
            description_allow_html=True,
            tooltip=f"joint {i + 1} of {component.name}: {' to '.join(r.ends())} {r.unit}",
            style=style,
            _dom_classes=("dhlab-joint", UNIT_CLASSES[r.unit], mark.format(first + i)),
        )
        for i, (r, value) in enumerate(zip(readings, component.q, strict=True))
    )


def _description(label: str, r: Reading) -> str:
    """Label and limits of a row; the style sheet puts the limits at the slider's ends."""
    lower, upper = r.ends()
    return f"<b>{label}</b><i>{lower}</i><em>{upper}</em>"


def _note(number: int, r: Reading) -> ipywidgets.Label | None:
    if r.bounded:
        return None
    lower, upper = r.ends(r.span)
    text = f"{joint_label(r.kind, number)} has no limits: its slider goes from {lower} to {upper}"
    return ipywidgets.Label(f"{text} {r.unit}", _dom_classes=("dhlab-note",))


def _hex(color: Color) -> str:
    return "#" + "".join(f"{round(255 * part):02x}" for part in color)


def _folding(layout: ipywidgets.Layout) -> Callable[[Any], None]:
    def follow(change: Any) -> None:
        layout.display = None if change.new else "none"

    return follow
