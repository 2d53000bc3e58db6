"""Arrows: where they lead, what they draw, what they refuse."""

import numpy as np
import pytest

from dhlab import InputError, View, arrow, rotz, rp2t
from dhlab.shapes import Label, Lines, Mesh
from dhlab.view import diff

POINTS = ((0.1, 0, 0), (0.1, 0.3, 0.4))


def drawn(handle):
    """Nodes by the last part of their paths."""
    return {path.rpartition("/")[2]: node for path, node in handle.describe("a").items()}


def world(node):
    """Points of a node's shape in its parent, shape (m, 3)."""
    points = node.shape.points if isinstance(node.shape, Lines) else node.shape.vertices
    return points @ node.pose[:3, :3].T + node.pose[:3, 3]


@pytest.mark.parametrize(("heads", "parts"), [("none", 0), ("end", 1), ("both", 2)])
def test_an_arrow_reaches_from_its_beginning_to_its_end_with_any_heads(heads, parts):
    nodes = drawn(arrow(*POINTS, heads=heads))
    meshes = [n for n in nodes.values() if isinstance(n.shape, Mesh)]
    assert len(meshes) == parts
    points = np.vstack([world(n) for n in nodes.values() if n.shape is not None])
    along = (points - POINTS[0]) @ np.array([0, 0.6, 0.8])
    assert (along.min(), along.max()) == pytest.approx((0, 0.5))
    for end in np.array(POINTS):
        assert np.linalg.norm(points - end, axis=1).min() < 1e-12


def test_the_label_stands_where_it_is_told_to():
    label = drawn(arrow(*POINTS, "l_1", label_at=1.1))["label"]
    assert label.shape.text == "l_1"
    assert label.pose[:3, 3] == pytest.approx([0.1, 0.33, 0.44])


def test_an_arrow_without_a_text_writes_nothing():
    assert not any(isinstance(n.shape, Label) for n in drawn(arrow(*POINTS)).values())


def test_an_arrow_moves_with_its_pose_and_a_view_follows_every_change():
    a = arrow(*POINTS, "long", name="a")
    view = View().add(a)
    a.move(rp2t(rotz(0.5), (1, 2, 3)))
    a.set(points=((0, 0, 0), (1, 0, 0)), label="short", heads="both", color="#ff0000")
    assert not diff(view.nodes, View().add(a).nodes)
    assert view.nodes["a"].pose[:3, 3] == pytest.approx([1, 2, 3])
    assert view.nodes["a/label"].shape.text == "short"


def test_a_head_is_never_longer_than_its_arrow():
    nodes = drawn(arrow((0, 0, 0), (0, 0, 0.1), heads="both", head=3.0))
    assert np.ptp(nodes["line"].shape.points[:, 2]) == pytest.approx(0.01)


@pytest.mark.parametrize(
    ("values", "told"),
    [
        ({"points": ((0, 0, 0), (0, 0, 0))}, r"points of 'a' begins and ends at one point"),
        ({"points": (0, 1)}, r"points of 'a': begin must have shape \(3,\)"),
        ({"points": 3}, "points of 'a' must be the points where it begins and ends, got 3"),
        ({"heads": "two"}, "heads of 'a' must be one of 'end', 'both', 'none', got 'two'"),
        ({"label": 3}, "label of 'a' must be text, got 3"),
        ({"label_at": "end"}, "label_at of 'a' must be"),
        ({"head": 0}, "head of 'a' must be above 0"),
    ],
)
def test_what_cannot_be_is_refused_and_changes_nothing(values, told):
    a = arrow(*POINTS, "text", name="a")
    before = repr(a), a.heads, a.label, a.label_at, a.head
    with pytest.raises(InputError, match=told):
        a.set(**values)
    assert (repr(a), a.heads, a.label, a.label_at, a.head) == before
