"""A value is marked as the check saw it, as it is in the notebook."""

import numpy as np
import pytest

from dhlab import transl
from dhlab.grading.asked import Ask
from dhlab.grading.runner import run_cells

CHECK = "from dhlab.grading import checks\ncheck = checks('e')"


@pytest.fixture
def came(sandbox):
    """A function that runs cells behind that with the checks and gives what came for `x`."""

    def came(*cells, ask=None):
        asks = [Ask("x") if ask is None else ask]
        run = run_cells([CHECK, *cells], asks, {}, sandbox=sandbox)
        assert run.notes == ()
        return run.replies["x"]

    return came


def test_a_robot_that_a_later_cell_moves_counts_as_it_was_when_it_was_checked(came):
    cells = [
        "from dhlab import dh, robot, robot_complex\nx = robot([dh(0, 0.5, 0, 0)], 'r', name='x')",
        "check('x', x)",
        "hand = robot_complex(x, base=(0, 0, 0.1))\nx.q = [1.0]",
    ]
    (robot,) = came(*cells, ask=Ask("x", "robot"))
    np.testing.assert_array_equal(robot["base"], np.eye(4))
    assert robot["q"] == [0]


def test_an_array_that_a_later_cell_writes_into_counts_as_it_was(came):
    cells = ["import numpy as np\nx = np.zeros(2)", "check('x', x)", "x += 1"]
    np.testing.assert_array_equal(came(*cells)[0], [0, 0])


@pytest.mark.parametrize(
    ("cells", "value"),
    [
        (["x = 1", "check('x', x)", "x = 2", "check('x', x)"], 2),
        (["check('x', 3)", "x = 1"], 3),
        (["x = 1", "check(name='x', answer=x)", "x = 2"], 1),
        (["x = 1", "check('y', 5)\ncheck(5, x)\ncheck([], x)\ncheck()", "x = 2"], 2),
        (["x = 1", "check('x', ...)", "x = 2"], 2),
        (["check('x', 1)", "check('x', ...)", "x = 2"], 2),
        (["x = 1", "def check(*_): pass", "check('x', x)", "x = 2"], 2),
    ],
)
def test_the_last_check_counts_and_the_variable_where_none_saw_a_value(came, cells, value):
    assert came(*cells) == (value,)


def test_what_is_no_value_is_none_when_it_is_checked_too(came):
    assert came("x = {1, 2}", "check('x', x)", "x = 1")[0].reason == "not numbers"
    odd = "class Odd:\n    def __array__(self, *_, **__):\n        raise KeyError('no')\nx = Odd()"
    reply = came(odd, "check('x', x)")[0]
    assert (reply.reason, reply.text[:8]) == ("raised", "KeyError")


def test_a_function_is_asked_when_all_cells_have_run(came):
    cells = ["n = 1\ndef x(a):\n    return n * a", "check('x', x)", "n = 2"]
    assert came(*cells, ask=Ask("x", cases=((3,), (4,)))) == (6, 8)


def test_a_value_that_must_not_have_the_library_is_not_seen_where_the_library_is(sandbox):
    cells = [CHECK, "import dhlab", "A = dhlab.csys((1, 2, 3))", "x = dhlab.transl((1, 2, 3))"]
    asks = [Ask("A", "csys"), Ask("x")]
    run = run_cells([*cells, "check('A', A)\ncheck('x', x)"], asks, {}, sandbox=sandbox)
    np.testing.assert_allclose(run.replies["A"][0], transl([1, 2, 3]))
    assert run.replies["x"][0].reason == "not numbers"
