"""The wire format: a JSON header and one binary buffer, for a change or for a whole scene.

The other end is ``static/wire.js``. A header refers to the buffer by byte offsets; floats and
integers are little-endian, poses the first three rows of their matrix. What moves often is small:
a joint is one float64 and the uint32 number of its node, a pose twelve float32. What is sent once
(a node's constants) is float64, so that the page's own forward kinematics is as good as Python's.
"""

import json
from collections.abc import Iterable, Mapping
from itertools import count
from typing import Any

import numpy as np
from numpy.typing import NDArray

from dhlab.scene.node import Curve, Joint, Node, Shape, Style
from dhlab.shapes import Label, Lines, Mesh
from dhlab.view.commands import Command, Paint, Place, Put, Remove, apply, diff

FORMAT = 1

Header = dict[str, Any]


class Wire:
    """What one page model has been told: the scene, its numbering and the number of the batch.

    Attributes
    ----------
    nodes : dict of str to Node
        The scene as it was told.
    sequence : int
        Number of the last batch.
    """

    def __init__(self, nodes: Mapping[str, Node]) -> None:
        self.nodes: dict[str, Node] = {}
        self.sequence = 0
        self._numbers: dict[str, int] = {}
        self._unused = count(1)
        self._remember(diff({}, nodes))

    def batch(self, commands: list[Command]) -> tuple[Header, bytes]:
        """Header and buffer of the next batch; from then on it counts as told.

        Parameters
        ----------
        commands : list of Put, Place, Paint, Remove

        Returns
        -------
        header : dict
        buffer : bytes
        """
        self.sequence += 1
        message = _Message(self.sequence)
        known = {node.shape.digest for node in self.nodes.values() if node.shape is not None}
        clocks = {node.curve.clock.key for node in self.nodes.values() if node.curve is not None}
        before = {c.path: self.nodes.get(c.path) for c in commands if not isinstance(c, Remove)}
        message.remove(self._numbers[c.path] for c in commands if isinstance(c, Remove))
        self._remember(commands)
        for command in commands:
            match command:
                case Put(path, node):
                    message.put(self._numbers[path], path, node, known, clocks)
                case Place(path, node):
                    message.place(self._numbers[path], before[path], node, clocks)
                case Paint(path, node):
                    message.paint(self._numbers[path], node)
        return message.finish()

    def snapshot(self, play: bool = False) -> bytes:
        """Return the whole scene as it was told, in one piece.

        Parameters
        ----------
        play : bool
            Whether planned motions start to play; otherwise their last state is shown.

        Returns
        -------
        snapshot : bytes
            Length of the header (uint32), the header, padding to 8 bytes, the buffer.
        """
        message = _Message(self.sequence)
        known: set[str] = set()
        clocks: set[str] = set()
        for path, node in self.nodes.items():
            message.put(self._numbers[path], path, node, known, clocks)
        header, buffer = message.finish()
        header |= {"fresh": True, "play": sorted(clocks) if play else []}
        text = json.dumps(header, separators=(",", ":")).encode()
        start = len(text).to_bytes(4, "little") + text
        return start + bytes(-len(start) % 8) + buffer

    def _remember(self, commands: Iterable[Command]) -> None:
        commands = list(commands)
        apply(self.nodes, commands)
        for command in commands:
            if isinstance(command, Put) and command.path not in self._numbers:
                self._numbers[command.path] = next(self._unused)
        if any(isinstance(command, Remove) for command in commands):
            self._numbers = {path: self._numbers[path] for path in self.nodes}


