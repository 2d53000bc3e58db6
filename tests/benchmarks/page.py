"""A JupyterLab and a browser for the benchmarks that need a page; the browser tests have theirs."""

import os
import shutil
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from playwright.sync_api import CDPSession, Page, sync_playwright

from tests.browser.conftest import (
    ARGUMENTS,
    BROWSERS,
    CONFIGURATION,
    QUIET,
    ROOT,
    wait_for_server,
)
from tests.browser.lab import Lab, Notebook


@contextmanager
def open_lab() -> Iterator["Desk"]:
    """Start a server and a browser; they end with the context."""
    browser = os.environ.get("DHLAB_BROWSER") or next(filter(None, map(shutil.which, BROWSERS)))
    with (
        TemporaryDirectory(ignore_cleanup_errors=True) as folder,
        sync_playwright() as playwright,
        server(Path(folder)) as lab,
    ):
        chromium = playwright.chromium.launch(executable_path=browser, args=[*ARGUMENTS])
        yield Desk(lab, chromium)
        chromium.close()
        lab.stop_kernels()


@contextmanager
def server(home: Path) -> Iterator[Lab]:
    """Start JupyterLab with settings and folders of its own."""
    for name in ("config", "notebooks"):
        (home / name).mkdir()
    (home / "config" / "jupyter_lab_config.py").write_text(CONFIGURATION)
    for plugin, setting in QUIET.items():
        file = home / "settings" / f"{plugin}.jupyterlab-settings"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(setting)
    with closing(socket.socket()) as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    here = str(Path(__file__).parent)
    environment = {key: value for key, value in os.environ.items() if key != "DHLAB_VIEW"} | {
        "HOME": str(home),
        "IPYTHONDIR": str(home / "ipython"),
        "JUPYTER_CONFIG_DIR": str(home / "config"),
        "JUPYTER_DATA_DIR": str(home / "data"),
        "JUPYTER_RUNTIME_DIR": str(home / "runtime"),
        "JUPYTERLAB_SETTINGS_DIR": str(home / "settings"),
        "JUPYTERLAB_WORKSPACES_DIR": str(home / "workspaces"),
        "PYTHONPATH": os.pathsep.join([str(ROOT), here, *sys.path]),
    }
    root = home / "notebooks"
    command = [sys.executable, "-m", "jupyterlab", f"--port={port}", f"--notebook-dir={root}"]
    with (home / "server.log").open("wb") as log:
        process = subprocess.Popen(command, env=environment, stdout=log, stderr=log, cwd=root)
    try:
        url = f"http://127.0.0.1:{port}"
        wait_for_server(url, process, home / "server.log")
        yield Lab(url, root)
    finally:
        process.terminate()
        process.wait(20)


class Desk:
    """A server and a browser.

    Parameters
    ----------
    lab : Lab
    browser : Browser
    """

    def __init__(self, lab: Lab, browser: object) -> None:
        self._lab = lab
        self._browser = browser

    def open(self, *cells: str) -> Notebook:
        """Open a new notebook with these cells in a page of its own, with a kernel of its own."""
        page = self._browser.new_page(viewport={"width": 1280, "height": 1200})
        return Notebook(self._lab, page, self._lab.write(*cells))


def heap_megabytes(page: Page, session: CDPSession) -> float:
    """What the page's JavaScript holds after garbage has been collected."""
    session.send("HeapProfiler.collectGarbage")
    page.wait_for_timeout(200)
    session.send("HeapProfiler.collectGarbage")
    return float(session.send("Runtime.getHeapUsage")["usedSize"]) / 1e6
