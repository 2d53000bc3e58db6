"""`class.html`: one page for the instructor, with how the class did and which mistakes it made.

It opens from disk, loads nothing, and runs nothing: HTML, CSS and one drawing.
"""

from collections.abc import Sequence
from importlib.resources import files

from dhlab.grading.figures import (
    NOTHING,
    Answers,
    Bar,
    Misconception,
    answers,
    marked_rows,
    mean_and_median,
    misconceptions,
    spread,
)
from dhlab.grading.grades import number
from dhlab.grading.judge import Judged
from dhlab.grading.markup import Html, tag
from dhlab.grading.results import STATUSES, ClassResults, Row

POLICY = "default-src 'none'; style-src 'unsafe-inline'"
OPEN = 8
"""A list of names up to this long is shown; a longer one opens by a click."""
BY_ID = (
    "{} known by an id have the numbers of the name in their notebook; the notes in grades.csv say "
    "which. A list of students with names and ids proves whose they are."
)
KINDS = (
    ("right", "right"),
    ("wrong", "wrong"),
    ("failed", "error or too slow"),
    ("nothing", "empty"),
)


def class_page(results: ClassResults) -> str:
    """Return the page.

    Parameters
    ----------
    results : ClassResults

    Returns
    -------
    html : str
    """
    title = f"{results.run.exercise}: the class"
    style = files("dhlab.grading").joinpath("classpage.css").read_text("utf-8")
    head = tag(
        "head",
        Html('<meta charset="utf-8">'),
        Html('<meta name="viewport" content="width=device-width, initial-scale=1">'),
        Html(f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">'),
        tag("title", title),
        tag("style", Html(style)),
    )
    main = tag(
        "main",
        _header(results),
        _tiles(results),
        tag("div", _marks(results), _questions(results), class_="pair"),
        _mistakes(misconceptions(results), len(marked_rows(results))),
        _attention(results.rows),
        _everybody(results),
        _footer(results),
    )
    return f"<!DOCTYPE html>\n{tag('html', head, tag('body', main), lang='en')}\n"


def _header(results: ClassResults) -> Html:
    course = f"{results.run.course} · " if results.run.course else ""
    return tag(
        "header",
        tag("p", f"{course}marked {results.finished[:16].replace('T', ' ')} UTC", class_="over"),
        tag("h1", results.run.exercise),
    )


def _section(title: str, *inside: Html | None, note: str = "", wide: bool = False) -> Html:
    said = tag("p", note, class_="note") if note else None
    return tag("section", tag("h2", title), said, *inside, class_="wide" if wide else None)


# ---- the figures at a glance ----


def _tiles(results: ClassResults) -> Html:
    marked, averages = marked_rows(results), mean_and_median(results)
    full = sum(row.points == results.out_of for row in marked)
    tiles = [(str(len(results.rows)), "students"), (str(len(marked)), "marked")]
    if averages is not None:
        tiles += [
            (number(round(averages[0], 2)), f"mean of {number(results.out_of)} points"),
            (number(round(averages[1], 2)), "median"),
            (str(full), "with full marks"),
        ]
    tiles.append((str(len(results.rows) - len(marked)), "without marks"))
    boxes = [tag("div", tag("dd", value), tag("dt", name)) for value, name in tiles]
    return tag("dl", boxes, class_="tiles")


def _marks(results: ClassResults) -> Html:
    bars = spread(results)
    note = "Students by points; without those whose notebook is missing or cannot be read."
    return _section("Spread of marks", _histogram(bars), note=note)


def _histogram(bars: Sequence[Bar]) -> Html:
    width, height, top = 640, 240, 28
    step, most = width / len(bars), max(1, *(bar.count for bar in bars))
    drawn = []
    for k, bar in enumerate(bars):
        tall, middle = (height - top) * bar.count / most, f"{(k + 0.5) * step:.1f}"
        place = {"x": f"{(k + 0.12) * step:.1f}", "y": f"{height - tall:.1f}"}
        size = {"width": f"{0.76 * step:.1f}", "height": f"{tall:.1f}"}
        drawn.append(tag("rect", **place, **size, rx="3"))
        if bar.count:
            drawn.append(tag("text", str(bar.count), x=middle, y=f"{height - tall - 7:.1f}"))
        drawn.append(tag("text", bar.label, x=middle, y=str(height + 20), class_="axis"))
    line = tag("line", x1="0", x2=str(width), y1=str(height), y2=str(height))
    said = "; ".join(f"{bar.label} points: {bar.count}" for bar in bars)
    title = tag("title", "Students by points")
    box = f"0 0 {width} {height + 30}"
    inside = [title, tag("desc", said), line, *drawn]
    return tag("svg", inside, viewBox=box, role="img", aria_label=f"Students by points. {said}")


def _questions(results: ClassResults) -> Html:
    rows = [_question(found) for found in answers(results)]
    key = [tag("li", tag("span", class_=f"dot {kind}"), words) for kind, words in KINDS]
    note = "Share of the students marked, and how many."
    return _section(
        "Question by question", tag("ul", key, class_="key"), tag("div", rows), note=note
    )


def _question(found: Answers) -> Html:
    total = max(1, found.right + found.wrong + found.nothing + found.failed)
    parts = []
    for kind, words in KINDS:
        count = getattr(found, kind)
        if count:
            style = f"flex-grow:{count}"
            parts.append(
                tag("span", str(count), class_=kind, style=style, title=f"{count} {words}")
            )
    said = ", ".join(f"{getattr(found, kind)} {words}" for kind, words in KINDS)
    return tag(
        "div",
        tag("p", tag("code", found.name), tag("b", f"{found.right / total:.0%} right")),
        tag("div", parts, class_="stack", role="img", aria_label=f"{found.name}: {said}"),
        class_="question",
    )


# ---- the mistakes ----


def _mistakes(found: Sequence[Misconception], marked: int) -> Html:
    note = "Mistakes that explain an answer exactly: they give the same values in every case."
    if not found:
        return _section("Misconceptions", tag("p", "None was diagnosed."), note=note, wide=True)
    heads = [tag("th", text, scope="col") for text in ("mistake", "question", "students", "who")]
    rows = [_mistake(one, marked) for one in found]
    table = tag("table", tag("thead", tag("tr", heads)), tag("tbody", rows), class_="mistakes")
    return _section("Misconceptions", table, note=note, wide=True)


def _mistake(one: Misconception, marked: int) -> Html:
    count = len(one.students)
    bar = tag("span", class_="bar", style=f"width:{100 * count / max(1, marked):.1f}%")
    return tag(
        "tr",
        tag("th", one.text, tag("code", ", ".join(one.keys), class_="small"), scope="row"),
        tag("td", tag("code", one.question)),
        tag("td", tag("b", str(count)), tag("span", bar, class_="track"), class_="count"),
        tag("td", _names(one.students)),
    )


def _names(students: Sequence[str]) -> Html:
    listed = tag("ul", [tag("li", tag("bdi", name)) for name in students], class_="names")
    if len(students) <= OPEN:
        return listed
    return tag("details", tag("summary", f"{len(students)} students"), listed)


# ---- the students ----


def _attention(rows: Sequence[Row]) -> Html | None:
    found = [row for row in rows if _is_odd(row)]
    by_id = sum(bool(row.whose) for row in rows if row not in found)
    if not found and not by_id:
        return None
    order: dict[str, int] = {status: k for k, status in enumerate(reversed(STATUSES))}
    found.sort(key=lambda row: order.get(row.status, 0))
    lines = [
        tag(
            "tr",
            tag("th", tag("bdi", row.student), scope="row"),
            tag("td", _status(row)),
            tag("td", " ".join(filter(None, (row.reason, row.failed, *row.all_notes)))),
        )
        for row in found
    ]
    heads = [tag("th", text, scope="col") for text in ("student", "status", "what was seen")]
    table = tag("table", tag("thead", tag("tr", heads)), tag("tbody", lines), class_="look")
    note = BY_ID.format(by_id) if by_id else ""
    return _section("For a second look", table if found else None, note=note, wide=True)


def _is_odd(row: Row) -> bool:
    """Whether a row must be looked at; an id beside the name in the notebook is nothing odd."""
    is_other_name = bool(row.whose) and " " in row.student
    return row.status != "graded" or bool(row.odd or row.notes) or is_other_name


def _status(row: Row) -> Html:
    return tag("span", row.status, class_=f"status {row.status.replace(' ', '-')}")


def _everybody(results: ClassResults) -> Html:
    names = [column.name for column in results.columns]
    heads = [tag("th", "student", scope="col"), tag("th", "points", scope="col")]
    heads += [tag("th", tag("code", name), scope="col") for name in names]
    lines = []
    for row in results.rows:
        judged = {one.name: one for one in row.questions}
        cells = [tag("td", _answer(judged.get(name))) for name in names]
        student = tag("th", tag("bdi", row.student), scope="row")
        lines.append(tag("tr", student, tag("td", _points(row, results.out_of)), cells))
    table = tag("table", tag("thead", tag("tr", heads)), tag("tbody", lines), class_="all")
    note = "What is not right opens by a click and says what the student was told."
    return _section("Everybody", tag("div", table, class_="scroll"), note=note, wide=True)


def _points(row: Row, out_of: float) -> Html:
    if not row.questions:
        return _status(row)
    bar = tag("span", class_="bar", style=f"width:{100 * row.points / (out_of or 1):.1f}%")
    return tag(
        "span", tag("b", number(row.points)), tag("span", bar, class_="track"), class_="count"
    )


def _answer(judged: Judged | None) -> Html:
    if judged is None:
        return tag("span", "–", class_="none", title="not marked")
    if judged.right:
        return tag("span", "✓ right", class_="mark right")
    kind = "nothing" if judged.reason in NOTHING else "failed"
    kind = "wrong" if judged.reason == "wrong" else kind
    said = {"stub": "empty", "raised": "error"}.get(judged.reason, judged.reason)
    head = tag("summary", f"✗ {said}", class_=f"mark {kind}")
    return tag("details", head, tag("p", judged.text))


def _footer(results: ClassResults) -> Html:
    run = results.run
    versions = ", ".join(f"{name} {version}" for name, version in run.versions.items())
    text = f"Seed {run.seed}, sandbox {run.sandbox}, {versions}. Exercise {run.digest[:12]}."
    return tag("footer", tag("p", text))
