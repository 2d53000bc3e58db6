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
wrong.py at least five typical wrong answers, each with the diagnosis meant for it:

  # %% rot_z: sign-1
  rot_z = lambda angle: rotz(-angle)

Before the colon stands the question, behind it the key of a mistake or some words of what the
student is told. A build that does not find them says which keys and words there are.\
"""
BUILD = """\
Make the notebook for students of each exercise: FOLDER is one, or holds several.

Each is proved first. It is refused, with file and line, if an answer fails its own checks, if the
blank notebook does not run to its end or gets a point, if a wrong answer gets a point or not its
diagnosis, if the notebook or a hint still holds a line of an answer, if a question has no check
cell or a check cell no question, or if the text tells other points than checks.py: "(2 points)" at
the end of a heading for what is checked below it, "**Points.** 6" for all.\
"""
NEW = """\
Begin a new exercise: a copy of another one, to be changed. What is to be changed is told.\
"""
NEXT = """\
dhlab: {made} is a copy of {like}. Change in it
  exercise.py  the text, the answers, and a cell check("NAME", NAME) for each question
  checks.py    the questions of these names: task, points, hint, and the students' numbers
  wrong.py     the wrong answers: those of the old questions must go, five new ones are needed
and then: dhlab exercise build {made}\
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
            first, *more = str(error).splitlines()
            said = f"\n  {first}" if more else f" {first}"
            print("\n  ".join([f"dhlab: {folder.resolve().name} is refused:{said}", *more]))
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
    print(NEXT.format(made=made, like=like.resolve().name))
    return 0
