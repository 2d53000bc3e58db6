"""What may go wrong around a table: with its base, its tool, and the zeros of its joints."""

from collections.abc import Iterator
from dataclasses import replace
from math import degrees

import numpy as np

from dhlab.diagnosis.slips import Slip
from dhlab.diagnosis.table_model import Table
from dhlab.diagnosis.values import inverted
from dhlab.diagnosis.verdict import mistake
from dhlab.kinematics.chain import Chain
from dhlab.kinematics.transforms import pose_of


def no_offset(chain: Chain) -> Iterator[Slip[Table]]:
    """Offsets that are forgotten."""
    if chain.offset.any():
        yield Slip(
            mistake("no-offset", "the offset is forgotten", "Where does each joint count from?"),
            lambda t: replace(t, offset=np.zeros(chain.n)),
        )


def offset_slips(chain: Chain) -> Iterator[Slip[Table]]:
    """Offsets with a wrong sign, exchanged, or in degrees."""
    question = "With all variables at 0, where does each joint stand?"
    ways = [
        (f"sign-offset-{i + 1}", f"the offset of joint {i + 1} has the wrong sign", {i: -offset})
        for i, offset in enumerate(chain.offset.tolist())
        if offset
    ]
    if len(ways) > 1:
        every = {i: -offset for i, offset in enumerate(chain.offset.tolist())}
        ways.append(("sign-offsets", "all offsets have the wrong sign", every))
    turning = {i: degrees(chain.offset[i]) for i, kind in enumerate(chain.kinds) if kind == "r"}
    ways.append(("degrees-offset", "the offsets are given in degrees", turning))
    for key, when, changes in ways:
        offset = chain.offset.copy()
        offset[list(changes)] = list(changes.values())
        if not np.array_equal(offset, chain.offset):
            yield Slip(
                mistake(key, when, question),
                lambda t, offset=offset: replace(t, offset=offset),  # type: ignore[misc]
                alone=True,
            )


def end_slips(chain: Chain) -> Iterator[Slip[Table]]:
    """Return base or tool left out, counted twice, inverted, or on the wrong side."""
    at_rest = {"base": chain.base, "tool": chain.grasper}
    asked = {
        "base": "In which frame is the tip asked for?",
        "tool": "Which frame is the tip: that of the last joint, or one behind it?",
    }
    sides = {"base": ("right", "left", ("ctb", "cbt")), "tool": ("left", "right", ("tbc", "btc"))}
    for end, pose in at_rest.items():
        if np.array_equal(pose, np.eye(4)):
            continue
        for key, how, changed in (
            (f"no-{end}", f"the {end} is left out", np.eye(4)),
            (f"{end}-twice", f"the {end} is counted twice", pose @ pose),
            (f"{end}-inverse", f"the inverse of the {end} is used", inverted(pose)),
        ):
            yield Slip(
                mistake(key, how, asked[end]),
                lambda t, end=end, changed=changed: replace(  # type: ignore[misc]
                    t, **{end: changed}
                ),
            )
        wrong, right, orders = sides[end]
        when = f"the {end} is multiplied on the {wrong} instead of the {right}"
        question = f"On which side of the product does the pose of the {end} stand?"
        for order in orders:
            yield Slip(
                mistake(f"{end}-side", when, question),
                lambda t, order=order: replace(t, ends=order),  # type: ignore[misc]
            )


def parts_of_ends(chain: Chain) -> Iterator[Slip[Table]]:
    """A base or tool without its turn or its slide, or with one coordinate the wrong way."""
    for end, pose in (("base", chain.base), ("tool", chain.grasper)):
        R, p = pose[:3, :3], pose[:3, 3]
        question = f"How is the {end} turned, and where is its origin?"
        ways = [
            (f"{end}-unturned", f"the turn of the {end} is left out", np.eye(3), p),
            (f"{end}-unmoved", f"the origin of the {end} is left out", R, np.zeros(3)),
        ]
        for k, axis in enumerate("xyz"):
            signs = np.where(np.arange(3) == k, -1, 1)
            when = f"{axis} of the {end}'s origin has the wrong sign"
            ways.append((f"{end}-sign-{axis}", when, R, p * signs))
        for key, when, turn, origin in ways:
            changed = pose_of(turn, origin)
            if not np.allclose(changed, pose) and not np.allclose(changed, np.eye(4)):
                yield Slip(
                    mistake(key, when, question),
                    lambda t, end=end, changed=changed: replace(  # type: ignore[misc]
                        t, **{end: changed}
                    ),
                    alone=True,
                )
