"""Kinematics: from arrays to arrays, numpy only, immutable, batched over leading axes.

- `transforms`: rotations and poses; `angles`: their angles, and the way between two poses
- `dh`: one row of a Denavit-Hartenberg table, in both conventions
- `chain`: a table and what stands around it: one open chain
- `mechanism`: a tree of chains, and all its frames at once; `plan`: how that is done fast
- `trajectory`: a configuration as a function of time, from a `task` by `polynomials` and `ramps`;
  `poly3`: the paper's own planner; `plot`: a picture of a motion
- `typeset`, `table`: matrices and tables to read
"""
