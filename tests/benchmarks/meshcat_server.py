"""meshcat-python's server, and somebody who looks at it."""

import asyncio
import socket
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import closing, contextmanager

import zmq
from tornado.websocket import websocket_connect


@contextmanager
def meshcat_server() -> Iterator[str]:
    """Start the server; nobody reads what it prints, so that it cannot block."""
    with closing(socket.socket()) as free:
        free.bind(("127.0.0.1", 0))
        url = f"tcp://127.0.0.1:{free.getsockname()[1]}"
    command = [sys.executable, "-m", "meshcat.servers.zmqserver", "--zmq-url", url]
    quiet = subprocess.DEVNULL
    server = subprocess.Popen(command, stdin=quiet, stdout=quiet, stderr=quiet)
    try:
        yield url
    finally:
        server.kill()
        server.wait()


def connect_page(url: str) -> None:
    """Listen as a page does, until the server ends, and throw everything away."""
    with zmq.Context.instance().socket(zmq.REQ) as ask:
        ask.connect(url)
        ask.send(b"url")
        page = ask.recv().decode().replace("http", "ws", 1).removesuffix("static/")
    connected = threading.Event()

    async def listen() -> None:
        connection = await websocket_connect(page)
        connected.set()
        while await connection.read_message() is not None:
            pass

    threading.Thread(target=asyncio.run, args=(listen(),), daemon=True).start()
    if not connected.wait(20):
        raise RuntimeError(f"no connection to {page}")
