"""Whose work was handed in, and which notebook of theirs is meant: one submission per student.

Four arrangements are known, and may be mixed: notebooks side by side, a folder per student,
nbgrader's `submitted/<student>/<exercise>/`, and what learning platforms pack. Where two notebooks
could be meant, none is taken: the submission then says which there are.
"""

import hashlib
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from dhlab.errors import InputError
from dhlab.grading.entries import Entry
from dhlab.grading.reading import Notebook, read_notebook
from dhlab.grading.roster import Person
from dhlab.grading.whose import Owner, is_for_another, name_key, owner_of_file, owner_of_folder

NOTEBOOK = ".ipynb"
ASIDE = (".csv", ".md", ".html", ".ini", ".db", ".log", ".yml", ".yaml", ".toml", ".cfg", ".xml")
"""Files beside the notebooks that nobody hands in for one."""
MOST_NAMED = 5


@dataclass(frozen=True)
class Submission:
    """What one student handed in.

    Attributes
    ----------
    student : str
        As the class's results name them; different for each submission of a class.
    names : tuple of str
        All names that are known of them; the first is the one their own numbers come from.
    where : str
        The notebook's path below what was handed in.
    status : {'', 'missing', 'unreadable'}
        Empty where there is one notebook.
    reason : str
        For a status: a sentence.
    notes : tuple of str
        What is odd, in sentences for the instructor.
    is_listed : bool
        Whether the first name is a full name of the list of students.
    """

    student: str
    names: tuple[str, ...]
    where: str = ""
    status: str = ""
    reason: str = ""
    notes: tuple[str, ...] = ()
    is_listed: bool = False
    entry: Entry | None = field(default=None, repr=False)

    def read(self) -> tuple[str, Notebook]:
        """Return the SHA-256 of the notebook, and its code.

        Raises
        ------
        InputError
            With the sentence for a submission that cannot be read.
        """
        try:
            if self.entry is None:
                raise InputError("is not there")
            content = self.entry.read()
            return hashlib.sha256(content).hexdigest(), read_notebook(content)
        except InputError as error:
            raise InputError(f"{self.where!r} {error}.") from error


def find_submissions(
    entries: Sequence[Entry],
    exercise: str,
    others: Iterable[str] = (),
    people: Sequence[Person] = (),
) -> tuple[Submission, ...]:
    """Find each student's submission: exactly one per student, whatever was handed in.

    Parameters
    ----------
    entries : sequence of Entry
        From `handed_in`.
    exercise : str
        Name of the exercise.
    others : iterable of str
        Names of other exercises; what is named as one of them belongs there.
    people : sequence of Person
        The students there should be. Who handed in nothing is `missing`; who is not among them is
        marked all the same.

    Returns
    -------
    submissions : tuple of Submission
        In the order of the students' names.
    """
    others = [name for name in others if name_key(name) != name_key(exercise)]
    owned = _by_owner(_below_submitted(entries), exercise, others)
    in_layout = any(_is_for(path, exercise) for paths in owned.values() for path in paths)
    found = [
        _submission(group, _meant(group.paths, exercise, others, in_layout))
        for group in _groups(owned, people)
    ]
    return tuple(sorted(found, key=lambda s: (name_key(s.student), s.student)))


@dataclass(frozen=True)
class _Path:
    """An entry, and what of its path lies below the student's own folder."""

    entry: Entry
    rest: tuple[str, ...]


@dataclass(frozen=True)
class _Group:
    """Everything that one student handed in."""

    student: str
    names: tuple[str, ...]
    paths: Sequence[_Path]
    notes: tuple[str, ...] = ()
    is_listed: bool = False


def _below_submitted(entries: Sequence[Entry]) -> list[Entry]:
    """Go into nbgrader's folder of submissions, where the course's folder was given."""
    inside = [e for e in entries if e.parts[0] == "submitted" and len(e.parts) > 1]
    if not inside:
        return list(entries)
    return [Entry(e.parts[1:], e.is_folder, e.problem, e.content) for e in inside]


