"""Views of handles: a Jupyter widget where there is a notebook, a record of it where there is not.

Importing this package imports neither ipywidgets nor meshcat; that happens when a view is shown.
"""

from dhlab.view.commands import Backend, Command, Paint, Place, Put, Remove, diff
from dhlab.view.display import handle_mimebundle, show
from dhlab.view.recording import RecordingBackend
from dhlab.view.view import View

__all__ = [
    "Backend",
    "Command",
    "Paint",
    "Place",
    "Put",
    "RecordingBackend",
    "Remove",
    "View",
    "diff",
    "handle_mimebundle",
    "show",
]
