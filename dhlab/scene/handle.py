"""The base of everything that can be seen: a name, who watches, and how a change is told."""

from __future__ import annotations

import threading
import weakref
from collections.abc import Iterable, Iterator, Mapping
from typing import Any, ClassVar, Protocol, Self

import numpy as np
from numpy.typing import NDArray

from dhlab.arrays import as_name
from dhlab.errors import AttachError, InputError
from dhlab.scene.node import Node
from dhlab.scene.setting import Setting, check_settings, flag
from dhlab.scene.way import Link, MotionAlong, end_of

CHANGES = threading.RLock()
"""Held while a change is made and while a handle is described: nobody sees half of a change."""


class Observer(Protocol):
    """Who watches a handle: a view, a panel."""

    def handle_changed(self, handle: Handle) -> None:
        """Take note; called with `CHANGES` held, so be quick."""


class Handle:
    """Something with an identity that views show and follow.

    Two handles are equal only if they are the same one. A setting is checked before anything
    changes; everybody who watches hears of a change once, after it.

    Parameters
    ----------
    name : str, optional
        Unique among its siblings; where it is not given the parent makes one up.
    """

    __slots__ = (
        "__weakref__",
        "_carried",
        "_marks",
        "_motion_alone",
        "_name",
        "_observers",
        "_parent",
        "_visible",
    )

    kind: ClassVar[str] = "handle"

    visible: Setting[bool] = Setting(flag, "bool: whether it and all it carries is drawn.")

    def __init__(self, name: str | None = None) -> None:
        self._name = None if name is None else as_name(name, f"name of a {self.kind}")
        self._observers: weakref.WeakKeyDictionary[Observer, None] | None = None
        self._parent: Handle | None = None
        self._carried: tuple[Handle, ...] | None = None
        self._marks: dict[str, Node] = {}
        self._motion_alone: MotionAlong | None = None
        self._visible = True

    @property
    def name(self) -> str:
        """Name of the handle, the kind of it (``'block'``) where none was given.

        Raises
        ------
        InputError
            On assignment of a name that a sibling has, or that is not a name.
        """
        return self.kind if self._name is None else self._name

    @name.setter
    def name(self, value: str) -> None:
        name = as_name(value, f"name of '{self.name}'")
        with CHANGES:
            siblings = () if self._parent is None else self._parent.children()
            if any(other is not self and other.name == name for other in siblings):
                raise InputError(f"name of '{self.name}': a sibling is called {name!r} already")
            self._name = name
            self._changed()

    @property
    def parent(self) -> Handle | None:
        """The handle that carries this one, or None."""
        return self._parent

    @property
    def root(self) -> Handle:
        """The handle at the top of all that carries this one; itself where nothing does."""
        return self if self._parent is None else self._parent.root

    @property
    def world_pose(self) -> NDArray[np.float64]:
        """Pose in the world frame, shape (4, 4)."""
        return end_of(self.way())

    def way(self) -> tuple[Link, ...]:
        """Return the frames from the world to this handle's own, each in the one before."""
        raise NotImplementedError

    def way_to(self, child: Handle) -> tuple[Link, ...]:
        """Return the frames from the world to the one that a child of this handle stands in."""
        raise NotImplementedError

    def set(self, **values: Any) -> Self:
        """Set several properties at once; all are checked before the first is changed.

        Parameters
        ----------
        **values
            Properties by name.

        Returns
        -------
        handle : the handle itself
        """
        with CHANGES:
            self._store(check_settings(self, self.name, values))
            self._changed()
        return self

    def children(self) -> tuple[Handle, ...]:
        """Return the handles that this one carries."""
        return ()

    def walk(self) -> tuple[Handle, ...]:
        """Return this handle and all that it carries, parents first."""
        if self._carried is None:
            self._carried = tuple(other for child in self.children() for other in child.walk())
        return (self, *self._carried)

    def watch(self, observer: Observer) -> None:
        """Tell `observer` of every change from now on; it is held weakly.

        Who watches first hears first, so that a view made before its panel moves before it.
        """
        if self._observers is None:
            self._observers = weakref.WeakKeyDictionary()
        self._observers.setdefault(observer)

    def unwatch(self, observer: Observer) -> None:
        """Tell `observer` no more; safe if it did not watch."""
        if self._observers is not None:
            self._observers.pop(observer, None)

    def describe(self, name: str | None = None) -> dict[str, Node]:
        """Say what is to be drawn.

        Parameters
        ----------
        name : str, optional
            First segment of the paths; the handle's own name unless given.

        Returns
        -------
        nodes : dict of str to Node
            Parents before children. The first node stands in the world, whatever carries it;
            what motions left behind follows under ``name.traces`` and ``name.ghosts``, and under
            ``name.2.traces`` for those of the second handle that this one carries.
        """
        name = self.name if name is None else name
        with CHANGES:
            nodes = self._nodes(name)
            if self._parent is not None:
                nodes[name] = self._alone(nodes[name])
            for number, handle in enumerate(self.walk()):
                if not handle._marks:
                    continue
                whose = f"{name}.{number}" if number else name
                for path, node in handle._marks.items():
                    nodes[f"{whose}.{path}"] = node
        return nodes

    def clear_traces(self) -> None:
        """Remove the traces and ghosts that a motion of this handle left."""
        with CHANGES:
            self.leave_marks({})
            self._changed()

    def leave_marks(self, marks: dict[str, Node]) -> None:
        """Draw marks in the world in place of the old ones; the lock is held, nobody is told."""
        self._marks = marks

    def tell(self) -> None:
        """Tell everybody who watches that something has changed."""
        with CHANGES:
            self._changed()

    def _nodes(self, path: str) -> dict[str, Node]:
        """Nodes of this handle below `path`, the first with its pose in its parent."""
        raise NotImplementedError

    def _alone(self, node: Node) -> Node:
        """Return this handle's first node as it stands and moves in the world."""
        way = self.way()
        self._motion_alone = self._motion_alone or MotionAlong()
        return node._replace(pose=end_of(way), curve=self._motion_alone(way))

    def _carrier(self) -> tuple[Link, ...]:
        """Return the way to the frame that this handle stands in; none in the world's own."""
        return () if self._parent is None else self._parent.way_to(self)

    def _store(self, checked: Mapping[str, Any]) -> None:
        """Keep checked values; the lock is held."""
        for key, value in checked.items():
            setattr(self, f"_{key}", value)

    def _forget(self) -> None:
        """Forget what was worked out from the state before a change; the lock is held."""
        self._carried = None

    def _changed(self) -> None:
        """Tell everybody who watches anything in this tree; the lock is held."""
        for handle in self.root.walk():
            handle._forget()
        self._moved()

    def _moved(self) -> None:
        """Tell everybody of a change that only moves joints; the lock is held."""
        for handle in self.root.walk():
            if handle._observers:
                for observer in tuple(handle._observers):
                    observer.handle_changed(handle)

    def _adopt(self, *children: Handle) -> None:
        """Become the parent of handles that have none; all are checked first."""
        self._check_free(*children)
        names = Names(child.name for child in self.children())
        for child in children:
            if child._name in names:
                raise InputError(f"two parts of '{self.name}' are called {child._name!r}")
            if child._name is not None:
                names.take(child._name)
        for child in children:
            if child._name is None:
                child._name = names.take(child.kind)
            child._parent = self
        for handle in self.ancestors():
            handle._carried = None

    def _check_free(self, *children: Handle) -> None:
        """Refuse handles that hang somewhere already, or that carry this one."""
        ancestors = set(self.ancestors())
        for k, child in enumerate(children):
            if child in ancestors:
                raise AttachError(
                    f"'{child.name}' cannot hang on '{self.name}', which it is or carries"
                )
            if child._parent is not None or child in children[:k]:
                other = self if child._parent is None else child._parent
                raise AttachError(
                    f"'{child.name}' is attached to '{other.name}' already; make a second one"
                )

    def ancestors(self) -> Iterator[Handle]:
        """Go through this handle and all that carry it, upwards."""
        handle: Handle | None = self
        while handle is not None:
            yield handle
            handle = handle._parent


class Names:
    """Names that are taken, among siblings or in a picture.

    Parameters
    ----------
    taken : iterable of str

    Examples
    --------
    >>> names = Names(["block", "block_2"])
    >>> names.take("block"), names.take("block"), names.take("arm")
    ('block_3', 'block_4', 'arm')
    >>> names.give("block_3")
    >>> names.take("block")
    'block_3'
    """

    def __init__(self, taken: Iterable[str] = ()) -> None:
        self._taken = set(taken)
        self._counts: dict[str, int] = {}

    def __contains__(self, name: object) -> bool:
        return name in self._taken

    def take(self, name: str) -> str:
        """Take `name`, or `name_2`, `name_3`, ... : the first that is free; return which."""
        free, count = name, self._counts.get(name, 1)
        while free in self._taken:
            count += 1
            free = f"{name}_{count}"
        self._counts[name] = count
        self._taken.add(free)
        return free

    def give(self, name: str) -> None:
        """Give a name back."""
        self._taken.discard(name)
        self._counts.clear()
