"""What moves a robot by hand: sliders, beside a view or alone."""

from dhlab.panel.beside import Beside, side_by_side
from dhlab.panel.lesson_view import LessonView
from dhlab.panel.panel import Panel
from dhlab.panel.table_editor import TableEditor

__all__ = ["Beside", "LessonView", "Panel", "TableEditor", "side_by_side"]
