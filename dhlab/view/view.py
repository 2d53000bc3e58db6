"""A view: it shows handles, follows them, and sends only what changed."""

import os
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, Self

from dhlab.arrays import as_name, as_number
from dhlab.errors import InputError
from dhlab.scene.handle import CHANGES, Handle
from dhlab.scene.node import Node
from dhlab.view.commands import Backend
from dhlab.view.outputs import outputs_of, shell_with_kernel
from dhlab.view.pace import Pace
from dhlab.view.picture import Picture
from dhlab.view.place import checked_path
from dhlab.view.raster import still_picture
from dhlab.view.recording import RecordingBackend

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from dhlab.view.filming import Film
    from dhlab.view.widget import SceneWidget, WidgetBackend

BACKGROUNDS = ("light", "dark")
WIDGET = "application/vnd.jupyter.widget-view+json"


class View:
    """A window onto handles; a cell that ends in a view shows it.

    Every change of a handle, by whomever, is seen in all its views. A view costs nothing before
    it is shown. With ``DHLAB_VIEW=record`` in the environment it is never shown: it remembers
    what would be seen.

    Parameters
    ----------
    name : str, optional
    height : int [pixel]
    background : {'light', 'dark'}
    grid : bool
        Whether the ground shows a grid in metres.
    controls : bool
        Whether meshcat's own control bar is shown.
    backend : Backend, optional
        Something else than a Jupyter widget to show the picture.

    Examples
    --------
    >>> from dhlab.scene.csys import Csys
    >>> frame = Csys(name="frame")
    >>> view = View("bench").add(frame)
    >>> view
    View('bench': frame)
    >>> frame.pose = frame.pose
    >>> "frame" in view.nodes
    True
    >>> View(background="blue")
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: no background 'blue'; use 'light' or 'dark'
    """

    def __init__(
        self,
        name: str | None = None,
        *,
        height: int = 480,
        background: Literal["light", "dark"] = "light",
        grid: bool = True,
        controls: bool = False,
        backend: Backend | None = None,
    ) -> None:
        self.name = "view" if name is None else as_name(name, "name of a view")
        if background not in BACKGROUNDS:
            raise InputError(f"no background {background!r}; use 'light' or 'dark'")
        self._options = {
            "height": int(as_number(height, f"height of {self.name!r}", minimum=40)),
            "background": background,
            "grid": bool(grid),
            "controls": bool(controls),
        }
        self._picture = Picture()
        self._pace = Pace(self.flush)
        self._shown: WidgetBackend | None = None
        self._backend: Backend | None = backend
        if backend is None and os.environ.get("DHLAB_VIEW") == "record":
            self._backend = RecordingBackend()

    @property
    def handles(self) -> tuple[Handle, ...]:
        """What the view shows, in the order it was added."""
        return tuple(self._picture)

    @property
    def nodes(self) -> Mapping[str, Node]:
        """What is seen: nodes by path, parents before their children; read-only.

        The first segment of a path is the handle's name in this view, with a number behind it
        where two handles have the same name.
        """
        with CHANGES:
            self.flush()
            return self._picture.nodes

    @property
    def widget(self) -> "SceneWidget":
        """The Jupyter widget of this view, to lay it out beside others.

        It stays open until `close` is called.
        """
        from dhlab.view.widget import WidgetBackend, shared_library
        from dhlab.view.wire import Wire

        with CHANGES:
            if self._shown is None or self._shown.widget.comm is None:
                shared_library()  # the page loads the viewer while the scene is described
                self._shown = WidgetBackend(Wire(self.nodes), name=self.name, **self._options)
                self._backend = self._shown
                shell = shell_with_kernel()
                if shell is not None:
                    outputs_of(shell).keep(self)
            return self._shown.widget

    @property
    def options(self) -> Mapping[str, Any]:
        """How it is shown: `height`, `background`, `grid`, `controls`."""
        return dict(self._options)

    def add(self, *handles: Handle) -> Self:
        """Show handles; those that are shown already stay as they are.

        Parameters
        ----------
        *handles : Handle
            Coordinate systems, blocks, robots.

        Returns
        -------
        view : the view itself

        Raises
        ------
        InputError
            For anything that is not a handle; then none is added.
        """
        for handle in handles:
            if not isinstance(handle, Handle):
                raise InputError(
                    f"{self.name!r} shows coordinate systems, blocks and robots, got {handle!r}"
                )
        with CHANGES:
            for handle in handles:
                if handle not in self._picture:
                    self._picture.add(handle)
                    handle.watch(self)
            self._send_soon()
        return self

    def remove(self, *handles: Handle) -> None:
        """Show some handles no more.

        Parameters
        ----------
        *handles : Handle

        Raises
        ------
        InputError
            For a handle that is not shown here; then none is removed.
        """
        with CHANGES:
            for handle in handles:
                if handle not in self._picture:
                    there = ", ".join(self._picture.names) or "nothing"
                    what = repr(getattr(handle, "name", handle))
                    raise InputError(f"{self.name!r} does not show {what}; it shows {there}")
            for handle in dict.fromkeys(handles):
                handle.unwatch(self)
                self._picture.remove(handle)
            self._send_soon()

    def clear(self) -> None:
        """Show nothing."""
        self.remove(*self._picture)

    def handle_changed(self, handle: Handle) -> None:
        """Take note that a handle changed; the handle calls this, with `CHANGES` held."""
        self._picture.touch(handle)
        self._send_soon()

    def flush(self) -> None:
        """Send now what waits to be sent."""
        with CHANGES:
            batch = self._picture.changes()
            if batch and self._backend is not None:
                self._backend.send(batch)

    def keep(self) -> None:
        """Tell a client that keeps state and no messages what is seen now; the kernel calls this.

        ``nbconvert --execute`` is such a client: the saved notebook then shows the last state.
        """
        with CHANGES:
            self.flush()
            if self._shown is not None and self._shown.widget.comm is not None:
                self._shown.widget.keep()

    def save_html(self, path: str | os.PathLike[str], title: str | None = None) -> Path:
        """Save what is seen as one HTML file, with sliders for the robots and their motions.

        It opens from disk by double click, without a kernel, a server or a network.

        Parameters
        ----------
        path : str or path
            An existing file is written over.
        title : str, optional
            Over the sliders; the view's name if not given.

        Returns
        -------
        path : Path

        Raises
        ------
        InputError
            The view shows nothing, or there is no such folder; then nothing is written.
        """
        from dhlab.view.html import save

        shown = self.name if title is None else title
        with CHANGES:
            return save(path, shown, self.handles, self.nodes, self._options)

    def save_png(
        self,
        path: str | os.PathLike[str],
        *,
        width: int = 900,
        height: int = 600,
        seen_from: "str | ArrayLike" = "first",
    ) -> Path:
        """Save a picture of what is seen, painted without a browser.

        Parameters
        ----------
        path : str or path
            An existing file is written over.
        width, height : int [pixel]
        seen_from : {'first', 'front', 'top', 'side', 'isometric'} or array_like, shape (3,)
            From where one looks: a direction from the scene to the camera.

        Returns
        -------
        path : Path

        Raises
        ------
        InputError
            For a path, a size or a direction that cannot be; then nothing is written.
        """
        from dhlab.view.still import still

        place = checked_path(path, "a picture", "limb.png")
        background = str(self._options["background"])
        png = still(
            self.nodes, width=width, height=height, seen_from=seen_from, background=background
        )
        place.write_bytes(png)
        return place

    def save_film(self, path: str | os.PathLike[str]) -> "Film":
        """Save a film of the planned motion, which the page that shows the view makes.

        It returns at once. The page plays the motion from its first instant to its last, and the
        file is written when that is over and no cell runs; what is returned says so.

        Parameters
        ----------
        path : str or path
            Ends in ``.webm``.

        Returns
        -------
        film : Film
            With `path`, `arrived` and `trouble`; as the last line of a cell it says how far it is.

        Raises
        ------
        InputError
            For a path that cannot be, where nothing moves, and where no page can be.
        """
        from dhlab.view.filming import ask_for_film

        widget = None if self._shown is None else self._shown.widget
        return ask_for_film(path, self.name, self.nodes, widget)

    def close(self) -> None:
        """Close the view's widget and the pictures it shows; it can be shown again."""
        with CHANGES:
            self._pace.stop()
            if self._shown is not None:
                self._shown.close()
                self._shown = self._backend = None

    def __repr__(self) -> str:
        shown = ", ".join(self._picture.names)
        return f"View({self.name!r}{': ' if shown else ''}{shown})"

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> dict[str, Any]:
        """What a cell that ends in this view shows: the picture, or else a line of text.

        A front end without widgets has a small still picture.
        """
        bundle: dict[str, Any] = {"text/plain": repr(self)}
        shell = shell_with_kernel()
        if shell is not None and (self._backend is None or self._shown is not None):
            bundle[WIDGET] = {
                "version_major": 2,
                "version_minor": 0,
                "model_id": self.widget.model_id,
            }
            bundle |= still_picture(self.nodes, str(self._options["background"]))
            outputs_of(shell).note(self)
        return bundle

    def _send_soon(self) -> None:
        """Send what changed in time; a recording view waits until it is looked at."""
        if self._backend is not None and not isinstance(self._backend, RecordingBackend):
            self._pace.ask()
