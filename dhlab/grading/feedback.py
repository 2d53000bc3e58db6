"""`feedback/<student>.md`: what a student may read of the marking.

Nothing of the submission's outputs, and no number that was expected, is in it; what comes from the
submission, such as the message of an error, is text and nothing else.
"""

from dhlab.grading.grades import number
from dhlab.grading.plain import markdown
from dhlab.grading.results import ClassResults, Row

MARKS = {"stub": "empty", "missing": "missing"}
"""What is said of an answer that is not there."""


def feedback(results: ClassResults, row: Row) -> str:
    """Return what one student is told, as Markdown.

    Parameters
    ----------
    results : ClassResults
    row : Row

    Returns
    -------
    text : str
    """
    points = f"{number(row.points)} of {number(results.out_of)} points"
    title = results.run.title or results.run.exercise
    lines = [f"# {markdown(title)}", "", f"**{markdown(row.student)}**: {points}"]
    if row.reason:
        lines += ["", markdown(row.reason)]
    for judged in row.questions:
        mark = "right" if judged.right else MARKS.get(judged.reason, "not yet right")
        value = f"{number(judged.points)} of {number(judged.out_of)}"
        lines += ["", f"## {markdown(judged.name)}: {mark}, {value}", "", markdown(judged.text)]
    if row.all_notes:
        lines += ["", "## Notes", "", *(f"- {markdown(note)}" for note in row.all_notes)]
    return "\n".join(lines) + "\n"
