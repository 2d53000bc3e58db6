"""The colours of dhlab: components, axes, ghosts; told apart by colour-blind people too."""

from __future__ import annotations

from dhlab.arrays import as_color
from dhlab.scene.node import Color

COMPONENTS: tuple[Color, ...] = tuple(
    as_color(text, "palette")
    for text in (
        "#0072b2",
        "#e69f00",
        "#009e73",
        "#cc79a7",
        "#56b4e9",
        "#d55e00",
        "#b8a800",
        "#7f7f8c",
    )
)
"""One per component robot, in order and round again: Okabe and Ito's palette, its yellow
darkened for a white wall and its black made grey (Okabe and Ito, Color Universal Design, 2008)."""

AXES: tuple[Color, Color, Color] = (
    as_color("#d1342f", "palette"),
    as_color("#2a9d3c", "palette"),
    as_color("#2f6fd6", "palette"),
)
"""x, y, z: red, green, blue as everywhere."""

BLOCK: Color = as_color("#9fa8b3", "palette")
"""A block without a colour of its own."""

METAL: Color = as_color("#4a5058", "palette")
"""Sleeves, rails, bases and grippers of the solid look."""

INK: Color = as_color("#2b2f36", "palette")
"""Lines and texts without a colour of their own."""


def component_color(index: int) -> Color:
    """Colour of component number `index` of a mechanism, from 0."""
    return COMPONENTS[index % len(COMPONENTS)]
