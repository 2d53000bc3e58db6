"""Whose a file is: what learning platforms, nbgrader and people make of a student's name."""

import re
import unicodedata
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import permutations

FOLDERS = (
    re.compile(r"(?P<name>.+)_(?P<id>\d+)_assignsubmission_(?:file|onlinetext)_?"),  # Moodle
    re.compile(r"\d+-(?P<id>\d+) ?- (?P<name>.+?) ?- .+"),  # Brightspace
)
FILES = (
    re.compile(r"(?P<name>.+?)_(?P<id>\d+)_assignsubmission_file_+.+"),  # Moodle, without folders
    re.compile(r"(?P<name>[^_]+)(?:_LATE)?_(?P<id>\d+)_\d+_.+"),  # Canvas
    re.compile(r".+?_(?P<name>[^_]+)_attempt_[\d-]+.*"),  # Blackboard
)
COPY = re.compile(r"(?: ?\(\d+\)|-Copy\d*)$")
"""What a browser and JupyterLab add to the name of a second file."""
WORDS = 5
"""More words of a name are not tried in every order."""


@dataclass(frozen=True)
class Owner:
    """A student as a platform names them.

    Attributes
    ----------
    name : str
    number : str
        The platform's own number of them, which tells two of one name apart; often empty.
    """

    name: str
    number: str = ""

    @property
    def key(self) -> tuple[str, str]:
        """What two spellings of one student have in common."""
        return name_key(self.name), self.number


def owner_of_folder(folder: str) -> Owner:
    """Read a student's name out of the name of their folder.

    Examples
    --------
    >>> owner_of_folder("Ada Lovelace_12345_assignsubmission_file_")
    Owner(name='Ada Lovelace', number='12345')
    >>> owner_of_folder("ada")
    Owner(name='ada', number='')
    """
    return _matched(FOLDERS, folder) or Owner(folder)


def owner_of_file(file: str, exercise: str) -> Owner:
    """Read a student's name out of the name of a file.

    Parameters
    ----------
    file : str
        As it lies in a folder without folders of the students.
    exercise : str
        Name of the exercise, which is often written before or behind that of the student.

    Examples
    --------
    >>> owner_of_file("lovelaceada_LATE_123_456_turns.ipynb", "01_turns").name
    'lovelaceada'
    >>> owner_of_file("ada_01_turns (1).ipynb", "01_turns").name
    'ada'
    """
    stem = COPY.sub("", stem_of(file))
    alone = without_exercise(stem, exercise)
    odd = re.match(r"\d+_\d+_", exercise) is not None  # such a name looks like numbers of Canvas
    platform = None if odd and alone != stem else _matched(FILES, file)
    return platform or Owner(alone)


def stem_of(file: str) -> str:
    """Return a file's name without what programs put behind its dot.

    Examples
    --------
    >>> stem_of("ada.ipynb.txt"), stem_of("a.b.ipynb"), stem_of("ada")
    ('ada', 'a.b', 'ada')
    """
    plain = re.sub(r"\.(txt|json)$", "", file, flags=re.IGNORECASE)
    return re.sub(r"(?<=.)\.\w{1,6}$", "", plain)


def without_exercise(stem: str, exercise: str) -> str:
    """Take the name of the exercise, and what joins it, off the name of a file.

    Examples
    --------
    >>> without_exercise("ada_07_dh_link", "07_dh_link"), without_exercise("ada", "07_dh_link")
    ('ada', 'ada')
    """
    name = re.escape(exercise)
    for pattern in (rf"(?P<rest>.+?)[-_ .]+{name}", rf"{name}[-_ .]+(?P<rest>.+)"):
        found = re.fullmatch(pattern, stem, re.IGNORECASE)
        if found:
            return found["rest"]
    return stem


def is_for_another(file: str, exercise: str, others: Iterable[str]) -> bool:
    """Whether a file's name says that it belongs to another exercise; the longest name counts.

    Examples
    --------
    >>> is_for_another("ada_02_sequences.ipynb", "01_turns", ["02_sequences"])
    True
    """
    stem = COPY.sub("", stem_of(file))
    named = [name for name in (exercise, *others) if _is_named_as(stem, name)]
    return bool(named) and max(named, key=len) != exercise


def _is_named_as(stem: str, exercise: str) -> bool:
    if name_key(stem) == name_key(exercise) or without_exercise(stem, exercise) != stem:
        return True
    return re.fullmatch(rf".+_\d+_{re.escape(exercise)}", stem, re.IGNORECASE) is not None


def name_key(name: str) -> str:
    """Return what all spellings of a name have in common: not the capitals, nor the spaces."""
    return " ".join(unicodedata.normalize("NFKC", name.casefold()).split())


def is_same_person(typed: str, names: Iterable[str]) -> bool:
    """Whether a name as a student typed it is one of these, as lists and platforms write them.

    Examples
    --------
    >>> is_same_person("Ada Lovelace", ["lovelaceada"]), is_same_person("Ada", ["Eva"])
    (True, False)
    """
    wanted = {_letters(name) for name in names} - {""}
    words = name_key(typed).replace(",", " ").split()
    if len(words) > WORDS:
        return _letters(typed) in wanted
    return any(_letters("".join(order)) in wanted for order in permutations(words))


def _letters(name: str) -> str:
    return "".join(c for c in name_key(name) if c.isalnum())


def _matched(patterns: Iterable[re.Pattern[str]], text: str) -> Owner | None:
    for pattern in patterns:
        found = pattern.fullmatch(text)
        if found:
            parts = found.groupdict()
            return Owner(parts["name"].strip(), parts.get("id") or "")
    return None
