"""The list of students of a course: who should have handed something in."""

import csv
import io
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from dhlab.errors import InputError
from dhlab.grading.reading import decoded
from dhlab.grading.whose import Owner, is_same_person, name_key

IDS = (
    *("student_id", "id", "username", "login", "login_id", "sis_login_id", "sis_user_id"),
    *("id_number", "email", "email_address"),
)
NAMES = ("name", "full_name", "student", "student_name")
FIRST, LAST = ("first_name", "firstname"), ("last_name", "lastname", "surname")


@dataclass(frozen=True)
class Person:
    """A student of the list.

    Attributes
    ----------
    student : str
        How the results name them: by the id, where the list has one.
    names : tuple of str
        All names and ids; the first is the full name, where the list has it.
    has_full_name : bool
        Whether it has one; a list of one word a line is taken for ids.
    """

    student: str
    names: tuple[str, ...]
    has_full_name: bool = True

    def has_number(self, owner: Owner) -> bool:
        """Whether a platform's own number of a student stands in the list."""
        return bool(owner.number) and owner.number in self.names

    def is_owner(self, owner: Owner) -> bool:
        """Whether a platform's name of a student is one of this student's."""
        known = name_key(owner.name) in {name_key(name) for name in self.names}
        return known or is_same_person(self.names[0], [owner.name])


def read_people(path: Path) -> tuple[Person, ...]:
    """Read a list of students: a CSV file with a heading, or one name a line.

    Parameters
    ----------
    path : Path
        Parted by commas, semicolons or tabs. Columns that are known, however they are capitalised:
        `IDS`; `NAMES`; `FIRST` with `LAST`. nbgrader's, Moodle's and Canvas's lists have some.

    Returns
    -------
    people : tuple of Person

    Raises
    ------
    InputError
        It cannot be read, has no such column, or names a student twice.
    """
    try:
        content = path.read_bytes()
    except OSError as error:
        raise InputError(f"the list of students {str(path)!r} cannot be read ({error})") from error
    people = people_from(decoded(content)[0], str(path))
    if not people:
        raise InputError(f"the list of students {str(path)!r} is empty")
    return people


def people_from(text: str, where: str = "the list of students") -> tuple[Person, ...]:
    r"""Read a list of students from its text.

    Examples
    --------
    >>> people_from("id,first_name,last_name\nal1,Ada,Lovelace\n")
    (Person(student='al1', names=('Ada Lovelace', 'al1'), has_full_name=True),)
    >>> people_from("Ada Lovelace\nKurt Gödel\n")[1].student
    'Kurt Gödel'
    >>> people_from("room,phone\n1,2\n")
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: the list of students: no column names the students; the heading must
    have one of student_id, id, username, name, student, first_name
    """
    rows = _rows(text, where)
    heading = [name_key(cell).replace(" ", "_") for cell in rows[0]] if rows else []
    known = {*IDS, *NAMES, *FIRST, *LAST}
    if known & set(heading):
        people = [_person(dict(zip(heading, row, strict=False))) for row in rows[1:]]
    elif all(len(row) == 1 for row in rows):
        lines = [" ".join(row[0].split()) for row in rows]
        people = [Person(name, (name,), " " in name) for name in lines if name]
    else:
        raise InputError(
            f"{where}: no column names the students; the heading must have one of "
            "student_id, id, username, name, student, first_name"
        )
    return _distinct([person for person in people if person is not None], where)


def _rows(text: str, where: str) -> list[list[str]]:
    """Split a list into its cells, by what its first line is split by."""
    delimiter = max(",;\t", key=text.lstrip("\r\n").partition("\n")[0].count)
    reader = csv.reader(io.StringIO(text, newline=None), delimiter=delimiter, strict=True)
    try:
        return [row for row in reader if any(row)]
    except csv.Error as error:
        raise InputError(f"{where}, line {reader.line_num}: {error}") from error


def _person(row: Mapping[str, str]) -> Person | None:
    ids = _there(row, IDS)
    parts = [*_there(row, FIRST)[:1], *_there(row, LAST)[:1]]
    full = [" ".join(parts)] if parts else _there(row, NAMES)
    names = tuple(dict.fromkeys([*full, *ids, *_there(row, NAMES)]))
    return Person((ids or full)[0], names, bool(full)) if names else None


def _there(row: Mapping[str, str], columns: Iterable[str]) -> list[str]:
    return [text for column in columns if (text := " ".join((row.get(column) or "").split()))]


def _distinct(people: Sequence[Person], where: str) -> tuple[Person, ...]:
    seen: set[str] = set()
    for person in people:
        if name_key(person.student) in seen:
            raise InputError(
                f"{where} names {person.student!r} twice; give each student an id of their own"
            )
        seen.add(name_key(person.student))
    return tuple(people)
