"""A JupyterLab and a browser for the benchmarks that need a page; the browser tests have theirs."""

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from playwright.sync_api import Browser, CDPSession, Page, sync_playwright

from tests.browser.conftest import ARGUMENTS, BROWSERS
from tests.browser.lab import Lab, Notebook
from tests.browser.servers import serving_notebooks

HERE = Path(__file__).parent


@contextmanager
def open_lab() -> Iterator["Desk"]:
    """Start a server and a browser; they end with the context."""
    with (
        TemporaryDirectory(ignore_cleanup_errors=True) as folder,
        open_browser() as browser,
        serving_notebooks(Path(folder), Path(folder) / "notebooks", paths=[HERE]) as lab,
    ):
        yield Desk(lab, browser)
        lab.stop_kernels()


@contextmanager
def open_browser() -> Iterator[Browser]:
    """Start a browser; it ends with the context."""
    path = os.environ.get("DHLAB_BROWSER") or next(filter(None, map(shutil.which, BROWSERS)))
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=path, args=[*ARGUMENTS])
        yield browser
        browser.close()


class Desk:
    """A server and a browser.

    Parameters
    ----------
    lab : Lab
    browser : Browser
    """

    def __init__(self, lab: Lab, browser: Browser) -> None:
        self._lab = lab
        self.browser = browser

    def open(self, *cells: str, page: Page | None = None) -> Notebook:
        """Open a new notebook with these cells, with a kernel of its own, in a new page or this."""
        page = page or self.browser.new_page(viewport={"width": 1280, "height": 1200})
        return Notebook(self._lab, page, self._lab.write(*cells))


def heap_megabytes(page: Page, session: CDPSession) -> float:
    """What the page's JavaScript holds after garbage has been collected."""
    session.send("HeapProfiler.collectGarbage")
    page.wait_for_timeout(200)
    session.send("HeapProfiler.collectGarbage")
    return float(session.send("Runtime.getHeapUsage")["usedSize"]) / 1e6
