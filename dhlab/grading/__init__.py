"""Exercises: what is asked, the check cell in the notebook, building and marking.

An exercise is a folder with `exercise.py` (the whole notebook as text, with its answers),
`checks.py` (the questions) and `wrong.py` (typical wrong answers and the diagnosis meant for each);
`dhlab exercise build` makes the notebook for students from them.

- `question`, `exercise`: what is asked; `judge`: from what came to points and a sentence
- `check`, `tried`, `printed`, `said`: the check cell
- `source`, `build`, `trial`: from the text to the notebook, and its proof
- `named`: whose numbers a notebook is marked with
- `mark`: one submission; `runner`: its cells run and asked for values, which nothing trusts
- `sandbox`, `mounts`, `syscalls`, `tools`: where they run, and what is there
- `heard`, `watched`, `processes`: what is listened to, and the clocks
- `asked`, `values`, `inside`: what is asked, and the way that an answer takes
"""

from dhlab.grading.check import checks
from dhlab.grading.question import Question

__all__ = ["Question", "checks"]
