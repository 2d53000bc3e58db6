"""Tables: each mistake is named, no right answer is called wrong."""

from math import pi

import numpy as np
import pytest

from dhlab.diagnosis import TableTask
from dhlab.diagnosis.chain_slips import table_slips
from dhlab.diagnosis.table_model import chain_of, table_of
from dhlab.kinematics.chain import Chain
from dhlab.kinematics.transforms import rotx, roty, rotz, rp2t
from dhlab.models.industrial import puma


def mapping(chain):
    """What a student gives for a chain."""
    told = ("rows", "joints", "convention", "base", "grasper", "offset")
    return {name: getattr(chain, name) for name in told}


@pytest.mark.parametrize("made", [1, 2])
def test_mistakes_in_tables_are_named(made, chains, tally):
    rng = np.random.default_rng(made)
    for _ in range(300 // made**2):
        chain = chains(rng)
        slips, table = table_slips(chain), table_of(chain, chain.home)
        slips = slips if made == 1 else [s for s in slips if not s.alone]
        chosen = [slips[k] for k in sorted(rng.choice(len(slips), made, replace=False))]
        for slip in chosen:
            table = slip.change(table)
        if table.is_chain(chain.n):
            came = mapping(chain_of(table))
            tally.judge(TableTask(chain), [((), came)], {s.mistake.key for s in chosen})
    tally.check()


def test_each_choice_of_a_right_table_is_accepted(chains, tally):
    rng = np.random.default_rng(3)
    for _ in range(60):
        chain = chains(rng)
        tally.judge(TableTask(chain), [((), mapping(chain.to_standard()))])
        tally.judge(TableTask(chain), [((), mapping(chain.to_modified()))])
        tally.judge(TableTask(chain, tool_free=True), [((), chain.rows)])
        turned = np.add(chain.rows, (2 * pi, 0, 0, -4 * pi))
        tally.judge(TableTask(chain), [((), turned)])
        flipped = np.array(chain.rows)
        flipped[:, :2] *= -1
        if chain.convention == "modified":  # x of every frame the other way, z as it was
            ends = {"base": chain.base @ np.diag([-1, -1, 1, 1])}
            ends["grasper"] = np.diag([-1, -1, 1, 1]) @ chain.grasper
            tally.judge(TableTask(chain), [((), {"rows": flipped, **ends})])
    tally.check(share=0)


def test_a_table_read_in_the_other_convention_is_named(keys):
    chain = Chain([(0, 0, 0.3, 0), (pi / 2, 0.1, 0, 0), (0, 0.4, 0.1, 0), (-1, 0, 0, 0)], "rrrr")
    task = TableTask(chain, tool_free=True)
    assert {"convention"} in keys(task.judge([((), chain.to_standard().rows)]))
    came = {"rows": chain.rows, "convention": "standard"}
    assert {"convention"} in keys(TableTask(chain).judge([((), came)]))


def test_a_joint_that_is_skipped_or_doubled_is_named(chains, keys):
    rng = np.random.default_rng(5)
    for _ in range(20):
        chain = chains(rng)
        i = int(rng.integers(chain.n))
        rows = [list(row) for row in chain.rows]
        less, more = rows[:i] + rows[i + 1 :], rows[: i + 1] + rows[i:]
        for table, key in ((less, f"skipped-{i + 1}"), (more, f"doubled-{i + 1}")):
            verdict = TableTask(chain).judge([((), table)])
            assert not verdict.right
            assert {key} in keys(verdict) or not len(table)


def test_a_row_for_the_tool_or_the_base_is_named(chains, keys):
    rng = np.random.default_rng(6)
    for _ in range(20):
        chain = chains(rng)
        rows, extra = [list(row) for row in chain.rows], [0.123, 0.456, 0.789, 0.321]
        for table, key in (([*rows, extra], "tool-row"), ([extra, *rows], "base-row")):
            verdict = TableTask(chain).judge([((), table)])
            assert {key} in keys(verdict)


def test_what_is_first_wrong_is_said_where_no_cause_fits(keys):
    chain = puma().own.chain
    rows = np.array(chain.rows)
    for cell, change, sentence in (
        ((2, 1), 0.0417, "axes of joints 2 and 3 are not as far apart"),
        ((3, 0), 0.1, "axes of joints 3 and 4 enclose another angle"),
        ((3, 2), 0.0713, "Along the axis of joint 4, its neighbours are not as far apart"),
    ):
        wrong = rows.copy()
        wrong[cell] += change
        verdict = TableTask(chain).judge([((), wrong)])
        assert sentence in verdict.text
        assert not keys(verdict)
    away = {"rows": rows, "base": (0.55, 0, 1.234)}
    assert (
        "axis of joint 1 does not lie where it should" in TableTask(chain).judge([((), away)]).text
    )
    tip = {"rows": rows, "grasper": (0, 0.777, 0.1)}
    assert "All axes lie where they should" in TableTask(chain).judge([((), tip)]).text


def test_the_zero_of_joints_counts_where_it_is_asked_for():
    chain = Chain([(0, 0, 0, 0), (0, 0.3, 0, 0)], "rr", grasper=(0.2, 0, 0), offset=(0.3, 0))
    rows = [list(row) for row in chain.rows]
    other = {"rows": rows, "offset": (0, 0)}
    assert TableTask(chain).judge([((), other)]).right
    strict = TableTask(chain, zero_free=False)
    assert strict.judge([((), rows)]).right
    assert [m.key for m in strict.judge([((), other)]).mistakes] == ["no-offset"]
    other["offset"] = (0.1, 0.77)
    assert "count from another zero" in strict.judge([((), other)]).text


def test_which_right_table_it_is_is_said():
    chain = Chain([(0, 0, 0, 0), (pi / 2, 0.3, 0, 0), (0, 0.4, 0, 0)], "rrr", grasper=(0.1, 0, 0))
    rows = [(0, 0, 0, 0), (-pi / 2, 0.3, 0, 0), (0, 0.4, 0, 0)]
    text = TableTask(chain, tool_free=True).judge([((), rows)]).text
    assert text == (
        "One of several right tables: z of joint 2, 3 points the other way than in our table."
    )


@pytest.mark.parametrize(
    ("table", "sentence"),
    [
        ("a table", "is text"),
        ([[0, 0, 0, 0]], "fewer rows"),
        ([[0, 0, 0, 0]] * 5, "more rows"),
        ([[0, 0, 0]] * 2, "shape"),
        ([[np.nan, 0, 0, 0]] * 2, "nan"),
        ({"rows": [[0, 0, 0, 0]] * 2, "joints": "rp"}, "Joint 2 has the wrong letter"),
        ({"rows": [[0, 0, 0, 0]] * 2, "joints": "rx"}, "letter of joint 2 is neither"),
        ({"rows": [[0, 0, 0, 0]] * 2, "joints": "r"}, "2 rows, but there are 1 joint letters"),
        ({"rows": [[0, 0, 0, 0]] * 2, "joints": 7}, "letter of joint 1 is neither"),
        ({"rows": [[0, 0, 0, 0]] * 2, "convention": "craig"}, "neither 'modified' nor"),
        ({"rows": [[0, 0, 0, 0]] * 2, "convention": [1]}, "neither 'modified' nor"),
        ({"rows": [[0, 0, 0, 0]] * 2, "base": np.ones((4, 4))}, "The base is no pose"),
        ({"rows": [[0, 0, 0, 0]] * 2, "offset": [1, 2, 3]}, "The offset has shape"),
        ({"joints": "rr"}, "asked for by its rows"),
        ({"alpha": [0, 0], "a": [1, 1]}, "asked for by its rows"),
    ],
)
def test_what_is_no_table_gets_a_sentence(table, sentence):
    verdict = TableTask(Chain([(0, 0.1, 0, 0)] * 2, "rr")).judge([((), table)])
    assert not verdict.right
    assert sentence in verdict.text


def test_columns_are_not_called_exchanged_when_the_number_is_nowhere():
    scara = Chain([(0, 0, 0.4, 0), (0, 0.3, 0, 0), (np.pi, 0.25, 0, 0)], "rrp")
    task = TableTask(scara, zero_free=False)
    no_height = [(0, 0, 0, 0), *scara.rows[1:]]
    assert [m.key for m in task.judge([((), no_height)]).mistakes] == ["left-out-d-1"]
    exchanged = [(row.alpha, row.a, row.theta, row.d) for row in scara.rows]
    assert "columns-0132" in [m.key for m in task.judge([((), exchanged)]).mistakes]


def test_links_moved_twice_are_no_pair_of_mistakes():
    arm = Chain([(0, 0, 0, 0), (-1.5, 0, 0, 0), (0, 0.4, 0.15, 0), (-1.5, 0.1, 0.36, 0)], "rrrr")
    flat = arm.replace(3, d=0.0)
    verdict = TableTask(arm, tool_free=True).judge([((), flat.rows)])
    assert [m.key for m in verdict.mistakes] == ["left-out-d-3"]


def test_all_lengths_in_millimetres_are_noticed_with_the_tool_among_them():
    arm = Chain([(0, 0, 0.4, 0), (1.5, 0.3, 0, 0), (0, 0.25, 0.1, 0)], "rrr", grasper=(0.1, 0, 0))
    rows = np.array(arm.rows) * [1, 1000, 1000, 1]
    came = {"rows": rows, "grasper": [100.0, 0, 0]}
    assert [m.key for m in TableTask(arm).judge([((), came)]).mistakes] == ["millimetres"]


def test_columns_are_not_called_exchanged_where_a_free_number_would_hide_it():
    upright = Chain([(np.pi / 2, 0, 0, 0), (0, 0.4, 0, 0), (0, 0.3, 0, 0)], "rrr")
    flat = [(0, 0.4, 0, 0), (0, 0.3, 0, 0), (0, 0.2, 0, 0)]
    verdict = TableTask(upright, tool_free=True).judge([((), flat)])
    assert not [m.key for m in verdict.mistakes if m.key.startswith("columns")]


ARM = Chain(
    [(0, 0, 0.3, 0), (-pi / 2, 0, 0, 0), (0, 0.45, 0, 0)],
    "rrr",
    base=rp2t(rotz(1.2), (0.4, -0.3, 0.6)),
    grasper=rp2t(roty(0.6), (0.5, 0, -0.1)),
    offset=(0, -pi / 2, pi / 2),
)


@pytest.mark.parametrize(
    ("changes", "key"),
    [
        ({"offset": (0, pi / 2, -pi / 2)}, "sign-offsets"),
        ({"offset": (0, pi / 2, pi / 2)}, "sign-offset-2"),
        ({"offset": (0, -90, 90)}, "degrees-offset"),
        ({"offset": (0, 0, 0)}, "no-offset"),
        ({"base": rp2t(np.eye(3), (0.4, -0.3, 0.6))}, "base-unturned"),
        ({"base": rp2t(rotz(1.2), (0, 0, 0))}, "base-unmoved"),
        ({"base": rp2t(rotz(1.2), (0.4, 0.3, 0.6))}, "base-sign-y"),
        ({"grasper": (0.5, 0, -0.1)}, "tool-unturned"),
        ({"grasper": rp2t(roty(0.6), (0.5, 0, 0.1))}, "tool-sign-z"),
        ({"base": np.eye(4)}, "no-base"),
    ],
)
def test_what_is_wrong_around_a_table_is_not_looked_for_in_its_rows(changes, key, keys):
    """Its rows are right as they stand: none is called wrong, even if that would do the same."""
    answer = {"rows": ARM.rows, "base": ARM.base, "grasper": ARM.grasper, "offset": ARM.offset}
    verdict = TableTask(ARM, zero_free=False).judge([((), answer | changes)])
    assert keys(verdict) == [{key}]


def test_a_slip_is_named_only_where_it_stands_in_the_table(keys):
    """Axes may point up or down: by the other choice, this is no slip of our table."""
    up = Chain([(0, 0, 0.4, 0), (0, 0.3, 0, 0), (0, 0.25, 0, 0)], "rrr", grasper=(0.1, 0, -0.1))
    task = TableTask(up)
    down = [(0, 0, 0.4, 0), (pi, 0.3, 0, 0), (0, 0.25, 0, 0)]
    right = {"rows": down, "grasper": rp2t(rotx(pi), (0.1, 0, 0.1))}
    assert task.judge([((), right)]).right
    verdict = task.judge([((), right | {"grasper": rp2t(rotx(pi), (0.1, 0, -0.1))})])
    assert not verdict.right
    assert keys(verdict) == []


def test_a_slip_beside_another_choice_of_axes_may_be_in_each_number_that_mends_it(keys):
    """The second axis is turned over; then d of its row goes the other way, and here does not."""
    wrist = [(pi / 2, 0, 0, 0), (-pi / 2, 0, 0, 0)]
    arm = Chain([(0, 0, 0, 0), (-pi / 2, 0.1, 0.4, 0), *wrist], "rrrr", grasper=(0, 0.2, 0.1))
    rows = [(0, 0, 0, 0), (pi / 2, 0.1, -0.4, 0), (-pi / 2, 0, 0, 0), (pi / 2, 0, 0, 0)]
    task = TableTask(arm, tool_free=True)
    assert task.judge([((), rows)]).right
    rows[1] = (pi / 2, 0.1, 0.4, 0)
    verdict = task.judge([((), rows)])
    assert keys(verdict) == [{"sign-alpha-2"}, {"sign-a-2"}, {"sign-d-2"}]
    assert "either alpha in row 2" in verdict.text
