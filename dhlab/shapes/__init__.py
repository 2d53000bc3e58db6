"""What can be drawn: meshes of flat faces, lines and labels, and a function for each block.

Everything here is a value: nothing has a place in the scene, a colour or a view. Where a block
stands in its own coordinates is said in each function's docstring.
"""

from dhlab.shapes.between import arrow, beam, tube
from dhlab.shapes.lines import Label, Lines
from dhlab.shapes.loft import loft
from dhlab.shapes.mesh import Mesh, RenderArrays
from dhlab.shapes.polyhedra import (
    cube,
    cuboid,
    polygon,
    polyhedron,
    polyline,
    prism,
    pyramid,
    tetrahedron,
)
from dhlab.shapes.profile import arc
from dhlab.shapes.revolution import cone, cylinder, sphere, srevolution

__all__ = [
    "Label",
    "Lines",
    "Mesh",
    "RenderArrays",
    "arc",
    "arrow",
    "beam",
    "cone",
    "cube",
    "cuboid",
    "cylinder",
    "loft",
    "polygon",
    "polyhedron",
    "polyline",
    "prism",
    "pyramid",
    "sphere",
    "srevolution",
    "tetrahedron",
    "tube",
]
