"""Handles: identity, settings, who hears of a change."""

import gc
import threading
from itertools import chain, count

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy import pi

from dhlab import AttachError, InputError, block_complex, csys, cube, rotz, rp2t, transl
from dhlab.scene.handle import CHANGES, Names


class Listener:
    """Counts what it hears."""

    def __init__(self):
        self.heard = []

    def handle_changed(self, handle):
        self.heard.append(handle)


def test_two_handles_are_equal_only_if_they_are_one():
    a, b = cube(1), cube(1)
    assert a == a
    assert a != b
    assert len({a, b}) == 2


def test_a_pose_read_from_a_handle_cannot_be_written_to():
    with pytest.raises(ValueError, match="read-only"):
        csys().pose[0, 3] = 1


def test_a_handle_keeps_no_hold_on_the_array_it_was_given():
    T = np.eye(4)
    A = csys(T)
    T[0, 3] = 5
    assert A.pose[0, 3] == 0


def test_a_misspelt_property_is_an_error():
    with pytest.raises(AttributeError, match="colour"):
        cube(1).colour = "#ff0000"
    with pytest.raises(TypeError, match=r"no property 'colour' of a Block; choose from color, "):
        cube(1).set(colour="#ff0000")


def test_an_assignment_is_told_once():
    b, ear = cube(1), Listener()
    b.watch(ear)
    b.pose = (1, 2, 3)
    assert ear.heard == [b]
    b.set(pose=(0, 0, 0), color="#ff0000", opacity=0.5)
    assert ear.heard == [b, b]


def test_a_failed_assignment_changes_nothing_and_tells_nobody():
    b, ear = cube(1, color="#ff0000"), Listener()
    b.watch(ear)
    with pytest.raises(InputError, match=r"opacity of 'block' must be at most 1, got 2"):
        b.set(color="#00ff00", opacity=2)
    assert b.color == (1, 0, 0)
    assert ear.heard == []


def test_who_watches_no_more_hears_no_more():
    b, ear = cube(1), Listener()
    b.watch(ear)
    b.unwatch(ear)
    b.unwatch(ear)
    b.pose = (1, 2, 3)
    assert ear.heard == []


def test_who_watches_first_hears_first():
    b, order = cube(1), []

    class Named:
        def __init__(self, name):
            self.name = name

        def handle_changed(self, handle):
            order.append(self.name)

    ears = [Named(name) for name in range(20)]
    for ear in ears:
        b.watch(ear)
    b.unwatch(ears[3])
    b.watch(ears[7])
    b.pose = (1, 2, 3)
    assert order == [name for name in range(20) if name != 3]


def test_a_handle_does_not_keep_its_watchers_alive():
    b = cube(1)
    b.watch(Listener())
    gc.collect()
    b.pose = (1, 2, 3)
    assert not b._observers


@pytest.mark.parametrize(
    ("value", "origin", "turned"),
    [
        ((1, 2, 3), (1, 2, 3), True),
        ([[1], [2], [3]], (1, 2, 3), True),
        (np.eye(4), (0, 0, 0), False),
        (np.eye(3), (4, 5, 6), False),
    ],
)
def test_what_a_move_does_not_give_stays(value, origin, turned):
    A = csys(rp2t(rotz(pi / 2), (4, 5, 6)))
    A.move(value)
    assert A.pose[:3, 3] == pytest.approx(origin)
    assert A.pose[:3, :3] == pytest.approx(rotz(pi / 2) if turned else np.eye(3))


@pytest.mark.parametrize(
    ("value", "message"),
    [
        ((1, 2), r"pose of 'A' must be a 3-vector, a 4x4 pose or a 3x3 rotation, got shape \(2,\)"),
        (np.diag([1, 1, -1, 1]), r"pose of 'A' is not a rotation but a reflection"),
        ((1, 2, np.nan), r"pose of 'A' must be finite, got nan at \[2\]"),
        ("origin", r"pose of 'A' must be made of numbers, got 'origin'"),
    ],
)
def test_a_pose_that_cannot_be_is_refused_in_words(value, message):
    A = csys(name="A")
    with pytest.raises(InputError, match=message):
        A.move(value)
    assert (A.pose == np.eye(4)).all()


