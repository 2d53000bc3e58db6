"""A view as one HTML file: it opens from disk, without a kernel, a server or a network.

The file holds the scene as the wire has it, meshcat's viewer and the page's own modules, each
deflated, and a description of the sliders. Two walls keep names and texts from being read as HTML
or code: they are escaped, and the page's content security policy runs the scripts named by their
hashes and nothing else, and loads nothing.
"""

import json
import os
from base64 import b64encode
from collections.abc import Iterable, Iterator, Mapping, Sequence
from hashlib import sha256
from html import escape
from importlib.resources import files
from math import isfinite
from pathlib import Path
from string import Template
from typing import Any
from zlib import compress

from dhlab.errors import InputError
from dhlab.scene.component import Component
from dhlab.scene.handle import Handle
from dhlab.scene.node import Node
from dhlab.scene.reading import Reading, component_readings, joint_label
from dhlab.scene.robot import Robot
from dhlab.view import assets
from dhlab.view.place import checked_path
from dhlab.view.wire import Wire

POLICY = (
    "default-src 'none'; script-src 'unsafe-eval' {}; style-src 'unsafe-inline'; "
    "img-src data: blob:"
)
"""`unsafe-eval` is for those who look into the page: the browser's tools, and tests."""


def save(
    path: str | os.PathLike[str],
    title: str,
    handles: Sequence[Handle],
    nodes: Mapping[str, Node],
    options: Mapping[str, Any],
    lesson: Mapping[str, Any] | None = None,
) -> Path:
    """Write a page that shows a scene; return where.

    Parameters
    ----------
    path : str or path
        An existing file is written over.
    title : str
    handles : sequence of Handle
        What the scene shows.
    nodes : mapping of str to Node
        What is seen of them.
    options : mapping
        Of the view.
    lesson : mapping, optional
        A lesson as `dhlab.view.lesson_html.rendered` tells it; its bar stands in place of
        sliders.

    Raises
    ------
    InputError
        Nothing is shown, or no such page can be written there; then nothing is.
    """
    place = checked_path(path, "a page", "limb.html")
    if not isinstance(title, str) or not title.strip():
        raise InputError(f"the title of a page must be text, not empty, got {title!r}")
    if not handles:
        raise InputError("there is nothing to save: the view shows no handle; add one first")
    text = page(title, handles, Wire(nodes).snapshot(), options, lesson)
    place.write_text(text, encoding="utf-8")
    return place


def page(
    title: str,
    handles: Iterable[Handle],
    snapshot: bytes,
    options: Mapping[str, Any],
    lesson: Mapping[str, Any] | None = None,
) -> str:
    """Return a page that shows a scene, with sliders for the robots among its handles.

    Parameters
    ----------
    title : str
    handles : iterable of Handle
        What the scene shows.
    snapshot : bytes
        The scene, as `dhlab.view.wire.Wire` has it.
    options : mapping
        Of the view: `height`, `background`, `grid`, `controls`.
    lesson : mapping, optional
        As in `save`.

    Returns
    -------
    text : str
        HTML with everything that it needs.
    """
    robots = [] if lesson else [_robot(component) for component in components(handles)]
    about = {"name": title, "options": dict(options), "robots": robots, "lesson": lesson}
    meshcat, start = assets.meshcat(), assets.bundle("unpack")
    viewer = f'(() => {{\n"use strict";\n{assets.bundle("standalone")}}})();\n'
    return Template(static("standalone.html")).substitute(
        policy=POLICY.format(" ".join(map(_hash, (start, meshcat, viewer)))),
        title=escape(title),
        style=static("standalone.css") + static("lesson.css" if lesson else "sliders.css"),
        body=' class="dhlab-lesson"' if lesson else "",
        hidden="" if robots or lesson else " hidden",
        heading="" if lesson else f"<h1>{escape(title)}</h1>",
        about=safe_json(about),
        scene=packed(snapshot),
        viewer=packed(viewer.encode()),
        meshcat=packed(meshcat.encode()),
        start=start,
    )


def components(handles: Iterable[Handle]) -> tuple[Component, ...]:
    """Return the simple robots among handles, each once, in the order of the handles."""
    robots = (handle for handle in handles if isinstance(handle, Robot))
    return tuple(dict.fromkeys(component for robot in robots for component in robot.components))


def _robot(component: Component) -> dict[str, Any]:
    color = "#" + "".join(f"{round(255 * part):02x}" for part in component.color)
    return {"name": component.name, "color": color, "joints": list(_joints(component))}


def _joints(component: Component) -> Iterator[dict[str, Any]]:
    chain = component.chain
    numbers = zip(chain.offset.tolist(), chain.home.tolist(), component.q.tolist(), strict=True)
    joints = zip(component.keys, component_readings(component), numbers, strict=True)
    for i, (key, reading, (offset, home, value)) in enumerate(joints, start=1):
        yield slider(i, key, reading, offset, home, value)


def slider(
    number: int, key: str, reading: Reading, offset: float, home: float, value: float
) -> dict[str, Any]:
    """Describe the slider of one joint, numbers in [rad or m] where nothing else is said.

    On the page a joint's variable has the offset in it; a slider shows ``factor`` times the
    variable without it.

    Parameters
    ----------
    number : int
        Of the joint in its component, from 1.
    key : str
        Of the joint in the page.
    reading : Reading
    offset, home, value : float [rad or m]

    Returns
    -------
    slider : dict
        What ``static/sliders.js`` reads.
    """
    lower, upper = (end if isfinite(end) else None for end in reading.limits)
    label = joint_label(reading.kind, number)
    return {
        "key": key,
        "label": label,
        "kind": reading.kind,
        "lower": lower,
        "upper": upper,
        "span": reading.span,
        "ends": reading.ends(),
        "note": None if reading.bounded else _note(label, reading),
        "offset": offset,
        "home": home,
        "value": value,
        "unit": reading.unit,
        "factor": reading.shown(1.0),
        "decimals": reading.decimals,
    }


def _note(label: str, reading: Reading) -> str:
    lower, upper = reading.ends(reading.span)
    return f"{label} has no limits: its slider goes from {lower} to {upper} {reading.unit}"


def static(name: str) -> str:
    """Return a file of the page's own."""
    return (files("dhlab.view") / "static" / name).read_text(encoding="utf-8")


def safe_json(value: Any) -> str:
    """Write JSON that holds no letter which HTML could take for its own."""
    text = json.dumps(value, allow_nan=False, separators=(",", ":"))
    return text.translate({ord(letter): f"\\u{ord(letter):04x}" for letter in "<>&"})


def packed(content: bytes) -> str:
    """Return bytes deflated, as letters that a page can hold anywhere."""
    return b64encode(compress(content, 9)).decode("ascii")


def _hash(script: str) -> str:
    return f"'sha256-{b64encode(sha256(script.encode()).digest()).decode('ascii')}'"
