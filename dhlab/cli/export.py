"""`dhlab export`: a model or a lesson as one page."""

import argparse
from pathlib import Path

from dhlab.cli.commands import Commands, add_command
from dhlab.errors import InputError

EXPORT = """\
Write a model of dhlab.models or a lesson of dhlab.lessons.course as one HTML file: the picture,
sliders or steps, and nothing else needed.

The page opens from disk by double click, offline, on a phone too.\
"""


def add_export(commands: Commands) -> None:
    """Add `dhlab export`."""
    short = "write a model or a lesson as one HTML file that needs nothing else"
    export = add_command(commands, "export", short, EXPORT, run_export)
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
