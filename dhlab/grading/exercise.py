"""An exercise: its questions, and each student's own numbers, from the text of a `checks.py`."""

import hashlib
import json
import re
import traceback
import unicodedata
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from dhlab.errors import DhlabError, InputError
from dhlab.grading.question import Question
from dhlab.scene.handle import Handle

CHECKS, NOTEBOOK = "checks.py", "exercise.py"
Given = dict[str, Any]


@dataclass(frozen=True)
class Exercise:
    """The questions of an exercise; made by `load_exercise` or `exercise_from_text`.

    It can be sent to other processes: what travels is the text.

    Attributes
    ----------
    name : str
        That of its folder.
    text : str
        Its `checks.py`.
    where : str
        What an error calls that file.
    tools : tuple of str
        What its notebook imports of dhlab: answers may compute with that, and with nothing else
        of dhlab.
    course : str
        What its notebook says to ``checks(course=...)``; part of the seed of students' numbers.
    """

    name: str
    text: str
    where: str
    parts: Mapping[str, Callable[..., Any]] = field(repr=False, compare=False)
    tools: tuple[str, ...] = ()
    course: str = ""

    @property
    def is_personal(self) -> bool:
        """Whether each student has numbers of their own."""
        return "numbers" in self.parts

    def numbers(self, student: str, course: str = "") -> Given:
        """Return the numbers of one student: the same whenever and wherever they are asked for.

        Parameters
        ----------
        student : str
            However it is written: capital letters and spaces do not count.
        course : str

        Returns
        -------
        given : dict
            Plain numbers, strings, lists and dicts; empty where all students have the same.
        """
        if not self.is_personal:
            return {}
        with speaking_of(self.where):
            drawn = self.parts["numbers"](np.random.default_rng(seed_of(course, student)))
            if not isinstance(drawn, dict):
                raise InputError(f"numbers(rng) must return a dict, got {drawn!r}")
            given: Given = json.loads(json.dumps(drawn, allow_nan=False, default=_plain))
        return given

    def questions(self, given: Mapping[str, Any]) -> tuple[Question, ...]:
        """Return the questions for a student with these numbers.

        Parameters
        ----------
        given : mapping
            From `numbers`.

        Raises
        ------
        DhlabError
            The file's own error, with its line; no question; two of one name.
        """
        with speaking_of(self.where):
            asked = tuple(self.parts["questions"](dict(given)))
        odd = next((q for q in asked if not isinstance(q, Question)), None)
        if odd is not None:
            raise DhlabError(f"{self.where}: questions(given) must give Questions, got {odd!r}")
        names = [q.name for q in asked]
        twice = next((name for name in names if names.count(name) > 1), None)
        if twice is not None or not names:
            what = "no question" if twice is None else f"two questions {twice!r}"
            raise DhlabError(f"{self.where}: questions(given) gives {what}")
        return asked

    def cases(self, question: Question, rng: np.random.Generator) -> tuple[tuple[Any, ...], ...]:
        """Return the arguments of all cases of a question: the examples, then those drawn."""
        with speaking_of(self.where):
            return question.cases(rng)

    def picture(self, name: str, given: Mapping[str, Any]) -> tuple[Handle, ...]:
        """Return what a picture of this exercise shows.

        Parameters
        ----------
        name : str
        given : mapping
            From `numbers`.

        Raises
        ------
        InputError
            There is no such picture.
        """
        with speaking_of(self.where):
            drawn: dict[str, Sequence[Handle]] = {}
            if "pictures" in self.parts:
                drawn = self.parts["pictures"](dict(given))
        if name not in drawn:
            there = ", ".join(drawn) or "none"
            raise InputError(f"exercise {self.name!r} has no picture {name!r}; there are: {there}")
        return tuple(drawn[name])

    def __reduce__(self) -> tuple[Callable[..., "Exercise"], tuple[Any, ...]]:
        return exercise_from_text, (self.text, self.name, self.where, self.tools, self.course)


def load_exercise(folder: Path) -> Exercise:
    """Load the exercise in a folder, from the `checks.py` in it.

    Parameters
    ----------
    folder : Path

    Returns
    -------
    exercise : Exercise

    Raises
    ------
    DhlabError
        There is no such file, or it has an error; the message names file and line.
    """
    path = Path(folder) / CHECKS
    text, notebook = text_of(path), path.with_name(NOTEBOOK)
    cells = text_of(notebook) if notebook.is_file() else ""
    named = re.search(r"""\bchecks\([^)]*course\s*=\s*(["'])(.*?)\1""", cells)
    course = named[2] if named else ""
    tools = imports_from_dhlab(cells)
    return exercise_from_text(text, path.resolve().parent.name, str(path), tools, course)


