"""A Denavit-Hartenberg table in numbers, whatever was done to it, and where its tip is."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from dhlab.diagnosis.product import After
from dhlab.diagnosis.values import Floats
from dhlab.kinematics.chain import Chain
from dhlab.kinematics.dh import DHRow, link_transform


@dataclass(frozen=True, eq=False)
class Table:
    """A table with its joint values in numbers, and what was done to it."""

    rows: Floats
    kinds: tuple[str, ...]
    q: Floats
    offset: Floats
    standard: bool
    base: Floats
    tool: Floats
    columns: tuple[int, ...] = (0, 1, 2, 3)
    use: tuple[int, ...] = ()
    ends: str = "bct"
    after: tuple[After, ...] = ()

    def filled(self) -> Floats:
        """Rows with the joint values in their places, shape (used, 4)."""
        rows = self.rows.copy()
        for i, kind in enumerate(self.kinds):
            rows[i, 3 if kind == "r" else 2] = self.q[i] + self.offset[i]
        out: Floats = rows[list(self.use)][:, list(self.columns)]
        return out

    def is_chain(self, n: int) -> bool:
        """Whether it is a table of n joints with its factors in their order."""
        return self.use == tuple(range(n)) and self.ends == "bct" and not self.after


def table_of(chain: Chain, q: Floats) -> Table:
    """Table of a chain at a configuration."""
    return Table(
        np.array(chain.rows, dtype=np.float64).reshape(-1, 4),
        chain.kinds,
        np.asarray(q, dtype=np.float64).reshape(chain.n),
        chain.offset,
        chain.convention == "standard",
        chain.base,
        chain.grasper,
        use=tuple(range(chain.n)),
    )


def evaluate_tables(tables: Sequence[Table]) -> list[Floats]:
    """Poses of the tips of many tables at once, each (4, 4)."""
    out: list[Floats] = [np.eye(4)] * len(tables)
    groups: dict[tuple[int, bool], list[int]] = {}
    for k, t in enumerate(tables):
        groups.setdefault((len(t.use), t.standard), []).append(k)
    for (n, standard), members in groups.items():
        rows = np.array([tables[k].filled() for k in members]).reshape(len(members), n, 4)
        links = link_transform(rows, "standard" if standard else "modified")
        T = np.broadcast_to(np.eye(4), (len(members), 4, 4))
        for i in range(n):
            T = T @ links[:, i]
        for k, chain in zip(members, T, strict=True):
            out[k] = _finished(tables[k], chain)
    return out


def _finished(t: Table, chain: Floats) -> Floats:
    parts = {"b": t.base, "c": chain, "t": t.tool}
    T = np.eye(4)
    for letter in t.ends:
        T = T @ parts[letter]
    for change in t.after:
        T = change(T)
    return T


def chain_of(table: Table) -> Chain:
    """Chain of a table that is one."""
    rows = table.rows[:, list(table.columns)].tolist()
    convention = "standard" if table.standard else "modified"
    return Chain(
        [DHRow(*row) for row in rows],
        table.kinds,
        "standard" if convention == "standard" else "modified",
        table.base,
        table.tool,
        offset=table.offset,
    )
