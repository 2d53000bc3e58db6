"""The `dhlab` command."""

import argparse
import os
import sys
from collections.abc import Callable, Sequence
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import TYPE_CHECKING

from dhlab.errors import DhlabError, InputError
from dhlab.workcopy import Refreshed, refresh, shipped

if TYPE_CHECKING:
    Commands = argparse._SubParsersAction[argparse.ArgumentParser]

DESCRIPTION = "Robot kinematics in a notebook, from a Denavit-Hartenberg row to a moving limb."
EXAMPLES = """\
examples:
  dhlab lab                            open the notebooks in your browser
  dhlab lab --dir FOLDER               keep your copy of them in FOLDER
  dhlab lab --no-browser --port 8890   start the server only, at this port
  dhlab export upper_limb -o limb.html   write a model as a page with sliders
  dhlab export puma --lesson -o puma.html   write the lesson of its table, step by step
  dhlab export order_matters -o order.html   write a lesson of the course
  dhlab COMMAND --help                 all about one command\
"""
LAB = """\
Open JupyterLab on your own copy of the notebooks, at their index.

The copy lies in a folder of its own (--dir). New notebooks are copied in, and those that you have
not changed are brought up to date. What you have changed is never overwritten: to start a notebook
afresh, delete or rename your copy and run this command again.\
"""
EXPORT = """\
Write a model of dhlab.models or a lesson of dhlab.lessons.course as one HTML file: the picture,
sliders or steps, and nothing else needed.

The page opens from disk by double click, offline, on a phone too.\
"""
INDEX = "notebooks/index.ipynb"


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
    run: Callable[[argparse.Namespace], int] = options.run
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


def add_lab(commands: "Commands") -> None:
    """Add `dhlab lab`."""
    lab = commands.add_parser(
        "lab",
        help="open JupyterLab on your own copy of the notebooks",
        description=LAB,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
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
    lab.set_defaults(run=run_lab)


def add_export(commands: "Commands") -> None:
    """Add `dhlab export`."""
    export = commands.add_parser(
        "export",
        help="write a model or a lesson as one HTML file that needs nothing else",
        description=EXPORT,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    export.add_argument(
        "name", metavar="NAME", help="of a model such as upper_limb, or a lesson such as detour"
    )
    export.add_argument("-o", "--out", required=True, type=Path, metavar="FILE")
    export.add_argument(
        "--look",
        choices=("user", "solid", "stick"),
        help="what is drawn",
    )
    export.add_argument(
        "--lesson",
        action="store_true",
        help="of a model: the lesson that walks through its table",
    )
    export.set_defaults(run=run_export)


COMMANDS: tuple[Callable[["Commands"], None], ...] = (add_lab, add_export)


def run_lab(options: argparse.Namespace) -> int:
    """Bring the working copy up to date and serve it until the server is stopped."""
    folder = options.dir.expanduser().resolve()
    for line in told(refresh(folder, shipped())):
        print(line)
    print(f"dhlab: JupyterLab on {folder}; stop it with Ctrl-C", flush=True)
    before = os.environ.get("JUPYTER_CONFIG_PATH")
    ours = str(Path(__file__).parent / "jupyter")
    os.environ["JUPYTER_CONFIG_PATH"] = os.pathsep.join([ours, before] if before else [ours])
    from jupyterlab.labapp import LabApp

    LabApp.launch_instance(server_arguments(options, folder))
    return 0


def run_export(options: argparse.Namespace) -> int:
    """Write a page that shows one model, or one lesson."""
    import dhlab.models as models
    from dhlab.lessons.course import LESSONS
    from dhlab.lessons.dh_steps import dh_lesson
    from dhlab.panel.lesson_view import LessonView
    from dhlab.view.view import View

    name, out = options.name, options.out.expanduser()
    if name in LESSONS:
        place = LessonView(LESSONS[name]()).save_html(out)
    elif name in models.__all__:
        robot = getattr(models, name)()
        if options.look is not None:
            robot.look = options.look
        if options.lesson:
            place = LessonView(dh_lesson(robot)).save_html(out)
        else:
            place = View(name).add(robot).save_html(out, name.replace("_", " "))
    else:
        choices = f"models {', '.join(models.__all__)}; lessons {', '.join(LESSONS)}"
        raise InputError(f"no model or lesson {name!r}; there are {choices}")
    print(f"dhlab: wrote {place} ({place.stat().st_size / 1e6:.1f} MB)")
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


def _version() -> str:
    try:
        return version("dhlab")
    except PackageNotFoundError:
        return "that is not installed"


def _port(text: str) -> int:
    if not (text.isdecimal() and 0 < int(text) < 65536):
        raise argparse.ArgumentTypeError(f"a port is a number from 1 to 65535, got {text!r}")
    return int(text)
