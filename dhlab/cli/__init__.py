"""The `dhlab` command: a module for each word that may follow it."""

from dhlab.cli.top import COMMANDS, main, parser

__all__ = ["COMMANDS", "main", "parser"]
