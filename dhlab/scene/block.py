"""Blocks: polyhedra and lines with a pose, and groups of them."""

from __future__ import annotations

from typing import Any, TypedDict, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dhlab.errors import InputError
from dhlab.scene import setting
from dhlab.scene.csys import placement_text
from dhlab.scene.frame_look import frame_nodes
from dhlab.scene.handle import Handle
from dhlab.scene.node import Color, Node, Style
from dhlab.scene.palette import BLOCK, INK
from dhlab.scene.placed import Placed
from dhlab.scene.setting import Setting
from dhlab.scene.way import Link
from dhlab.shapes import Lines, Mesh

PAINT = ("color", "opacity", "edges", "edge_color", "line_width", "show_csys")
"""What a complex block hands on to its components."""


class BlockOptions(TypedDict, total=False):
    """What every block takes by keyword.

    Attributes
    ----------
    name : str
    pose : array_like, shape (4, 4) or (3,)
        Where it stands; at the origin unless given.
    color : str or 3 floats
        ``"#rrggbb"`` or red, green, blue in [0, 1].
    opacity : float in [0, 1]
    edges : bool
        Whether the edges are drawn.
    edge_color : str or 3 floats
    line_width : float [pixel]
        Of edges and lines.
    visible, show_csys : bool
    """

    name: str | None
    pose: ArrayLike
    color: str | ArrayLike | None
    opacity: float
    edges: bool
    edge_color: str | ArrayLike | None
    line_width: float
    visible: bool
    show_csys: bool


class Block(Placed):
    """A polyhedron or a line; made by `block`, `cube`, `cylinder`, ..."""

    __slots__ = (
        "_color",
        "_edge_color",
        "_edges",
        "_line_width",
        "_opacity",
        "_shape",
        "_show_csys",
    )

    kind = "block"

    color: Setting[Color | None] = Setting(
        setting.color, "colour as 3 floats in [0, 1] or '#rrggbb'; None: the default."
    )
    opacity: Setting[float] = Setting(setting.fraction, "float in [0, 1]: 1 hides what is behind.")
    edges: Setting[bool] = Setting(setting.flag, "bool: whether the edges are drawn.")
    edge_color: Setting[Color | None] = Setting(
        setting.color, "colour of the edges; None: darker than the faces."
    )
    line_width: Setting[float] = Setting(
        setting.positive, "float [pixel]: width of edges and lines on the screen."
    )
    show_csys: Setting[bool] = Setting(
        setting.flag, "bool: whether the local coordinate system is drawn."
    )

    def __init__(self, shape: Mesh | Lines, **options: Unpack[BlockOptions]) -> None:
        super().__init__(options.pop("name", None))
        self._shape = shape
        self._color: Color | None = None
        self._opacity = 1.0
        self._edges = True
        self._edge_color: Color | None = None
        self._line_width = 3.0 if isinstance(shape, Lines) else 1.5
        self._show_csys = False
        self.set(**options)

    @property
    def shape(self) -> Mesh | Lines:
        """What is drawn, in the block's own coordinates."""
        return self._shape

    @property
    def vertices(self) -> NDArray[np.float64]:
        """Corners in the block's own coordinates, shape (m, 3) [m]."""
        return self._shape.points if isinstance(self._shape, Lines) else self._shape.vertices

    @property
    def faces(self) -> tuple[tuple[int, ...], ...]:
        """Indices of the corners of each face, from 0; none for a line."""
        return () if isinstance(self._shape, Lines) else self._shape.faces

    def _trail_color(self) -> Color:
        return self._color or BLOCK

    def _nodes(self, path: str, color: Color | None = None) -> dict[str, Node]:
        default = INK if isinstance(self._shape, Lines) else BLOCK
        style = Style(
            color=self._color or color or default,
            opacity=self._opacity,
            edges=self._edges,
            edge_color=self._edge_color,
            line_width=self._line_width,
        )
        nodes = {path: self._own_node()._replace(shape=self._shape, style=style)}
        if self._show_csys:
            low, high = self._shape.bounds
            nodes |= frame_nodes(path, 0.75 * float(np.linalg.norm(high - low)), name=self._name)
        return nodes

    def __repr__(self) -> str:
        size = f"{len(self.vertices)} vertices, {len(self.faces)} faces"
        return f"Block {self.name!r}: {size}, at {placement_text(self.pose)}"


class Shared(Setting[Any]):
    """A setting that a complex block has in common with its components.

    Reading gives the value that all of them have, or None where they differ.
    """

    def value(self, handle: Any) -> Any:
        """Return what the components agree on."""
        values = {getattr(child, self.slot[1:]) for child in handle.components}
        return values.pop() if len(values) == 1 else None


