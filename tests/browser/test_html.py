"""A page without a kernel in a real browser, from disk, with the network refused."""

from contextlib import contextmanager

import numpy as np
import pytest

from dhlab import View, animate, dh, robot
from dhlab.models import upper_limb

from .lab import PAGE, Shown

HOSTILE = '</script><img src=x onerror="globalThis.hit = 1">'
NAME = '<img src=x onerror="globalThis.hit = 1">'
OFFSET = [0.25, 0, 0.05]
LIMITS = np.array([(-1, 1), (-2, 0.5), (-0.1, 0.3)])


class Opened(Shown):
    """A saved page that is open; it asks the browser for nothing but its file."""

    def __init__(self, page):
        self.page = page
        self.said = []
        self.asked = []
        page.on("console", lambda said: self.said.append(f"{said.type}: {said.text}"))
        page.on("pageerror", lambda error: self.said.append(f"error: {error}"))
        page.on("request", lambda request: self.asked.append(request.url))
        page.route("**/*", only_files)
        super().__init__(self, HOSTILE, -1)

    def evaluate(self, script):
        return self.page.evaluate(
            f"() => {{ const view = {self.connection}; const stage = {self.stage}; "
            f"return ({script}); }}"
        )

    def slider(self, name):
        return self.page.get_by_role("slider", name=name, exact=True)

    def typed(self, name):
        return self.page.get_by_role("spinbutton", name=f"{name}, ")

    def drag(self, name, way):
        """Drag a slider to a part of its way with the mouse."""
        self.slider(name).scroll_into_view_if_needed()
        box = self.slider(name).bounding_box()
        middle = box["y"] + box["height"] / 2
        now = float(self.slider(name).evaluate("s => (s.value - s.min) / (s.max - s.min)"))
        thumb = 15
        at = [box["x"] + thumb / 2 + x * (box["width"] - thumb) for x in (now, way)]
        self.page.mouse.move(at[0], middle)
        self.page.mouse.down()
        self.page.mouse.move(sum(at) / 2, middle)
        self.page.mouse.move(at[1], middle)
        self.page.mouse.up()


def only_files(route):
    """Let the page read its own file and nothing else."""
    if route.request.url.startswith("file:"):
        route.continue_()
    else:
        route.abort()


@pytest.fixture(scope="module")
def arm():
    table = [dh(0, 0, 0.3, 0.2), dh(np.pi / 2, 0.1, 0, 0.3), dh(0.2, 0.3, 0.1, 0)]
    arm = robot(table, "rrp", name="arm", limits=LIMITS, offset=OFFSET)
    finger = robot(
        [dh(0, 0.15, 0, 0), dh(0.3, 0.1, 0, 0)],
        "rr",
        name=NAME.replace("/", ""),
        convention="standard",
        grasper=(0.1, 0, 0),
        limits=[(-2, 2), (-np.inf, np.inf)],
    )
    arm.connect(finger)
    animate([0, 0.5, 1], {arm: lambda t: arm.clip(np.array([t, -t, 0.2 * t, t, t]))})
    return arm


@pytest.fixture(scope="module")
def file(arm, tmp_path_factory):
    """The page of the arm, whose motion ends where it stands."""
    view = View("arm", grid=False).add(arm)
    return view.save_html(tmp_path_factory.mktemp("saved") / "page.html", HOSTILE)


@pytest.fixture
def opened(browser, file):
    with open_(browser, file, viewport={"width": 1280, "height": 800}) as opened:
        yield opened


@pytest.fixture
def on_a_phone(browser, file):
    phone = {"is_mobile": True, "has_touch": True, "device_scale_factor": 2}
    with open_(browser, file, viewport={"width": 390, "height": 844}, **phone) as opened:
        yield opened


@contextmanager
def open_(browser, file, **options):
    """Open a saved page; it must have asked for nothing and complained of nothing."""
    page = browser.new_page(**options)
    opened = Opened(page)
    page.goto(file.as_uri())
    opened.wait_until("stage.settled", seconds=30)
    yield opened
    asked, said = opened.asked, opened.said
    page.close()
    assert asked == [file.as_uri()]
    assert said == []


