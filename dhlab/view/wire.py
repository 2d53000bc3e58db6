"""The wire format: a JSON header and one binary buffer, for a change or for a whole scene.

The other end is ``static/wire.js``. A header refers to the buffer by byte offsets; floats and
integers are little-endian, poses the first three rows of their matrix. What moves often is small:
a joint is one float64 and the uint32 number of its node, a pose twelve float32. What is sent once
(a node's constants) is float64, so that the page's own forward kinematics is as good as Python's.
"""

import json
from collections.abc import Mapping
from functools import cached_property
from itertools import count
from typing import Any

import numpy as np
from numpy.typing import NDArray

from dhlab.scene.node import Clock, Curve, Joint, Node, Shape, Span, Style, same_pose
from dhlab.shapes import Label, Lines, Mesh
from dhlab.view.commands import Command, Paint, Place, Put, Remove, apply

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
        self.nodes = dict(nodes)
        self.sequence = 0
        self._unused = count(1)
        self._numbers = {path: next(self._unused) for path in nodes}

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
        message = _Message(self.sequence, self._numbers, self.nodes)
        for command in commands:
            match command:
                case Place(path, node):
                    message.place(path, node)
                case Put(path, node):
                    if path not in self._numbers:
                        self._numbers[path] = next(self._unused)
                    message.put(path, node)
                case Paint(path, node):
                    message.paint(path, node)
                case Remove(path):
                    message.remove(path)
        header, buffer = message.finish()
        apply(self.nodes, commands)
        if "removes" in header:
            self._numbers = {path: self._numbers[path] for path in self.nodes}
        return header, buffer

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
        message = _Message(self.sequence, self._numbers, {})
        for path, node in self.nodes.items():
            message.put(path, node)
        header, buffer = message.finish()
        header |= {"fresh": True, "play": sorted(header.get("clocks", ())) if play else []}
        text = json.dumps(header, separators=(",", ":")).encode()
        start = len(text).to_bytes(4, "little") + text
        return start + bytes(-len(start) % 8) + buffer


class _Message:
    """A header and a buffer that grow command by command.

    Parameters
    ----------
    sequence : int
    numbers : mapping of str to int
        Numbers of the nodes by path.
    told : mapping of str to Node
        What the page shows so far.
    """

    def __init__(self, sequence: int, numbers: Mapping[str, int], told: Mapping[str, Node]) -> None:
        self._numbers = numbers
        self._told = told
        self._header: Header = {"kind": "batch", "format": FORMAT, "seq": sequence}
        self._chunks: list[bytes] = []
        self._size = 0
        self._styles: dict[Style, int] = {}
        self._joints: list[tuple[int, float]] = []
        self._poses: list[tuple[int, NDArray[np.float64]]] = []

    @cached_property
    def _known(self) -> set[str]:
        """Digests of the geometry that the page has."""
        return {node.shape.digest for node in self._told.values() if node.shape is not None}

    @cached_property
    def _clocks(self) -> set[str]:
        """Keys of the clocks that the page has."""
        moved = {node.curve.clock.key for node in self._told.values() if node.curve is not None}
        return moved | {node.span.clock.key for node in self._told.values() if node.span}

    def remove(self, path: str) -> None:
        """Remove a node and what hangs on it."""
        self._append("removes", self._numbers[path])

    def put(self, path: str, node: Node) -> None:
        """Add a node that is new or draws another shape; geometry the page has is only named."""
        entry: Header = {"id": self._numbers[path], "path": path}
        entry |= {"pose": self._pack(node.pose[:3], "<f8"), "style": self._style(node.style)}
        if node.joint is not None:
            entry |= {"joint": _joint(node.joint), "value": float(node.value)}
        if node.shape is not None:
            entry["shape"] = node.shape.digest
            self._geometry(node.shape)
        if not node.visible:
            entry["visible"] = False
        if node.curve is not None:
            entry["curve"] = self._curve(node.curve)
        if node.span is not None:
            entry["span"] = self._span(node.span)
        if node.gauge is not None:
            entry["gauge"] = node.gauge._asdict()
        self._append("puts", entry)

    def place(self, path: str, node: Node) -> None:
        """Move a node: of a joint the value, of any other the pose, and its motion if it is new."""
        number, before = self._numbers[path], self._told.get(path)
        if node.joint is not None:
            self._joints.append((number, node.value))
        if node.joint is None or before is None or not same_pose(before, node):
            self._poses.append((number, node.pose))
        if before is None or before.curve is not node.curve:
            self._move(number, None if before is None else before.curve, node.curve)

    def _move(self, number: int, before: Curve | None, curve: Curve | None) -> None:
        """Give a node its motion; of one that it has only where it stands."""
        if curve is not None and curve.moves_like(before):
            self._rest(curve)
        else:
            self._append("curves", (number, None if curve is None else self._curve(curve)))

    def paint(self, path: str, node: Node) -> None:
        """Paint a node."""
        self._append("paints", (self._numbers[path], self._style(node.style), node.visible))

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

    def _geometry(self, shape: Shape) -> None:
        if shape.digest in self._known:
            return
        self._known.add(shape.digest)
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

    def _curve(self, curve: Curve) -> Header:
        clock, samples = curve.clock, np.asarray(curve.samples)
        self._clock(clock)
        self._rest(curve)
        poses = samples.ndim == 3
        at = self._pack(samples[:, :3], "<f4") if poses else self._pack(samples, "<f8")
        return {"clock": clock.key, "count": len(samples), "width": 12 if poses else 1, "at": at}

    def _clock(self, clock: Clock) -> None:
        if clock.key in self._clocks:
            return
        self._clocks.add(clock.key)
        form: Header = {"count": len(clock.times), "at": self._pack(clock.times, "<f8")}
        form |= {"stops": list(clock.stops)} if clock.stops else {}
        self._header.setdefault("clocks", {})[clock.key] = form

    def _rest(self, curve: Curve) -> None:
        if curve.rest is not None:
            self._header.setdefault("rests", {})[curve.clock.key] = list(curve.rest)

    def _span(self, span: Span) -> Header:
        self._clock(span.clock)
        form: Header = {"clock": span.clock.key, "begin": span.begin}
        form |= {"end": span.end} if span.end < float("inf") else {}
        return form | ({"grown": span.grown} if span.grown > span.begin else {})

    def _style(self, style: Style) -> int:
        return self._styles.setdefault(style, len(self._styles))

    def _append(self, key: str, entry: Any) -> None:
        self._header.setdefault(key, []).append(entry)

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
