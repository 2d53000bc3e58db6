"""The Jupyter widgets behind a view: the scene, and the viewer that all views of a page share."""

from collections.abc import Callable, Iterable, Mapping
from itertools import count
from typing import Any
from uuid import uuid4

import anywidget
import traitlets
from ipywidgets import widget_serialization

from dhlab.scene.handle import CHANGES
from dhlab.view import assets
from dhlab.view.commands import Command
from dhlab.view.wire import Wire

Take = Callable[[Mapping[str, Any], list[Any]], None]


class Library(anywidget.AnyWidget):
    """Carries the viewer's code into the page: once, however many views there are."""

    _esm = assets.bundle("librarian")
    meshcat = traitlets.Unicode(read_only=True).tag(sync=True)
    viewer = traitlets.Unicode(read_only=True).tag(sync=True)
    digest = traitlets.Unicode(read_only=True).tag(sync=True)

    @traitlets.default("digest")
    def _digest(self) -> str:
        return assets.digest()

    @traitlets.default("meshcat")
    def _meshcat(self) -> str:
        return assets.meshcat()

    @traitlets.default("viewer")
    def _viewer(self) -> str:
        return assets.viewer()


class SceneWidget(anywidget.AnyWidget):
    """Shows one scene in any number of outputs and pages.

    The trait `scene` is never assigned. Whoever asks for it, when the widget is created and when
    a page loads again, gets the scene as it is then; in between the page gets batches, numbered
    so that it notices when one is missing.

    Parameters
    ----------
    wire : Wire
        The scene, and what the page has been told of it.
    library : Library
    **options
        `name`, `height`, `background`, `grid`, `controls` of the view.

    Attributes
    ----------
    heard : bool
        Whether a page has ever said a word.
    """

    _esm = assets.bundle("loader")
    scene = traitlets.Bytes(read_only=True).tag(sync=True)
    library = traitlets.Instance(Library).tag(sync=True, **widget_serialization)
    library_digest = traitlets.Unicode().tag(sync=True)
    own_id = traitlets.Unicode().tag(sync=True)
    name = traitlets.Unicode().tag(sync=True)
    height = traitlets.Int(480).tag(sync=True)
    background = traitlets.Unicode("light").tag(sync=True)
    grid = traitlets.Bool(True).tag(sync=True)
    controls = traitlets.Bool(False).tag(sync=True)

    def __init__(self, wire: Wire, library: Library, **options: Any) -> None:
        self._wire = wire
        self._kept = -1
        self._films: dict[int, Take] = {}
        self._numbers = count(1)
        self.heard = False
        self._is_new = True
        own_id = uuid4().hex
        super().__init__(
            model_id=own_id,
            own_id=own_id,
            library=library,
            library_digest=library.digest,
            layout={"width": "100%"},
            **options,
        )
        self._is_new = False
        self.on_msg(self._answer)

    def send_batch(self, batch: list[Command]) -> None:
        """Tell the page of a batch, in one message."""
        header, buffer = self._wire.batch(batch)
        self.send(header, [buffer])

    def ask_for_film(self, take: Take) -> None:
        """Let a page film the planned motion; `take` hears of what the first one has made."""
        number = next(self._numbers)
        self._films[number] = take
        self.send({"kind": "film", "number": number})

    def close(self) -> None:
        """Take the widget out of the page; films that it still waits for will not come."""
        films = list(self._films.values())
        self._films.clear()
        super().close()
        for take in films:
            take({"trouble": "the view was closed before it was made"}, [])

    def keep(self) -> None:
        """Tell the scene as it is now as state, if it has changed since this was last called."""
        if self._kept != self._wire.sequence:
            self._kept = self._wire.sequence
            self.send_state("scene")

    def get_state(
        self, key: str | Iterable[str] | None = None, drop_defaults: bool = False
    ) -> dict[str, Any]:
        """State for a page, with the scene as it is now."""
        state: dict[str, Any] = super().get_state(key, drop_defaults)
        if key is None or key == "scene" or (not isinstance(key, str) and "scene" in key):
            with CHANGES:
                state["scene"] = self._wire.snapshot(play=self._is_new)
        return state

    def _answer(self, widget: Any, content: Any, buffers: Any) -> None:
        if not isinstance(content, dict):
            return
        self.heard = True
        if content.get("ask") == "scene":
            with CHANGES:
                if content.get("have") != self._wire.sequence:
                    self.send_state("scene")
        elif content.get("film") in self._films:
            self._films.pop(content["film"])(content, buffers)


class WidgetBackend:
    """Sends batches to a widget, which is made with the scene as it is.

    Attributes
    ----------
    widget : SceneWidget

    Parameters
    ----------
    wire : Wire
    **options
        Of the widget.
    """

    def __init__(self, wire: Wire, **options: Any) -> None:
        self.widget = SceneWidget(wire, shared_library(), **options)

    def send(self, batch: list[Command]) -> None:
        """Tell the page of a batch.

        Parameters
        ----------
        batch : list of Put, Place, Paint, Remove
        """
        self.widget.send_batch(batch)

    def close(self) -> None:
        """Take the widget out of the page and, with its layout, out of ipywidgets' registry."""
        layout = self.widget.layout
        self.widget.close()
        layout.close()


def _library_keeper() -> Callable[[], Library]:
    kept: list[Library] = []

    def shared() -> Library:
        """Return the one library of this kernel, made when it is first needed or was closed."""
        if not kept or kept[0].comm is None:
            kept[:] = [Library()]
        return kept[0]

    return shared


shared_library = _library_keeper()
