"""Other viewers, each with an interpreter and a page of its own.

`DHLAB_PEERS` names an interpreter that has them. Without it an environment is made once in the
user's cache, with pip.
"""

import hashlib
import os
import subprocess
import sys
import venv
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
PACKAGES = ("viser==1.1.1", "swift-sim==2.1.0", "mapbox-earcut")
"""Measured in these versions, beside what dhlab itself needs there."""


class PeerMissingError(RuntimeError):
    """There is no such viewer here; the text says why."""


def interpreter() -> str:
    """Return the interpreter that has the other viewers; make it if there is none."""
    named = os.environ.get("DHLAB_PEERS")
    if named:
        return named
    cache = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "dhlab"
    wanted = " ".join((*PACKAGES, sys.version))
    folder = cache / f"peers-{hashlib.sha256(wanted.encode()).hexdigest()[:12]}"
    python = folder / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    if not (folder / "complete").exists():
        try:
            venv.create(folder, with_pip=True, clear=True)
            command = [python, "-m", "pip", "install", "--quiet", *PACKAGES]
            subprocess.run(command, check=True, capture_output=True, text=True, timeout=600)
        except subprocess.CalledProcessError as error:
            reason = (error.stderr.strip().splitlines() or ["pip failed"])[-1]
            raise PeerMissingError(f"could not be installed: {reason}") from error
        except (OSError, subprocess.TimeoutExpired) as error:
            raise PeerMissingError(f"could not be installed: {error}") from error
        (folder / "complete").touch()
    return str(python)


@contextmanager
def running(name: str, *arguments: str) -> Iterator[str]:
    """Run ``peer_NAME.py`` with the interpreter of the others; give where its page is."""
    command = [interpreter(), str(HERE / f"peer_{name}.py"), *arguments]
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    pipe = subprocess.PIPE
    peer = subprocess.Popen(
        command, stdin=pipe, stdout=pipe, stderr=pipe, text=True, env=environment
    )
    try:
        address = next((line.strip() for line in peer.stdout if line.startswith("http")), None)
        if address is None:
            said = peer.stderr.read().strip().splitlines() or ["it said nothing"]
            raise PeerMissingError(f"did not start: {said[-1]}")
        yield address
    finally:
        peer.kill()
        peer.communicate()
