"""The files of results: all made from the same rows, and each replaced whole."""

from collections.abc import Iterable
from pathlib import Path

from dhlab.grading.classpage import class_page
from dhlab.grading.feedback import feedback
from dhlab.grading.grades import write_grades
from dhlab.grading.gradescope import gradescope
from dhlab.grading.plain import file_name
from dhlab.grading.results import RESULTS, ClassResults, Row, write_results, write_whole

GRADES, PAGE = "grades.csv", "class.html"
PER_STUDENT = {"feedback": (".md", feedback), "gradescope": (".json", gradescope)}


def write_reports(folder: Path, results: ClassResults, earlier: Iterable[Row] = ()) -> None:
    """Write all files of results; those of students who are no longer there are taken away.

    Parameters
    ----------
    folder : Path
    results : ClassResults
    earlier : iterable of Row
        What the folder held before.
    """
    here = {row.student for row in results.rows}
    gone = {row.student for row in earlier} - here
    for name, (ending, report) in PER_STUDENT.items():
        (folder / name).mkdir(exist_ok=True)
        for row in results.rows:
            write_whole(folder / name / (file_name(row.student) + ending), report(results, row))
        for student in gone:
            (folder / name / (file_name(student) + ending)).unlink(missing_ok=True)
    write_whole(folder / PAGE, class_page(results))
    write_grades(folder / GRADES, results)
    write_results(folder / RESULTS, results)
