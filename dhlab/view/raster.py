"""A small still picture, painted by numpy alone, fast: what an output shows where no widget can be.

Every triangle and line is cut into the pixels that it covers, all at once; of each pixel the
nearest is seen. Labels are left out, what is half transparent is mixed once.
"""

import struct
import zlib
from base64 import b64encode
from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from dhlab.scene.node import Node
from dhlab.view.still import BACKGROUNDS, FROM, Drawn, Eye, gather, look

PNG = "image/png"
WIDTH, HEIGHT = 480, 320
FINER = 2
"""Pixels painted for one that is kept, each way."""

MOST_NODES, MOST_PIECES = 400, 25_000
"""What is more than this would take too long for a picture that is seldom looked at."""

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]


def thumbnail(nodes: Mapping[str, Node], background: str = "light") -> bytes | None:
    """Paint a scene small, seen as a view shows it first.

    Parameters
    ----------
    nodes : mapping of str to Node
        The scene.
    background : {'light', 'dark'}

    Returns
    -------
    png : bytes or None
        None for a scene that would take too long.

    Examples
    --------
    >>> from dhlab.scene.blocks import cube
    >>> thumbnail(cube(1).describe())[1:4]
    b'PNG'
    """
    if len(nodes) > MOST_NODES:
        return None
    drawn, _ = gather(nodes)
    if len(drawn.points) > MOST_PIECES:
        return None
    eye = look(drawn.points.reshape(-1, 3), np.array(FROM["first"]), WIDTH / HEIGHT)
    return to_png(paint(drawn, eye, (WIDTH, HEIGHT), BACKGROUNDS[background]))


def still_picture(nodes: Mapping[str, Node], background: str) -> dict[str, str]:
    """Return the still picture of a scene by MIME type, as a notebook keeps it; or nothing.

    Parameters
    ----------
    nodes, background
        As for `thumbnail`.
    """
    png = thumbnail(nodes, background)
    return {} if png is None else {PNG: b64encode(png).decode("ascii")}


def paint(drawn: Drawn, eye: Eye, size: tuple[int, int], background: str) -> NDArray[np.uint8]:
    """Paint primitives as an eye sees them.

    Parameters
    ----------
    drawn : Drawn
    eye : Eye
    size : tuple of 2 ints [pixel]
        Width and height.
    background : str
        ``'#rrggbb'``.

    Returns
    -------
    picture : ndarray of uint8, shape (height, width, 3)
    """
    width, height = (FINER * length for length in size)
    corners, color = _corners(drawn, eye, width, height)
    owner, pixel, near = _cover(corners, width, height)
    back = np.array([int(background[i : i + 2], 16) for i in (1, 3, 5)]) / 255
    canvas = np.tile(back, (width * height, 1))
    depth = np.full(width * height, -np.inf)
    solid = color[owner, 3] >= 1
    _lay(canvas, depth, pixel[solid], near[solid], color[owner[solid]])
    seen = ~solid & (near > depth[pixel])
    _lay(canvas, depth, pixel[seen], near[seen], color[owner[seen]])
    fine = canvas.reshape(size[1], FINER, size[0], FINER, 3)
    small = sum(fine[:, i, :, j] for i in range(FINER) for j in range(FINER)) / FINER**2
    picture: NDArray[np.uint8] = np.round(255 * small).astype(np.uint8)
    return picture


