"""What the buttons of a view save."""

import base64
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from .test_view import ORANGE, SETUP, middle, near


@pytest.fixture(scope="module")
def notebook(open_notebook):
    notebook = open_notebook(SETUP, "named = View('Öl&b: c', height=300).add(box)\nnamed")
    notebook.run_cell(0)
    notebook.run_cell(1)
    return notebook


def saved(shown, action):
    """Name and path of the file that a button saves."""
    with shown.notebook.page.expect_download(timeout=20_000) as downloading:
        shown.click(action)
    download = downloading.value
    return download.suggested_filename, Path(download.path())


def test_a_button_saves_the_present_picture(notebook):
    shown = notebook.view("Öl&b: c")
    notebook.execute("box.move((0.1, 0, 0)); named.flush()")
    shown.wait_until("view.pose('box')[3] > 0.09")
    shown.settle()
    name, path = saved(shown, "save")
    assert name == "Öl_b_ c.png"
    picture = np.asarray(Image.open(path).convert("RGB"))
    seen = shown.pixels()
    assert picture.shape == seen.shape
    assert np.abs(picture.astype(int) - seen).mean() < 0.5
    assert near(picture, ORANGE).mean() > 0.02


def test_a_key_saves_the_picture_too(notebook):
    shown = notebook.view("Öl&b: c")
    shown.evaluate("stage.element.focus()")
    with notebook.page.expect_download(timeout=20_000):
        notebook.page.keyboard.press("8")


def test_the_buttons_fit_into_a_narrow_view(notebook):
    shown = notebook.view("Öl&b: c")
    box = """(() => {
        stage.element.style.width = "220px";
        const bar = stage.element.querySelector(".dhlab-toolbar").getBoundingClientRect();
        const { left, right } = stage.element.getBoundingClientRect();
        stage.element.style.width = "";
        return [bar.left - left, right - bar.right];
    })()"""
    assert min(shown.evaluate(box)) >= 0


PLAYED_BACK = """async (base64) => {
  const video = document.createElement("video");
  video.src = `data:video/webm;base64,${base64}`;
  video.muted = true;
  await new Promise((loaded) => { video.onloadeddata = loaded; video.load(); });
  const { duration, videoWidth: width, videoHeight: height } = video;
  const canvas = Object.assign(document.createElement("canvas"), { width, height });
  const context = canvas.getContext("2d", { willReadFrequently: true });
  const pictures = [];
  for (const time of [0, duration]) {
    const drawn = new Promise((there) => video.requestVideoFrameCallback(there));
    await new Promise((there) => { video.onseeked = there; video.currentTime = time; });
    await Promise.race([drawn, new Promise((late) => setTimeout(late, 2000))]);  // none if the same
    context.drawImage(video, 0, 0);
    pictures.push(canvas.toDataURL("image/png"));
  }
  return { duration, pictures };
}"""


def decoded(url):
    png = base64.b64decode(url.removeprefix("data:image/png;base64,"))
    return np.asarray(Image.open(BytesIO(png)).convert("RGB"))


def played_back(browser, film):
    """Duration of a film, and its first and last picture."""
    cinema = browser.new_page()
    back = cinema.evaluate(PLAYED_BACK, base64.b64encode(film).decode())
    cinema.close()
    return back["duration"], *map(decoded, back["pictures"])


def test_a_button_films_the_planned_motion_from_its_first_to_its_last_instant(notebook, browser):
    shown = notebook.view("Öl&b: c")
    notebook.execute(
        "box.color = '#d55e00'\n"
        "animate(np.linspace(0, 1.2, 25), {box: lambda t: transl((0.6 * t - 0.36, 0, 0))})"
    )
    shown.wait_until("view.scene.players.length === 1 && !view.scene.players[0].playing")
    shown.evaluate("view.scene.players[0].setLoop(true)")
    name, path = saved(shown, "film")
    assert name == "Öl_b_ c.webm"
    film = path.read_bytes()
    assert film[:4] == bytes.fromhex("1a45dfa3")
    duration, first, last = played_back(browser, film)
    assert 1.2 < duration < 8  # a busy machine takes longer over it
    assert first[5, 5].min() > 200
    assert first.shape[1] % 2 == 0
    ways = [middle(near(picture, ORANGE, tolerance=90))[0] for picture in (first, last)]
    assert ways[1] - ways[0] > 0.1 * first.shape[1]
    shown.wait_until("stage.playerBar.filmButton.getAttribute('aria-pressed') === 'false'")
    assert shown.evaluate("view.scene.players[0].loop")
    shown.evaluate("view.scene.players[0].setLoop(false)")


