"""The command line as a whole: its commands, and one sentence for each error."""

import argparse
import sys
from collections.abc import Callable, Sequence
from importlib.metadata import PackageNotFoundError, version

from dhlab.cli.commands import Commands, Run
from dhlab.cli.exercise import add_exercise
from dhlab.cli.export import add_export
from dhlab.cli.grade import add_grade
from dhlab.cli.lab import add_lab
from dhlab.errors import DhlabError

DESCRIPTION = "Robot kinematics in a notebook, from a Denavit-Hartenberg row to a moving limb."
EXAMPLES = """\
examples:
  dhlab lab                            open the notebooks in your browser
  dhlab lab --dir FOLDER               keep your copy of them in FOLDER
  dhlab lab --no-browser --port 8890   start the server only, at this port
  dhlab export upper_limb -o limb.html   write a model as a page with sliders
  dhlab export puma --lesson -o puma.html   write the lesson of its table, step by step
  dhlab export order_matters -o order.html   write a lesson of the course
  dhlab exercise build exercises/      prove exercises and make their notebooks
  dhlab grade exercises/01_rotation_matrices submissions/ --out results/   mark a class
  dhlab COMMAND --help                 all about one command\
"""

COMMANDS: tuple[Callable[[Commands], None], ...] = (add_lab, add_export, add_exercise, add_grade)
"""Each adds one command to the parser."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command line; the exit status is 0, or 2 with one sentence on what is wrong.

    Parameters
    ----------
    arguments : sequence of str, optional
        The words after `dhlab`; those of the process if not given.

    Returns
    -------
    int
        The exit status.
    """
    options = parser().parse_args(arguments)
    run: Run = options.run
    try:
        return run(options)
    except (DhlabError, OSError) as error:
        print(f"dhlab: {error}", file=sys.stderr)
        return 2


def parser() -> argparse.ArgumentParser:
    """Make the parser of the command line; each command adds itself and names what it runs."""
    top = argparse.ArgumentParser(
        prog="dhlab",
        description=DESCRIPTION,
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    top.add_argument("--version", action="version", version=f"dhlab {_version()}")
    commands = top.add_subparsers(title="commands", metavar="COMMAND", required=True)
    for add in COMMANDS:
        add(commands)
    return top


def _version() -> str:
    try:
        return version("dhlab")
    except PackageNotFoundError:
        return "that is not installed"