def test_moving_a_complex_moves_its_parts_and_each_can_still_be_set_alone():
    left, right = cube(1, name="left"), cube(1, name="right", pose=(2, 0, 0))
    both = block_complex(left, right, name="both")
    both.move((0, 0, 5))
    assert right.world_pose[:3, 3] == pytest.approx((2, 0, 5))
    assert right.pose[:3, 3] == pytest.approx((2, 0, 0))
    both.color = "#ff0000"
    right.color = "#00ff00"
    assert left.color == (1, 0, 0)
    assert right.color == (0, 1, 0)
    assert both.color is None


def test_who_watches_a_part_hears_of_the_whole_and_the_other_way_round():
    left, right = cube(1, name="left"), cube(1, name="right")
    both, part_ear, whole_ear = block_complex(left, right), Listener(), Listener()
    left.watch(part_ear)
    both.watch(whole_ear)
    both.move((0, 0, 1))
    right.color = "#ff0000"
    assert part_ear.heard == [left, left]
    assert whole_ear.heard == [both, both]


def test_a_part_described_alone_stands_where_it_is_in_the_world():
    part = cube(1, name="part", pose=(1, 0, 0))
    block_complex(part, cube(1), pose=rp2t(rotz(pi / 2), (0, 0, 1)))
    assert part.describe()["part"].pose[:3, 3] == pytest.approx((0, 1, 1))
    assert part.describe("other").keys() == {"other"}


def test_names_of_parts_are_made_up_where_they_are_missing():
    group = block_complex(cube(1), cube(1), cube(1, name="block_2"))
    assert [part.name for part in group.components] == ["block", "block_3", "block_2"]


def test_a_name_that_a_sibling_has_is_refused():
    with pytest.raises(InputError, match="two parts of 'block_complex' are called 'a'"):
        block_complex(cube(1, name="a"), cube(1, name="a"))
    a, b = cube(1, name="a"), cube(1, name="b")
    block_complex(a, b)
    with pytest.raises(InputError, match="name of 'b': a sibling is called 'a' already"):
        b.name = "a"
    assert b.name == "b"


@pytest.mark.parametrize("name", ["", "  ", "a/b", 3])
def test_what_is_no_name_is_refused(name):
    with pytest.raises(InputError, match="must be text, not empty and without '/'"):
        csys(name=name)


def test_a_part_belongs_to_one_whole_at_most():
    a, b = cube(1, name="a"), cube(1, name="b")
    whole = block_complex(a, name="whole")
    with pytest.raises(AttachError, match="'a' is attached to 'whole' already"):
        block_complex(b, a)
    assert b.parent is None
    assert a.parent is whole
    c = cube(1, name="c")
    with pytest.raises(AttachError, match="'c' is attached to"):
        block_complex(c, c)
    assert c.parent is None


def test_bad_options_leave_the_parts_of_a_complex_free():
    a = cube(1)
    with pytest.raises(InputError, match="opacity"):
        block_complex(a, opacity=3)
    assert a.parent is None


def test_nobody_sees_half_of_a_change_made_in_another_thread():
    b = cube(1)
    b.set(pose=(0, 0, 0), opacity=0.0)
    torn = []

    def change():
        for k in range(300):
            b.set(pose=(k, 0, 0), opacity=k / 300)

    worker = threading.Thread(target=change)
    worker.start()
    while worker.is_alive():
        with CHANGES:
            node = b.describe()["block"]
        if abs(node.pose[0, 3] / 300 - node.style.opacity) > 1e-12:
            torn.append(node)
    worker.join()
    assert torn == []


def test_a_csys_reads_well():
    assert repr(csys(transl((1, 2, -0.00001)), name="A")) == (
        "Csys 'A' at (1.0000, 2.0000, 0.0000), axes of its parent"
    )
    assert repr(csys(rp2t(rotz(pi / 2), (0, 0, 0)))) == (
        "Csys 'csys' at (0.0000, 0.0000, 0.0000), x = (0.0000, 1.0000, 0.0000); "
        "y = (-1.0000, 0.0000, 0.0000); z = (0.0000, 0.0000, 1.0000)"
    )


@settings(derandomize=True, deadline=None)
@given(st.lists(st.tuples(st.booleans(), st.sampled_from(["a", "a_2", "a_3", "b"]))))
def test_a_name_is_the_first_that_is_free_also_where_names_came_back(steps):
    names, taken = Names(), set()
    for gives, name in steps:
        if gives:
            names.give(name)
            taken.discard(name)
        else:
            numbered = (f"{name}_{k}" for k in count(2))
            free = next(one for one in chain([name], numbered) if one not in taken)
            assert names.take(name) == free
            taken.add(free)
        assert all(one in names for one in taken)
