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
    corners, color = _corners(drawn, eye, height)
    corners += (width / 2, height / 2, 0)
    owner, pixel, near = _cover(corners, width, height)
    back = np.array([int(background[i : i + 2], 16) for i in (1, 3, 5)]) / 255
    canvas = np.tile(back, (width * height, 1))
    depth = np.full(width * height, -np.inf)
    solid = color[owner, 3] >= 1
    _lay(canvas, depth, pixel[solid], near[solid], color[owner[solid]])
    seen = ~solid & (near > depth[pixel])
    _lay(canvas, depth, pixel[seen], near[seen], color[owner[seen]])
    small = canvas.reshape(size[1], FINER, size[0], FINER, 3).mean(axis=(1, 3))
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
    data = zlib.compress(lines.tobytes(), 9)
    chunks = ((b"IHDR", header), (b"PLTE", palette.tobytes()), (b"IDAT", data), (b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(_chunk(kind, content) for kind, content in chunks)


def _corners(drawn: Drawn, eye: Eye, height: int) -> tuple[Floats, Floats]:
    """Return triangles in pixels from the middle, with nearness, and their colours.

    A line becomes two triangles as wide as the line, a little nearer than the face it bounds.
    """
    flat, near = eye.project(drawn.points)
    points = np.dstack([flat * (0.5 * height) * (1, -1), near])
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
    return corners, np.concatenate([drawn.face[~is_line], line, line])


def _cover(corners: Floats, width: int, height: int) -> tuple[Integers, Integers, Floats]:
    """Cut triangles into pixels: number of the triangle, number of the pixel, nearness.

    Each triangle is cut into rows first, and each row into its pixels.
    """
    low = np.clip(np.ceil(corners[..., 1].min(axis=1) - 0.5), 0, height).astype(int)
    high = np.clip(np.ceil(corners[..., 1].max(axis=1) - 0.5), 0, height).astype(int)
    owner, y = _spread(low, high)
    middle = y + 0.5
    here, there = corners[owner], np.roll(corners, -1, axis=1)[owner]
    rise = there[..., 1] - here[..., 1]
    with np.errstate(divide="ignore", invalid="ignore"):
        way = (middle[:, None] - here[..., 1]) / rise
        cut = here[..., 0] + way * (there[..., 0] - here[..., 0])
    crossed = (way >= 0) & (way <= 1) & (rise != 0)
    left = np.where(crossed, cut, np.inf).min(axis=1)
    right = np.where(crossed, cut, -np.inf).max(axis=1)
    left, right = np.nan_to_num(left, posinf=width), np.nan_to_num(right, neginf=0)
    begin = np.clip(np.ceil(left - 0.5), 0, width).astype(int)
    row, x = _spread(begin, np.maximum(np.clip(np.ceil(right - 0.5), 0, width).astype(int), begin))
    slope = _slopes(corners)[owner[row]]
    first = corners[owner[row], 0]
    near = (
        first[:, 2]
        + slope[:, 0] * (x + 0.5 - first[:, 0])
        + slope[:, 1] * (middle[row] - first[:, 1])
    )
    return owner[row], y[row] * width + x, near


def _spread(begin: Integers, end: Integers) -> tuple[Integers, Integers]:
    """Count from each begin to each end: numbers of the ranges, and what is counted."""
    length = np.maximum(end - begin, 0)
    owner = np.repeat(np.arange(len(begin)), length)
    first = np.cumsum(length) - length
    return owner, np.arange(len(owner)) - first[owner] + begin[owner]


def _slopes(corners: Floats) -> Floats:
    """How nearness grows from pixel to pixel, to the right and down; 0 for a triangle on edge."""
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    flat = np.abs(normal[:, 2]) < 1e-9
    slope: Floats = -normal[:, :2] / np.where(flat, 1, normal[:, 2])[:, None]
    slope[flat] = 0
    return slope


def _lay(canvas: Floats, depth: Floats, pixel: Integers, near: Floats, color: Floats) -> None:
    """Lay pixels onto the canvas, the nearest last."""
    order = np.argsort(near, kind="stable")
    pixel, near, color = pixel[order], near[order], color[order]
    last = np.full(len(canvas), -1)
    last[pixel] = np.arange(len(pixel))
    there = np.flatnonzero(last >= 0)
    top = color[last[there]]
    canvas[there] += top[:, 3:] * (top[:, :3] - canvas[there])
    depth[there] = near[last[there]]


def _palette(colors: NDArray[np.uint8]) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:
    """Return at most 256 colours, and for each pixel the number of the nearest."""
    coarse = colors & 0xF8
    code = coarse.astype(np.int64) @ (1 << 16, 1 << 8, 1)
    found, back, count = np.unique(code, return_inverse=True, return_counts=True)
    rgb = np.column_stack([found >> 16, (found >> 8) & 255, found & 255])
    kept = rgb[np.argsort(-count, kind="stable")[:256]]
    nearest = ((rgb[:, None] - kept[None]) ** 2).sum(axis=2).argmin(axis=1)
    palette = np.minimum(kept + 4, 255).astype(np.uint8)
    return palette, nearest.astype(np.uint8)[back]


def _chunk(kind: bytes, content: bytes) -> bytes:
    return (
        struct.pack(">I", len(content))
        + kind
        + content
        + struct.pack(">I", zlib.crc32(kind + content))
    )
