"""Measure what dhlab costs and print one table, in Markdown.

    python tests/benchmarks/run.py [NAME ...]

A name is that of a module beside this one without ``bench_``; without names all are run. Times of
one row are taken in one run, in turns, so the ratio says more than the times do. `DHLAB_BROWSER`
names the Chromium, `DHLAB_PEERS` an interpreter that has viser and Swift; without it they are
installed in an environment of their own in the user's cache.
"""

import os
import platform
import sys
from datetime import date
from importlib import import_module
from pathlib import Path

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
MARK = {True: "met", False: "MISSED", None: ""}
HEAD = ("what", "ratio", "measured", "beside", "", "aim", "")
ALIGN = ("---", "--:", "--:", "--:", "---", "---", "---")


def main(names: list[str]) -> None:
    sys.path.insert(0, str(ROOT))
    os.environ["PYTHONPATH"] = os.pathsep.join(filter(None, [str(ROOT), os.getenv("PYTHONPATH")]))
    known = sorted(path.stem.removeprefix("bench_") for path in HERE.glob("bench_*.py"))
    unknown = [name for name in names if name not in known]
    if unknown:
        sys.exit(f"no benchmark {', '.join(unknown)}; choose from {', '.join(known)}")
    say(f"{date.today()}, {machine()}; {load()}\n")
    say(line(HEAD))
    say(line(ALIGN))
    for name in names or known:
        say(line((f"**{name}**", "", "", "", "", "", "")))
        for row in import_module(f"bench_{name}").measure():
            say(line(cells(row)))
    say(f"\nat the end: {load()}")


def cells(row: object) -> tuple[str, ...]:
    """Texts of one row of the table."""
    from rows import Skipped

    if isinstance(row, Skipped):
        return row.what, "", "skipped", "", row.reason, "", ""
    beside = "" if row.beside is None else f"{figure(row.beside)} {row.unit}"
    ratio = "" if row.ratio is None else figure(row.ratio, 2)
    measured = f"{figure(row.value)} {row.unit}"
    return row.what, ratio, measured, beside, row.name, row.target, MARK[row.met()]


def figure(number: float, digits: int = 3) -> str:
    """A number to some digits, never with a power of ten."""
    return f"{number:,.0f}" if abs(number) >= 10**digits else f"{number:.{digits}g}"


def line(texts: tuple[str, ...]) -> str:
    """One line of the table; the first columns are as wide as most need."""
    widths = 46, 6, 9, 9, 28, 8, 6
    padded = (text.strip().ljust(width) for text, width in zip(texts, widths, strict=True))
    return f"| {' | '.join(padded)} |"


def machine() -> str:
    """What it is measured on."""
    return f"Python {platform.python_version()}, {platform.system()}, {os.cpu_count()} cores"


def load() -> str:
    """How busy the machine is."""
    if not hasattr(os, "getloadavg"):
        return "load unknown"
    return f"load of the last minute {os.getloadavg()[0]:.1f}"


def say(text: str) -> None:
    """Print a line at once."""
    sys.stdout.write(text + "\n")
    sys.stdout.flush()


if __name__ == "__main__":
    main(sys.argv[1:])