def test_python_saves_a_film_that_the_page_makes(open_notebook, browser, tmp_path):
    path = tmp_path / "box.webm"
    cell = f"""
animate(np.linspace(0, 1.2, 25), {{box: lambda t: transl((0.6 * t - 0.36, 0, 0))}})
film = filmed.save_film({str(path)!r})
film"""
    notebook = open_notebook(
        f"{SETUP}\nbox.color = '#d55e00'",
        "filmed = View('filmed', height=300).add(box)\nfilmed",
        cell,
    )
    notebook.evaluate("() => jupyterapp.commands.execute('notebook:run-all-cells')")
    said = notebook.page.get_by_text("film ", exact=False).filter(has_text="box.webm: saved").last
    said.wait_for(timeout=120_000)
    assert notebook.value("film.arrived").item() is True
    duration, first, last = played_back(browser, path.read_bytes())
    assert duration > 1
    ways = [middle(near(picture, ORANGE, tolerance=90))[0] for picture in (first, last)]
    assert ways[1] - ways[0] > 0.1 * first.shape[1]


def test_a_film_whose_output_goes_is_made_by_the_next_one(notebook, browser, tmp_path):
    path = tmp_path / "again.webm"
    notebook.run("named")
    shown = notebook.view("Öl&b: c")
    shown.wait_until("view.stages.length === 2")
    notebook.execute(
        "animate(np.linspace(0, 2, 25), {box: lambda t: transl((0.4 * t - 0.4, 0, 0))})\n"
        f"film = named.save_film({str(path)!r})"
    )
    shown.wait_until("stage.studio.filming && stage.player.time > 0.2", seconds=30)
    notebook.evaluate("() => jupyterapp.commands.execute('notebook:delete-cell')")
    shown.wait_until("view.stages.length === 1")
    notebook.wait_until("film.arrived or film.trouble", seconds=120)
    assert notebook.value("film.arrived").item() is True
    _, first, last = played_back(browser, path.read_bytes())
    ways = [middle(near(picture, ORANGE, tolerance=90))[0] for picture in (first, last)]
    assert ways[1] - ways[0] > 0.1 * first.shape[1]


def test_a_page_that_cannot_film_says_why(notebook):
    able = "MediaRecorder.isTypeSupported"
    notebook.evaluate(f"() => {{ globalThis.able = {able}; {able} = () => false; }}")
    notebook.execute(
        "animate([0, 1], {box: lambda t: transl((0, 0, t))})\nfilm = named.save_film('none.webm')"
    )
    notebook.wait_until("film.trouble")
    assert notebook.execute("print(film)") == "no film none.webm: this browser makes no films\n"
    notebook.evaluate(f"() => {{ {able} = globalThis.able; }}")


def test_a_film_that_is_ended_before_its_first_picture_is_told_so(notebook):
    shown = notebook.view("Öl&b: c")
    shown.evaluate(
        "(stage.graphics.use = (act) => new Promise(go => (globalThis.go = () => go(act()))), 0)"
    )
    notebook.execute(
        "animate([0, 1], {box: lambda t: transl((0, 0, t))})\nfilm = named.save_film('none.webm')"
    )
    shown.wait_until("stage.studio.filming && globalThis.go")
    shown.click("film")
    shown.evaluate("(delete stage.graphics.use, globalThis.go())")
    notebook.wait_until("film.trouble")
    assert notebook.execute("print(film.trouble)") == "it was ended before it began\n"
    shown.wait_until("!stage.studio.filming")
