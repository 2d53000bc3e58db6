"""A lesson in a real page: keys, scrubbing, predictions, the lecture hall, no kernel."""

import json
import re

import numpy as np
import pytest

from dhlab import LessonView, dh_lesson, models
from dhlab.lessons import course

PAGE = 'globalThis[Symbol.for("dhlab.page")]'
PLAYER = f"[...{PAGE}.players.values()].find((player) => player.stops.length)"
SETUP = """
import json
from dhlab import *
from dhlab.lessons import course
"""


@pytest.fixture(scope="module")
def notebook(open_notebook):
    notebook = open_notebook(
        SETUP,
        "lesson = dh_lesson(models.scara())\nlesson",
        "asks = course.order_matters()\nasks",
        "place = course.place_a_frame()\nplace",
        width=1440,
        height=900,
    )
    notebook.run_cell(0)
    return notebook


@pytest.fixture(scope="module")
def walk(notebook):
    """The page with a lesson that asks nothing."""
    notebook.run_cell(1)
    return Bar(notebook, 0)


class Bar:
    """One lesson's bar in a page."""

    def __init__(self, notebook, number):
        self.notebook, self.page = notebook, notebook.page
        self.bar = self.page.locator(".dhlab-bar").nth(number)
        self.bar.wait_for()
        self.bar.locator("h4", has_text=re.compile(r"\S")).wait_for(timeout=60_000)

    def player(self, what, clock):
        return self.page.evaluate(f"(key) => {PAGE}.players.get(key).{what}", clock)

    def press(self, key):
        """Press a key on the bar, once it has the focus: a notebook takes it after a cell ran."""
        for _ in range(50):
            self.bar.focus()
            self.page.wait_for_timeout(30)
            if self.bar.evaluate("(bar) => document.activeElement === bar"):
                break
        self.page.keyboard.press(key)

    def at_rest(self, clock, k):
        self.page.wait_for_function(
            f"([key, k]) => {{ const p = {PAGE}.players.get(key);"
            " return p.at === k && !p.playing && p.time === p.stops[k]; }",
            arg=[clock, k],
            timeout=60_000,
        )

    def text(self, selector):
        return self.bar.locator(selector).inner_text()

    def pose(self, path):
        script = f"""(path) => {PAGE}.views.findLast((v) => v.scene.paths.has(path)).pose(path)"""
        return np.reshape(self.page.evaluate(script, path), (4, 4))


def clock_of(notebook, name):
    return notebook.execute(f"print({name}.clock.key)").strip()


def test_a_whole_lesson_is_walked_with_the_keyboard(notebook, walk):
    clock = clock_of(notebook, "lesson")
    count = int(notebook.value("len(lesson.steps)"))
    walk.bar.locator("select").select_option("4")
    for k in range(1, count + 1):
        walk.press("ArrowRight")
        walk.at_rest(clock, k)
        expected = notebook.value(f"lesson.timeline.states[{k}][lesson.product_of]")
        assert np.allclose(walk.pose("F"), expected, atol=1e-6), f"step {k}"
        assert walk.text("h4") == notebook.execute(f"print(lesson.steps[{k - 1}].title)").strip()
    assert int(notebook.value("lesson.at")) == count
    assert walk.bar.locator('[data-action="next"]').is_disabled()


def test_going_back_undoes_and_the_numbers_are_the_picture_s(notebook, walk):
    clock = clock_of(notebook, "lesson")
    walk.press("Home")
    walk.at_rest(clock, 0)
    for k in (1, 2, 3, 4):
        walk.press("ArrowRight")
        walk.at_rest(clock, k)
    walk.press("ArrowLeft")
    walk.at_rest(clock, 3)
    expected = notebook.value("lesson.timeline.states[3][lesson.product_of]")
    assert np.allclose(walk.pose("F"), expected, atol=1e-6)
    relative = notebook.value("lesson.describe()['steps'][2]['product']['relative']")
    numbers = [
        float(text.replace("\u2212", "-"))
        for text in walk.bar.locator(".dhlab-matrix td").all_inner_texts()
    ]
    assert np.allclose(np.reshape(numbers, (4, 4)), np.linalg.inv(relative) @ expected, atol=6e-4)
    assert walk.bar.locator(".dhlab-table td.present").count() == 1
    assert walk.bar.locator(".dhlab-factors .added").count() == 1


def test_scrubbing_within_a_step_moves_the_picture_and_the_numbers(notebook, walk):
    clock = clock_of(notebook, "lesson")
    walk.press("Home")
    walk.press("End")
    walk.at_rest(clock, int(notebook.value("len(lesson.steps)")))
    before = walk.bar.locator(".dhlab-controls input")
    before.fill("500")
    stops = walk.player("stops", clock)
    time = walk.player("time", clock)
    assert stops[-2] < time < stops[-1]
    expected = notebook.value(f"lesson.timeline.states[{len(stops) - 1}][lesson.product_of]")
    assert np.abs(walk.pose("F") - expected).max() > 1e-4


def test_python_moves_the_bar_and_the_bar_tells_python(notebook, walk):
    clock = clock_of(notebook, "lesson")
    notebook.execute("lesson.go(5)")
    walk.at_rest(clock, 5)
    walk.page.wait_for_function(
        "(title) => document.querySelector('.dhlab-bar h4').textContent === title",
        arg=notebook.execute("print(lesson.steps[4].title)").strip(),
    )
    walk.press("ArrowRight")
    walk.at_rest(clock, 6)
    notebook.execute("import time\nt = time.time()")
    assert int(notebook.value("lesson.at")) == 6