def title_of(folder: Path) -> str:
    """Return the title of an exercise's notebook, or the exercise's name where it has none."""
    notebook = Path(folder) / NOTEBOOK
    found = re.search(r"^# # (.*\S)", text_of(notebook) if notebook.is_file() else "", re.MULTILINE)
    return found[1] if found else notebook.resolve().parent.name


def text_of(path: Path) -> str:
    """Text of one of an exercise's files.

    Raises
    ------
    DhlabError
        There is no such file, or it is not written in UTF-8.
    """
    if not path.is_file():
        raise DhlabError(f"{path.parent} is no exercise: there is no {path.name} in it")
    try:
        return path.read_text("utf-8")
    except UnicodeDecodeError as error:
        raise DhlabError(f"{path} is not written in UTF-8 ({error})") from None


def exercise_from_text(
    text: str, name: str, where: str = CHECKS, tools: Sequence[str] = (), course: str = ""
) -> Exercise:
    r"""Make an exercise from the text of a `checks.py`.

    Parameters
    ----------
    text : str
        Python that defines ``questions(given)``; it may define ``numbers(rng)``, the student's
        own numbers, and ``pictures(given)``, what is drawn, as lists of handles by name.
    name : str
    where : str
        What an error calls the file.
    tools : sequence of str
        What answers may use of dhlab.
    course : str
        What its notebook says to ``checks(course=...)``.

    Returns
    -------
    exercise : Exercise

    Raises
    ------
    DhlabError
        The text has an error; the message names the line.

    Examples
    --------
    >>> exercise_from_text("import numpy\nnumpy.rotz", "turns")
    Traceback (most recent call last):
    ...
    dhlab.errors.DhlabError: checks.py, line 2: AttributeError: module 'numpy' has no attribute
    'rotz'
    """
    namespace: dict[str, Any] = {"__name__": f"checks of {name}"}
    with speaking_of(where):
        exec(compile(text, where, "exec"), namespace)
    known = ("questions", "numbers", "pictures")
    parts = {part: namespace[part] for part in known if callable(namespace.get(part))}
    if "questions" not in parts:
        raise DhlabError(f"{where} must define questions(given), which returns a list of Questions")
    return Exercise(name, text, where, parts, tuple(tools), course)


def imports_from_dhlab(text: str) -> tuple[str, ...]:
    r"""Names that ``from dhlab import ...`` brings into a notebook written as text.

    Examples
    --------
    >>> imports_from_dhlab("import numpy\nfrom dhlab import deg, rotz as turn\n")
    ('deg', 'rotz')
    """
    statements = re.findall(r"^from dhlab import (?:\(([^)]*)\)|(.+))$", text, re.MULTILINE)
    words = [word.split() for names in statements for word in "".join(names).split(",")]
    return tuple(dict.fromkeys(word[0] for word in words if word))


def seed_of(course: str, student: str) -> int:
    """Return the seed of a student's own numbers.

    Parameters
    ----------
    course, student : str
        Capital letters, accents written in another way, and spaces do not count.

    Examples
    --------
    >>> seed_of("robots", "Ada  Lovelace") == seed_of("robots", " ada lovelace")
    True
    """
    words = [" ".join(_folded(text).split()) for text in (course, student)]
    return int.from_bytes(hashlib.sha256("\n".join(words).encode("utf-8", "replace")).digest()[:8])


@contextmanager
def speaking_of(where: str) -> Iterator[None]:
    """Turn any error of an instructor's file into one that names the file and the line."""
    try:
        yield
    except (Exception, SystemExit) as error:
        line = _line(error, where)
        place = f"{where}, line {line}" if line else where
        what = f"{error.msg}" if isinstance(error, SyntaxError) else str(error)
        kind = "" if isinstance(error, DhlabError) else f"{type(error).__name__}: "
        raise DhlabError(f"{place}: {kind}{what}") from error


def _line(error: BaseException, where: str) -> int | None:
    if isinstance(error, SyntaxError) and error.filename == where:
        return error.lineno
    frames = traceback.extract_tb(error.__traceback__)
    return next((frame.lineno for frame in reversed(frames) if frame.filename == where), None)


def _folded(text: str) -> str:
    return unicodedata.normalize("NFKC", text.casefold())


def _plain(value: Any) -> Any:
    if isinstance(value, np.ndarray | np.generic):
        return value.tolist()
    raise InputError(f"numbers(rng) must give numbers, strings, lists and dicts, got {value!r}")
