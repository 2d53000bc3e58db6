"""What runs beside the student's code; it needs numpy and the standard library alone.

In the sandbox this folder is all there is of dhlab's grading, so its modules import only each
other; from outside only `plain`, `handles` and `notes` are imported. Nothing here knows what is
right: no expected value, tolerance or point comes in.

- `boot`, `main`: the process: the cells, then a process for each question
- `cells`, `answers`: running a cell; what an answer gives for the arguments of a case
- `plain`, `handles`: between values and strict JSON; what of a robot or a scene is judged
- `given`: functions of dhlab that the exercise gives
- `stub`: the `dhlab` that the cells import; `notes`: what they were seen to try
"""
