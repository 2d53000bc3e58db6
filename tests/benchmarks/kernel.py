"""A Jupyter kernel of its own, without a page, and what it says on the wire."""

import json
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from uuid import uuid4

import zmq
from jupyter_client.blocking import BlockingKernelClient
from jupyter_client.manager import KernelManager

HERE = Path(__file__).parent
SECONDS = 300


class Kernel:
    """A running kernel that code is sent to.

    Parameters
    ----------
    client : BlockingKernelClient
    said : zmq.Socket
        Receives all that the kernel publishes, as it comes.
    """

    def __init__(self, client: BlockingKernelClient, said: zmq.Socket) -> None:
        self._client = client
        self._said = said

    def run(self, code: str) -> str:
        """Run a cell, as a page does, which names it; return what it prints."""
        printed: list[str] = []
        self._client.session.metadata = {"cellId": uuid4().hex}

        def note(message: dict[str, Any]) -> None:
            if message["msg_type"] == "stream":
                printed.append(message["content"]["text"])

        reply = self._client.execute_interactive(code, output_hook=note, timeout=SECONDS)
        if reply["content"]["status"] != "ok":
            raise RuntimeError("\n".join(reply["content"]["traceback"]))
        return "".join(printed)

    def value(self, module: str, function: str, *arguments: object) -> Any:
        """Call a function of a module beside this one in the kernel; return what it gives."""
        given = ", ".join(map(repr, arguments))
        code = f"import json, {module}\nprint(json.dumps({module}.{function}({given})))"
        return json.loads(self.run(code).splitlines()[-1])

    def messages(self) -> list[list[bytes]]:
        """All widget messages since this was last asked, each as its parts on the wire."""
        messages = []
        while self._said.poll(500):
            parts = self._said.recv_multipart()
            header = json.loads(parts[parts.index(b"<IDS|MSG>") + 2])
            if header["msg_type"].startswith("comm_"):
                messages.append(parts)
        return messages


@contextmanager
def open_kernel() -> Iterator[Kernel]:
    """Start a kernel; it ends with the context."""
    manager = KernelManager()
    manager.kernel_cmd = [sys.executable, "-m", "ipykernel_launcher", "-f", "{connection_file}"]
    manager.start_kernel()
    client = manager.blocking_client()
    said = zmq.Context.instance().socket(zmq.SUB)
    try:
        client.start_channels()
        client.wait_for_ready(timeout=60)
        said.connect(f"tcp://{manager.ip}:{manager.iopub_port}")
        said.subscribe(b"")
        kernel = Kernel(client, said)
        kernel.run(f"import sys; sys.path.insert(0, {str(HERE)!r})")
        yield kernel
    finally:
        said.close(linger=0)
        client.stop_channels()
        manager.shutdown_kernel(now=True)
