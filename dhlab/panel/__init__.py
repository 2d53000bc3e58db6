"""What moves a robot by hand: sliders, beside a view or alone."""

from dhlab.panel.beside import Beside, side_by_side
from dhlab.panel.panel import Panel

__all__ = ["Beside", "Panel", "side_by_side"]
