"""`import dhlab` beside `import numpy`: fresh interpreters in turns."""

import os
import subprocess
import sys
from collections.abc import Iterator
from time import perf_counter

from rows import Row

ROUNDS = 40
NAMES = ("numpy", "dhlab")
CODE = """
from time import perf_counter, thread_time
times = thread_time(), perf_counter()
import {}
print(thread_time() - times[0], perf_counter() - times[1])
"""
ENVIRONMENT = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}


def measure() -> Iterator[Row]:
    for name in NAMES:
        run(name)  # writes the byte code and warms the disk's cache
    times = {name: [run(name) for _ in range(2)] for name in NAMES}
    for _ in range(ROUNDS):
        for name in NAMES:
            times[name].append(run(name))
    numpy, dhlab = ([1000 * min(t) for t in zip(*times[name], strict=True)] for name in NAMES)
    kinds = (
        "import dhlab, CPU time of its thread",
        "  by the clock",
        "  with python's start and end",
    )
    for kind, value, beside in zip(kinds, dhlab, numpy, strict=True):
        yield Row(kind, value, beside, "import numpy", target="<= 1.3")


def run(name: str) -> tuple[float, float, float]:
    """Seconds that an import takes in a fresh interpreter, and seconds of the interpreter."""
    began = perf_counter()
    command = [sys.executable, "-c", CODE.format(name)]
    printed = subprocess.check_output(command, env=ENVIRONMENT, text=True)
    whole = perf_counter() - began
    thread, clock = map(float, printed.split())
    return thread, clock, whole
