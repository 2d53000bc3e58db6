"""A real JupyterLab and a real browser for the tests in this folder: one of each per session."""

import os
import shutil
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from playwright.sync_api import Browser, Error, Page, sync_playwright

from .lab import Lab, Notebook
from .servers import serving_notebooks

BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
ARGUMENTS = (
    "--no-sandbox",
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--disable-background-networking",
    "--no-first-run",
)


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    """The browser of this session."""
    path = os.environ.get("DHLAB_BROWSER") or next(filter(None, map(shutil.which, BROWSERS)), None)
    if path is None:
        pytest.fail("no Chromium found; install one or name it with DHLAB_BROWSER=...")
    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=path, args=[*ARGUMENTS])
        yield chromium
        chromium.close()


@pytest.fixture(scope="session")
def lab(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Lab]:
    """The JupyterLab server of this session; its folders are its own."""
    home, root = tmp_path_factory.mktemp("home"), tmp_path_factory.mktemp("notebooks")
    with serving_notebooks(home, root) as lab:
        yield lab


@pytest.fixture(scope="module")
def open_notebook(lab: Lab, browser: Browser) -> Iterator[Callable[..., Notebook]]:
    """Open a notebook in a page of its own; all are closed after the module.

    It is a new one with the given cells, or the one called `name` once more.
    """
    pages: list[Page] = []

    def open_(*cells: str, name: str | None = None, **options: Any) -> Notebook:
        viewport = {"width": options.pop("width", 1200), "height": options.pop("height", 900)}
        page = browser.new_page(viewport=viewport, **options)
        pages.append(page)
        return Notebook(lab, page, name or lab.write(*cells))

    yield open_
    for page in pages:
        try:
            page.close()
        except Error:
            continue
    lab.stop_kernels()
