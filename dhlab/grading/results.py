"""What marking a class gave: a row per student, and the run that they come from.

`results.json` holds everything; all other files are made from it.
"""

import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field, fields
from pathlib import Path
from typing import Any, get_args

from dhlab.errors import DhlabError
from dhlab.grading.judge import Judged
from dhlab.grading.mark import Marked, Status

STATUSES: tuple[Status, ...] = get_args(Status)
FORMAT = 1
RESULTS = "results.json"


@dataclass(frozen=True)
class Run:
    """What all marks of a class depend on.

    Attributes
    ----------
    exercise : str
    digest : str
        SHA-256 of its `checks.py` and of what answers may use.
    course : str
    seed : int
        The hidden cases are drawn from it.
    sandbox : str
    versions : mapping of str to str
        Of what took part, by name.
    source : str
        Where the submissions were.
    title : str
        Of the exercise. On this and on `source` the marks do not depend.
    """

    exercise: str
    digest: str
    course: str
    seed: int
    sandbox: str
    versions: Mapping[str, str]
    source: str = field(default="", compare=False)
    title: str = field(default="", compare=False)


@dataclass(frozen=True)
class Row:
    """What became of one student's submission.

    Attributes
    ----------
    student : str
    name : str
        The name that their own numbers come from.
    status : {'graded', 'second look', 'partly graded', 'unreadable', 'missing'}
    reason : str
        For all but 'graded': a sentence.
    points, out_of : float
    questions : tuple of Judged
        Empty where nothing could be marked.
    notes : tuple of str
        What marking noticed, in sentences.
    odd : tuple of str
        What is odd about the file, in sentences.
    details : mapping
        What else marking says: seconds, cells left out, names imported, the cases.
    where : str
        The notebook's path below what was handed in.
    sha256 : str
        Of the notebook.
    failed : str
        Where marking itself failed: why, for the instructor. The next run marks it anew.
    typed : str
        The name in the notebook, where students have numbers of their own.
    whose : str
        A sentence, where this name gave the numbers and the submission is known by another one.
    """

    student: str
    name: str
    status: str
    reason: str
    points: float
    out_of: float
    questions: tuple[Judged, ...] = ()
    notes: tuple[str, ...] = ()
    odd: tuple[str, ...] = ()
    details: Mapping[str, Any] | None = None
    where: str = ""
    sha256: str = ""
    failed: str = ""
    typed: str = ""
    whose: str = ""

    @property
    def all_notes(self) -> tuple[str, ...]:
        """What is odd about the file, whose numbers it has, and what marking noticed."""
        return (*self.odd, *([self.whose] if self.whose else ()), *self.notes)

    def as_json(self) -> dict[str, Any]:
        """Return it as plain data."""
        return asdict(self)


@dataclass(frozen=True)
class Column:
    """A question as all students have it: its name, and what it is worth."""

    name: str
    out_of: float


@dataclass(frozen=True)
class ClassResults:
    """A class that was marked.

    Attributes
    ----------
    run : Run
    columns : tuple of Column
    rows : tuple of Row
        One per student, in the order of their names.
    finished : str
        When, as an ISO date and time.
    """

    run: Run
    columns: tuple[Column, ...]
    rows: tuple[Row, ...]
    finished: str = ""

    @property
    def out_of(self) -> float:
        """What full marks are."""
        return sum(column.out_of for column in self.columns)

    def points_of(self, row: Row) -> list[float]:
        """Return a student's points, question by question; 0 where there is nothing."""
        points = {judged.name: judged.points for judged in row.questions}
        return [points.get(column.name, 0) for column in self.columns]


def row_of(marked: Marked, student: str, sha256: str) -> Row:
    """Make a row from what marking one submission gave."""
    own = {field.name for field in fields(Row)}
    rest = {f.name: getattr(marked, f.name) for f in fields(marked) if f.name not in own}
    return Row(
        student=student,
        name=marked.student,
        status=marked.status,
        reason=marked.reason,
        points=marked.points,
        out_of=marked.out_of,
        questions=tuple(marked.questions),
        notes=tuple(marked.notes),
        details={key: _plain(value) for key, value in rest.items() if key != "questions"},
        sha256=sha256,
    )


def row_from(data: Mapping[str, Any]) -> Row:
    """Make a row from plain data.

    Raises
    ------
    DhlabError
        The data are no row.
    """
    try:
        asked = (dict(question) for question in data["questions"])
        questions = tuple(Judged(**q | {"mistakes": tuple(q["mistakes"])}) for q in asked)
        texts = {"notes": tuple(data["notes"]), "odd": tuple(data["odd"])}
        return Row(**dict(data) | {"questions": questions} | texts)
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise DhlabError(f"not a row of results ({error})") from error


def write_results(path: Path, results: ClassResults) -> None:
    """Write everything that is known of a class, as JSON."""
    document = {
        "format": FORMAT,
        **asdict(results.run),
        "finished": results.finished,
        "questions": [asdict(column) for column in results.columns],
        "students": [row.as_json() for row in results.rows],
    }
    write_whole(path, json.dumps(document, indent=1, ensure_ascii=False, allow_nan=False) + "\n")


def read_results(path: Path) -> tuple[Run, list[Row]]:
    """Read the run and the rows of a class.

    Raises
    ------
    DhlabError
        It is none of our files, or damaged.
    """
    try:
        document = json.loads(path.read_text("utf-8"))
        run = run_from(document)
        return run, [row_from(row) for row in document["students"]]
    except (OSError, ValueError, KeyError, TypeError, DhlabError) as error:
        raise DhlabError(
            f"{str(path)!r} is not a file of results ({error}); move it away, or name another --out"
        ) from error


def run_from(document: Mapping[str, Any]) -> Run:
    """Take the run out of plain data."""
    known = {"source": "", "title": "", **document}
    return Run(**{field.name: known[field.name] for field in fields(Run)})


def write_whole(path: Path, text: str) -> None:
    """Write a file so that there is the old one or the new one, never a half."""
    half = path.with_name(f".{path.name}.part")
    half.write_text(text, "utf-8", newline="\n")
    os.replace(half, path)


def _plain(value: Any) -> Any:
    return list(value) if isinstance(value, Sequence) and not isinstance(value, str) else value
