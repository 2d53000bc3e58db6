"""Dimensions are drawn where the numbers of the table lead, in either convention, for every q."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dhlab import InputError, View, models, robot
from dhlab.scene.dimensions import PARAMETERS
from dhlab.view.recording import RecordingBackend


def world(nodes, path):
    """Pose of a node in the world."""
    T = np.eye(4)
    parts = path.split("/")
    for k in range(len(parts)):
        T = T @ nodes["/".join(parts[: k + 1])].matrix
    return T


def ends(nodes, path):
    """Both ends of the line of a dimension, in the world."""
    points = nodes[path].shape.points[[0, -1]]
    T = world(nodes, path)
    return points @ T[:3, :3].T + T[:3, 3]


def random_arm(seed, convention):
    rng = np.random.default_rng(seed)
    n = 3
    rows = rng.uniform(0.3, 1.2, (n, 4)) * rng.choice([-1, 1], (n, 4))
    arm = robot(
        rows,
        rng.choice(["r", "p"], n),
        name="arm",
        convention=convention,
        offset=rng.uniform(-0.4, 0.4, n),
    )
    return arm.set(q=rng.uniform(-1.2, 1.2, n))


@pytest.mark.parametrize("convention", ["modified", "standard"])
@settings(max_examples=40, deadline=None)
@given(seed=st.integers(0, 2**32 - 1), row=st.integers(1, 3))
def test_lines_lead_along_the_row_from_frame_to_frame(convention, seed, row):
    arm = random_arm(seed, convention)
    arm.dimensions = row
    nodes = arm.describe()
    frames = [np.eye(4), *arm.frames().values()]
    before, own = frames[row - 1], frames[row]
    paths = {p.rpartition("/")[2]: p for p in nodes if p.rpartition("/")[2] in PARAMETERS}
    a, d = ends(nodes, paths["a"]), ends(nodes, paths["d"])
    first, second = (a, d) if convention == "modified" else (d, a)
    assert np.allclose(first[0], before[:3, 3], atol=1e-9)
    assert np.allclose(first[1], second[0], atol=1e-9)
    assert np.allclose(second[1], own[:3, 3], atol=1e-9)


@pytest.mark.parametrize("convention", ["modified", "standard"])
@settings(max_examples=40, deadline=None)
@given(seed=st.integers(0, 2**32 - 1), row=st.integers(1, 3))
def test_arcs_turn_one_axis_into_the_next(convention, seed, row):
    arm = random_arm(seed, convention)
    arm.dimensions = (row, "alpha")
    nodes = arm.describe()
    frames = [np.eye(4), *arm.frames().values()]
    before, own = frames[row - 1], frames[row]
    for name, column in (("alpha", 2), ("theta", 0)):
        path = next(p for p in nodes if p.endswith(f"/{name}"))
        centre = world(nodes, path)[:3, 3]
        start, end = ends(nodes, path) - centre
        radius = np.linalg.norm(start)
        assert np.allclose(start / radius, before[:3, column], atol=1e-9)
        assert np.allclose(end / radius, own[:3, column], atol=1e-9)


def test_the_lit_one_stands_out_and_all_say_their_values():
    arm = models.puma()
    arm.dimensions = (3, "a")
    nodes = arm.describe()
    styles = {
        p.rpartition("/")[2]: n.style
        for p, n in nodes.items()
        if p.rpartition("/")[2] in PARAMETERS
    }
    assert styles["a"].opacity == 1 > styles["d"].opacity
    assert styles["a"].line_width > styles["d"].line_width
    texts = {n.shape.text for n in nodes.values() if hasattr(n.shape, "text")}
    assert {"a_{2} = 0.4318 m", "d_{3} = 0.1491 m", "α_{2} = 0°", "θ_{3} = 0°"} <= texts


@pytest.mark.parametrize("convention", ["modified", "standard"])
@pytest.mark.parametrize("seed", range(6))
def test_the_number_that_is_the_joint_s_variable_is_a_gauge_of_that_joint(convention, seed):
    arm = random_arm(seed, convention)
    for row in (1, 2, 3):
        arm.dimensions = row
        nodes = arm.describe()
        gauges = {p: n.gauge for p, n in nodes.items() if n.gauge is not None}
        joint = next(n for p, n in nodes.items() if p.endswith(f"/{row}") and n.joint is not None)
        name = "theta" if joint.joint.kind == "r" else "d"
        assert [p.partition(f"/{name}")[2] for p in gauges] == ["", "/head", "/label"]
        for gauge in gauges.values():
            assert gauge[:3] == (joint.joint.key, joint.joint.kind, joint.value)
            assert nodes[next(p for p in gauges if p.endswith("label"))].shape.text.startswith(
                gauge.text
            )


def test_an_arc_of_many_turns_is_drawn_with_a_limited_number_of_points():
    arm = models.scara()
    arm.set(limits=None, q=[1e6, *arm.q[1:]], dimensions=1)
    arc = next(n for p, n in arm.describe().items() if p.endswith("/theta"))
    assert len(arc.shape.points) == 400


def test_live_equals_fresh_while_the_robot_moves():
    arm = models.scara()
    backend = RecordingBackend()
    view = View("v", backend=backend).add(arm)
    view.flush()
    rng = np.random.default_rng(0)
    for selection in [1, (2, "theta"), (3, "d"), None, 4]:
        arm.dimensions = selection
        arm.q = arm.clip(rng.uniform(-1, 1, arm.n))
        view.flush()
        fresh = RecordingBackend()
        View("f", backend=fresh).add(arm).flush()
        assert backend.nodes.keys() == fresh.nodes.keys()
        for path, node in fresh.nodes.items():
            assert np.array_equal(node.matrix, backend.nodes[path].matrix)
            assert (node.shape is None) == (backend.nodes[path].shape is None)
            assert node.shape is None or node.shape.digest == backend.nodes[path].shape.digest


def test_a_component_of_a_complex_robot_has_its_own():
    limb = models.upper_limb()
    limb.components[2].dimensions = 3
    paths = [p for p in limb.describe() if p.rpartition("/")[2] in PARAMETERS]
    assert len(paths) == 4
    assert all("index" in path for path in paths)


@pytest.mark.parametrize(
    ("value", "message"),
    [
        (0, "dimensions of 'puma': the table has rows 1 to 6, got 0"),
        (7, "dimensions of 'puma': the table has rows 1 to 6, got 7"),
        ((2, "beta"), "no parameter 'beta'; use alpha, a, d, theta"),
        ("2", r"must be None, a row such as 2, or a row and a parameter such as \(2, 'alpha'\)"),
    ],
)
def test_what_cannot_be_drawn_is_said(value, message):
    arm = models.puma()
    with pytest.raises(InputError, match=message):
        arm.dimensions = value
    assert arm.dimensions is None
