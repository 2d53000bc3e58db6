"""A lesson's description with its texts as HTML: what the bar in a page reads."""

from typing import Any

from dhlab.lessons.lesson import Lesson
from dhlab.view.prose import formula, phrase, prose

OPENING = (
    "Go on with the arrow to the right, or the key →. Where something is asked, answer before you "
    "see it: that is how it stays with you."
)


def rendered(lesson: Lesson) -> dict[str, Any]:
    """Return `lesson.describe()` with every text and formula as safe HTML.

    Parameters
    ----------
    lesson : Lesson

    Returns
    -------
    description : dict
        Plain data. What ends in ``html`` may be read as HTML, all else is text.
    """
    told = lesson.describe()
    answers = {str(k): record for k, record in lesson.answers.items()}
    steps = [_step(step) for step in told["steps"]]
    return told | {"steps": steps, "opening_html": prose(OPENING), "answers": answers}


def _step(step: dict[str, Any]) -> dict[str, Any]:
    read = {key: step[key] for key in ("title", "moves")} | {"text_html": prose(step["text"])}
    read["question"] = step["question"] and _question(step["question"])
    read["product"] = step["product"] and _product(step["product"])
    table = step.get("table")
    read["table"] = table and table | {"columns_html": [formula(name) for name in table["columns"]]}
    return read


def _question(question: dict[str, Any]) -> dict[str, Any]:
    told = {key: value for key, value in question.items() if key not in ("text", "because")}
    told |= {"text_html": prose(question["text"]), "because_html": prose(question["because"])}
    if "choices" in told:
        told["choices_html"] = [phrase(choice) for choice in told["choices"]]
    return told


def _product(product: dict[str, Any]) -> dict[str, Any]:
    """Return a product to show; what is a whole pose in one factor shows its numbers alone."""
    factors = product["factors"]
    whole = len(factors) == 1 and factors[0]["latex"] == product["label"]
    return {
        "label_html": formula(product["label"]),
        "of": product["of"],
        "relative": product["relative"],
        "added": product["added"],
        "factors": [{"html": formula(factor["latex"])} for factor in factors if not whole],
    }
