"""One open chain: a Denavit-Hartenberg table, its joints, and what stands before and behind it."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from dhlab.arrays import as_array, as_config, as_limits, as_placement, read_only
from dhlab.errors import InputError, LimitError
from dhlab.kinematics.dh import (
    Convention,
    DHRow,
    JointKind,
    as_convention,
    as_kinds,
    as_rows,
    dh,
    joint_motion,
    link_constants,
    links_down,
    links_up,
)
from dhlab.kinematics.table import angle_text, html_table, number_text, place_text, text_table

LIMIT_TOLERANCE = 1e-9
ORIGIN = (0.0, 0.0, 0.0)
PARAMETERS = ("rows", "joints", "convention", "base", "grasper", "limits", "offset")


@dataclass(frozen=True, eq=False, init=False, repr=False)
class Chain:
    """An open chain of joints that never changes; `replace` gives a changed copy.

    The variable of joint i is theta_i of a revolute joint ('r') and d_i of a prismatic one ('p').
    A configuration `q` holds all variables; the table's own values are the home configuration.

    Parameters
    ----------
    rows : sequence of n DHRow or of n times 4 numbers
        The table, see `dh`.
    joints : str or sequence of str, length n
        'r' or 'p' (or 'd') for each joint: ``"rrp"``, ``6 * "r"``.
    convention : {'modified', 'standard'}
        What the rows mean.
    base : array_like, shape (3,) [m] or (4, 4)
        Where the chain begins, in the frame of whatever carries it.
    grasper : array_like, shape (3,) [m] or (4, 4)
        Pose of the grasper in the last frame.
    limits : array_like, shape (n, 2) [rad or m], or None
        Lower and upper limit of each variable; None: no limits.
    offset : array_like, shape (n,) [rad or m], or None
        Added to each variable before it goes into the table; None: 0.

    Examples
    --------
    >>> from dhlab.kinematics.dh import deg, dh
    >>> arm = Chain([dh(0, 0, 0, 0), dh(0, 0.3, 0, 90 * deg)], "rr", grasper=(0.2, 0, 0))
    >>> arm.tip(arm.home)[:3, 3].round(6)
    array([0.3, 0.2, 0. ])
    >>> arm
    Chain 'rr', modified Denavit-Hartenberg (m, rad)
    i  alpha_{i-1}  a_{i-1}  d_i  theta_i  home  limits
    1  0            0        0    q_1      0     none
    2  0            0.3      0    q_2      pi/2  none
    grasper: origin (0.2, 0, 0)
    """

    rows: tuple[DHRow, ...]
    joints: str
    convention: Convention
    base: NDArray[np.float64]
    grasper: NDArray[np.float64]
    limits: NDArray[np.float64]
    offset: NDArray[np.float64]
    kinds: tuple[JointKind, ...]
    home: NDArray[np.float64]
    constants: tuple[tuple[NDArray[np.float64], NDArray[np.float64]], ...]

    def __init__(
        self,
        rows: Sequence[ArrayLike],
        joints: Iterable[str],
        convention: Convention = "modified",
        base: ArrayLike = ORIGIN,
        grasper: ArrayLike = ORIGIN,
        limits: ArrayLike | None = None,
        offset: ArrayLike | None = None,
    ) -> None:
        table = as_rows(rows)
        n = len(table)
        kinds = as_kinds(joints, n)
        convention = as_convention(convention)
        constants = (
            link_constants(row, kind, convention) for row, kind in zip(table, kinds, strict=True)
        )
        fields = {
            "rows": table,
            "joints": "".join(kinds),
            "convention": convention,
            "base": as_placement(base, "base"),
            "grasper": as_placement(grasper, "grasper"),
            "limits": as_limits(limits, n, "limits"),
            "offset": as_config(np.zeros(n) if offset is None else offset, n, "offset"),
            "kinds": kinds,
            "home": read_only(
                [row.theta if k == "r" else row.d for row, k in zip(table, kinds, strict=True)]
            ),
            "constants": tuple(
                (read_only(before), read_only(after)) for before, after in constants
            ),
        }
        for name, value in fields.items():
            object.__setattr__(self, name, value)

    @property
    def n(self) -> int:
        """Number of joints."""
        return len(self.rows)

    def frames(self, q: ArrayLike) -> NDArray[np.float64]:
        """Poses of the joint frames, in the frame that `base` is given in.

        Parameters
        ----------
        q : array_like, shape (..., n) [rad or m]

        Returns
        -------
        T : ndarray, shape (..., n, 4, 4)
            ``T[..., i - 1, :, :]`` is the frame of joint i.
        """
        q = as_array(q, (..., self.n), "q") + self.offset
        T = np.empty((*q.shape, 4, 4))
        previous = self.base
        for i, (before, after) in enumerate(self.constants):
            previous = previous @ before @ joint_motion(self.kinds[i], q[..., i]) @ after
            T[..., i, :, :] = previous
        return T

    def tip(self, q: ArrayLike) -> NDArray[np.float64]:
        """Pose of the grasper, shape (..., 4, 4), in the frame that `base` is given in."""
        T = self.frames(q)
        last = T[..., -1, :, :] if self.n else np.broadcast_to(self.base, (*T.shape[:-3], 4, 4))
        return last @ self.grasper

    def check(
        self, q: ArrayLike, name: str = "chain", tolerance: float = LIMIT_TOLERANCE
    ) -> NDArray[np.float64]:
        """Configurations within the limits; a value just outside is put on its limit.

        Parameters
        ----------
        q : array_like, shape (..., n) [rad or m]
        name : str
            Who is named in the error.
        tolerance : float [rad or m]
            How far outside still counts as on the limit.

        Raises
        ------
        LimitError
            For the first variable that is further outside.

        Examples
        --------
        >>> slide = Chain([(0, 0, 0, 0)], "p", limits=[(0, 0.5)])
        >>> slide.check([0.5 + 1e-12])
        array([0.5])
        >>> slide.check([0.6], "slide")
        Traceback (most recent call last):
        ...
        dhlab.errors.LimitError: joint 1 of 'slide': 0.6000 m is outside [0.0000, 0.5000]
        """
        q = as_array(q, (..., self.n), f"q of '{name}'")
        inside = self.clip(q)
        outside = np.argwhere(np.abs(q - inside) > tolerance)
        if len(outside):
            *_, i = index = tuple(outside[0].tolist())
            lower, upper = self.limits[i].tolist()
            raise LimitError(name, i + 1, float(q[index]), (lower, upper), self.kinds[i])
        return inside

    def clip(self, q: ArrayLike) -> NDArray[np.float64]:
        """Nearest configurations within the limits, shape (..., n) [rad or m]."""
        q = as_array(q, (..., self.n), "q")
        return read_only(np.clip(q, self.limits[:, 0], self.limits[:, 1]))

    def replace(self, joint: int | None = None, /, **changes: Any) -> Self:
        """Copy with some values changed: those of one row of the table, or of the chain.

        Parameters
        ----------
        joint : int
            Row of the table, from 1; without it the changes are the chain's own parameters.
        **changes
            `alpha`, `a`, `d`, `theta` of the row; else any parameter of `Chain`.

        Examples
        --------
        >>> arm = Chain([(0, 0, 0, 0), (0, 0.3, 0, 0)], "rr")
        >>> arm.replace(2, a=0.5).rows[1].a
        0.5
        >>> arm.replace(2, length=0.5)
        Traceback (most recent call last):
        ...
        dhlab.errors.InputError: a row of the table has no 'length'; it has alpha, a, d, theta
        """
        if joint is not None:
            if joint not in range(1, self.n + 1):
                raise InputError(f"the table has rows 1 to {self.n}, got {joint!r}")
            _check_names(changes, DHRow._fields, "a row of the table")
            rows = list(self.rows)
            rows[joint - 1] = dh(**rows[joint - 1]._asdict() | changes)
            changes = {"rows": rows}
        _check_names(changes, PARAMETERS, "a chain")
        return type(self)(**{name: getattr(self, name) for name in PARAMETERS} | changes)

    def to_standard(self) -> Self:
        """Chain with a standard table that moves the grasper just the same for every q.

        A modified row has its link before its joint, a standard one behind it: all links move up
        by one row, and the first goes into the base. The joint frames become others.
        """
        if self.convention == "standard":
            return self
        first, rows = links_up(self.rows)
        return self.replace(convention="standard", base=self.base @ first, rows=rows)

    def to_modified(self) -> Self:
        """Chain with a modified table that moves the grasper just the same for every q.

        The way back from `to_standard`: all links move down by one row, and the last goes into
        the grasper.
        """
        if self.convention == "modified":
            return self
        rows, last = links_down(self.rows)
        return self.replace(convention="modified", rows=rows, grasper=last @ self.grasper)

    def __repr__(self) -> str:
        head, rows = _cells(self)
        title = f"Chain '{self.joints}', {self.convention} Denavit-Hartenberg (m, rad)"
        return "\n".join([title, *(text_table(head, rows) if rows else []), *_ends(self)])

    def _repr_html_(self) -> str:
        title = f"{self.convention} Denavit-Hartenberg (m, rad)"
        return html_table(title, *_cells(self), _ends(self))


def _check_names(changes: Iterable[str], known: Sequence[str], owner: str) -> None:
    for name in changes:
        if name not in known:
            raise InputError(f"{owner} has no '{name}'; it has {', '.join(known)}")


def _cells(chain: Chain) -> tuple[list[str], list[list[str]]]:
    """Head and rows of the table to read, with each joint's variable in its place."""
    link = "_{i-1}" if chain.convention == "modified" else "_i"
    head = ["i", f"alpha{link}", f"a{link}", "d_i", "theta_i", "home", "limits"]
    rows = []
    for i, (alpha, a, d, theta) in enumerate(chain.rows):
        revolute, offset, limits = chain.kinds[i] == "r", chain.offset[i], chain.limits[i]
        show = angle_text if revolute else number_text
        variable = f"q_{i + 1}"
        if offset:
            variable += f" {'+' if offset > 0 else '-'} {show(abs(offset))}"
        joint = [number_text(d), variable] if revolute else [variable, angle_text(theta)]
        span = f"[{', '.join(map(show, limits))}]" if np.isfinite(limits).any() else "none"
        link_cells = [angle_text(alpha), number_text(a)]
        rows.append([str(i + 1), *link_cells, *joint, show(chain.home[i]), span])
    return head, rows


def _ends(chain: Chain) -> list[str]:
    """Base and grasper, where they are not just the frame they stand in."""
    ends = (("base", chain.base), ("grasper", chain.grasper))
    return [f"{name}: {place_text(T)}" for name, T in ends if not np.array_equal(T, np.eye(4))]