class _Message:
    """A header and a buffer that grow command by command."""

    def __init__(self, sequence: int) -> None:
        self._header: Header = {"kind": "batch", "format": FORMAT, "seq": sequence}
        self._chunks: list[bytes] = []
        self._size = 0
        self._styles: dict[Style, int] = {}
        self._joints: list[tuple[int, float]] = []
        self._poses: list[tuple[int, NDArray[np.float64]]] = []

    def remove(self, numbers: Iterable[int]) -> None:
        """Nodes that go."""
        self._extend("removes", list(numbers))

    def put(self, number: int, path: str, node: Node, known: set[str], clocks: set[str]) -> None:
        """Add a node that is new or draws another shape; geometry the page has is only named."""
        entry: Header = {"id": number, "path": path, "pose": self._pack(node.pose[:3], "<f8")}
        entry["style"] = self._style(node.style)
        if node.joint is not None:
            entry |= {"joint": _joint(node.joint), "value": float(node.value)}
        if node.shape is not None:
            entry["shape"] = node.shape.digest
            self._geometry(node.shape, known)
        if not node.visible:
            entry["visible"] = False
        if node.curve is not None:
            entry["curve"] = self._curve(node.curve, clocks)
        self._extend("puts", [entry])

    def place(self, number: int, before: Node | None, node: Node, clocks: set[str]) -> None:
        """Move a node: of a joint the value, of any other the pose, and its motion if it is new."""
        if node.joint is not None:
            self._joints.append((number, node.value))
        if node.joint is None or before is None or not np.array_equal(before.pose, node.pose):
            self._poses.append((number, node.pose))
        if before is None or before.curve is not node.curve:
            curve = None if node.curve is None else self._curve(node.curve, clocks)
            self._extend("curves", [(number, curve)])

    def paint(self, number: int, node: Node) -> None:
        """Paint a node."""
        self._extend("paints", [(number, self._style(node.style), node.visible)])

    def finish(self) -> tuple[Header, bytes]:
        """Header and buffer, what moved packed into two arrays each."""
        if self._joints:
            ids, values = zip(*self._joints, strict=True)
            self._header["joints"] = {
                "count": len(ids),
                "values": self._pack(values, "<f8"),
                "ids": self._pack(ids, "<u4"),
            }
        if self._poses:
            ids, poses = zip(*self._poses, strict=True)
            self._header["poses"] = {
                "count": len(ids),
                "matrices": self._pack(np.stack(poses)[:, :3], "<f4"),
                "ids": self._pack(ids, "<u4"),
            }
        if self._styles:
            self._header["styles"] = [_style(style) for style in self._styles]
        return self._header, b"".join(self._chunks)

    def _geometry(self, shape: Shape, known: set[str]) -> None:
        if shape.digest in known:
            return
        known.add(shape.digest)
        self._header.setdefault("geometry", {})[shape.digest] = self._shape(shape)

    def _shape(self, shape: Shape) -> Header:
        if isinstance(shape, Label):
            return {"kind": "label", "text": shape.text, "size": shape.size}
        if isinstance(shape, Lines):
            ends = shape.points[shape.segments]
            return {"kind": "lines", "count": len(ends), "segments": self._pack(ends, "<f4")}
        return self._mesh(shape)

    def _mesh(self, mesh: Mesh) -> Header:
        positions, normals, index = mesh.render_arrays()
        return {
            "kind": "mesh",
            "vertices": len(positions),
            "positions": self._pack(positions, "<f4"),
            "normals": self._pack(normals, "<f4"),
            "triangles": len(index),
            "indices": self._pack(index, "<u4"),
            "segments": len(mesh.edges),
            "edges": self._pack(mesh.vertices[mesh.edges], "<f4"),
        }

    def _curve(self, curve: Curve, clocks: set[str]) -> Header:
        clock, samples = curve.clock, np.asarray(curve.samples)
        if clock.key not in clocks:
            clocks.add(clock.key)
            times = {"count": len(clock.times), "at": self._pack(clock.times, "<f8")}
            self._header.setdefault("clocks", {})[clock.key] = times
        poses = samples.ndim == 3
        at = self._pack(samples[:, :3], "<f4") if poses else self._pack(samples, "<f8")
        return {"clock": clock.key, "count": len(samples), "width": 12 if poses else 1, "at": at}

    def _style(self, style: Style) -> int:
        return self._styles.setdefault(style, len(self._styles))

    def _extend(self, key: str, entries: list[Any]) -> None:
        if entries:
            self._header.setdefault(key, []).extend(entries)

    def _pack(self, numbers: Any, kind: str) -> int:
        """Append an array to the buffer; return the offset, a multiple of 8, where it begins."""
        at = self._size
        chunk = np.ascontiguousarray(numbers, dtype=kind).tobytes()
        chunk += bytes(-len(chunk) % 8)
        self._chunks.append(chunk)
        self._size += len(chunk)
        return at


def _joint(joint: Joint) -> Header:
    still = np.array_equal(joint.after, np.eye(4))
    after = None if still else joint.after[:3].ravel().tolist()
    return {"kind": joint.kind, "key": joint.key, "after": after}


def _style(style: Style) -> Header:
    return {
        "color": style.color,
        "opacity": style.opacity,
        "edges": style.edges,
        "edge_color": style.edge_color,
        "line_width": style.line_width,
    }
