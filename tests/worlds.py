"""Random scenes and what may be done to them, for tests without a browser and in one."""

import json

import numpy as np

from dhlab import (
    DhlabError,
    animate,
    block_complex,
    csys,
    cube,
    cuboid,
    cylinder,
    dh,
    robot,
    robot_complex,
    rotx,
    rotz,
    rp2t,
)
from dhlab.view import RecordingBackend, View, diff
from dhlab.view.wire import Wire

COLORS = ("#0072b2", "#d55e00", "#009e73")


class Replica:
    """A page in Python: it knows of the scene what it was told by the wire."""

    def __init__(self):
        self.wire = Wire({})
        self.nodes = {}
        self.geometry = set()
        self.clocks = {}

    def send(self, batch):
        header, buffer = self.wire.batch(batch)
        header = json.loads(json.dumps(header))
        self.geometry |= set(header.get("geometry", {}))
        for key, form in header.get("clocks", {}).items():
            self.clocks[key] = np.frombuffer(buffer, "<f8", form["count"], form["at"])
        for number in header.get("removes", []):
            path = self.nodes[number]["path"]
            self.nodes = {
                n: node
                for n, node in self.nodes.items()
                if not f"{node['path']}/".startswith(f"{path}/")
            }
        for put in header.get("puts", []):
            self.put(put, header, buffer)
        if joints := header.get("joints"):
            ids = np.frombuffer(buffer, "<u4", joints["count"], joints["ids"])
            values = np.frombuffer(buffer, "<f8", joints["count"], joints["values"])
            for number, value in zip(ids, values, strict=True):
                assert self.nodes[number]["joint"] is not None
                self.nodes[number]["value"] = value
        if poses := header.get("poses"):
            ids = np.frombuffer(buffer, "<u4", poses["count"], poses["ids"])
            matrices = np.frombuffer(buffer, "<f4", 12 * poses["count"], poses["matrices"])
            for number, matrix in zip(ids, matrices.reshape(-1, 3, 4), strict=True):
                self.nodes[number]["pose"] = matrix
        for number, style, visible in header.get("paints", []):
            self.nodes[number].update(style=header["styles"][style], visible=visible)
        for number, curve in header.get("curves", []):
            self.nodes[number]["curve"] = curve and self.curve(curve, buffer)
        self.forget_what_is_unused()

    def put(self, put, header, buffer):
        pose = np.frombuffer(buffer, "<f8", 12, put["pose"]).reshape(3, 4)
        curve = put.get("curve")
        self.nodes[put["id"]] = {
            "path": put["path"],
            "pose": pose,
            "value": put.get("value", 0.0),
            "joint": put.get("joint"),
            "shape": put.get("shape"),
            "style": header["styles"][put["style"]],
            "visible": put.get("visible", True),
            "curve": curve and self.curve(curve, buffer),
        }

    def curve(self, curve, buffer):
        kind = "<f8" if curve["width"] == 1 else "<f4"
        count = curve["width"] * curve["count"]
        assert len(self.clocks[curve["clock"]]) == curve["count"]
        return np.frombuffer(buffer, kind, count, curve["at"])

    def forget_what_is_unused(self):
        """A page keeps geometry only as long as a node draws it."""
        used = {node["shape"] for node in self.nodes.values() if node["shape"]}
        assert used <= self.geometry
        self.geometry = used

    def differs_from(self, nodes):
        """Paths of the nodes that the page has wrong."""
        told = {node["path"]: node for node in self.nodes.values()}
        if told.keys() != nodes.keys():
            return sorted(told.keys() ^ nodes.keys())
        return [path for path, node in nodes.items() if not self.agrees(told[path], node)]

    @staticmethod
    def agrees(told, node):
        curve = told["curve"]
        samples = None if node.curve is None else np.asarray(node.curve.samples)
        if samples is not None and samples.ndim == 3:
            samples = samples[:, :3]
        return (
            np.allclose(told["pose"], node.pose[:3], atol=1e-6)
            and told["value"] == (node.value if node.joint else 0)
            and (told["joint"] is None) == (node.joint is None)
            and told["shape"] == (node.shape.digest if node.shape else None)
            and told["visible"] == node.visible
            and np.allclose(told["style"]["color"], node.style.color)
            and told["style"]["opacity"] == node.style.opacity
            and (curve is None) == (samples is None)
            and (curve is None or np.allclose(curve, samples.ravel(), atol=1e-6))
        )


