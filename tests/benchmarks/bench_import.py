"""`import dhlab` beside `import numpy`: fresh interpreters in turns."""

import os
import subprocess
import sys
from collections.abc import Iterator
from time import perf_counter

from rows import Row

ENVIRONMENT = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
CODES = ("pass", "import numpy", "import dhlab")
ROUNDS = 40


def measure() -> Iterator[Row]:
    walls = {code: float("inf") for code in CODES}
    cpus = dict(walls)
    for code in CODES:
        run(code)  # writes the byte code and warms the disk's cache
    for _ in range(ROUNDS):
        for code in CODES:
            wall, cpu = run(code)
            walls[code] = min(walls[code], wall)
            cpus[code] = min(cpus[code], cpu)
    for kind, times in (("wall", walls), ("CPU", cpus)):
        bare, numpy, dhlab = (1000 * times[code] for code in CODES)
        yield Row(f"import dhlab, {kind} time", dhlab, numpy, "import numpy", target="<= 1.3")
        numpy -= bare
        dhlab -= bare
        yield Row(f"the same without python's own start, {kind}", dhlab, numpy, "import numpy")


def run(code: str) -> tuple[float, float]:
    """Wall and CPU seconds of a fresh interpreter."""
    began = perf_counter()
    process = subprocess.Popen([sys.executable, "-c", code], env=ENVIRONMENT)
    _, status, used = os.wait4(process.pid, 0)
    wall = perf_counter() - began
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        raise RuntimeError(f"{code!r} failed")
    return wall, used.ru_utime + used.ru_stime
