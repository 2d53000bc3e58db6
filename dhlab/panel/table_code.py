"""Tables of robots as Python code that makes them again."""

import re
from collections.abc import Sequence
from keyword import iskeyword

import numpy as np

from dhlab.kinematics.chain import Chain
from dhlab.panel.code import number_code
from dhlab.scene.component import Component
from dhlab.scene.handle import Names


def table_code(components: Sequence[Component]) -> str:
    """Write the tables of components as calls of `robot`.

    Parameters
    ----------
    components : sequence of Component

    Returns
    -------
    str
        Python code with its imports; it gives each table back bit for bit.

    Examples
    --------
    >>> from dhlab import dh, robot
    >>> print(table_code(robot([dh(0, 0.3, 0, 0)], "r", name="arm").components))
    from dhlab import dh, robot
    arm = robot([
        dh(0, 0.3, 0, 0),
    ], 'r', name='arm')
    """
    variables = Names(["deg", "dh", "pi", "robot"])
    text = "\n".join(_call(c, variables.take(_variable(c.name))) for c in components)
    head = [f"from dhlab import {'deg, ' if '*deg' in text else ''}dh, robot"]
    if re.search(r"\bpi\b", text):
        head.append("from numpy import pi")
    return "\n".join([*head, text])


def _variable(name: str) -> str:
    return name if name.isidentifier() and not iskeyword(name) else "arm"


def _call(component: Component, variable: str) -> str:
    chain, name = component.chain, component.name
    rows = [f"    dh({', '.join(number_code(x) for x in row)})," for row in chain.rows]
    options = "".join(f", {key}={text}" for key, text in _options(chain).items())
    return "\n".join(
        [f"{variable} = robot([", *rows, f"], {chain.joints!r}, name={name!r}{options})"]
    )


def _options(chain: Chain) -> dict[str, str]:
    options = {}
    if chain.convention != "modified":
        options["convention"] = repr(chain.convention)
    for key in ("base", "grasper"):
        T = getattr(chain, key)
        if not np.array_equal(T, np.eye(4)):
            turned = not np.array_equal(T[:3, :3], np.eye(3))
            options[key] = repr(T.tolist() if turned else tuple(T[:3, 3].tolist()))
    if chain.offset.any():
        options["offset"] = f"[{', '.join(number_code(x) for x in chain.offset)}]"
    if np.isfinite(chain.limits).any():
        pairs = ", ".join(f"({_end(low)}, {_end(high)})" for low, high in chain.limits)
        options["limits"] = f"[{pairs}]"
    return options


def _end(x: float) -> str:
    return number_code(x) if np.isfinite(x) else f"float('{x}')"
