"""What runs beside the student's code; it needs numpy and the standard library alone.

In the sandbox this folder is all there is of dhlab's grading, so its modules import only each
other. Nothing here knows what is right: no expected value, tolerance or point comes in.

- `plain`: between values and strict JSON
- `answers`: what an answer gives for the arguments of a case
- `runner`: the cells, then a process per question
- `stub`: the `dhlab` that the cells import
"""
