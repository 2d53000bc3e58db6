"""The difference between two pictures."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dhlab.scene.node import Clock, Curve, Joint, Node, Style
from dhlab.shapes import Label, cube
from dhlab.view.commands import Paint, Place, Put, Remove, apply, diff

THERE = np.eye(4) + np.eye(4, k=3)
CLOCK = Clock("clock", np.array([0.0, 1.0]))
JOINT = Joint("r", np.eye(4), "key")
NODE = Node(shape=cube(1))

poses = st.sampled_from([np.eye(4), THERE, THERE @ THERE])
styles = st.sampled_from([Style(), Style(color=(1, 0, 0)), Style(opacity=0.5)])
shapes = st.sampled_from([None, cube(1), cube(2), Label("a")])
curves = st.sampled_from([None, Curve(CLOCK, np.array([0.0, 1.0]))])
joints = st.sampled_from([None, JOINT, Joint("p", np.eye(4), "slide")])
nodes = st.builds(
    Node,
    pose=poses,
    joint=joints,
    value=st.sampled_from([0.0, 1.0]),
    shape=shapes,
    style=styles,
    visible=st.booleans(),
    curve=curves,
)
trees = st.sets(st.sampled_from(["a", "a/b", "a/b/c", "a/d", "e", "ab"])).flatmap(
    lambda paths: st.fixed_dictionaries(
        {path: nodes for path in sorted(paths) if all_above(path) <= paths}
    )
)


def all_above(path):
    parts = path.split("/")
    return {"/".join(parts[:k]) for k in range(1, len(parts))}


@settings(derandomize=True, deadline=None)
@given(trees, trees)
def test_a_picture_and_the_difference_give_the_other_picture(old, new):
    picture = dict(old)
    apply(picture, diff(old, new))
    assert picture.keys() == new.keys()
    assert diff(picture, new) == []


@settings(derandomize=True, deadline=None)
@given(trees)
def test_a_picture_does_not_differ_from_its_copy(tree):
    copy = {path: node._replace(pose=node.pose.copy()) for path, node in tree.items()}
    assert diff(tree, copy) == []


@pytest.mark.parametrize(
    ("new", "kinds"),
    [
        (Node(shape=cube(1), pose=THERE), [Place]),
        (Node(shape=cube(1), style=Style(color=(1, 0, 0))), [Paint]),
        (Node(shape=cube(1), visible=False), [Paint]),
        (Node(shape=cube(1), pose=THERE, visible=False), [Place, Paint]),
        (Node(shape=cube(1), curve=Curve(CLOCK, np.array([0.0, 1.0]))), [Place]),
        (Node(shape=cube(1), joint=JOINT), [Put]),
        (Node(shape=cube(2)), [Put]),
        (Node(), [Put]),
        (Node(shape=cube(1)), []),
    ],
)
def test_each_change_of_a_node_is_told_by_its_verb(new, kinds):
    assert [type(command) for command in diff({"a": NODE}, {"a": new})] == kinds


def test_a_joint_that_moves_is_one_command():
    arm = {"arm": Node(), "arm/1": Node(joint=JOINT), "arm/1/body": NODE}
    moved = arm | {"arm/1": Node(joint=JOINT, value=0.5)}
    (command,) = diff(arm, moved)
    assert isinstance(command, Place)
    assert (command.path, command.node.value) == ("arm/1", 0.5)


def test_a_subtree_that_goes_is_one_command():
    old = {"a": Node(), "a/b": Node(), "a/b/c": Node(), "a/d": Node(), "ab": Node()}
    (command,) = diff(old, {"a": old["a"], "ab": old["ab"], "a/d": old["a/d"]})
    assert isinstance(command, Remove)
    assert command.path == "a/b"


def test_removing_a_node_leaves_those_whose_names_only_begin_alike():
    picture = {"a": Node(), "a/b": Node(), "ab": Node(), "a.ghosts": Node()}
    apply(picture, [Remove("a")])
    assert list(picture) == ["ab", "a.ghosts"]


def test_parents_are_put_before_their_children():
    new = {"a": Node(), "a/b": Node(), "a/b/c": Node()}
    assert [command.path for command in diff({}, new)] == ["a", "a/b", "a/b/c"]


def test_placing_leaves_the_paint_and_painting_the_place():
    new = Node(shape=cube(1), pose=THERE, style=Style(color=(1, 0, 0)))
    placed, painted = {"a": NODE}, {"a": NODE}
    apply(placed, [Place("a", new)])
    apply(painted, [Paint("a", new)])
    assert placed["a"].style == NODE.style
    assert np.array_equal(painted["a"].pose, NODE.pose)