def _by_owner(
    entries: Sequence[Entry], exercise: str, others: Sequence[str]
) -> dict[Owner, list[_Path]]:
    """Sort files by student; a student whose folder is empty is there too."""
    owned: dict[tuple[str, str], tuple[Owner, list[_Path]]] = {}
    for entry in entries:
        first, *rest = entry.parts
        in_folder = bool(rest) or entry.is_folder or (bool(entry.problem) and "." not in first)
        if not in_folder and (_is_aside(first) or is_for_another(first, exercise, others)):
            continue
        owner = owner_of_folder(first) if in_folder else owner_of_file(first, exercise)
        paths = owned.setdefault(owner.key, (owner, []))[1]
        if not entry.is_folder:
            paths.append(_Path(entry, tuple(rest)))
    return dict(owned.values())


def _is_aside(file: str) -> bool:
    return file.lower().endswith(ASIDE) or file.lower() in ("readme", "readme.txt")


def _is_for(path: _Path, exercise: str) -> bool:
    """Whether a file lies in a folder named as the exercise, inside the student's."""
    return len(path.rest) > 1 and name_key(path.rest[0]) == name_key(exercise)


def _groups(owned: Mapping[Owner, list[_Path]], people: Sequence[Person]) -> Iterator[_Group]:
    """Put together what belongs to one student of the list; each other owner is one student."""
    theirs: dict[str, list[_Path]] = {person.student: [] for person in people}
    strangers: dict[Owner, list[_Path]] = {}
    for owner, paths in owned.items():
        meant = [person for person in people if person.has_number(owner)]
        meant = meant or [person for person in people if person.is_owner(owner)]
        if len(meant) == 1:
            theirs[meant[0].student] += paths
        else:
            strangers[owner] = paths
    for person in people:
        group = _Group(person.student, person.names, theirs[person.student])
        yield replace(group, is_listed=person.has_full_name)
    taken = {name_key(person.student) for person in people}
    often = Counter(name_key(owner.name) for owner in strangers)
    for owner, paths in strangers.items():
        label = owner.name if name_key(owner.name) else "(no name)"
        if owner.number and (often[name_key(label)] > 1 or name_key(label) in taken):
            label = f"{owner.name} ({owner.number})"
        while name_key(label) in taken:
            label += " (another)"
        taken.add(name_key(label))
        notes = ("Not on the list of students.",) if people else ()
        yield _Group(label, (owner.name,), paths, notes)


def _meant(
    paths: Sequence[_Path], exercise: str, others: Sequence[str], in_layout: bool
) -> list[Entry]:
    """Find what of a student's files can be the notebook: notebooks, or else anything."""
    own = [path for path in paths if _is_for(path, exercise)]
    if not own:
        shut = {name_key(name) for name in others}
        for path in paths:
            in_other = len(path.rest) > 1 and (in_layout or name_key(path.rest[0]) in shut)
            if not in_other and not is_for_another(path.entry.parts[-1], exercise, others):
                own.append(path)
    notebooks = [p.entry for p in own if p.entry.parts[-1].lower().endswith(NOTEBOOK)]
    return notebooks or [path.entry for path in own]


def _submission(group: _Group, meant: Sequence[Entry]) -> Submission:
    """Say which notebook of a student is read, or why none is."""
    plain = Submission(group.student, group.names, notes=group.notes, is_listed=group.is_listed)
    if len(meant) == 1:
        return replace(plain, where=meant[0].path, entry=meant[0])
    if not meant:
        return replace(plain, status="missing", reason="No notebook was handed in.")
    which = ", ".join(repr(entry.path) for entry in meant[:MOST_NAMED])
    which += ", ..." if len(meant) > MOST_NAMED else ""
    if meant[0].parts[-1].lower().endswith(NOTEBOOK):
        reason = f"There are {len(meant)} notebooks: {which}. Which one is meant? Leave that one."
        return replace(plain, status="unreadable", reason=reason)
    reason = f"No notebook was handed in, but {len(meant)} other files: {which}."
    return replace(plain, status="missing", reason=reason)
