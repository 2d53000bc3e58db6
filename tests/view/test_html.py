"""A page without a kernel, as far as it can be read without a browser."""

import json
import re
from base64 import b64decode, b64encode
from hashlib import sha256
from html.parser import HTMLParser
from zlib import decompress

import numpy as np
import pytest

from dhlab.errors import InputError
from dhlab.kinematics.dh import dh
from dhlab.models import puma, upper_limb
from dhlab.scene.blocks import cube
from dhlab.scene.robots import robot
from dhlab.view import View, assets
from dhlab.view.html import components
from dhlab.view.wire import Wire

HOSTILE = "</script><!--<img src=x onerror=alert(1)>&amp;\"'`\u2028${1}$title"


class Elements(HTMLParser):
    """Tags of a page in order, and the text in each element by its id or else its tag."""

    def __init__(self, text):
        super().__init__()
        self.tags = []
        self.texts = {}
        self.inside = ""
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.tags.append((tag, dict(attributes)))
        self.inside = dict(attributes).get("id", tag)

    def handle_endtag(self, tag):
        self.inside = ""

    def handle_data(self, data):
        self.texts[self.inside] = self.texts.get(self.inside, "") + data


@pytest.fixture
def arm():
    """Two joints with limits and an offset, and one that slides without limits."""
    table = [dh(0, 0, 0.2, 0.5), dh(0, 0.4, 0, 0.1), dh(0, 0.1, 0.05, 0)]
    limits = [(-1, 1), (-2, 0.5), (-np.inf, np.inf)]
    return robot(table, "rrp", name="arm", limits=limits, offset=[0.25, 0, 0])


@pytest.fixture
def saved(tmp_path):
    """Save a view of handles; read the page."""

    def save(*handles, title=None, **options):
        return read(View("shown", **options).add(*handles).save_html(tmp_path / "page.html", title))

    return save


def read(path):
    """Elements of a page that lies in a file."""
    return Elements(path.read_text("utf-8"))


def about(page):
    return json.loads(page.texts["about"])


def unpacked(page, name):
    return decompress(b64decode(page.texts[name]))


def test_the_limb_in_its_own_look_fits_into_one_small_file(tmp_path):
    limb = upper_limb()
    limb.look = "user"
    path = View("limb").add(limb).save_html(tmp_path / "limb.html")
    assert path == tmp_path / "limb.html"
    assert path.stat().st_size < 600_000


def test_the_page_refers_to_nothing_outside_itself(saved, tmp_path):
    page = saved(puma())
    text = (tmp_path / "page.html").read_text("utf-8")
    assert not re.search(r"https?://|\bsrc\s*=|@import|url\(|\bimport\b", text)
    assert {tag for tag, _ in page.tags} <= {
        *("html", "head", "meta", "title", "style", "body"),
        *("main", "p", "aside", "h1", "div", "noscript", "script"),
    }
    assert not [name for _, attributes in page.tags for name in attributes if name == "href"]


def test_the_page_carries_the_scene_and_the_viewer_once(saved, arm):
    page = saved(arm)
    assert unpacked(page, "scene") == Wire(View().add(arm).nodes).snapshot()
    assert unpacked(page, "meshcat").decode() == assets.meshcat()
    viewer = unpacked(page, "viewer").decode()
    assert "class Connection" in viewer
    assert not re.search(r"^(import|export) ", viewer, re.MULTILINE)


def test_the_page_runs_only_scripts_that_it_names_and_loads_nothing(saved, arm):
    page = saved(arm)
    policy = next(a["content"] for tag, a in page.tags if tag == "meta" and "http-equiv" in a)
    scripts = [page.texts["script"].encode(), unpacked(page, "meshcat"), unpacked(page, "viewer")]
    hashes = [f"'sha256-{b64encode(sha256(script).digest()).decode()}'" for script in scripts]
    assert policy.startswith("default-src 'none'; script-src 'unsafe-eval' ")
    assert re.findall(r"'sha256-[^']*'", policy) == hashes
    assert "unsafe-inline" not in policy.split("style-src")[0]


