"""What a notebook says of itself: whose it is, and of which exercise; nothing in it is run."""

import re
from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from dhlab.grading.check import name_in
from dhlab.grading.exercise import seed_of
from dhlab.grading.plain import one_line
from dhlab.grading.results import Row
from dhlab.grading.submissions import Submission
from dhlab.grading.whose import is_same_person, name_key

TYPED = re.compile(r"""^STUDENT\s*=\s*(?P<quote>["'])(?P<name>.*?)(?P=quote)""", re.MULTILINE)
CHECKS = re.compile(r"""\bchecks\(\s*(["'])(?P<text>[A-Za-z0-9+/=]+)\1""")


@dataclass(frozen=True)
class Named:
    """Whose numbers a notebook is marked with.

    Attributes
    ----------
    name : str
        The numbers are drawn from it.
    typed : str
        The name in the notebook; empty where there is none, or where all have the same numbers.
    whose : str
        A sentence, where `name` is that of the notebook and none that is known of the submission.
    """

    name: str
    typed: str = ""
    whose: str = ""


def named(submission: Submission, cells: Iterable[str]) -> Named:
    """Say whose numbers a notebook is marked with: those of the name that it gives.

    A list of students says otherwise where it has another full name for them: then the numbers
    are those of the list.

    Parameters
    ----------
    submission : Submission
    cells : iterable of str

    Examples
    --------
    >>> named(Submission("al1", ("al1",)), ['STUDENT = "Ada"']).whose
    "The numbers are those of 'Ada', whom the notebook names; the submission is that of 'al1'."
    """
    found = [found["name"].strip() for cell in cells for found in TYPED.finditer(cell)]
    typed, names = (found[-1] if found else ""), submission.names
    if not typed:
        return Named(names[0])
    if is_same_person(typed, names):
        return Named(typed, typed)
    if submission.is_listed:
        return Named(names[0], typed)
    shown = one_line(typed, 100)
    whose = (
        f"The numbers are those of '{shown}', whom the notebook names; the submission is that of "
        f"'{submission.student}'."
    )
    return Named(typed, typed, whose)


def other_exercise(cells: Iterable[str], exercise: str) -> str:
    """Return the exercise that the checks of a notebook belong to, if it is another than this."""
    found = [name_in(found["text"]) for cell in cells for found in CHECKS.finditer(cell)]
    others = [name for name in found if name]
    is_this = any(name_key(name) == name_key(exercise) for name in others)
    return "" if is_this or not others else others[0]


def told_of_other(row: Row, other: str, exercise: str) -> Row:
    """Say of a row that its notebook has the checks of another exercise.

    One without any answer is a notebook of that exercise. Else the marks stay, and somebody must
    look: the folder of the exercise may have got another name since the notebook was handed out.
    """
    if all(judged.reason == "missing" for judged in row.questions):
        reason = f"This is a notebook of '{other}', not of '{exercise}'."
        return replace(row, status="unreadable", reason=reason, points=0, questions=(), notes=())
    reason = f"The notebook has the checks of '{other}', not those of '{exercise}'."
    return replace(row, status="second look", reason=f"{row.reason} {reason}".strip())


def doubles(rows: Iterable[Row]) -> list[list[Row]]:
    """Return the rows of submissions that name the same student, name by name."""
    found: dict[int, list[Row]] = defaultdict(list)
    for row in rows:
        if row.typed:
            found[seed_of("", row.typed)].append(row)
    return [group for group in found.values() if len(group) > 1]


def told_of_doubles(rows: Sequence[Row]) -> list[Row]:
    """Note in each row whose notebook names a student whom others name too, how many do."""
    notes: dict[str, str] = {}
    for group in doubles(rows):
        note = f"{len(group)} submissions name '{one_line(group[0].typed, 100)}'."
        notes |= dict.fromkeys((row.student for row in group), note)
    return [
        replace(row, odd=(*row.odd, notes[row.student])) if row.student in notes else row
        for row in rows
    ]