class BlockComplex(Placed):
    """Several blocks managed as one that stay themselves; made by `block_complex`."""

    __slots__ = ("_components",)

    kind = "block_complex"

    color = Shared(setting.color, Block.color.__doc__ or "")
    opacity = Shared(setting.fraction, Block.opacity.__doc__ or "")
    edges = Shared(setting.flag, Block.edges.__doc__ or "")
    edge_color = Shared(setting.color, Block.edge_color.__doc__ or "")
    line_width = Shared(setting.positive, Block.line_width.__doc__ or "")
    show_csys = Shared(setting.flag, Block.show_csys.__doc__ or "")

    def __init__(self, components: tuple[Block | BlockComplex, ...], name: str | None) -> None:
        super().__init__(name)
        self._components: tuple[Block | BlockComplex, ...] = ()
        self._adopt(*components)
        self._components = components

    @property
    def components(self) -> tuple[Block | BlockComplex, ...]:
        """The blocks it is made of; each can be set alone."""
        return self._components

    def children(self) -> tuple[Handle, ...]:
        """Return the component blocks."""
        return self._components

    def way_to(self, child: Handle) -> tuple[Link, ...]:
        """Return the way to what carries a component: the complex itself."""
        return self.way()

    def _trail_color(self) -> Color:
        return self.color or BLOCK

    def _store(self, checked: Any) -> None:
        shared = {key: value for key, value in checked.items() if key in PAINT}
        for child in self._components:
            child._store(shared)
        super()._store({key: value for key, value in checked.items() if key not in PAINT})

    def _nodes(self, path: str, color: Color | None = None) -> dict[str, Node]:
        nodes = {path: self._own_node()}
        for child in self._components:
            nodes |= child._nodes(f"{path}/{child.name}", color)
        return nodes

    def __repr__(self) -> str:
        names = ", ".join(child.name for child in self._components)
        return f"BlockComplex {self.name!r} of {names}, at {placement_text(self.pose)}"


def block_complex(*blocks: Block | BlockComplex, **options: Unpack[BlockOptions]) -> BlockComplex:
    """Join blocks to one that keeps their handles.

    An operation or property set on the complex goes to all; each block can still be set alone.
    The blocks stay where they are; from then on their poses are poses in the complex, and
    moving it moves all.

    Parameters
    ----------
    *blocks : Block or BlockComplex
    **options
        Those of every block (`BlockOptions`).

    Returns
    -------
    B : BlockComplex

    Raises
    ------
    AttachError
        A block belongs to something already, or is given twice.
    InputError
        Two blocks have the same name, or there are none.

    Examples
    --------
    >>> from dhlab.scene.blocks import cube
    >>> legs = block_complex(cube(1, name="left"), cube(1, name="right", pose=(2, 0, 0)))
    >>> legs.color = "#0072b2"
    >>> legs.components[0].color == legs.components[1].color
    True

    References
    ----------
    Pajak, section 3.2.
    """
    _check_blocks(blocks, "block_complex")
    name = options.pop("name", None)
    complex_ = BlockComplex((), name)
    setting.check_settings(complex_, complex_.name, options)
    return BlockComplex(blocks, name).set(**options)


def block_merge(*blocks: Block | BlockComplex, **options: Unpack[BlockOptions]) -> Block:
    """Copy the vertices and faces of several blocks into one block.

    The blocks stay as they are; the new one has nothing more to do with them.

    Parameters
    ----------
    *blocks : Block or BlockComplex
        Polyhedra, each taken where it stands.
    **options
        Those of every block (`BlockOptions`).

    Returns
    -------
    b : Block
        In the coordinates of the world.

    Raises
    ------
    InputError
        A block is a line, or there are none.

    Examples
    --------
    >>> from dhlab.scene.blocks import cube
    >>> len(block_merge(cube(1), cube(2)).faces)
    12

    References
    ----------
    Pajak, sections 2.2 and 3.2.
    """
    _check_blocks(blocks, "block_merge")
    parts = [part for b in blocks for part in _simple(b, b.world_pose)]
    for k, (_, shape) in enumerate(parts, start=1):
        if isinstance(shape, Lines):
            raise InputError(f"block_merge joins polyhedra: part {k} is a line; use block_complex")
    meshes = [shape.transformed(T) for T, shape in parts if isinstance(shape, Mesh)]
    return Block(meshes[0].merged(*meshes[1:]), **options)


def _check_blocks(blocks: tuple[Any, ...], what: str) -> None:
    if not blocks:
        raise InputError(f"{what} needs at least one block, got none")
    for k, b in enumerate(blocks, start=1):
        if not isinstance(b, Block | BlockComplex):
            raise TypeError(f"{what}: argument {k} is a {type(b).__name__}, not a block")


def _simple(
    b: Block | BlockComplex, T: NDArray[np.float64]
) -> list[tuple[NDArray[np.float64], Mesh | Lines]]:
    """Return pose and shape of the simple blocks in `b`, which stands at `T`."""
    if isinstance(b, Block):
        return [(T, b.shape)]
    return [pair for child in b.components for pair in _simple(child, T @ child.pose)]
