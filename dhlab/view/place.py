"""Where a file may be written."""

import os
from pathlib import Path

from dhlab.errors import InputError


def checked_path(path: str | os.PathLike[str], what: str, example: str) -> Path:
    """Return where a file may be written; one that exists may be written over.

    Parameters
    ----------
    path : str or path
    what, example : str
        What the file is, and a name for one, for the error.

    Returns
    -------
    place : Path

    Raises
    ------
    InputError
        No path, a folder, or a file in a folder that there is not.

    Examples
    --------
    >>> checked_path("no/such/folder/limb.png", "a picture", "limb.png")
    Traceback (most recent call last):
    ...
    dhlab.errors.InputError: there is no folder 'no/such/folder' for 'limb.png'
    """
    if not isinstance(path, str | os.PathLike) or not os.fspath(path):
        raise InputError(f"{what} needs a path such as {example!r}, got {path!r}")
    place = Path(path)
    if place.is_dir():
        raise InputError(f"{str(place)!r} is a folder; {what} needs the path of a file in it")
    if not place.parent.is_dir():
        raise InputError(f"there is no folder {str(place.parent)!r} for {place.name!r}")
    return place
