"""Diagnosis: from a wrong answer and what was asked to the mistake that was made.

A task says what was asked. It judges *cases*: pairs of the arguments of a case (an empty tuple for
a plain value) and what came for them, as plain numbers::

    task = MatrixTask(turn("z", lambda yaw: yaw), slide((1, 0, 0)))
    verdict = task.judge([((yaw,), answer(yaw)) for yaw in (0.3, 1.2, -2.0)])
    verdict.right      # True or False
    verdict.text       # sentences for a student
    verdict.mistakes   # the mistakes by name: `key`, `text`, `question`

A judgement works by making what each known misconception, alone or with a second one, would have
made of the same inputs. What fits in all cases is named: "This is exactly what you get when ...".
Explanations that give the same values are named as alternatives. Where nothing fits, no cause is
named: `seen` then says what anybody can see. The more cases and the less special their numbers,
the fewer the alternatives: three inputs without zeros and right angles tell most mistakes apart.

- `verdict`: what a judgement says; `values`: from whatever came to numbers; `seen`: what is seen
- `slips`: the search; `product`, `product_slips`, `turn_slips`, `after`: what goes wrong in a
  product
- `matrix`: a matrix that is a product of turns, slides and given poses; `point`: what such a
  product is applied to; `triples`: the angles of a rotation
- `trajectory`, `motion`: a cubic or a quintic from one configuration to another
- `link`: the function of one row; `forward`: the pose of a chain's tip; `table_model`,
  `chain_slips`, `end_slips`: a table in numbers, and what goes wrong in and around it
- `tables`, `reading`, `table_search`: a table that came; `gauge`, `waiting`: when two tables are
  the same mechanism; `robots`, `hanging`: one or several chains that came; `paths`, `renaming`,
  `zeros`: when two of these are the same; `beside`: limits, and where a robot stands
- `arrangement`: coordinate systems in a scene

The tasks: `MatrixTask` (a rotation or a pose, plain or as a function), `PointTask` (a point or a
direction in another frame), `AnglesTask` (three angles of a rotation), `LinkTask` (the pose of one
row, as a function of alpha, a, d, theta), `ForwardTask` (the pose of the tip as a function of one
configuration), `TrajectoryTask` (a motion by a polynomial), `TableTask` (a table), `RobotTask` (a
robot, as plain data), `ArrangementTask` (poses of coordinate systems by name).
"""

from dhlab.diagnosis.arrangement import ArrangementTask
from dhlab.diagnosis.forward import ForwardTask
from dhlab.diagnosis.link import LinkTask
from dhlab.diagnosis.matrix import MatrixTask
from dhlab.diagnosis.point import PointTask
from dhlab.diagnosis.product import given, inverse_of, slide, turn
from dhlab.diagnosis.robots import RobotTask
from dhlab.diagnosis.tables import TableTask
from dhlab.diagnosis.trajectory import TrajectoryTask
from dhlab.diagnosis.triples import AnglesTask
from dhlab.diagnosis.verdict import Mistake, Task, Verdict

__all__ = [
    "AnglesTask",
    "ArrangementTask",
    "ForwardTask",
    "LinkTask",
    "MatrixTask",
    "Mistake",
    "PointTask",
    "RobotTask",
    "TableTask",
    "Task",
    "TrajectoryTask",
    "Verdict",
    "given",
    "inverse_of",
    "slide",
    "turn",
]
