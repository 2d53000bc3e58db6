"""Measure what dhlab costs and print one table of ratios.

    python tests/benchmarks/run.py [NAME ...]

A name is that of a module beside this one without ``bench_``; without names all are run. Times of
one row are taken in one run, in turns, so the ratio says more than the times do.
"""

import os
import sys
from importlib import import_module
from pathlib import Path

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
MARK = {True: "met", False: "MISSED", None: ""}


def main(names: list[str]) -> None:
    sys.path.insert(0, str(ROOT))
    os.environ["PYTHONPATH"] = os.pathsep.join(filter(None, [str(ROOT), os.getenv("PYTHONPATH")]))
    known = sorted(path.stem.removeprefix("bench_") for path in HERE.glob("bench_*.py"))
    unknown = [name for name in names if name not in known]
    if unknown:
        sys.exit(f"no benchmark {', '.join(unknown)}; choose from {', '.join(known)}")
    say(f"{'':53}{'measured':>12}{'beside':>12}  {'':26}{'ratio':>8}  target")
    for name in names or known:
        say(name)
        for row in import_module(f"bench_{name}").measure():
            beside = "" if row.beside is None else f"{row.beside:.4g} {row.unit}"
            ratio = "" if row.ratio is None else f"{row.ratio:.3g}"
            say(
                f"  {row.what:51}{f'{row.value:.4g} {row.unit}':>12}{beside:>12}  {row.name:26}"
                f"{ratio:>8}  {row.target:14}{MARK[row.met()]}".rstrip()
            )


def say(line: str) -> None:
    """Print a line at once."""
    sys.stdout.write(line + "\n")
    sys.stdout.flush()


if __name__ == "__main__":
    main(sys.argv[1:])
