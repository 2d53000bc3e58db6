"""`dhlab exercise`: prove exercises and make their notebooks, or begin a new one."""

import argparse
from pathlib import Path

from dhlab.cli.commands import Commands, add_command
from dhlab.errors import DhlabError
from dhlab.workcopy import home

EXERCISE = """\
Make the notebooks of exercises, or begin a new exercise.

An exercise is a folder: exercise.py is the whole notebook as text (jupytext's percent form), with
its answers between '### BEGIN SOLUTION' and '### END SOLUTION'; checks.py holds its questions;
wrong.py at least five typical wrong answers, each with the diagnosis meant for it.\
"""
BUILD = """\
Make the notebook for students of each exercise: FOLDER is one, or holds several.

Each is proved first. It is refused, with file and line, if an answer fails its own checks, if the
blank notebook does not run to its end or gets a point, if a wrong answer gets a point or not its
diagnosis, or if the notebook still holds a line of an answer.\
"""
NEW = """\
Begin a new exercise: a copy of another one, to be changed.\
"""


def add_exercise(commands: Commands) -> None:
    """Add `dhlab exercise`."""
    short = "make the notebooks of exercises, or begin a new exercise"
    exercise = add_command(commands, "exercise", short, EXERCISE)
    kinds = exercise.add_subparsers(title="what to do", metavar="WHAT", required=True)
    short = "prove exercises and make their notebooks"
    build = add_command(kinds, "build", short, BUILD, run_build)
    build.add_argument(
        "folders",
        nargs="*",
        type=Path,
        default=[Path("exercises")],
        metavar="FOLDER",
        help="exercises, or folders of them (default: exercises)",
    )
    new = add_command(kinds, "new", "begin a new exercise", NEW, run_new)
    new.add_argument("folder", type=Path, metavar="FOLDER", help="such as exercises/12_my_arm")
    new.add_argument(
        "--like",
        type=Path,
        metavar="FOLDER",
        help="the exercise to copy (default: the first that came with dhlab)",
    )


def run_build(options: argparse.Namespace) -> int:
    """Build each exercise; go on after one that is refused, and say so at the end."""
    from dhlab.grading.build import build, exercises_in

    refused = 0
    for folder in exercises_in(options.folders):
        try:
            built = build(folder)
        except DhlabError as error:
            refused += 1
            print(f"dhlab: {folder.name} is refused: {error}")
            continue
        done = "written" if built.changed else "up to date"
        print(
            f"dhlab: {built.notebook} {done} "
            f"({built.questions} questions, {built.wrong} wrong answers tried)"
        )
    if refused:
        raise DhlabError(f"{refused} of the exercises cannot be released yet")
    return 0


def run_new(options: argparse.Namespace) -> int:
    """Copy an exercise into a new folder."""
    from dhlab.grading.build import begin, exercises_in

    like = options.like or exercises_in([home() / "exercises"])[0]
    made = begin(options.folder, like)
    print(f"dhlab: {made} is a copy to be changed; then: dhlab exercise build {made}")
    return 0