def test_hostile_names_and_titles_stay_text(saved):
    name = HOSTILE.replace("/", "\\")
    page = saved(robot([dh(0, 0, 0.1, 0)], "r", name=name), title=HOSTILE)
    harmless = saved(robot([dh(0, 0, 0.1, 0)], "r", name="arm"), title="arm")
    assert [tag for tag, _ in page.tags] == [tag for tag, _ in harmless.tags]
    assert page.texts["title"] == page.texts["h1"] == HOSTILE
    assert about(page)["name"] == HOSTILE
    assert about(page)["robots"][0]["name"] == name
    assert not re.search("[<>&\u2028]", page.texts["about"])


def test_the_title_is_the_views_name_unless_another_is_given(saved, arm):
    assert saved(arm).texts["h1"] == "shown"
    assert saved(arm, title="An arm").texts["title"] == "An arm"


def test_each_joint_says_how_it_reads(saved, arm):
    arm.q = [1, -0.5, 0.1]
    (group,) = about(saved(arm))["robots"]
    first, second, third = group["joints"]
    assert (group["name"], group["color"]) == ("arm", "#0072b2")
    assert [joint["key"] for joint in group["joints"]] == list(arm.own.keys)
    assert [joint["label"] for joint in group["joints"]] == ["θ₁", "θ₂", "d₃"]
    assert [joint["kind"] for joint in group["joints"]] == ["r", "r", "p"]
    assert [joint["value"] for joint in group["joints"]] == [1, -0.5, 0.1]
    assert [joint["home"] for joint in group["joints"]] == arm.home.tolist()
    assert [joint["offset"] for joint in group["joints"]] == [0.25, 0, 0]
    assert (first["lower"], first["upper"], first["span"]) == (-1, 1, [-1, 1])
    assert (first["ends"], first["unit"], first["decimals"]) == (["−57.296", "57.296"], "°", 1)
    assert first["factor"] == pytest.approx(180 / np.pi)
    assert second["note"] is None
    assert (third["lower"], third["upper"], third["ends"]) == (None, None, ["−∞", "∞"])
    assert (third["unit"], third["factor"], third["span"]) == ("mm", 1000, [-0.5, 0.5])
    assert third["note"] == "d₃ has no limits: its slider goes from −500 to 500 mm"


def test_every_robot_has_sliders_once_however_it_is_shown(arm):
    limb = upper_limb()
    part = limb.attached[0]
    shown = components([limb, cube(0.1), arm, part, limb])
    assert [component.name for component in shown] == [
        *("arm", "thumb", "index", "middle", "ring", "little"),
        "arm",
    ]


def test_without_robots_there_is_no_panel(saved, arm):
    def aside(page):
        return next(attributes for tag, attributes in page.tags if tag == "aside")

    assert "hidden" in aside(saved(cube(0.1)))
    assert "hidden" not in aside(saved(arm))


def test_options_of_the_view_are_those_of_the_page(saved, arm):
    options = about(saved(arm, background="dark", grid=False))["options"]
    assert options == {"height": 480, "background": "dark", "grid": False, "controls": False}


def test_a_page_that_is_there_is_written_over(saved, arm, tmp_path):
    (tmp_path / "page.html").write_text("something else " * 100_000)
    assert saved(arm).texts["h1"] == "shown"


def test_saving_shows_nothing_and_changes_nothing(saved, arm, comms):
    saved(arm)
    assert comms == []


@pytest.mark.parametrize(
    ("path", "words"),
    [
        ("none/page.html", "there is no folder '.*none' for 'page.html'"),
        (".", "is a folder; a page needs the path of a file in it"),
    ],
)
def test_where_no_page_can_be_is_said(arm, tmp_path, path, words):
    with pytest.raises(InputError, match=words):
        View().add(arm).save_html(tmp_path / path)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("path", [None, 7, ""])
def test_what_is_no_path_is_refused(arm, path):
    with pytest.raises(InputError, match=r"a page needs a path such as 'limb\.html', got "):
        View().add(arm).save_html(path)


@pytest.mark.parametrize("title", ["", "  ", 7])
def test_what_is_no_title_is_refused(arm, tmp_path, title):
    with pytest.raises(InputError, match="the title of a page must be text, not empty, got "):
        View().add(arm).save_html(tmp_path / "page.html", title)
    assert list(tmp_path.iterdir()) == []


def test_a_view_of_nothing_is_not_saved(tmp_path):
    with pytest.raises(InputError, match="nothing to save: the view shows no handle"):
        View().save_html(tmp_path / "page.html")
    assert list(tmp_path.iterdir()) == []
