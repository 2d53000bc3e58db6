"""How the industrial robots look: castings, motors and flanges as meshes by their finish.

Each function gives the bodies of one link, in the coordinates of the joint frame that moves it:
``{"paint": mesh, "dark": mesh, "steel": mesh}``. Paint takes the colour of the robot. All lengths
are in metres.
"""

from collections.abc import Callable, Iterable
from functools import cache

import numpy as np
from numpy.typing import NDArray

from dhlab.kinematics.transforms import rotx, roty, rotz, rp2t, transl
from dhlab.shapes import Mesh, cuboid, cylinder, loft, prism, srevolution, tube

Outline = Callable[[float], NDArray[np.float64]]
"""Corners of a convex outline, shape (k, 2), as a function of how far it is drawn in [m]."""

Bodies = dict[str, Mesh]

FINISHES = {"paint": None, "dark": "#33383f", "steel": "#b4bcc6"}
"""Colour of each finish; None is the robot's own."""

ARM_LENGTHS = {"height": 0.495, "shoulder": 0.175, "upper": 0.9, "elbow": 0.175, "fore": 0.96}
FLANGE = 0.135
GRIP = 0.23

ALONG_Y = rp2t(rotx(-np.pi / 2), (0, 0, 0))
ALONG_X = rp2t(roty(np.pi / 2), (0, 0, 0))


# ---- the arm of six revolute joints ----


@cache
def arm_base() -> Bodies:
    """Foot, pedestal and plug box, in the base."""
    plate = slab(rectangle(0.62, 0.52, 0.06), 0, 0.035, 0.008)
    pedestal = srevolution(
        [(0, 0.035), (0.245, 0.035), (0.245, 0.075), (0.2, 0.11), (0.2, 0.2), (0, 0.2)], 48
    )
    plugs = _at(slab(rectangle(0.2, 0.24, 0.02), 0, 0.12, 0.012), (-0.25, 0, 0.035))
    bolts = [
        tube((x, y, 0.035), (x, y, 0.052), 0.018, 6) for x in (-0.26, 0.26) for y in (-0.2, 0.2)
    ]
    return {"paint": pedestal.merged(plugs), "dark": plate, "steel": _merged(bolts)}


@cache
def column() -> Bodies:
    """What turns about the upright axis: a table with two cheeks that hold the upper arm."""
    table = _at(slab(rectangle(0.5, 0.42, 0.14), 0, 0.085, 0.02), (0.02, 0, -0.255))
    cheek = [(-0.19, -0.19), (0.22, -0.19), (0.3, -0.1), *_bow((0.175, 0), 0.155, -35, 125)]
    cheek += [(-0.06, 0.03), (-0.19, -0.09)]
    cheeks = [_cheek(cheek, side * 0.135, 0.075) for side in (-1, 1)]
    ring = _at(cylinder(0.215, 0.04, 48), (0, 0, -0.295))
    lift = tube((-0.13, 0.245, -0.2), (-0.13, 0.245, 0.12), 0.062)
    cap = tube((-0.13, 0.245, 0.12), (-0.13, 0.245, 0.17), 0.05)
    foot = _at(cuboid(0.13, 0.17, 0.03), (-0.13, 0.22, -0.2))
    swing = tube((0.175, -0.17, 0), (0.175, -0.4, 0), 0.078)
    end = tube((0.175, -0.4, 0), (0.175, -0.44, 0), 0.062)
    return {
        "paint": table.merged(*cheeks, foot),
        "dark": _merged([ring, lift, swing]),
        "steel": cap.merged(end),
    }


@cache
def upper_arm() -> Bodies:
    """Upper arm from shoulder to elbow, along x; it turns between the cheeks."""
    length = ARM_LENGTHS["upper"]
    beam = slab(stadium(length, 0.15, 0.13), -0.085, 0.085, 0.022)
    rib = slab(stadium(length - 0.26, 0.075, 0.055), -0.098, 0.098, 0.006)
    hubs = tube((0, 0, -0.19), (0, 0, -0.1), 0.105).merged(tube((0, 0, 0.1), (0, 0, 0.19), 0.105))
    return {"paint": beam, "dark": _at(rib, (0.13, 0, 0)), "steel": hubs}


@cache
def elbow() -> Bodies:
    """Housing above the elbow with the motors of the wrist behind it, in joint frame 3."""
    rise = ARM_LENGTHS["elbow"]
    cheek = [(0.19, -0.13), (0.26, -0.1), (0.26, 0.1), (0.19, 0.16), (0.06, 0.13)]
    cheek += [*_bow((0, 0), 0.125, 60, 285), (0.06, -0.13)]
    cheeks = [_cheek_z(cheek, side * 0.125, 0.055) for side in (-1, 1)]
    box = _turned(slab(rectangle(0.31, 0.17, 0.04), -0.2, 0.17, 0.02), rise + 0.055)
    front = _turned(slab(rectangle(0.27, 0.27, 0.08), 0.145, 0.215, 0.02), rise)
    neck = _turned(srevolution([(0, 0.16), (0.115, 0.16), (0.115, 0.25), (0, 0.25)], 48), rise)
    motors = [
        tube((rise + x, -0.19, z), (rise + x, -0.36, z), 0.052)
        for x, z in ((0.045, 0.075), (0.045, -0.075), (-0.045, 0))
    ]
    ends = [
        tube((rise + x, -0.36, z), (rise + x, -0.385, z), 0.04)
        for x, z in ((0.045, 0.075), (0.045, -0.075), (-0.045, 0))
    ]
    hubs = tube((0, 0, -0.165), (0, 0, -0.15), 0.085).merged(
        tube((0, 0, 0.15), (0, 0, 0.165), 0.085)
    )
    return {
        "paint": box.merged(front, *cheeks),
        "dark": _merged([neck, *motors]),
        "steel": hubs.merged(*ends),
    }


