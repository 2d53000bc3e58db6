"""How a handle shows itself as the last expression of a cell."""

from typing import Any

from dhlab.scene.handle import Handle
from dhlab.view.view import WIDGET, View


def handle_mimebundle(handle: Handle, include: Any = None, exclude: Any = None) -> dict[str, Any]:
    """Return what a cell that ends in a handle shows: a view of its own, or a line of text.

    IPython calls this for every `Handle`; ``dhlab/__init__.py`` registers it when IPython runs,
    so that the scene needs to know nothing of views.

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
