"""Servers for notebooks on this machine: each is a process of its own with folders of its own."""

import os
import socket
import subprocess
import sys
import urllib.request
from collections.abc import Iterator, Mapping, Sequence
from contextlib import closing, contextmanager
from pathlib import Path
from time import monotonic, sleep

import psutil

from .lab import Lab

ROOT = Path(__file__).parents[2]
START = 120  # seconds that a server may take to answer for the first time
LEAVE = 30  # seconds that a server may take to end what it started
CONFIGURATION = """
c.ServerApp.token = ""
c.ServerApp.password = ""
c.ServerApp.open_browser = False
c.ServerApp.allow_root = True
c.ServerApp.disable_check_xsrf = True
c.ServerApp.terminals_enabled = False
c.LabApp.expose_app_in_browser = True
c.JupyterNotebookApp.expose_app_in_browser = True
"""
QUIET = {
    "@jupyterlab/apputils-extension/notification": '{"fetchNews": "false"}',
    "@jupyterlab/docmanager-extension/plugin": '{"autosave": false}',
}


@contextmanager
def serving_notebooks(
    home: Path, root: Path, module: str = "jupyterlab", paths: Sequence[Path] = ()
) -> Iterator[Lab]:
    """Serve the notebooks in `root` without a token, by JupyterLab or another `module`.

    The server keeps what is its own in `home`; kernels find modules in `paths` too.
    """
    home.mkdir(exist_ok=True)
    root.mkdir(exist_ok=True)
    (home / "config").mkdir()
    for name in ("jupyter_lab_config.py", "jupyter_notebook_config.py"):
        (home / "config" / name).write_text(CONFIGURATION)
    write_settings(home / "settings")
    port = free_port()
    url = f"http://127.0.0.1:{port}"
    command = [sys.executable, "-m", module, f"--port={port}", f"--notebook-dir={root}"]
    with serving(command, f"{url}/api", home, root, surroundings(home, paths)):
        yield Lab(url, root)


@contextmanager
def serving(
    command: Sequence[str], asked: str, home: Path, root: Path, environment: Mapping[str, str]
) -> Iterator["subprocess.Popen[bytes]"]:
    """Run a server in `root` until the context ends, and then all that it has started.

    The context begins when the server answers at the address `asked`. What it says is in
    ``home/server.log``.
    """
    log = home / "server.log"
    with log.open("wb") as file:
        server = subprocess.Popen(command, env=environment, stdout=file, stderr=file, cwd=root)
    try:
        wait_for_answer(asked, server, log)
        yield server
    finally:
        end(server)


def end(server: "subprocess.Popen[bytes]") -> None:
    """Ask a server to end; what is then left of its processes is killed."""
    started = psutil.Process(server.pid).children(recursive=True) if server.poll() is None else []
    server.terminate()
    try:
        server.wait(LEAVE)
    except subprocess.TimeoutExpired:
        server.kill()
        server.wait()
    _, left = psutil.wait_procs(started, timeout=5)
    for process in left:
        process.kill()
    psutil.wait_procs(left, timeout=5)


def wait_for_answer(url: str, server: "subprocess.Popen[bytes]", log: Path) -> None:
    """Return when a server answers."""
    limit = monotonic() + START
    while monotonic() < limit and server.poll() is None:
        try:
            urllib.request.urlopen(url, timeout=5).close()
        except OSError:
            sleep(0.1)
        else:
            return
    raise RuntimeError(f"no answer at {url}; the server said:\n{log.read_text()[-3000:]}")


def surroundings(home: Path, paths: Sequence[Path] = ()) -> dict[str, str]:
    """Environment of a server that keeps its own in `home` and runs this checkout of dhlab."""
    inherited = {key: value for key, value in os.environ.items() if key != "DHLAB_VIEW"}
    return inherited | {
        "HOME": str(home),
        "IPYTHONDIR": str(home / "ipython"),
        "JUPYTER_CONFIG_DIR": str(home / "config"),
        "JUPYTER_DATA_DIR": str(home / "data"),
        "JUPYTER_RUNTIME_DIR": str(home / "runtime"),
        "JUPYTERLAB_SETTINGS_DIR": str(home / "settings"),
        "JUPYTERLAB_WORKSPACES_DIR": str(home / "workspaces"),
        "PYTHONPATH": os.pathsep.join([str(ROOT), *map(str, paths), *sys.path]),
    }


def write_settings(folder: Path) -> None:
    """Write settings of JupyterLab under which it asks for no news and saves when told."""
    for plugin, setting in QUIET.items():
        file = folder / f"{plugin}.jupyterlab-settings"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(setting)


def free_port() -> int:
    """Return a port of this machine that nobody listens on."""
    with closing(socket.socket()) as free:
        free.bind(("127.0.0.1", 0))
        port: int = free.getsockname()[1]
    return port
