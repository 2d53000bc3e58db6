"""A real JupyterLab and a real browser for the tests in this folder: one of each per session."""

import os
import shutil
import socket
import subprocess
import sys
import urllib.request
from collections.abc import Callable, Iterator
from contextlib import closing
from pathlib import Path
from time import monotonic, sleep
from typing import Any

import pytest
from playwright.sync_api import Browser, Error, Page, sync_playwright

from .lab import Lab, Notebook

ROOT = Path(__file__).parents[2]
BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
ARGUMENTS = (
    "--no-sandbox",
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--disable-background-networking",
    "--no-first-run",
)
CONFIGURATION = """
c.ServerApp.token = ""
c.ServerApp.password = ""
c.ServerApp.open_browser = False
c.ServerApp.allow_root = True
c.ServerApp.disable_check_xsrf = True
c.ServerApp.terminals_enabled = False
c.LabApp.expose_app_in_browser = True
"""
QUIET = {
    "@jupyterlab/apputils-extension/notification": '{"fetchNews": "false"}',
    "@jupyterlab/docmanager-extension/plugin": '{"autosave": false}',
}


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
    home = tmp_path_factory.mktemp("home")
    root = tmp_path_factory.mktemp("notebooks")
    (home / "config").mkdir()
    (home / "config" / "jupyter_lab_config.py").write_text(CONFIGURATION)
    for plugin, setting in QUIET.items():
        file = home / "settings" / f"{plugin}.jupyterlab-settings"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(setting)
    with closing(socket.socket()) as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    environment = {key: value for key, value in os.environ.items() if key != "DHLAB_VIEW"}
    environment |= {
        "HOME": str(home),
        "IPYTHONDIR": str(home / "ipython"),
        "JUPYTER_CONFIG_DIR": str(home / "config"),
        "JUPYTER_DATA_DIR": str(home / "data"),
        "JUPYTER_RUNTIME_DIR": str(home / "runtime"),
        "JUPYTERLAB_SETTINGS_DIR": str(home / "settings"),
        "JUPYTERLAB_WORKSPACES_DIR": str(home / "workspaces"),
        "PYTHONPATH": os.pathsep.join([str(ROOT), *sys.path]),
    }
    command = [sys.executable, "-m", "jupyterlab", f"--port={port}", f"--notebook-dir={root}"]
    with (home / "server.log").open("wb") as log:
        server = subprocess.Popen(command, env=environment, stdout=log, stderr=log, cwd=root)
    try:
        url = f"http://127.0.0.1:{port}"
        wait_for_server(url, server, home / "server.log")
        yield Lab(url, root)
    finally:
        server.terminate()
        server.wait(20)


def wait_for_server(url: str, server: "subprocess.Popen[bytes]", log: Path) -> None:
    """Return when the server answers."""
    end = monotonic() + 60
    while monotonic() < end and server.poll() is None:
        try:
            urllib.request.urlopen(f"{url}/api", timeout=2).close()
        except OSError:
            sleep(0.1)
        else:
            return
    pytest.fail(f"JupyterLab did not start:\n{log.read_text()[-3000:]}")


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
