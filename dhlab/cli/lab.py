"""`dhlab lab`: JupyterLab on a copy of the notebooks."""

import argparse
import os
from pathlib import Path

from dhlab.cli.commands import Commands, add_command
from dhlab.workcopy import Refreshed, refresh, shipped

LAB = """\
Open JupyterLab on your own copy of the notebooks, at their index.

The copy lies in a folder of its own (--dir). New notebooks are copied in, and those that you have
not changed are brought up to date. What you have changed is never overwritten: to start a notebook
afresh, delete or rename your copy and run this command again.\
"""
INDEX = "notebooks/index.ipynb"


def add_lab(commands: Commands) -> None:
    """Add `dhlab lab`."""
    short = "open JupyterLab on your own copy of the notebooks"
    lab = add_command(commands, "lab", short, LAB, run_lab)
    lab.add_argument(
        "--dir",
        type=Path,
        default=Path("dhlab-work"),
        metavar="FOLDER",
        help="where your copy lies (default: ./dhlab-work)",
    )
    lab.add_argument("--no-browser", action="store_true", help="start the server only")
    lab.add_argument(
        "--port",
        type=_port,
        metavar="N",
        help="the server's port (default: 8888, or the next free)",
    )
    lab.add_argument(
        "--no-token",
        action="store_true",
        help="let everybody in who reaches the port; only where that is yourself alone",
    )


def run_lab(options: argparse.Namespace) -> int:
    """Bring the working copy up to date and serve it until the server is stopped."""
    folder = options.dir.expanduser().resolve()
    for line in told(refresh(folder, shipped())):
        print(line)
    print(f"dhlab: JupyterLab on {folder}; stop it with Ctrl-C", flush=True)
    before = os.environ.get("JUPYTER_CONFIG_PATH")
    ours = str(Path(__file__).parents[1] / "jupyter")
    os.environ["JUPYTER_CONFIG_PATH"] = os.pathsep.join([ours, before] if before else [ours])
    from jupyterlab.labapp import LabApp

    LabApp.launch_instance(server_arguments(options, folder))
    return 0


def server_arguments(options: argparse.Namespace, folder: Path) -> list[str]:
    """Put `dhlab lab`'s options into JupyterLab's words."""
    arguments = [
        f"--ServerApp.root_dir={folder}",
        f"--LabApp.default_url=/lab/tree/{INDEX}",
    ]
    if options.no_browser:
        arguments.append("--no-browser")
    if options.port is not None:
        arguments += [f"--ServerApp.port={options.port}", "--ServerApp.port_retries=0"]
    if options.no_token:
        arguments.append("--IdentityProvider.token=")
    if hasattr(os, "geteuid") and os.geteuid() == 0:
        arguments.append("--allow-root")
    return arguments


def told(done: Refreshed) -> list[str]:
    """Say in lines what was done to the working copy."""
    lines = []
    if done.copied:
        lines.append(f"dhlab: new in your copy: {', '.join(done.copied)}")
    if done.updated:
        lines.append(f"dhlab: brought up to date: {', '.join(done.updated)}")
    lines += [f"dhlab: kept your {name}; rename it to get dhlab's newer one" for name in done.kept]
    return lines


def _port(text: str) -> int:
    if not (text.isdecimal() and 0 < int(text) < 65536):
        raise argparse.ArgumentTypeError(f"a port is a number from 1 to 65535, got {text!r}")
    return int(text)
