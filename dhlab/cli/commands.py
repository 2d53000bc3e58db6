"""What the modules of the commands share."""

import argparse
from collections.abc import Callable
from typing import TypeAlias

Commands: TypeAlias = "argparse._SubParsersAction[argparse.ArgumentParser]"
"""Where a command adds itself."""
Run: TypeAlias = Callable[[argparse.Namespace], int]
"""What a command does; it returns the exit status."""


def add_command(
    commands: Commands, name: str, short: str, text: str, run: Run | None = None, after: str = ""
) -> argparse.ArgumentParser:
    """Add a command whose help is shown with its lines as they are written.

    Parameters
    ----------
    commands : Commands
    name : str
    short : str
        Its line in the list of commands.
    text : str
        What its own help says first.
    run : callable, optional
        What it does; none where further words choose that.
    after : str
        What its own help says last.

    Returns
    -------
    parser : ArgumentParser
        Takes the command's arguments.
    """
    parser = commands.add_parser(
        name,
        help=short,
        description=text,
        epilog=after or None,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    if run is not None:
        parser.set_defaults(run=run)
    return parser
