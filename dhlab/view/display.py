"""How handles are shown: by a call, or as the last expression of a cell."""

import sys
from collections.abc import Callable
from typing import Any

from dhlab.scene.handle import Handle
from dhlab.view.view import View


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
    return {**View(handle.name).add(handle)._repr_mimebundle_(), "text/plain": repr(handle)}


def register(**others: tuple[str, Callable[..., dict[str, Any]]]) -> None:
    """Let handles show themselves as the last expression of a cell, if IPython runs.

    ``dhlab/__init__.py`` calls this, so that the scene needs to know nothing of views.

    Parameters
    ----------
    **others
        Other classes by name, each with its module and what gives its MIME bundle: classes that
        need not be loaded yet.
    """
    ipython = sys.modules.get("IPython")
    shell = None if ipython is None else ipython.get_ipython()
    if shell is not None:
        formatter = shell.display_formatter.mimebundle_formatter
        formatter.for_type(Handle, handle_mimebundle)
        for name, (module, bundle) in others.items():
            formatter.for_type_by_name(module, name, bundle)
