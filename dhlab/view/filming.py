"""Films of planned motions, asked for in Python and made by a page that shows the view."""

import os
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from dhlab.errors import InputError
from dhlab.scene.node import Node
from dhlab.view.outputs import outputs_of, shell_with_kernel
from dhlab.view.place import checked_path

if TYPE_CHECKING:
    from dhlab.view.widget import SceneWidget


class Film:
    """A film on its way; made by `View.save_film`.

    A page plays the motion once, in its own time, and what it sends is heard of when no cell runs:
    a cell cannot wait for it. Shown by a cell, this says how far it is, and when it is there.

    Attributes
    ----------
    path : Path
        Where it will be; another ending than asked for where the browser makes no WebM.
    arrived : bool
        Whether the file has been written.
    trouble : str
        Why there will be none; nothing if all is well.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self.arrived = False
        self.trouble = ""
        self._label: Any = None

    def take(self, content: Mapping[str, Any], buffers: list[Any]) -> None:
        """Take what a page has made, or its excuse; the view's widget calls this."""
        try:
            if "ending" not in content or not buffers:
                self.trouble = str(content.get("trouble") or "the page has sent none")
            else:
                self.path = self.path.with_suffix(f".{_ending(content['ending'])}")
                self.path.write_bytes(bytes(buffers[0]))
                self.arrived = True
        except OSError as error:
            self.trouble = f"{self.path} could not be written ({error.strerror})"
        if self._label is not None:
            self._label.value = repr(self)

    def __repr__(self) -> str:
        if self.trouble:
            return f"no film {self.path}: {self.trouble}"
        if not self.arrived:
            return f"film {self.path}: the page plays the motion; the file comes after that"
        return f"film {self.path}: saved, {self.path.stat().st_size / 1e6:.2f} MB"

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> dict[str, Any]:
        """What a cell shows that ends in this: a line that changes when the film is there."""
        bundle: dict[str, Any] = {"text/plain": repr(self)}
        if shell_with_kernel() is not None:
            import ipywidgets

            self._label = self._label or ipywidgets.Label(repr(self))
            bundle = {**self._label._repr_mimebundle_(), **bundle}
        return bundle


def ask_for_film(
    path: str | os.PathLike[str],
    name: str,
    nodes: Mapping[str, Node],
    widget: "SceneWidget | None",
) -> Film:
    """Ask a page for a film of what a view shows.

    Parameters
    ----------
    path : str or path
        Ends in ``.webm``; a file that exists is written over when the film is there.
    name : str
        Of the view.
    nodes : mapping of str to Node
        What it shows.
    widget : SceneWidget or None
        None where it is shown nowhere.

    Returns
    -------
    film : Film

    Raises
    ------
    InputError
        For a path that cannot be, where nothing moves, and where no page can be.
    """
    place = checked_path(path, "a film", "limb.webm")
    if place.suffix != ".webm":
        raise InputError(f"a film is saved as WebM: 'limb.webm' for one, got {str(place)!r}")
    if not any(node.curve is not None for node in nodes.values()):
        raise InputError(f"nothing moves in {name!r}: plan a motion first, with animate for one")
    shell = shell_with_kernel()
    if widget is None or shell is None or not (widget.heard or outputs_of(shell).has_page()):
        raise InputError(
            f"no page shows {name!r}, and a page makes the film: show the view in a cell first"
        )
    film = Film(place)
    widget.ask_for_film(film.take)
    return film


def _ending(told: Any) -> str:
    """Return the ending of a film that a page has made: one of those it may make."""
    return "mp4" if told == "mp4" else "webm"
