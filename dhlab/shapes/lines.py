"""Lines and labels: what is drawn with no surface."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from dhlab.arrays import as_number, as_points, as_pose, read_only
from dhlab.errors import InputError


@dataclass(frozen=True, eq=False, repr=False)
class Lines:
    """Straight segments between points.

    Attributes
    ----------
    points : ndarray, shape (m, 3) [m]
    segments : ndarray of int, shape (k, 2)
        The two points of each segment, counted from 0.

    Examples
    --------
    >>> Lines([[0, 0, 0], [1, 0, 0]], [[0, 1]])
    Lines(2 points, 1 segment)
    >>> Lines([[0, 0, 0], [1, 0, 0]], [[0, 2]])
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: segment 0 names point 2; there are 2 points, counted from 0 to 1
    """

    points: NDArray[np.float64]
    segments: NDArray[np.intp]

    def __post_init__(self) -> None:
        points = as_points(self.points, "the points of lines")
        segments = np.array(self.segments)
        if segments.ndim != 2 or segments.shape[1] != 2 or segments.dtype.kind not in "iu":
            raise InputError(f"segments must be pairs of point numbers, got {self.segments!r}")
        outside = (segments < 0) | (segments >= len(points))
        if outside.any():
            number, end = np.argwhere(outside)[0]
            there = f"there are {len(points)} points, counted from 0 to {len(points) - 1}"
            raise InputError(f"segment {number} names point {segments[number, end]}; {there}")
        segments = segments.astype(np.intp)
        segments.flags.writeable = False
        object.__setattr__(self, "points", points)
        object.__setattr__(self, "segments", segments)

    def __repr__(self) -> str:
        count = len(self.segments)
        return f"Lines({len(self.points)} points, {count} segment{'' if count == 1 else 's'})"

    @cached_property
    def bounds(self) -> NDArray[np.float64]:
        """Lowest and highest coordinates, shape (2, 3) [m]."""
        return read_only([self.points.min(axis=0), self.points.max(axis=0)])

    @cached_property
    def digest(self) -> str:
        """Name of the content: equal for lines with equal points and segments."""
        from hashlib import blake2b

        content = blake2b((self.points + 0.0).tobytes(), digest_size=16, person=b"lines")
        content.update(self.segments.astype("<i8").tobytes())
        return content.hexdigest()

    def transformed(self, T: NDArray[np.float64]) -> "Lines":
        """Give these lines moved by a pose: points ``p`` become ``T @ p``.

        Parameters
        ----------
        T : array_like, shape (4, 4)
        """
        T = as_pose(T, "the pose of lines")
        return Lines(self.points @ T[:3, :3].T + T[:3, 3], self.segments)

    def merged(self, *others: "Lines") -> "Lines":
        """Give all the segments of these and other lines as one.

        Parameters
        ----------
        *others : Lines
        """
        parts = (self, *others)
        first = np.cumsum([0, *(len(part.points) for part in parts)])
        segments = [part.segments + k for part, k in zip(parts, first, strict=False)]
        return Lines(np.vstack([part.points for part in parts]), np.vstack(segments))


@dataclass(frozen=True)
class Label:
    """A short text at the origin of its node that faces the camera.

    Attributes
    ----------
    text : str
        ``x_1`` and ``x_{12}`` are written with a subscript.
    size : float [pixel]
        Height of the letters on the screen.
    """

    text: str
    size: float = 18.0

    def __post_init__(self) -> None:
        if not isinstance(self.text, str) or not self.text.strip():
            raise InputError(f"the text of a label must not be empty, got {self.text!r}")
        object.__setattr__(self, "size", as_number(self.size, "the size of a label", above=0))

    @cached_property
    def digest(self) -> str:
        """Name of the content: equal for labels with equal text and size."""
        from hashlib import blake2b

        content = f"{self.size!r} {self.text}".encode()
        return blake2b(content, digest_size=16, person=b"label").hexdigest()
