"""The table editor: edits move the robot, wrong input is explained, undo, code."""

import numpy as np
import pytest

from dhlab import InputError, LimitError, TableEditor, View, deg, dh, models, robot, side_by_side
from dhlab.panel.table_code import table_code
from dhlab.panel.table_editor import TableWidget
from dhlab.scene.robot import Robot


@pytest.fixture
def arm():
    rows = [dh(0, 0, 0.4, 0), dh(90 * deg, 0.2, 0, 0.5), dh(0, 0.7, 0, 0)]
    return robot(rows, "rrp", name="arm", grasper=(0.5, 0, 0), limits=[(-3, 3), (-3, 3), (0, 1)])


@pytest.fixture
def editor(arm):
    editor = TableEditor(arm)
    yield editor
    editor.close()


def say(editor, *words):
    """Let the page say something."""
    editor.widget._handle_custom_msg({"say": list(words)}, [])


def test_an_edit_moves_the_robot_at_once(arm, editor):
    before = arm.frames()["arm/grasper"]
    editor.edit(2, "a", "0.35")
    editor.edit(2, "alpha", "-45°")
    assert (arm.chain.rows[1].a, arm.chain.rows[1].alpha) == (0.35, pytest.approx(-np.pi / 4))
    assert not np.allclose(arm.frames()["arm/grasper"], before)


def test_the_page_gets_the_tables_together_with_the_widget(arm, monkeypatch):
    opened = []
    monkeypatch.setattr(TableWidget, "open", lambda self: opened.append(self.get_state()))
    editor = TableEditor(arm)
    editor.edit(1, "d", "0.3")
    assert editor.widget.comm is None
    state = opened[0]
    assert [len(table["rows"]) for table in state["tables"]] == [3]
    assert state["steps"] == [True, False]


def test_a_page_that_is_ready_late_is_told_again(editor, monkeypatch):
    told, _ = [], editor.widget
    monkeypatch.setattr(TableWidget, "send_state", lambda self, key=None: told.append(key))
    say(editor, "ready")
    assert told == [("tables", "steps")]


def test_the_cell_of_a_variable_sets_the_variable(arm, editor):
    editor.edit(2, "theta", "30")
    editor.edit(3, "d", "0.6")
    assert np.allclose(arm.q, [0, np.pi / 6, 0.6])
    assert arm.chain.rows[1].theta == 0.5


def test_undo_and_redo_give_tables_and_variables_back(arm, editor):
    chain, q = arm.chain, arm.q
    editor.edit(2, "a", "0.35")
    editor.edit(2, "theta", "30")
    editor.undo()
    editor.undo()
    editor.undo()
    assert arm.chain is chain
    assert np.array_equal(arm.q, q)
    editor.redo()
    assert arm.chain.rows[1].a == 0.35
    editor.edit(1, "d", "0.5")
    editor.redo()
    assert (arm.chain.rows[0].d, arm.chain.rows[1].a) == (0.5, 0.35)


@pytest.mark.parametrize(
    ("where", "text", "error", "message"),
    [
        ((2, "alpha"), "ninety", InputError, "row 2, α: 'ninety' is no number; type degrees"),
        ((2, "a"), "0,3", InputError, r"type metres, such as 0.25 \(a decimal point, not a comma"),
        ((2, "a"), "inf", InputError, "row 2, a: 'inf' is not finite; type metres"),
        ((3, "d"), "5", LimitError, r"joint 3 of 'arm': 5.0000 m is outside \[0.0000, 1.0000\]"),
        ((4, "a"), "1", InputError, "the table has rows 1 to 3, got 4"),
    ],
)
def test_wrong_input_is_explained_and_changes_nothing(arm, editor, where, text, error, message):
    chain, q = arm.chain, arm.q
    with pytest.raises((error, IndexError), match=message):
        editor.edit(*where, text)
    assert arm.chain is chain
    assert np.array_equal(arm.q, q)