@cache
def forearm() -> Bodies:
    """Tube that turns about its own axis, and the fork of the wrist, in joint frame 4."""
    start = 0.255 - ARM_LENGTHS["fore"]
    sections = ((start, 0.105, 0.105, 1.0), (-0.3, 0.085, 0.09, 1.0), (-0.16, 0.07, 0.105, 0.6))
    skin = loft([_superellipse(a, b, power, z) for z, a, b, power in sections])
    outline = [(-0.165, -0.07), *_bow((0, 0), 0.072, -90, 90), (-0.165, 0.07)]
    lugs = [_fork(outline, side * 0.0825, 0.045) for side in (-1, 1)]
    caps = [tube((0, side * 0.105, 0), (0, side * 0.118, 0), 0.05) for side in (-1, 1)]
    ring = _at(cylinder(0.112, 0.03, 48), (0, 0, start - 0.004))
    return {"paint": skin.merged(*lugs), "steel": _merged(caps), "dark": ring}


@cache
def wrist() -> Bodies:
    """Ball of the wrist between the lugs of the fork, in joint frame 5."""
    hub = tube((0, 0, -0.058), (0, 0, 0.058), 0.07)
    nose = tube((0, 0.03, 0), (0, 0.1, 0), 0.056)
    return {"paint": hub.merged(nose)}


@cache
def flange() -> Bodies:
    """Flange that carries the tool, in joint frame 6; a pin shows how it is turned."""
    disc = srevolution([(0, 0.098), (0.05, 0.098), (0.05, 0.125), (0.044, FLANGE), (0, FLANGE)])
    bolts = [
        _at(cylinder(0.005, 0.006, 8), (0.034 * np.cos(a), 0.034 * np.sin(a), FLANGE))
        for a in np.arange(6) * np.pi / 3
    ]
    return {"steel": disc, "dark": _merged(bolts)}


# ---- the gripper ----


@cache
def gripper_body() -> Bodies:
    """Adapter, housing and rail of a parallel gripper whose jaws slide along y."""
    adapter = srevolution([(0, 0), (0.055, 0), (0.055, 0.015), (0.045, 0.03), (0, 0.03)])
    housing = _at(slab(rectangle(0.12, 0.32, 0.025), 0, 0.08, 0.012), (0, 0, 0.025))
    rail = _at(cuboid(0.05, 0.33, 0.012), (0, 0, 0.102))
    return {"dark": housing, "steel": adapter.merged(rail)}


@cache
def jaw(side: str) -> Bodies:
    """One jaw in its joint frame, z to the outside: its pad lies in z = 0."""
    slide = _at(cuboid(0.08, 0.04, 0.055), (0, -0.012, 0.002))
    finger = [(0.012, 0), (0.012, 0.168), (0.02, 0.178), (0.034, 0.06), (0.05, 0.03), (0.05, 0)]
    blade = prism([(z, -y) for z, y in finger], 0.06).transformed(
        rp2t(np.column_stack([(0, 0, 1), (0, 1, 0), (-1, 0, 0)]), (0.03, 0, 0))
    )
    pad = _at(cuboid(0.054, 0.09, 0.012), (0, -0.12, 0))
    to_the_tip = rp2t(rotz(0 if side == "left" else np.pi), (0, 0, 0))
    steel = slide.merged(blade).transformed(to_the_tip)
    return {"steel": steel, "dark": pad.transformed(to_the_tip)}


# ---- the SCARA ----


@cache
def scara_base() -> Bodies:
    """Column of a SCARA, up to its first joint."""
    plate = slab(rectangle(0.24, 0.2, 0.03), 0, 0.02, 0.004)
    stem = slab(rectangle(0.17, 0.17, 0.04), 0.02, 0.31, 0.012)
    ring = _at(cylinder(0.07, 0.032, 48), (0, 0, 0.308))
    return {"paint": stem, "dark": plate.merged(ring)}


@cache
def scara_inner() -> Bodies:
    """First link: a flat beam, in joint frame 1."""
    beam = slab(stadium(0.325, 0.088, 0.075), -0.05, 0.03, 0.012)
    ring = _at(cylinder(0.06, 0.012, 48), (0.325, 0, 0.028))
    return {"paint": beam, "dark": ring}


