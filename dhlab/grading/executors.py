"""Where a class is marked: in processes of this machine, or on the workers of a Dask cluster."""

import multiprocessing
import os
import signal
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, ProcessPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from multiprocessing.context import BaseContext
from typing import Any

from dhlab.errors import DhlabError

AHEAD = 4
"""Submissions that wait at each worker, so that none has to wait for its next."""


@dataclass(frozen=True)
class Workers:
    """Workers that submissions can be sent to.

    Attributes
    ----------
    count : int
    executors : callable
        Makes an executor on them.
    everywhere : callable
        Runs a function once on each machine, and raises what it raises.
    """

    count: int
    executors: Callable[[], Executor]
    everywhere: Callable[[Callable[[], Any]], object]

    @property
    def window(self) -> int:
        """How many submissions are under way at a time."""
        return AHEAD * self.count


def local_workers(count: int | None = None) -> Workers:
    """Return processes of this machine, by default one for each processor that may be used."""
    number = count or _processors()
    context = _context()

    def executors() -> Executor:
        return ProcessPoolExecutor(number, mp_context=context, initializer=stay_with_parent)

    return Workers(number, executors, lambda function: function())


@contextmanager
def dask_workers(address: str) -> Iterator[Workers]:
    """Connect to a Dask cluster; its workers need dhlab and, on each machine, a sandbox.

    Parameters
    ----------
    address : str
        Of the scheduler: "tcp://host:8786".

    Yields
    ------
    workers : Workers

    Raises
    ------
    DhlabError
        Dask is not installed, there is no cluster, or it has no workers.
    """
    try:
        from distributed import Client
    except ImportError as error:
        raise DhlabError("--dask needs Dask: pip install 'dhlab[dask]'") from error
    try:
        client = Client(address, timeout=10)
    except (OSError, TimeoutError, ValueError) as error:
        raise DhlabError(f"there is no Dask scheduler at {address!r} ({error})") from error
    with client:
        count = sum(client.nthreads().values())
        if not count:
            raise DhlabError(f"the Dask cluster at {address!r} has no workers")
        yield Workers(count, lambda: client.get_executor(pure=False, retries=0), client.run)


def stay_with_parent() -> None:
    """Make this worker end with the process that started it, however that one ends."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the parent to answer
    parent = multiprocessing.parent_process()
    if parent is not None:
        threading.Thread(target=_end_after, args=(parent,), daemon=True).start()


def _context() -> BaseContext:
    """How processes are started: copies of one that has imported what they need, where it goes."""
    if "forkserver" not in multiprocessing.get_all_start_methods():
        return multiprocessing.get_context("spawn")
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload(["dhlab.grading.batch"])
    return context


def _end_after(parent: Any) -> None:
    parent.join()
    os._exit(1)


def _processors() -> int:
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1
