"""The four verbs that a picture is changed with, and the difference between two pictures."""

from collections.abc import Iterable, Mapping
from typing import NamedTuple, Protocol, TypeAlias

from dhlab.scene.node import Node, same_body, same_but_for_place, same_paint, same_place


class Put(NamedTuple):
    """A node is new, or draws another shape than before; what hangs on it stays.

    Attributes
    ----------
    path : str
    node : Node
    """

    path: str
    node: Node


class Place(NamedTuple):
    """A node stands elsewhere, or its planned motion is another one.

    Attributes
    ----------
    path : str
    node : Node
        Of this only `pose`, `value` and `curve` are meant.
    """

    path: str
    node: Node


class Paint(NamedTuple):
    """A node looks different.

    Attributes
    ----------
    path : str
    node : Node
        Of this only `style` and `visible` are meant.
    """

    path: str
    node: Node


class Remove(NamedTuple):
    """A node goes, with everything that hangs on it.

    Attributes
    ----------
    path : str
    """

    path: str


Command: TypeAlias = Put | Place | Paint | Remove


class Backend(Protocol):
    """Whatever shows a picture: it takes commands in batches, and knows no handles."""

    def send(self, batch: list[Command]) -> None:
        """Change the picture by one batch, as a whole."""


def diff(old: Mapping[str, Node], new: Mapping[str, Node]) -> list[Command]:
    """Return the commands that turn one picture into another.

    Parameters
    ----------
    old, new : mapping of str to Node
        Pictures by path, parents before their children.

    Returns
    -------
    commands : list of Put, Place, Paint, Remove
        Nothing for a node that did not change; one `Remove` for a subtree that goes.

    Examples
    --------
    >>> import numpy as np
    >>> from dhlab.scene.node import Node
    >>> there = Node(pose=np.diag([1.0, 1, 1, 1]) + np.eye(4, k=3))
    >>> [type(c).__name__ for c in diff({"a": Node(), "b": Node()}, {"a": there, "c": Node()})]
    ['Remove', 'Place', 'Put']
    """
    gone = [path for path in old if path not in new]
    below = set(gone)
    commands: list[Command] = [Remove(path) for path in gone if _parent(path) not in below]
    for path, node in new.items():
        before = old.get(path)
        if before is node:
            continue
        if before is not None and same_but_for_place(before, node):
            if not same_place(before, node):
                commands.append(Place(path, node))
        else:
            commands.extend(_changes(path, before, node))
    return commands


def apply(nodes: dict[str, Node], batch: Iterable[Command]) -> None:
    """Change a picture, a dict of nodes by path, as a batch says.

    Parameters
    ----------
    nodes : dict of str to Node
        Changed in place.
    batch : iterable of Put, Place, Paint, Remove
    """
    for command in batch:
        match command:
            case Place(path, node):
                nodes[path] = _placed(nodes[path], node)
            case Put(path, node):
                nodes[path] = node
            case Paint(path, node):
                nodes[path] = nodes[path]._replace(style=node.style, visible=node.visible)
            case Remove(path):
                for gone in [p for p in nodes if p == path or p.startswith(f"{path}/")]:
                    del nodes[gone]


def _changes(path: str, before: Node | None, node: Node) -> list[Command]:
    if before is None or not same_body(before, node):
        return [Put(path, node)]
    commands: list[Command] = []
    if not same_place(before, node):
        commands.append(Place(path, node))
    if not same_paint(before, node):
        commands.append(Paint(path, node))
    return commands


def _placed(node: Node, place: Node) -> Node:
    """Return a node at the place of another, which may be the same but for its place."""
    if same_but_for_place(node, place):
        return place
    return node._replace(pose=place.pose, value=place.value, curve=place.curve)


def _parent(path: str) -> str:
    return path.rpartition("/")[0]
