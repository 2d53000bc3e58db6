"""A JupyterHub on this machine, behind its proxy: every user has a server and a home."""

import json
import os
import shutil
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from urllib.parse import urlencode

import psutil
from playwright.sync_api import Page

from .lab import READY, RUN_ALL, Lab
from .servers import ROOT, free_port, serving, surroundings, write_settings

PROXY = "configurable-http-proxy"
PASSWORD = "a shared password"
CONFIGURATION = """
c.JupyterHub.bind_url = {url!r}
c.JupyterHub.hub_ip = "127.0.0.1"
c.JupyterHub.hub_port = {hub_port}
c.JupyterHub.db_url = "sqlite:///{home}/hub.sqlite"
c.JupyterHub.cookie_secret_file = "{home}/cookie_secret"
c.JupyterHub.authenticator_class = "shared-password"
c.SharedPasswordAuthenticator.user_password = {password!r}
c.Authenticator.allow_all = True
c.ConfigurableHTTPProxy.command = [{proxy!r}]
c.ConfigurableHTTPProxy.api_url = "http://127.0.0.1:{proxy_port}"
c.ConfigurableHTTPProxy.pid_file = "{home}/proxy.pid"
c.JupyterHub.spawner_class = "simple"
c.SimpleLocalProcessSpawner.home_dir_template = "{home}/users/{{username}}"
c.Spawner.cmd = {command}
c.Spawner.environment = {{"JUPYTERLAB_SETTINGS_DIR": "{home}/settings"}}
c.Spawner.start_timeout = 120
c.Spawner.http_timeout = 120
"""


@dataclass(frozen=True)
class Hub:
    """A running hub: the address of its proxy, the users' homes, and its own process."""

    url: str
    home: Path
    process: psutil.Process

    def write(self, user: str, *cells: str) -> str:
        """Write a notebook into a user's home; return its address for that user."""
        home = self.home / "users" / user
        home.mkdir(parents=True, exist_ok=True)
        name = Lab(self.url, home).write(*cells)
        return f"/user/{user}/lab/workspaces/{user}/tree/{name}"

    def visit(self, page: Page, user: str, address: str) -> None:
        """Log a user in, with a server that may have to start first, and run a notebook."""
        start = f"/hub/spawn/{user}?{urlencode({'next': address})}"
        page.goto(f"{self.url}/hub/login?{urlencode({'next': start})}", timeout=60_000)
        page.get_by_label("Username").fill(user)
        page.get_by_label("Password").fill(PASSWORD)
        page.get_by_role("button", name="Sign in").click()
        page.wait_for_function(READY, timeout=120_000)
        page.evaluate(RUN_ALL)

    def processes(self) -> list[psutil.Process]:
        """All that runs for the hub: itself, its proxy, the users' servers and kernels."""
        return [self.process, *self.process.children(recursive=True)]


def what_is_missing() -> str:
    """Say what a hub would need that is not here; nothing if it can run."""
    missing = [] if find_spec("jupyterhub") else ["pip install '.[hub]'"]
    missing += [] if find_proxy() else [f"npm install --prefix .venv/hub {PROXY}"]
    return " and ".join(missing)


def find_proxy() -> str | None:
    """Return the proxy's command, of this environment or else of the machine."""
    own = ROOT / ".venv" / "hub" / "node_modules" / ".bin"
    return shutil.which(PROXY, path=own) or shutil.which(PROXY)


@contextmanager
def serving_hub(home: Path) -> Iterator[Hub]:
    """Run a hub that keeps all of its own in `home`, until the context ends."""
    url = f"http://127.0.0.1:{free_port()}"
    server = [sys.executable, "-m", "jupyterhub.singleuser", "--LabApp.expose_app_in_browser=True"]
    is_root = hasattr(os, "geteuid") and os.geteuid() == 0
    text = CONFIGURATION.format(
        url=url,
        home=home,
        hub_port=free_port(),
        proxy_port=free_port(),
        proxy=find_proxy(),
        password=PASSWORD,
        command=json.dumps([*server, *(["--allow-root"] if is_root else [])]),
    )
    (home / "jupyterhub_config.py").write_text(text)
    write_settings(home / "settings")
    command = [sys.executable, "-m", "jupyterhub", "--config", str(home / "jupyterhub_config.py")]
    with serving(command, f"{url}/hub/health", home, home, surroundings(home)) as hub:
        yield Hub(url, home, psutil.Process(hub.pid))
