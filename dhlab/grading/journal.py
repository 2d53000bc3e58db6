"""A run's rows on disk as they come, so that an interrupted run goes on where it was.

Beside `results.json` of the last finished run lies `unfinished.jsonl` as long as a run lasts: its
first line says what the run is, each further line is a row. A line cut off by a crash is no row.
"""

import json
import os
from collections.abc import Iterable
from dataclasses import asdict
from pathlib import Path
from types import TracebackType

from dhlab.errors import DhlabError
from dhlab.grading.results import (
    RESULTS,
    Row,
    Run,
    read_results,
    row_from,
    run_from,
    write_whole,
)

UNFINISHED = "unfinished.jsonl"


def earlier_rows(folder: Path) -> tuple[Run | None, list[Row]]:
    """Read what earlier runs left: the last run, and its rows, later ones last.

    Raises
    ------
    DhlabError
        The folder holds a `results.json` that is not ours.
    """
    run: Run | None = None
    rows: list[Row] = []
    if (folder / RESULTS).exists():
        run, rows = read_results(folder / RESULTS)
    later, more = _unfinished(folder / UNFINISHED)
    if later is None:
        return run, rows
    return later, [*(rows if later == run else ()), *more]


def _unfinished(path: Path) -> tuple[Run | None, list[Row]]:
    run: Run | None = None
    rows: list[Row] = []
    for line in path.read_bytes().split(b"\n") if path.exists() else ():
        try:
            data = json.loads(line)
            if run is None:
                run = run_from(data)
            else:
                rows.append(row_from(data))
        except (ValueError, KeyError, TypeError, DhlabError):
            continue
    return run, rows


class Journal:
    """Writes each row when it is known; to be used as a context.

    Parameters
    ----------
    folder : Path
        That of the results; made if it does not exist.
    run : Run
    kept : iterable of Row
        Rows of earlier runs that still hold.

    Raises
    ------
    DhlabError
        Another run is writing there.
    """

    def __init__(self, folder: Path, run: Run, kept: Iterable[Row] = ()) -> None:
        folder.mkdir(parents=True, exist_ok=True)
        self._path = folder / UNFINISHED
        self._lock = _locked(folder)
        try:
            lines = [json.dumps(asdict(run)), *(json.dumps(row.as_json()) for row in kept)]
            write_whole(self._path, "".join(f"{line}\n" for line in lines))
            self._file = open(self._path, "ab")  # noqa: SIM115 (closed on leaving the context)
        except BaseException:
            self._unlock()
            raise

    def __enter__(self) -> "Journal":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._file.close()
        self._unlock()

    def add(self, row: Row) -> None:
        """Write a row; when this returns, it survives whatever happens."""
        self._file.write(json.dumps(row.as_json()).encode() + b"\n")
        self._file.flush()
        os.fsync(self._file.fileno())

    def done(self) -> None:
        """Say that the results are written, and this file is no longer needed."""
        self._path.unlink(missing_ok=True)

    def _unlock(self) -> None:
        if self._lock is not None:
            os.close(self._lock)


def _locked(folder: Path) -> int | None:
    """Keep other runs out of the folder, where the system can do that."""
    try:
        import fcntl
    except ImportError:
        return None
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        os.close(descriptor)
        raise DhlabError(f"another run is writing to {str(folder)!r}; wait for it") from error
    return descriptor