def config(opened, arm):
    """Configuration that the page shows, without the offsets."""
    keys = [key for component in arm.components for key in component.keys]
    offset = np.concatenate([component.chain.offset for component in arm.components])
    shown = opened.evaluate(f"{keys!r}.map(key => {PAGE}.joints.get(key))")
    return np.array(shown) - offset


def distance(opened, arm, q):
    """How far the page's frames are from Python's at `q`, at most."""
    paths = ["arm/1", "arm/1/2", "arm/1/2/3"]
    tip = f"arm/1/2/3/{arm.attached[0].name}"
    paths += [f"{tip}/1", f"{tip}/1/2", f"{tip}/1/2/grasper"]
    python = np.array(list(arm.frames(q).values()))
    return np.abs(np.array([opened.pose(path) for path in paths]) - python).max()


def test_a_page_from_disk_draws_its_scene(opened, arm):
    pixels = opened.pixels()
    assert len(np.unique(pixels.reshape(-1, 3), axis=0)) > 200
    assert distance(opened, arm, arm.q) < 1e-6
    assert np.allclose(config(opened, arm), arm.q, atol=1e-12)


def test_a_dragged_slider_moves_the_robot_as_python_would(opened, arm):
    before = opened.pixels()
    opened.drag("θ₁ of arm", 0.1)
    opened.drag("d₃ of arm", 0.4)
    opened.drag(f"θ₂ of {arm.attached[0].name}", 0.2)
    q = config(opened, arm)
    assert np.abs(q - arm.q)[[0, 2, 4]].min() > 0.02
    assert np.array_equal(q[[1, 3]], arm.q[[1, 3]])
    assert distance(opened, arm, q) < 1e-6
    assert float(opened.typed("θ₁ of arm").input_value()) == pytest.approx(
        np.degrees(q[0]), abs=0.06
    )
    assert np.abs(opened.pixels().astype(int) - before).mean() > 0.2
    opened.settle()
    assert np.array_equal(config(opened, arm), q)


def test_limits_hold_for_dragged_and_typed_values(opened, arm):
    opened.drag("θ₁ of arm", -0.5)
    opened.drag("θ₂ of arm", 1.5)
    opened.typed("d₃ of arm").fill("1000")
    opened.typed("d₃ of arm").press("Enter")
    q = config(opened, arm)
    assert np.abs(q[:3] - [-1, 0.5, 0.3]).max() < 1e-12
    assert opened.typed("d₃ of arm").input_value() == "300.0"
    assert distance(opened, arm, q) < 1e-6
    arm.mechanism.check(q)


def test_a_typed_value_is_taken_as_it_is(opened, arm):
    opened.typed("θ₁ of arm").fill("-12.345")
    opened.typed("θ₁ of arm").press("Enter")
    assert config(opened, arm)[0] == pytest.approx(np.radians(-12.345), abs=1e-12)
    opened.typed("θ₁ of arm").fill("")
    opened.typed("θ₁ of arm").press("Enter")
    assert config(opened, arm)[0] == pytest.approx(np.radians(-12.345), abs=1e-12)
    assert opened.typed("θ₁ of arm").input_value() == "-12.3"


def test_a_joint_without_limits_says_so_and_takes_any_value(opened, arm):
    note = opened.page.get_by_text("θ₂ has no limits: its slider goes from −180 to 180 °")
    assert note.is_visible()
    name = f"θ₂ of {arm.attached[0].name}"
    opened.typed(name).fill("720")
    opened.typed(name).press("Enter")
    assert config(opened, arm)[4] == pytest.approx(4 * np.pi)
    assert float(opened.slider(name).input_value()) == pytest.approx(720)


def test_home_brings_all_joints_to_the_tables(opened, arm):
    opened.drag("θ₁ of arm", 0.1)
    opened.page.get_by_role("button", name="Home").click()
    assert np.allclose(config(opened, arm), arm.home, atol=1e-12)
    assert distance(opened, arm, arm.home) < 1e-6


