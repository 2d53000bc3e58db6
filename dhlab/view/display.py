"""How handles are shown: by a call, or as the last expression of a cell."""

import sys
from typing import Any

from dhlab.scene.handle import Handle
from dhlab.view.view import WIDGET, View


def show(*handles: Handle, **options: Any) -> View:
    """Give a new view of some handles: a cell that ends in this call shows it.

    Parameters
    ----------
    *handles : Handle
        Coordinate systems, blocks, robots.
    **options
        Of the `View`.

    Returns
    -------
    view : View

    Examples
    --------
    >>> from dhlab.scene.csys import Csys
    >>> show(Csys(name="a"), Csys(name="b"), height=300)
    View('view': a, b)
    """
    return View(**options).add(*handles)


def handle_mimebundle(handle: Handle, include: Any = None, exclude: Any = None) -> dict[str, Any]:
    """Return what a cell that ends in a handle shows: a view of its own, or a line of text.

    IPython calls this for every `Handle` once it is registered.

    Parameters
    ----------
    handle : Handle
    include, exclude : ignored

    Returns
    -------
    bundle : dict
        Representations by MIME type.
    """
    bundle: dict[str, Any] = {"text/plain": repr(handle)}
    shown = View(handle.name).add(handle)._repr_mimebundle_()
    if WIDGET in shown:
        bundle[WIDGET] = shown[WIDGET]
    return bundle


def register() -> None:
    """Let handles show themselves as the last expression of a cell, if IPython runs.

    ``dhlab/__init__.py`` calls this, so that the scene needs to know nothing of views.
    """
    ipython = sys.modules.get("IPython")
    shell = None if ipython is None else ipython.get_ipython()
    if shell is not None:
        shell.display_formatter.mimebundle_formatter.for_type(Handle, handle_mimebundle)
