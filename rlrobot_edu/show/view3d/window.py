"""Where meshcat's drawing commands go, in place of meshcat's own server process: into one page, or to open browsers.

A command is a dictionary packed with msgpack. `StillWindow` keeps those that make up a scene, `page` makes HTML of them
that works offline. `LiveWindow` also tells them to browsers on this computer, from threads that end with `close`.
"""

import base64
import html
import json
import threading
from collections.abc import Sequence
from contextlib import suppress
from functools import partial
from http.server import BaseHTTPRequestHandler
from importlib.resources import files
from socketserver import ThreadingTCPServer
from string import Template
from typing import Any

import umsgpack

HOST = "127.0.0.1"
PATIENCE = 1.0  # for how long a browser's question waits for news [s]
FRAME = 0.02  # what is drawn together comes within this time, and is told together [s]


class StillWindow:
    """Keeps the commands that make up the scene; a later one for the same thing takes the place of the earlier."""

    def __init__(self) -> None:
        self.count = 0  # of commands so far
        self._messages: dict[tuple[str, str, str], tuple[int, str]] = {}

    def send(self, command: Any) -> None:
        """Take a meshcat command (`SetObject`, `SetTransform`, …)."""
        data = command.lower()
        kind, path = data["type"], data["path"]
        if kind == "delete":  # it makes void all that came for this path and those below it
            for old in [key for key in self._messages if (key[1] + "/").startswith(path + "/")]:
                del self._messages[old]
        key = kind, path, data.get("property", "")
        self._messages.pop(key, None)  # to the end: an animation, say, must follow the objects it moves
        self.count += 1
        self._messages[key] = self.count, base64.b64encode(umsgpack.packb(data)).decode("ascii")

    def since(self, count: int = 0) -> list[str]:
        """The messages that draw all that has come after the first `count` commands, in base64."""
        return [message for number, message in self._messages.values() if number > count]


def page(messages: list[str], title: str, captions: Sequence[str] = (), fps: float = 1.0, live: bool = False) -> str:
    """A stand-alone HTML page that draws the messages.

    title: what is to be seen, in words; captions: one line a frame, fps: frames a second [1/s], of a replay;
    live: go on asking the server that the page came from
    """
    template = Template(files(__package__).joinpath("page.html").read_text(encoding="utf-8"))
    library = files("meshcat").joinpath("viewer/dist/main.min.js").read_text(encoding="utf-8")
    feed = json.dumps({"messages": messages, "captions": captions, "fps": fps, "live": live})
    # "</script" and "<!--" would end the script element too early or too late
    return template.substitute(title=html.escape(title), library=library, feed=feed.replace("<", "\\u003c"))


class LiveWindow(StillWindow):
    """Shows the scene at `url` in any number of browsers on this computer, whenever they come.

    Each browser asks again and again for what is new: a slow one skips what has been replaced meanwhile.
    """

    def __init__(self) -> None:
        super().__init__()
        self.changed = threading.Condition()  # held by whoever touches the messages
        self.closed = False
        self._server = ThreadingTCPServer((HOST, 0), partial(_Answer, self))
        self._server.daemon_threads = True  # an open page keeps no program from ending
        self._server.timeout = 0.05  # for how long it listens before it looks whether it is to end [s]
        self.address = f"{HOST}:{self._server.server_address[1]}"
        self.url = f"http://{self.address}/"
        self._thread = threading.Thread(target=self._serve, name=self.url, daemon=True)
        self._thread.start()

    def _serve(self) -> None:
        with self._server:
            while not self.closed:
                self._server.handle_request()

    def send(self, command: Any) -> None:
        """Take a meshcat command and return at once. Raises RuntimeError after `close`."""
        with self.changed:
            if self.closed:
                raise RuntimeError("this live view is closed; make a new one")
            super().send(command)
            self.changed.notify_all()

    def close(self) -> None:
        """Stop the server and free its port; the pages that wait for news are told."""
        with self.changed:
            self.closed = True
            self.changed.notify_all()
        if threading.current_thread() is not self._thread:  # the garbage collector may call from any thread
            self._thread.join()


class _Answer(BaseHTTPRequestHandler):
    """One question of a browser: ``/`` for the page, ``/news?n`` for what came after the first n commands."""

    timeout = 10  # seconds, for a browser that connects and then asks nothing

    def __init__(self, window: LiveWindow, *request: Any) -> None:
        self.window = window
        super().__init__(*request)

    def handle(self) -> None:
        with suppress(OSError):  # the page was closed and does not wait for its answer
            super().handle()

    def do_GET(self) -> None:
        window, (path, _, seen) = self.window, self.path.partition("?")
        # a foreign page gets nothing, not even one that has its own name point to this computer
        own = self.headers["Host"] == window.address and self.headers["Origin"] in (None, f"http://{window.address}")
        if own and path == "/":
            self._send("text/html; charset=utf-8", page([], "Live 3D view", live=True))
        elif own and path == "/news" and seen.isdecimal():
            with window.changed:
                window.changed.wait_for(lambda: window.count > int(seen) or window.closed, PATIENCE)
                window.changed.wait_for(lambda: window.closed, FRAME)
                news = {"count": window.count, "messages": window.since(int(seen)), "closed": window.closed}
            self._send("application/json", json.dumps(news))
        else:
            self.send_error(404)

    def _send(self, kind: str, text: str) -> None:
        self.send_response(200)
        self.send_header("Content-Type", kind)
        self.send_header("Cache-Control", "no-store")
        self.end_headers()
        self.wfile.write(text.encode())

    def log_message(self, *_: object) -> None:
        """Nothing: a learner's notebook is no place for a server's log."""