def test_the_page_is_told_of_edits_mistakes_and_the_robot(arm, editor):
    widget = editor.widget
    say(editor, "edit", 0, 2, 1, "0.35")
    assert arm.chain.rows[1].a == 0.35
    assert widget.tables[0]["rows"][1] == ["90", "0.35", "0", "28.6479"]
    assert widget.steps == [True, False]
    say(editor, "edit", 0, 2, 0, "x")
    assert widget.note["text"].startswith("Row 2, α: 'x' is no number")
    assert (widget.note["row"], widget.note["column"]) == (2, 0)
    say(editor, "edit", 0, 2, 0, "10")
    assert widget.note == {}
    arm.q = [0.1, 0.2, 0.3]
    editor.flush()
    assert widget.tables[0]["rows"][2][2] == "0.3"
    say(editor, "undo")
    say(editor, "copy")
    assert widget.code[1] == editor.code


def test_the_cell_with_the_focus_is_drawn_on_the_robot(arm, editor):
    say(editor, "focus", 0, 2, 0)
    assert arm.dimensions == (2, "alpha")
    say(editor, "focus", 0, 3, None)
    assert arm.dimensions == (3, None)
    editor.select(None)
    assert arm.dimensions is None


def test_a_complex_robot_has_a_table_for_each_component():
    limb = models.upper_limb()
    editor = TableEditor(limb)
    assert [table["name"] for table in editor.widget.tables] == [c.name for c in limb.components]
    editor.edit(3, "a", "0.06", component=2)
    assert limb.components[2].chain.rows[2].a == 0.06
    editor.select(1, component=3)
    assert [c.dimensions for c in limb.components].count(None) == 5
    editor.close()


@pytest.mark.parametrize("make", [models.puma, models.scara, models.finger, models.thumb])
def test_the_code_gives_the_robot_back(make):
    made = make() if make is not models.finger else models.finger("index")
    space = {}
    exec(table_code(made.components), space)
    again = space[made.name]
    assert np.array_equal(again.chain.rows, made.chain.rows)
    for key in ("base", "grasper", "limits", "offset"):
        assert np.array_equal(getattr(again.chain, key), getattr(made.chain, key)), key
    assert (again.chain.joints, again.chain.convention) == (
        made.chain.joints,
        made.chain.convention,
    )


def test_the_code_names_each_robot_so_that_it_runs():
    names = ["robot", "class", "my arm", "arm", "pi", "deg"]
    made = [robot([dh(0, k, 0, 30 * deg)], "r", name=name) for k, name in enumerate(names)]
    space = {}
    exec(table_code([r.own for r in made]), space)
    again = {r.name: r for r in space.values() if isinstance(r, Robot)}
    assert list(again) == names
    for r in made:
        assert np.array_equal(again[r.name].chain.rows, r.chain.rows)


def test_a_component_that_there_is_not_is_refused_before_anything_changes():
    limb = models.upper_limb()
    editor = TableEditor(limb)
    limb.components[0].dimensions = 2
    words = r"'arm' has no component 6; choose from 0 \(arm\), 1 \(thumb\), 2 \(index\), "
    with pytest.raises(InputError, match=words):
        editor.edit(1, "a", "0.1", component=6)
    with pytest.raises(InputError, match="'arm' has no component -1"):
        editor.select(1, component=-1)
    with pytest.raises(InputError, match="the table has rows 1 to 4, got 5"):
        editor.select(5, component=2)
    say(editor, "focus", 6, 1, 0)
    assert limb.components[0].dimensions == (2, None)


def test_it_stands_beside_a_view(arm, editor):
    assert repr(side_by_side(View("v").add(arm), editor)).endswith(
        "TableEditor of 'arm': arm (3 rows)"
    )
    with pytest.raises(InputError, match="a table editor needs a robot, got 3"):
        TableEditor(3)