@cache
def scara_outer() -> Bodies:
    """Second link: a beam under a hood, which the quill goes through, in joint frame 2."""
    beam = slab(stadium(0.275, 0.078, 0.055), 0.038, 0.105, 0.01)
    hood = slab(stadium(0.15, 0.066, 0.058), 0.1, 0.235, 0.025)
    sleeve = _at(cylinder(0.034, 0.05), (0.275, 0, 0.1)).merged(
        _at(cylinder(0.03, 0.02), (0.275, 0, 0.02))
    )
    return {"paint": beam.merged(hood), "dark": sleeve}


@cache
def scara_quill() -> Bodies:
    """Shaft that slides down along z, in joint frame 3."""
    shaft = tube((0, 0, -0.38), (0, 0, 0.09), 0.013)
    stop = tube((0, 0, -0.385), (0, 0, -0.372), 0.018)
    return {"steel": shaft, "dark": stop}


@cache
def suction_cup() -> Bodies:
    """Cup at the end of the quill, 0.12 m before joint frame 4."""
    cup = srevolution([(0, 0.09), (0.014, 0.09), (0.014, 0.1), (0.03, 0.12), (0, 0.12)])
    nozzle = tube((0, 0, 0.07), (0, 0, 0.092), 0.02)
    arm = _at(cuboid(0.05, 0.012, 0.008), (0.03, 0, 0.074))
    return {"dark": cup, "steel": nozzle.merged(arm)}


# ---- what they are made of ----


def slab(outline: Outline, low: float, high: float, bevel: float) -> Mesh:
    """Plate from z = low to z = high with bevelled edges."""
    rings = ((low, bevel), (low + bevel, 0.0), (high - bevel, 0.0), (high, bevel))
    return loft([np.insert(outline(drawn_in), 2, z, axis=1) for z, drawn_in in rings])


def rectangle(a: float, b: float, corner: float) -> Outline:
    """Outline of a rectangle of a by b with round corners."""

    def outline(drawn_in: float) -> NDArray[np.float64]:
        r = max(corner - drawn_in, 0.2 * corner)
        x, y = a / 2 - drawn_in - r, b / 2 - drawn_in - r
        return np.array(
            [
                point
                for k, centre in enumerate(((x, y), (-x, y), (-x, -y), (x, -y)))
                for point in _bow(centre, r, 90 * k, 90 * k + 90, 5)
            ]
        )

    return outline


def stadium(length: float, first: float, second: float) -> Outline:
    """Outline around two circles, the second one `length` along x from the first."""
    lean = np.degrees(np.arccos((first - second) / length))

    def outline(drawn_in: float) -> NDArray[np.float64]:
        far = _bow((length, 0), second - drawn_in, -lean, lean, 16)
        near = _bow((0, 0), first - drawn_in, lean, 360 - lean, 16)
        return np.array(far + near)

    return outline


def _bow(
    centre: tuple[float, float], radius: float, start: float, end: float, pieces: int = 12
) -> list[tuple[float, float]]:
    """Points on a circle from one angle to another [degrees]."""
    turn = np.radians(np.linspace(start, end, pieces + 1))
    x, y = centre[0] + radius * np.cos(turn), centre[1] + radius * np.sin(turn)
    return list(zip(x.tolist(), y.tolist(), strict=True))


def _superellipse(a: float, b: float, power: float, z: float) -> NDArray[np.float64]:
    turn = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    cos, sin = np.cos(turn), np.sin(turn)
    x, y = a * np.sign(cos) * np.abs(cos) ** power, b * np.sign(sin) * np.abs(sin) ** power
    return np.column_stack([x, y, np.full(40, z)])


def _cheek(profile: Iterable[tuple[float, float]], y: float, thick: float) -> Mesh:
    """Plate with a profile (x, z), its middle at y."""
    upright = prism([(x, -z) for x, z in profile], thick)
    return upright.transformed(transl((0, y - thick / 2, 0)) @ ALONG_Y)


def _cheek_z(profile: Iterable[tuple[float, float]], z: float, thick: float) -> Mesh:
    """Plate with a profile (x, y), its middle at z."""
    return _at(prism(list(profile), thick), (0, 0, z - thick / 2))


def _fork(profile: Iterable[tuple[float, float]], y: float, thick: float) -> Mesh:
    """Plate with a profile (z, x), its middle at y."""
    flat = prism([(x, -z) for z, x in profile], thick)
    return flat.transformed(transl((0, y - thick / 2, 0)) @ ALONG_Y)


def _turned(mesh: Mesh, x: float) -> Mesh:
    """Lay a body that stands along z along y, beside the origin; what was y is then x."""
    across = np.column_stack([(0, 0, 1), (1, 0, 0), (0, 1, 0)])
    return mesh.transformed(rp2t(across, (x, 0, 0)))


def _at(mesh: Mesh, p: tuple[float, float, float]) -> Mesh:
    return mesh.transformed(transl(p))


def _merged(meshes: list[Mesh]) -> Mesh:
    return meshes[0].merged(*meshes[1:])
