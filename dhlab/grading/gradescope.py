"""`gradescope/<student>.json`: the same as Gradescope reads it from an autograder.

The format: https://gradescope-autograders.readthedocs.io/en/latest/specs/
"""

import json
from typing import Any

from dhlab.grading.plain import one_line
from dhlab.grading.results import ClassResults, Row

TEXT = "text"
"""Shown as it stands, not as HTML or Markdown."""


def gradescope(results: ClassResults, row: Row) -> str:
    """Return one student's results as Gradescope's `results.json`.

    Parameters
    ----------
    results : ClassResults
    row : Row

    Returns
    -------
    text : str
    """
    document: dict[str, Any] = {
        "score": row.points,
        "output": " ".join(one_line(text) for text in (row.reason, *row.all_notes) if text),
        "output_format": TEXT,
        "test_output_format": TEXT,
        "test_name_format": TEXT,
        "visibility": "visible",
        "stdout_visibility": "hidden",
        "tests": [
            {
                "name": judged.name,
                "score": judged.points,
                "max_score": judged.out_of,
                "status": "passed" if judged.right else "failed",
                "output": one_line(judged.text),
                "visibility": "visible",
            }
            for judged in row.questions
        ],
        "extra_data": {"student": row.student, "status": row.status},
    }
    if not row.questions:
        document["tests"] = [
            {"name": c.name, "score": 0, "max_score": c.out_of, "status": "failed", "output": ""}
            for c in results.columns
        ]
    return json.dumps(document, indent=1, ensure_ascii=False, allow_nan=False) + "\n"
