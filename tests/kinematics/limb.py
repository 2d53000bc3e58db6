"""The upper limb of the paper, straight from its tables (Pajak, section 4)."""

from math import pi

from dhlab.kinematics.chain import Chain
from dhlab.kinematics.dh import dh
from dhlab.kinematics.mechanism import Branch, Mechanism
from dhlab.kinematics.transforms import roty, rp2t

ARM = Chain(
    [
        dh(0, 0, 0, 0),
        dh(pi / 2, 0, 0, -pi / 2),
        dh(pi / 2, 0, 0, 0),
        dh(0, 0.25, 0, pi),
        dh(pi / 2, 0, 0.25, 0),
        dh(-pi / 2, 0, 0, pi / 2),
        dh(pi / 2, 0, 0, pi),
    ],
    7 * "r",
)
THUMB = Chain(
    [
        dh(pi, 0, 0, -pi / 8),
        dh(-pi / 2, 0.015, 0, pi / 4),
        dh(0, 0.050, 0, pi / 4),
        dh(0, 0.040, 0, pi / 4),
    ],
    4 * "r",
    base=rp2t(roty(pi / 2), (0.040, 0.030, -0.015)),
    grasper=(0.030, 0, 0),
)


def finger(l2, l3, l4, base):
    table = [
        dh(pi, 0, 0, 0),
        dh(-pi / 2, 0, 0, -pi / 16),
        dh(0, l2, 0, -pi / 8),
        dh(0, l3, 0, -pi / 8),
    ]
    return Chain(table, 4 * "r", base=base, grasper=(l4, 0, 0))


CHAINS = {
    "arm/hand/thumb": THUMB,
    "arm/hand/index": finger(0.050, 0.030, 0.025, (0.095, 0.022, 0)),
    "arm/hand/middle": finger(0.055, 0.035, 0.025, (0.095, 0, 0)),
    "arm/hand/ring": finger(0.050, 0.030, 0.025, (0.090, -0.020, 0)),
    "arm/hand/little": finger(0.040, 0.025, 0.023, (0.085, -0.038, 0)),
}
LIMB = Mechanism(
    [
        Branch("arm", ARM),
        Branch("arm/hand", Chain((), ""), parent=0, at=7),
        *(Branch(name, chain, parent=1) for name, chain in CHAINS.items()),
    ]
)
