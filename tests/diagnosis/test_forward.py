"""Links and chains as functions: each mistake is named."""

import numpy as np
import pytest

from dhlab.diagnosis import ForwardTask, LinkTask
from dhlab.diagnosis.chain_slips import chain_slips
from dhlab.diagnosis.table_model import evaluate_tables, table_of
from dhlab.kinematics.dh import link_transform


@pytest.mark.parametrize("made", [1, 2])
def test_mistakes_in_forward_kinematics_are_named(made, chains, tally):
    rng = np.random.default_rng(made)
    for _ in range(300 if made == 1 else 60):
        chain = chains(rng)
        slips = [s for s in chain_slips(chain) if made == 1 or not s.alone]
        chosen = [slips[k] for k in sorted(rng.choice(len(slips), made, replace=False))]
        cases = []
        for q in rng.uniform(-2, 2, (4, chain.n)):
            model = table_of(chain, q)
            for slip in chosen:
                model = slip.change(model)
            cases.append(((q,), evaluate_tables([model])[0]))
        tally.judge(ForwardTask(chain), cases, {s.mistake.key for s in chosen})
    tally.check()


def test_a_configuration_comes_as_a_list_or_as_numbers(chains, tally):
    rng = np.random.default_rng(8)
    for _ in range(30):
        chain = chains(rng)
        q = rng.uniform(-1, 1, (2, chain.n))
        tally.judge(ForwardTask(chain), [((x.tolist(),), chain.tip(x)) for x in q])
        tally.judge(ForwardTask(chain), [(tuple(x), chain.tip(x)) for x in q])
    tally.check(share=0)


@pytest.mark.parametrize("convention", ["modified", "standard"])
def test_a_link_written_in_the_other_convention_or_transposed_is_named(convention, keys):
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


@pytest.mark.parametrize("convention", ["modified", "standard"])
def test_an_origin_at_a_0_d_is_a_slide_along_an_axis_that_was_not_turned(convention, keys):
    rows = np.random.default_rng(3).uniform(0.2, 1, (3, 4))
    came = []
    for row in rows:
        T = link_transform(row, convention)
        T[:3, 3] = row[1], 0, row[2]
        came.append((tuple(row), T))
    assert keys(LinkTask(convention).judge(came)) == [{"origin-plain"}]
