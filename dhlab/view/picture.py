"""What a view shows of its handles, and what changed since it was last asked."""

from collections.abc import Iterator, Mapping
from types import MappingProxyType

from dhlab.scene.handle import Handle, Names
from dhlab.scene.node import Node
from dhlab.view.commands import Command, diff


class Picture:
    """Handles under names of their own, and their nodes as they were last described.

    It does not watch the handles: somebody tells it which have changed. Whoever calls holds
    `dhlab.scene.handle.CHANGES`.

    Examples
    --------
    >>> from dhlab.scene.csys import Csys
    >>> picture = Picture()
    >>> frame = Csys()
    >>> picture.add(frame), picture.add(Csys())
    ('csys', 'csys_2')
    >>> len(picture.changes()) > 0, picture.changes()
    (True, [])
    """

    def __init__(self) -> None:
        self._names: dict[Handle, str] = {}
        self._taken = Names()
        self._drawn: dict[str, dict[str, Node]] = {}
        self._stale: set[Handle] = set()
        self._gone: set[str] = set()

    def __iter__(self) -> Iterator[Handle]:
        return iter(self._names)

    def __contains__(self, handle: object) -> bool:
        return handle in self._names

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the handles in this picture, in the order they were added."""
        return tuple(self._names.values())

    @property
    def nodes(self) -> Mapping[str, Node]:
        """Nodes by path as they were last described; read-only."""
        drawn = (self._drawn.get(name, {}) for name in self._names.values())
        return MappingProxyType({path: node for nodes in drawn for path, node in nodes.items()})

    def add(self, handle: Handle) -> str:
        """Take a handle in, under its name or the name with a number; return which."""
        self._names[handle] = self._taken.take(handle.name)
        self._stale.add(handle)
        return self._names[handle]

    def remove(self, handle: Handle) -> None:
        """Drop a handle."""
        self._stale.discard(handle)
        name = self._names.pop(handle)
        self._taken.give(name)
        self._gone.add(name)

    def touch(self, handle: Handle) -> None:
        """Note that a handle has changed."""
        self._stale.add(handle)

    def changes(self) -> list[Command]:
        """Return the commands from what was described last to what is there now.

        With a handle go all those that hang together with it: a change of a robot is one batch,
        also where its parts are shown one by one.
        """
        roots = {handle.root for handle in self._stale}
        batch: list[Command] = []
        for name in sorted(self._gone - set(self._names.values())):
            batch.extend(diff(self._drawn.pop(name, {}), {}))
        for handle, name in self._names.items():
            if handle.root in roots:
                now = handle.describe(name)
                batch.extend(diff(self._drawn.get(name, {}), now))
                self._drawn[name] = now
        self._stale.clear()
        self._gone.clear()
        return batch