def to_png(picture: NDArray[np.uint8]) -> bytes:
    """Write a picture with at most 256 colours.

    Parameters
    ----------
    picture : ndarray of uint8, shape (height, width, 3)

    Returns
    -------
    png : bytes
    """
    height, width, _ = picture.shape
    palette, index = _palette(picture.reshape(-1, 3))
    lines = np.hstack([np.zeros((height, 1), np.uint8), index.reshape(height, width)])
    header = struct.pack(">IIBBBBB", width, height, 8, 3, 0, 0, 0)
    data = zlib.compress(lines.tobytes(), 6)
    chunks = ((b"IHDR", header), (b"PLTE", palette.tobytes()), (b"IDAT", data), (b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(_chunk(kind, content) for kind, content in chunks)


def _corners(drawn: Drawn, eye: Eye, width: int, height: int) -> tuple[Floats, Floats]:
    """Return the corners of k triangles and their colours, shapes (3, 3, k) and (k, 4).

    Of the corners the first index is x, y [pixel] or nearness, the second the corner. A line
    becomes two triangles as wide as the line, a little nearer than the face it bounds.
    """
    flat, near = eye.project(drawn.points)
    points = np.dstack([flat * (0.5 * height) * (1, -1) + (width / 2, height / 2), near])
    is_line = drawn.face[:, 3] == 0
    faces, ends = points[~is_line], points[is_line][:, :2]
    ends[..., 2] += 0.004 * eye.distance
    way = ends[:, 1, :2] - ends[:, 0, :2]
    way /= np.maximum(np.linalg.norm(way, axis=1, keepdims=True), 1e-9)
    half = np.maximum(0.5 * FINER * drawn.width[is_line, None], 0.6)
    aside = np.column_stack([way[:, ::-1] * (-1, 1) * half, np.zeros(len(way))])
    a, b, c, d = ends[:, 0] + aside, ends[:, 0] - aside, ends[:, 1] + aside, ends[:, 1] - aside
    strips = [np.stack(three, axis=1) for three in ((a, b, c), (b, c, d))]
    line = drawn.line[is_line]
    corners = np.concatenate([faces, *strips])
    color = np.concatenate([drawn.face[~is_line], line, line])
    return np.ascontiguousarray(corners.T), color


def _cover(corners: Floats, width: int, height: int) -> tuple[Integers, Integers, Floats]:
    """Cut triangles into pixels: number of the triangle, number of the pixel, nearness.

    Each triangle is cut into rows first, and each row into its pixels.
    """
    x, y, near = corners
    low = np.clip(np.ceil(y.min(axis=0) - 0.5), 0, height).astype(int)
    high = np.clip(np.ceil(y.max(axis=0) - 0.5), 0, height).astype(int)
    owner, row = _spread(low, high)
    middle = row + 0.5
    left, right = np.full(len(row), float(width)), np.zeros(len(row))
    for side in range(3):
        x0, y0, x1, y1 = (at[k][owner] for k in (side, (side + 1) % 3) for at in (x, y))
        with np.errstate(divide="ignore", invalid="ignore"):
            way = (middle - y0) / (y1 - y0)
        crossed = (way >= 0) & (way <= 1)
        cut = x0 + way * (x1 - x0)
        np.minimum(left, cut, out=left, where=crossed)
        np.maximum(right, cut, out=right, where=crossed)
    begin = np.clip(np.ceil(left - 0.5), 0, width).astype(int)
    piece, column = _spread(begin, np.clip(np.ceil(right - 0.5), 0, width).astype(int))
    right_on, down = (slope[owner] for slope in _slopes(corners))
    first = near[0][owner] + right_on * (0.5 - x[0][owner]) + down * (middle - y[0][owner])
    pixel = row[piece] * width + column
    return owner[piece], pixel, first[piece] + right_on[piece] * column


def _spread(begin: Integers, end: Integers) -> tuple[Integers, Integers]:
    """Count from each begin to each end: numbers of the ranges, and what is counted."""
    length = np.maximum(end - begin, 0)
    owner = np.repeat(np.arange(len(begin)), length)
    first = np.cumsum(length) - length
    return owner, np.arange(len(owner)) + (begin - first)[owner]


def _slopes(corners: Floats) -> tuple[Floats, Floats]:
    """How nearness grows from pixel to pixel, to the right and down; 0 for a triangle on edge."""
    (ux, uy, uz), (vx, vy, vz) = (corners[:, k] - corners[:, 0] for k in (1, 2))
    area = ux * vy - uy * vx
    flat = np.abs(area) < 1e-9
    scale = np.where(flat, 0, 1 / np.where(flat, 1, area))
    return (uz * vy - uy * vz) * scale, (ux * vz - uz * vx) * scale


def _lay(canvas: Floats, depth: Floats, pixel: Integers, near: Floats, color: Floats) -> None:
    """Lay pixels onto the canvas; of those at one place the nearest is seen."""
    np.maximum.at(depth, pixel, near)
    top = np.flatnonzero(near == depth[pixel])
    there, ink = pixel[top], color[top]
    canvas[there] += ink[:, 3:] * (ink[:, :3] - canvas[there])


def _palette(colors: NDArray[np.uint8]) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
    """Return at most 256 colours, and for each pixel the number of the nearest."""
    red, green, blue = (colors >> 3).astype(np.intp).T
    code = (red << 10) + (green << 5) + blue
    count = np.bincount(code, minlength=1 << 15)
    found = np.flatnonzero(count)
    rgb = 8 * np.column_stack([found >> 10, (found >> 5) & 31, found & 31])
    kept = rgb[np.argsort(-count[found], kind="stable")[:256]]
    number = np.zeros(len(count), np.uint8)
    number[found] = ((rgb[:, None] - kept[None]) ** 2).sum(axis=2).argmin(axis=1)
    palette = np.minimum(kept + 4, 255).astype(np.uint8)
    return palette, number[code]


def _chunk(kind: bytes, content: bytes) -> bytes:
    return (
        struct.pack(">I", len(content))
        + kind
        + content
        + struct.pack(">I", zlib.crc32(kind + content))
    )
