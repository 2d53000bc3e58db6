"""`dhlab lab`."""

import json
import os
import re
import socket
import subprocess
import sys
import time
import urllib.request
from pathlib import Path

import pytest

from dhlab.cli import lab, main, parser
from dhlab.workcopy import refresh, shipped

ROOT = Path(__file__).parents[2]


def test_the_notebooks_that_came_with_dhlab_start_with_an_index():
    assert lab.INDEX in shipped()


def test_a_folder_that_cannot_be_written_is_one_sentence(tmp_path, capsys):
    (tmp_path / "file").write_text("not a folder")
    assert main(["lab", "--dir", str(tmp_path / "file" / "copy")]) == 2
    assert re.match(r"dhlab: .*file.*\n$", capsys.readouterr().err)


def test_jupyterlab_asks_for_a_token_unless_told_otherwise(tmp_path):
    def arguments(*words):
        return lab.server_arguments(parser().parse_args(["lab", *words]), tmp_path)

    assert not any("token" in word for word in arguments("--no-browser", "--port", "9000"))
    assert "--IdentityProvider.token=" in arguments("--no-token")
    assert "--ServerApp.port=9000" in arguments("--port", "9000")


def test_what_was_done_is_told_in_lines(tmp_path):
    folder, source = tmp_path / "copy", tmp_path / "first.ipynb"
    source.write_text("{}")
    sources = {"notebooks/index.ipynb": source, "notebooks/first.ipynb": source}
    done = refresh(folder, sources)
    assert lab.told(done) == [
        "dhlab: new in your copy: notebooks/index.ipynb, notebooks/first.ipynb"
    ]
    assert lab.told(refresh(folder, sources)) == []


@pytest.fixture
def server(tmp_path):
    """A running `dhlab lab` without a token: its address and its process."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    command = [sys.executable, "-m", "dhlab", "lab", "--no-browser", "--no-token"]
    paths = {"PYTHONPATH": os.pathsep.join(filter(None, [str(ROOT), os.environ.get("PYTHONPATH")]))}
    home = {name: str(tmp_path / name) for name in ("HOME", "JUPYTER_DATA_DIR", "IPYTHONDIR")}
    process = subprocess.Popen(
        [*command, "--port", str(port), "--dir", "work"],
        cwd=tmp_path,
        env=os.environ | paths | home,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    yield f"http://127.0.0.1:{port}", process
    process.terminate()
    process.wait(timeout=20)


def fetch(server, path, seconds=30.0):
    """Answer of a server that may still be starting."""
    address, process = server
    end = time.monotonic() + seconds
    while True:
        try:
            with urllib.request.urlopen(address + path, timeout=seconds) as answer:
                return json.load(answer)
        except OSError:
            if process.poll() is not None or time.monotonic() > end:
                raise
            time.sleep(0.1)


def test_lab_serves_the_working_copy_and_saves_the_state_of_widgets(server):
    assert fetch(server, f"/api/contents/{lab.INDEX}")["type"] == "notebook"
    plugin = "@jupyter-widgets/jupyterlab-manager:plugin"
    settings = fetch(server, f"/lab/api/settings/{plugin}")
    assert settings["schema"]["properties"]["saveState"]["default"] is True
