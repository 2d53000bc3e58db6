"""Links, chains and tables: each mistake is named, no right answer is called wrong."""

from math import pi

import numpy as np
import pytest

from dhlab.diagnosis import ForwardTask, LinkTask, TableTask
from dhlab.diagnosis.chain_slips import chain_slips, evaluate_tables, table_of
from dhlab.kinematics.chain import Chain
from dhlab.kinematics.dh import link_transform
from dhlab.kinematics.transforms import rotx, rp2t


def random_chain(rng):
    n = int(rng.integers(2, 7))
    joints = "".join(rng.choice(["r", "r", "p"], n))
    angles = (0, pi / 2, -pi / 2, 0.4, -1.1)
    rows = [
        (rng.choice(angles), rng.uniform(-1, 1), rng.uniform(-1, 1), rng.choice(angles))
        for _ in range(n)
    ]
    return Chain(
        rows,
        joints,
        rng.choice(["modified", "standard"]),
        base=rng.uniform(-1, 1, 3),
        grasper=rp2t(rotx(rng.uniform(-1, 1)), rng.uniform(-1, 1, 3)),
        offset=rng.uniform(-1, 1, n) * rng.integers(2),
    )


def keys(verdict):
    groups = verdict.either or ((verdict.mistakes,) if verdict.mistakes else ())
    return [{m.key for m in group} for group in groups]


@pytest.mark.parametrize("slips_made", [1, 2])
def test_mistakes_in_forward_kinematics_are_named_and_none_that_was_not_made(slips_made):
    rng = np.random.default_rng(slips_made)
    named = false = tried = 0
    for _ in range(120 if slips_made == 1 else 25):
        chain = random_chain(rng)
        slips = chain_slips(chain)
        chosen = [slips[k] for k in sorted(rng.choice(len(slips), slips_made, replace=False))]
        cases = []
        for q in rng.uniform(-2, 2, (4, chain.n)):
            model = table_of(chain, q)
            for slip in chosen:
                model = slip.change(model)
            cases.append(((q,), evaluate_tables([model])[0]))
        verdict = ForwardTask(chain).judge(cases)
        if verdict.right:
            continue
        tried += 1
        found, made = keys(verdict), {slip.mistake.key for slip in chosen}
        simpler = any(len(group) < len(made) for group in found)  # gives the very same values
        named += made in found or simpler
        false += bool(found) and made not in found and not simpler
    share = f"rightly named: {named} of {tried}, falsely: {false}"
    assert false == 0, share
    assert named >= 0.95 * tried, share


def test_a_right_table_is_accepted_with_its_ends_and_without():
    rng = np.random.default_rng(3)
    for _ in range(50):
        chain = random_chain(rng)
        other = chain.to_standard()
        table = {
            "rows": other.rows,
            "convention": "standard",
            "base": other.base,
            "grasper": other.grasper,
        }
        assert TableTask(chain).judge([((), table)]).right
        rows = [list(row) for row in chain.rows]
        assert TableTask(chain, tool_free=True).judge([((), rows)]).right


def test_a_table_with_a_mistake_is_never_called_right_and_the_mistake_is_among_those_named():
    rng = np.random.default_rng(4)
    for _ in range(25):
        chain = random_chain(rng).replace(convention="modified")
        slips = [s for s in chain_slips(chain, table=True) if "side" not in s.mistake.key]
        slip = slips[rng.integers(len(slips))]
        wrong = slip.change(table_of(chain, chain.home)).chain(chain)
        table = {name: getattr(wrong, name) for name in ("rows", "convention", "base", "grasper")}
        verdict = TableTask(chain).judge([((), table | {"offset": wrong.offset})])
        same = np.allclose(wrong.tip(np.ones(chain.n)), chain.tip(np.ones(chain.n)))
        assert verdict.right or not same
        assert verdict.right or not verdict.mistakes or {slip.mistake.key} in keys(verdict)


@pytest.mark.parametrize("convention", ["modified", "standard"])
def test_a_link_written_in_the_other_convention_or_transposed_is_named(convention):
    rows = np.random.default_rng(2).uniform(-1, 1, (3, 4))
    task, other = LinkTask(convention), {"modified": "standard", "standard": "modified"}
    right = [(tuple(r), link_transform(r, convention)) for r in rows]
    assert task.judge(right).right
    mixed = [(tuple(r), link_transform(r, other[convention])) for r in rows]
    assert {"convention"} in keys(task.judge(mixed))
    turned = [(r, T.T) for r, T in right]
    assert keys(task.judge(turned)) == [{"transposed"}]
    permuted = [(tuple(r), link_transform(r[[1, 0, 2, 3]], convention)) for r in rows]
    assert keys(task.judge(permuted)) == [{"columns-1023"}]


@pytest.mark.parametrize(
    ("table", "sentence"),
    [
        ("a table", "is text"),
        ([[0, 0, 0, 0]], "fewer rows"),
        ([[0, 0, 0]] * 2, "shape"),
        ([[90, 0, 0, 0]] * 2, "degrees"),
        ([[np.nan, 0, 0, 0]] * 2, "nan"),
        ({"rows": [[0, 0, 0, 0]] * 2, "joints": "rp"}, "Joint 2 has the wrong letter"),
    ],
)
def test_what_is_no_table_gets_a_sentence(table, sentence):
    verdict = TableTask(Chain([(0, 0.1, 0, 0)] * 2, "rr")).judge([((), table)])
    assert not verdict.right
    assert sentence in verdict.text
