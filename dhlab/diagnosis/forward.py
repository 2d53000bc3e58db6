"""The task of computing the pose of a chain's tip from its configuration."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from dhlab.arrays import as_config
from dhlab.diagnosis.chain_slips import chain_slips
from dhlab.diagnosis.matrix import judge_matrices
from dhlab.diagnosis.slips import NOTHING
from dhlab.diagnosis.table_model import evaluate_tables, table_of
from dhlab.diagnosis.values import TOLERANCE, Floats
from dhlab.diagnosis.verdict import Case, Verdict
from dhlab.kinematics.chain import Chain


@dataclass(frozen=True, eq=False)
class ForwardTask:
    """A function from a configuration to the pose of the tip.

    Parameters
    ----------
    chain : Chain
        What is right. Each case has one argument, the configuration, shape (n,); or n numbers.
    tolerance : float

    Examples
    --------
    >>> arm = Chain([(0, 0, 0, 0), (1, 0.3, 0, 0)], "rr", grasper=(0.2, 0, 0))
    >>> no_tool = arm.replace(grasper=(0, 0, 0))
    >>> cases = [((q,), no_tool.tip(q)) for q in ([0.3, 1.2], [-1.0, 0.4])]
    >>> [m.key for m in ForwardTask(arm).judge(cases).mistakes]
    ['no-tool']
    """

    chain: Chain
    tolerance: float = TOLERANCE

    def reference(self, *inputs: Any) -> Floats:
        """What is right for these inputs, shape (4, 4)."""
        return np.array(self.chain.tip(self._q(inputs)))

    def judge(self, cases: Sequence[Case]) -> Verdict:
        """Judge an answer by what came for several configurations."""
        if not cases:
            return NOTHING
        models = [table_of(self.chain, self._q(inputs)) for inputs, _ in cases]
        slips = chain_slips(self.chain)
        return judge_matrices(cases, models, slips, 4, self.tolerance, evaluate_tables)

    def _q(self, inputs: Sequence[Any]) -> Floats:
        q = inputs[0] if len(inputs) == 1 and np.ndim(inputs[0]) else list(inputs)
        return as_config(q, self.chain.n, "q")