def test_the_motion_plays_takes_the_sliders_along_and_ends_in_the_last_state(opened, arm):
    player = f"[...{PAGE}.players.values()][0]"
    assert opened.evaluate(f"[{player}.playing, {player}.time]") == [False, 1]
    opened.evaluate(f"{player}.seek(0)")
    assert np.allclose(config(opened, arm), arm.clip(np.zeros(5)), atol=1e-12)
    assert float(opened.slider("θ₁ of arm").input_value()) == pytest.approx(0, abs=1e-9)
    opened.page.get_by_role("button", name="Play").click()
    opened.wait_until(f"{player}.time > 0.1 && {player}.time < 0.95")
    opened.wait_until(f"{player}.time === 1 && !{player}.playing", seconds=20)
    assert np.allclose(config(opened, arm), arm.q, atol=1e-12)
    assert distance(opened, arm, arm.q) < 1e-6
    shown = float(opened.slider("θ₁ of arm").input_value())
    assert shown == pytest.approx(np.degrees(arm.q[0]))


def test_speed_repeat_and_scrubbing_work(opened, arm):
    player = f"[...{PAGE}.players.values()][0]"
    opened.page.get_by_label("Time").fill("250")
    assert opened.evaluate(f"{player}.time") == pytest.approx(0.25)
    assert config(opened, arm)[0] == pytest.approx(0.25)
    opened.page.get_by_label("Speed").select_option("0.25")
    opened.page.get_by_role("button", name="Repeat").click()
    assert opened.evaluate(f"[{player}.speed, {player}.loop]") == [0.25, True]


def test_camera_buttons_and_background_work(opened):
    before = opened.pixels()
    opened.click("top")
    opened.settle()
    assert np.abs(opened.pixels().astype(int) - before).mean() > 0.5
    opened.click("background")
    assert opened.pixels()[0].mean() < 100
    paper = opened.evaluate("getComputedStyle(document.body).backgroundColor")
    assert paper == "rgb(27, 32, 39)"


def test_hostile_names_are_text(opened, arm):
    page = opened.page
    assert page.locator("h1").inner_text() == page.title() == HOSTILE
    assert page.locator("summary").all_inner_texts() == ["arm", arm.attached[0].name]
    assert page.locator("img").count() == 0
    assert opened.evaluate("globalThis.hit ?? 0") == 0


def test_an_injected_script_would_not_run(opened):
    opened.evaluate(
        "(() => { const s = document.createElement('script'); "
        "s.textContent = 'globalThis.hit = 1'; document.body.append(s); })()"
    )
    assert opened.evaluate("globalThis.hit ?? 0") == 0
    assert "Content Security Policy" in opened.said.pop()


def test_the_page_agrees_with_python_wherever_the_joints_are(browser, tmp_path):
    limb = upper_limb()
    view = View("limb").add(limb)
    path_of = {node.joint.key: path for path, node in view.nodes.items() if node.joint}
    keys = [key for component in limb.components for key in component.keys]
    rng = np.random.default_rng(1)
    with open_(browser, view.save_html(tmp_path / "limb.html", HOSTILE)) as opened:
        for q in rng.uniform(*limb.limits.T, (10, limb.n)):
            moved = dict(zip(keys, q.tolist(), strict=True))
            opened.evaluate(f"{PAGE}.publish({moved}, 'test')")
            page = np.array([opened.pose(path_of[key]) for key in keys])
            frames = limb.frames(q)
            python = [frames[name] for name in frames if not name.endswith("/grasper")]
            assert np.abs(page - python).max() < 1e-6


def test_groups_fold(opened):
    row = opened.slider("θ₁ of arm")
    assert row.is_visible()
    opened.page.locator("summary").first.click()
    assert not row.is_visible()


def test_a_phone_shows_picture_and_sliders_without_scrolling_sideways(on_a_phone, arm):
    page = on_a_phone.page
    wide = "[document.documentElement.scrollWidth, document.querySelector('aside').scrollWidth]"
    assert on_a_phone.evaluate(wide) == [390, 390]
    picture = page.locator("canvas").bounding_box()
    slider = on_a_phone.slider("θ₁ of arm").bounding_box()
    assert picture["width"] == 390
    assert picture["height"] > 300
    assert picture["y"] + picture["height"] <= slider["y"] < 844 - slider["height"]
    assert slider["height"] >= 32
    assert slider["x"] > 0
    assert slider["x"] + slider["width"] < 390
    assert len(np.unique(on_a_phone.pixels().reshape(-1, 3), axis=0)) > 200
    page.touchscreen.tap(slider["x"] + 0.2 * slider["width"], slider["y"] + slider["height"] / 2)
    q = config(on_a_phone, arm)
    assert q[0] < -0.4
    assert distance(on_a_phone, arm, q) < 1e-6
