"""Robot kinematics in a notebook: from a Denavit-Hartenberg row to a moving limb in the cell.

The names below are the whole public face of dhlab; modules behind them may move. What needs a
screen (`View`, `show`, `Panel`, `side_by_side`), and what not everybody needs, is loaded when it
is first used.
"""

import sys
from importlib import import_module
from typing import TYPE_CHECKING, Any

from dhlab import shapes
from dhlab.errors import AttachError, DegreesWarning, DhlabError, InputError, LimitError
from dhlab.kinematics.angles import (
    angvec2r,
    eul2r,
    interpolate,
    r2angvec,
    r2eul,
    r2rpy,
    rpy2r,
)
from dhlab.kinematics.chain import Chain
from dhlab.kinematics.dh import DHRow, deg, dh, link_transform
from dhlab.kinematics.mechanism import Branch, Mechanism
from dhlab.kinematics.transforms import inverse, rotx, roty, rotz, rp2t, transl
from dhlab.scene.arrow import Arrow, arrow
from dhlab.scene.block import Block, BlockComplex, block_complex, block_merge
from dhlab.scene.blocks import (
    block,
    cone,
    cube,
    cuboid,
    cylinder,
    polygon,
    polyline,
    prism,
    pyramid,
    sphere,
    srevolution,
    tetrahedron,
)
from dhlab.scene.component import Component
from dhlab.scene.csys import Csys, csys
from dhlab.scene.handle import Handle
from dhlab.scene.robot import Robot
from dhlab.scene.robots import robot, robot_complex
from dhlab.shapes import arc

if TYPE_CHECKING:
    from dhlab import models
    from dhlab.animation import PlannedMotion, animate, block_motion, robot_motion
    from dhlab.kinematics.poly3 import trj_poly3
    from dhlab.kinematics.trajectory import Trajectory
    from dhlab.kinematics.typeset import Typeset, typeset
    from dhlab.lessons import (
        Choice,
        Lesson,
        Place,
        Step,
        configure,
        dh_lesson,
        move_to,
        sequence_lesson,
        slide,
        turn,
    )
    from dhlab.panel import LessonView, Panel, TableEditor, side_by_side
    from dhlab.view import View, show

ON_FIRST_USE = {
    "Choice": "dhlab.lessons",
    "Lesson": "dhlab.lessons",
    "LessonView": "dhlab.panel",
    "Panel": "dhlab.panel",
    "Place": "dhlab.lessons",
    "PlannedMotion": "dhlab.animation",
    "Step": "dhlab.lessons",
    "TableEditor": "dhlab.panel",
    "Trajectory": "dhlab.kinematics.trajectory",
    "Typeset": "dhlab.kinematics.typeset",
    "View": "dhlab.view",
    "animate": "dhlab.animation",
    "block_motion": "dhlab.animation",
    "configure": "dhlab.lessons",
    "dh_lesson": "dhlab.lessons",
    "models": "dhlab.models",
    "move_to": "dhlab.lessons",
    "robot_motion": "dhlab.animation",
    "sequence_lesson": "dhlab.lessons",
    "show": "dhlab.view",
    "side_by_side": "dhlab.panel",
    "slide": "dhlab.lessons",
    "trj_poly3": "dhlab.kinematics.poly3",
    "turn": "dhlab.lessons",
    "typeset": "dhlab.kinematics.typeset",
}

__all__ = [
    "Arrow",
    "AttachError",
    "Block",
    "BlockComplex",
    "Branch",
    "Chain",
    "Choice",
    "Component",
    "Csys",
    "DHRow",
    "DegreesWarning",
    "DhlabError",
    "Handle",
    "InputError",
    "Lesson",
    "LessonView",
    "LimitError",
    "Mechanism",
    "Panel",
    "Place",
    "PlannedMotion",
    "Robot",
    "Step",
    "TableEditor",
    "Trajectory",
    "Typeset",
    "View",
    "angvec2r",
    "animate",
    "arc",
    "arrow",
    "block",
    "block_complex",
    "block_merge",
    "block_motion",
    "cone",
    "configure",
    "csys",
    "cube",
    "cuboid",
    "cylinder",
    "deg",
    "dh",
    "dh_lesson",
    "eul2r",
    "interpolate",
    "inverse",
    "link_transform",
    "models",
    "move_to",
    "polygon",
    "polyline",
    "prism",
    "pyramid",
    "r2angvec",
    "r2eul",
    "r2rpy",
    "robot",
    "robot_complex",
    "robot_motion",
    "rotx",
    "roty",
    "rotz",
    "rp2t",
    "rpy2r",
    "sequence_lesson",
    "shapes",
    "show",
    "side_by_side",
    "slide",
    "sphere",
    "srevolution",
    "tetrahedron",
    "transl",
    "trj_poly3",
    "turn",
    "typeset",
]


def __getattr__(name: str) -> Any:
    """Load a name when it is first used: that of a module, or one in a module."""
    if name not in ON_FIRST_USE:
        raise AttributeError(f"module 'dhlab' has no attribute {name!r}")
    module = import_module(ON_FIRST_USE[name])
    return getattr(module, name, module)


def __dir__() -> list[str]:
    """List the public names."""
    return sorted(__all__)


def _lesson_bundle(lesson: Any, **options: Any) -> Any:
    """Return what a cell that ends in a lesson shows; what that needs is loaded here."""
    return import_module("dhlab.panel.lesson_view").lesson_mimebundle(lesson, **options)


if "IPython" in sys.modules:  # a handle as the last expression of a cell shows itself
    lesson = ("dhlab.lessons.lesson", _lesson_bundle)
    import_module("dhlab.view.display").register(Lesson=lesson)
    del lesson
