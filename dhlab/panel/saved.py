"""What the outputs of a saved notebook show, read from the widget state that was saved with it."""

from base64 import b64decode
from collections.abc import Iterable, Mapping
from math import inf
from typing import Any

import numpy as np

from dhlab.panel.lesson_view import LessonBar
from dhlab.panel.link import Link
from dhlab.panel.table_editor import TableWidget
from dhlab.scene.reading import Reading
from dhlab.view.html import slider
from dhlab.view.widget import SceneWidget

Part = dict[str, Any]

REFERENCE = "IPY_MODEL_"
BOXES = {"HBoxModel": "row", "BoxModel": "row", "VBoxModel": "column", "GridBoxModel": "column"}
KINDS = {"dhlab-lesson": "lesson", "dhlab-beside": "beside"}
HOSTS = {"dhlab-stage-host", "dhlab-bar-host"}
TEXTS = {"LabelModel", "HTMLModel", "HTMLMathModel"}


class Saved:
    """The widgets of a saved notebook.

    Parameters
    ----------
    models : mapping of str to mapping
        By id: what ``application/vnd.jupyter.widget-state+json`` holds under ``state``.

    Attributes
    ----------
    scenes : dict of str to bytes
        Snapshots of the scenes in all parts that were asked for.
    """

    def __init__(self, models: Mapping[str, Any]) -> None:
        self._models = models
        self.scenes: dict[str, bytes] = {}

    def __contains__(self, model: str) -> bool:
        return model in self._models

    def part(self, model: str) -> Part | None:
        """Describe what a widget shows, if anything of dhlab is in it.

        Parameters
        ----------
        model : str
            Its id.

        Returns
        -------
        part : dict or None
            What ``static/living.js`` builds.
        """
        return self._part(model) if any(self._ours(model, set())) else None

    def needed(self, models: Iterable[str]) -> dict[str, Any]:
        """Return some widgets and all that they refer to."""
        found: dict[str, Any] = {}
        waiting = list(models)
        while waiting:
            model = waiting.pop()
            if model in self._models and model not in found:
                found[model] = self._models[model]
                waiting += _references(self._state(model))
        return found

    def _ours(self, model: str, seen: set[str]) -> Iterable[bool]:
        if model not in seen:
            seen.add(model)
            state = self._state(model)
            yield state.get("_anywidget_id") in SHOWN
            for child in _references(state.get("children", ())):
                yield from self._ours(child, seen)

    def _part(self, model: str) -> Part:
        state, name = self._state(model), str(self._models.get(model, {}).get("model_name", ""))
        make = SHOWN.get(str(state.get("_anywidget_id")))
        if make is not None:
            return make(self, model)
        if name in TEXTS:
            return {"words": str(state.get("value", ""))}
        if name in BOXES:
            return self._box(BOXES[name], state)
        return {"words": f"({name.removesuffix('Model') or 'A widget'}: needs a kernel)"}

    def _box(self, kind: str, state: Mapping[str, Any]) -> Part:
        children = _references(state.get("children", ()))
        links = [c for c in children if self._state(c).get("_anywidget_id") == _id(Link)]
        if links:
            return self._sliders(links[0])
        classes = set(state.get("_dom_classes", ()))
        parts = [self._part(child) for child in children]
        if classes & HOSTS and len(parts) == 1:
            return parts[0]
        kind = next((KINDS[c] for c in classes if c in KINDS), kind)
        layout = self._state(str(state.get("layout", "")).removeprefix(REFERENCE))
        return {"kind": kind, "height": _pixels(layout.get("height")), "parts": parts}

    def _scene(self, model: str) -> Part:
        state = self._state(model)
        self.scenes[model] = self._buffer(model, "scene")
        options = {
            "name": str(state.get("name", "view")),
            "height": int(state.get("height", 480)),
            "background": str(state.get("background", "light")),
            "grid": bool(state.get("grid", True)),
            "controls": bool(state.get("controls", False)),
        }
        return {"scene": model, "options": options}

    def _lesson(self, model: str) -> Part:
        state = self._state(model)
        return {"lesson": {**state["lesson"], "answers": state.get("answers", {})}}

    def _table(self, model: str) -> Part:
        names = [str(table["name"]) for table in self._state(model).get("tables", ())]
        return {"words": f"(The table of {', '.join(names)} can be edited with a kernel.)"}

    def _sliders(self, link: str) -> Part:
        robots = self._state(link).get("robots", ())
        told = np.frombuffer(self._buffer(link, "values"))[2:].tolist()
        joints = sum(len(robot["joints"]) for robot in robots)
        shown = iter(told if len(told) == joints else [None] * joints)
        return {"robots": [_robot(robot, shown) for robot in robots]}

    def _state(self, model: str) -> Mapping[str, Any]:
        state: Mapping[str, Any] = self._models.get(model, {}).get("state", {})
        return state

    def _buffer(self, model: str, name: str) -> bytes:
        for buffer in self._models[model].get("buffers", ()):
            if list(buffer["path"]) == [name]:
                is_hex = buffer.get("encoding") == "hex"
                return bytes.fromhex(buffer["data"]) if is_hex else b64decode(buffer["data"])
        return b""


def _robot(robot: Mapping[str, Any], shown: Iterable[float | None]) -> dict[str, Any]:
    """Describe the sliders of one robot as a page without a kernel has them."""
    joints = []
    numbered = zip(range(1, len(robot["joints"]) + 1), robot["joints"], shown, strict=False)
    for number, (key, kind, offset, home, (lower, upper), span), value in numbered:
        limits = (-inf if lower is None else lower, inf if upper is None else upper)
        reading = Reading(kind, limits, (span[0], span[1]))
        meant = home if value is None else reading.meant(value)
        joints.append(slider(number, key, reading, offset, home, meant))
    return {"name": robot["name"], "color": robot["color"], "joints": joints}


def _references(value: Any) -> list[str]:
    """Return the ids of all widgets that a state refers to."""
    if isinstance(value, str):
        return [value.removeprefix(REFERENCE)] if value.startswith(REFERENCE) else []
    inner = value.values() if isinstance(value, Mapping) else value
    if isinstance(value, Mapping | list | tuple):
        return [model for item in inner for model in _references(item)]
    return []


def _pixels(length: Any) -> int | None:
    number = str(length).removesuffix("px")
    return int(number) if number.isdecimal() else None


def _id(widget: type) -> str:
    """Return the name under which anywidget saves a class."""
    return f"{widget.__module__}.{widget.__qualname__}"


SHOWN = {
    _id(SceneWidget): Saved._scene,
    _id(LessonBar): Saved._lesson,
    _id(TableWidget): Saved._table,
    _id(Link): Saved._sliders,
}