def test_steps_go_on_while_the_kernel_is_busy(notebook, walk):
    clock = clock_of(notebook, "lesson")
    notebook.execute("lesson.go(1)")
    walk.at_rest(clock, 1)
    expected = [notebook.value(f"lesson.timeline.states[{k}][lesson.product_of]") for k in (2, 3)]
    with notebook.busy():
        for k, wanted in zip((2, 3), expected, strict=True):
            walk.press("ArrowRight")
            walk.at_rest(clock, k)
            assert np.allclose(walk.pose("F"), wanted, atol=1e-6)
    notebook.wait_until("lesson.at == 3")


def test_a_choice_is_asked_before_its_step_is_shown(notebook, walk):
    notebook.run_cell(2)
    asks = Bar(notebook, 1)
    clock = clock_of(notebook, "asks")
    asks.press("ArrowRight")
    asks.at_rest(clock, 1)
    asks.press("ArrowRight")
    assert asks.bar.locator(".dhlab-choice").count() == 2
    assert "commute" not in asks.bar.inner_text()
    asks.press("ArrowRight")
    asks.press("End")
    asks.at_rest(clock, 1)
    asks.page.keyboard.press("1")
    asks.at_rest(clock, 2)
    assert asks.text(".dhlab-verdict").startswith("You predicted: yes: the same two turns")
    assert "commute" in asks.text(".dhlab-words")
    notebook.page.wait_for_timeout(200)
    answers = json.loads(notebook.execute("print(json.dumps(asks.answers))"))
    assert [(a["step"], a["right"]) for a in answers.values()] == [(2, False)]
    asks.press("Home")
    asks.at_rest(clock, 0)
    asks.press("End")
    asks.at_rest(clock, 3)


def test_a_frame_is_placed_by_sliders_and_compared(notebook, walk):
    notebook.run_cell(3)
    place = Bar(notebook, 2)
    clock = clock_of(notebook, "place")
    place.press("ArrowRight")
    sliders = place.bar.locator(".dhlab-guess input")
    assert sliders.count() == 6
    sliders.nth(0).fill("1")
    sliders.nth(2).fill("0.5")
    guess = place.pose("B?/x/y/z/yaw/pitch/roll")
    assert np.allclose(guess[:3, 3], (1, 0, 0.5), atol=1e-6)
    place.bar.locator(".dhlab-done").click()
    place.at_rest(clock, 1)
    assert place.text(".dhlab-verdict").startswith("As you predicted: 0.000 m and 0.0° away")
    record = json.loads(notebook.execute("print(json.dumps(place.answers[1]))"))
    assert record["right"]
    place.press("ArrowRight")
    place.bar.locator(".dhlab-done").click()
    place.at_rest(clock, 2)
    assert "90.0° away" in place.text(".dhlab-verdict")
    assert not json.loads(notebook.execute("print(json.dumps(place.answers[2]))"))["right"]


def test_present_fills_the_window_and_escape_leaves(notebook, walk):
    clock = clock_of(notebook, "lesson")
    walk.press("p")
    walk.page.wait_for_function("() => document.querySelector('.dhlab-presenting') !== null")
    width = walk.page.viewport_size["width"]
    box = walk.page.locator(".dhlab-presenting .dhlab-view").bounding_box()
    assert box["width"] > 0.6 * width
    size = walk.page.evaluate(
        "() => { const words = document.querySelector('.dhlab-presenting .dhlab-words');"
        " return parseFloat(getComputedStyle(words).fontSize); }"
    )
    assert size >= 17
    notebook.execute("lesson.go(2)")
    walk.at_rest(clock, 2)
    walk.page.keyboard.press("ArrowRight")
    walk.at_rest(clock, 3)
    walk.page.keyboard.press("p")
    walk.page.wait_for_function("() => document.querySelector('.dhlab-presenting') === null")


@pytest.fixture
def saved(tmp_path, browser):
    """Opens a lesson saved as a page, from disk and without a network."""
    pages = []

    def open_saved(lesson):
        path = LessonView(lesson).save_html(tmp_path / "lesson.html")
        context = browser.new_context(viewport={"width": 1200, "height": 800}, offline=True)
        page = context.new_page()
        page.said = []
        page.on("console", lambda message: page.said.append(message.text))
        page.on("pageerror", lambda error: page.said.append(str(error)))
        page.goto(path.as_uri())
        page.wait_for_function(f"() => {PAGE}?.players.size > 0", timeout=60_000)
        pages.append(context)
        return page, path

    yield open_saved
    for context in pages:
        context.close()


def test_a_saved_lesson_is_walked_without_kernel_and_network(saved):
    lesson = dh_lesson(models.scara())
    page, path = saved(lesson)
    assert path.stat().st_size < 1_300_000
    bar = Bar.__new__(Bar)
    bar.page, bar.bar = page, page.locator(".dhlab-bar")
    bar.bar.locator("select").select_option("4")
    for k in (1, 2, 3, 4):
        bar.press("ArrowRight")
        bar.at_rest(lesson.clock.key, k)
        assert np.allclose(bar.pose("F"), lesson.timeline.states[k][lesson.product_of], atol=1e-6)
    assert page.locator(".dhlab-words math").count() > 0
    assert not page.said


def test_a_saved_lesson_asks_and_answers_by_itself(saved):
    page, _ = saved(course.place_a_frame())
    page.keyboard.press("ArrowRight")
    page.locator(".dhlab-guess input").nth(0).fill("1")
    page.locator(".dhlab-done").click()
    page.wait_for_selector(".dhlab-verdict:not([hidden])")
    assert "0.500 m" in page.locator(".dhlab-verdict").inner_text()
    assert not page.said