class World:
    """Handles of all kinds, two views of them, and everything that can be done to them.

    One view records; the other, `paged`, is told by the wire.
    """

    def __init__(self, seed, paged=None):
        self.rng = np.random.default_rng(seed)
        self.count = 0
        self.backend, self.replica = RecordingBackend(), Replica()
        self.live = View("live", backend=self.backend)
        self.paged = View("paged", backend=self.replica) if paged is None else paged
        self.handles = []
        self.shown = []
        for make in (self.make_block, self.make_csys, self.make_robot, self.make_robot):
            self.show(make())

    def name(self, kind):
        self.count += 1
        return f"{kind}{self.count}"

    def pick(self, choices):
        return choices[self.rng.integers(len(choices))]

    def pose(self):
        a, b, *p = self.rng.uniform(-1, 1, 5)
        return rp2t(rotx(a) @ rotz(b), p)

    def make_block(self):
        shape = self.pick([lambda n: cube(0.1, name=n), lambda n: cylinder(0.1, 0.2, name=n)])
        return self.keep(shape(self.name("block")))

    def make_csys(self):
        return self.keep(csys(self.pose(), name=self.name("csys")))

    def make_robot(self):
        n = self.rng.integers(1, 4)
        rows = [dh(*self.rng.uniform(-1, 1, 4)) for _ in range(n)]
        joints = "".join(self.pick("rp") for _ in range(n))
        convention = self.pick(["modified", "standard"])
        name = self.name("robot")
        return self.keep(robot(rows, joints, name=name, convention=convention))

    def make_complex(self):
        free = [h for h in self.handles if hasattr(h, "q") and h.parent is None]
        self.keep(robot_complex(*free[:2], name=self.name("complex")))

    def make_block_complex(self):
        free = [h for h in self.handles if hasattr(h, "vertices") and h.parent is None]
        self.keep(block_complex(*free[:2], name=self.name("blocks")))

    def keep(self, handle):
        self.handles.append(handle)
        return handle

    def show(self, handle):
        if handle not in self.shown:
            self.shown.append(handle)
        self.live.add(handle)
        self.paged.add(handle)

    def hide(self, handle):
        if handle in self.shown:
            self.shown.remove(handle)
            self.live.remove(handle)
            self.paged.remove(handle)

    def act(self):
        """Do something to something; what dhlab refuses must change nothing."""
        handle = self.pick(self.handles)
        before = dict(self.live.nodes)
        action = self.pick(self.actions(handle))
        try:
            action()
        except DhlabError:
            assert diff(before, self.live.nodes) == []

    def actions(self, handle):
        rng = self.rng
        actions = [
            lambda: self.show(handle),
            lambda: self.hide(handle),
            lambda: handle.set(visible=bool(rng.integers(2))),
            lambda: handle.set(opacity=self.pick([0.3, 1.0, 7.0])),
            handle.clear_traces,
        ]
        if rng.random() < 0.2:
            actions = [self.make_block, self.make_robot, self.make_complex, self.make_block_complex]
        elif hasattr(handle, "q"):
            actions += 3 * self.robot_actions(handle)
        else:
            actions += [
                lambda: handle.move(self.pose()),
                lambda: handle.move(rng.uniform(-1, 1, 3)),
                lambda: animate([0, 1, 2], {handle: lambda t: (t, 0, 0)}, trace=self.trace()),
            ]
            if hasattr(handle, "color"):
                actions.append(lambda: handle.set(color=self.pick(COLORS)))
        return actions

    def robot_actions(self, robot):
        q = self.rng.uniform(-1, 1, robot.n)
        other = self.pick([h for h in self.handles if hasattr(h, "q")])
        component = self.pick(robot.components) if robot.components else robot
        return [
            lambda: setattr(robot, "q", q),
            lambda: setattr(robot, "q", q * np.nan),
            lambda: setattr(component, "q", self.rng.uniform(-1, 1, component.n)),
            lambda: setattr(robot, "base", self.pose()),
            lambda: setattr(robot, "look", self.pick(["stick", "solid", "user", "none"])),
            lambda: setattr(component, "color", self.pick(COLORS)),
            lambda: setattr(robot, "show_csys", bool(self.rng.integers(2))),
            lambda: setattr(robot, "radius", self.rng.uniform(-0.01, 0.05)),
            lambda: setattr(component, "grasper", self.rng.uniform(-1, 1, 3)),
            lambda: component.set_part(cuboid(0.1, 0.1, 0.1), joint=1),
            lambda: robot.connect(other),
            lambda: animate([0, 1, 3], {robot: lambda t: q * t / 3}, trace=self.trace()),
            lambda: animate([0, 1], {component: lambda t: np.zeros(component.n)}),
        ]

    def trace(self):
        return self.pick([False, True, "ghosts"])

    def fresh(self):
        return View("fresh", backend=RecordingBackend()).add(*self.shown).nodes
