"""The instructor's page in a real browser, from disk, with the network refused."""

import pytest

from dhlab.grading.classpage import class_page
from tests.grading.made import ADA, BOB, CLASS, EVE, HOSTILE, KURT, LOST, results, row, wrong

MANY = [row(f"Student {k}", wrong("dh_link", 2, "x", ("a",)), wrong("T", 1)) for k in range(60)]


@pytest.fixture
def opened(browser, tmp_path):
    """Open a page that was made of results; nothing but the file may be asked for."""
    pages, asked, said = [], [], []

    def open_(made, width=1280, scheme="light"):
        path = tmp_path / "class.html"
        path.write_text(class_page(made), "utf-8")
        page = browser.new_page(viewport={"width": width, "height": 900}, color_scheme=scheme)
        pages.append(page)
        page.on("request", lambda request: asked.append(request.url))
        page.on("console", lambda message: said.append(message.text))
        page.on("pageerror", lambda error: said.append(str(error)))
        page.goto(path.as_uri())
        return page

    yield open_
    for page in pages:
        page.close()
    assert {url.split(":")[0] for url in asked} == {"file"}
    assert said == []


def test_hostile_names_are_shown_and_do_nothing(opened):
    page = opened(results(HOSTILE, ADA))
    assert page.title() == "07_dh_link: the class"
    assert page.locator("img, script, main svg svg").count() == 0
    assert page.get_by_text(HOSTILE.student).count() >= 2
    page.get_by_text("✗ wrong").first.click()
    assert page.get_by_text("<img src=x onerror").first.is_visible()


def test_what_a_student_was_told_opens_by_a_click_and_by_the_keyboard(opened):
    page = opened(CLASS)
    told = page.get_by_role("row", name="Eve").last.locator("details").nth(1)
    assert not told.get_by_text("the order is reversed").is_visible()
    told.locator("summary").focus()
    page.keyboard.press("Enter")
    assert told.get_by_text("the order is reversed").is_visible()


@pytest.mark.parametrize("width", [360, 800, 1280])
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_the_page_fits_any_width_in_light_and_dark(opened, width, scheme):
    page = opened(results(ADA, BOB, EVE, KURT, LOST, HOSTILE, *MANY), width, scheme)
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    bars = page.locator("svg rect")
    assert bars.count() == 4
    tall = bars.evaluate_all("all => all.map(bar => bar.getBoundingClientRect().height)")
    assert tall[0] > tall[1] > 0
    assert tall[2] == 0


def test_every_text_can_be_read(opened):
    contrast = """() => {
      const light = text => {
        const parts = text.match(/[\\d.]+/g).map(Number);
        const [r, g, b] = parts.map(x => x / 255).map(
          x => (x <= 0.03928 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4));
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
      };
      const behind = element => {
        for (let e = element; e; e = e.parentElement) {
          const color = getComputedStyle(e).backgroundColor;
          if (!color.endsWith(", 0)")) return color;
        }
        return "rgb(255, 255, 255)";
      };
      let least = 100;
      for (const element of document.querySelectorAll("main *:not(svg *)")) {
        if (![...element.childNodes].some(n => n.nodeType === 3 && n.data.trim())) continue;
        const [a, b] = [light(getComputedStyle(element).color), light(behind(element))];
        least = Math.min(least, (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05));
      }
      return least;
    }"""
    for scheme in ("light", "dark"):
        assert opened(results(ADA, BOB, EVE, KURT, LOST), scheme=scheme).evaluate(contrast) >= 4.5
