"""Where meshcat's drawing commands go, in place of meshcat's own server process: into one page, or to open browsers.

A command is a dictionary packed with msgpack. `Commands` keeps those that make up a scene, `page` makes HTML of them
that works offline. `LiveWindow` hands them to browsers on this computer, from a thread that ends with `close`.
"""

from __future__ import annotations

import asyncio
import base64
import html
import json
import threading
from collections.abc import Iterable, Sequence
from contextlib import suppress
from importlib.resources import files
from string import Template
from typing import Any

import umsgpack
from tornado.httpserver import HTTPServer
from tornado.iostream import StreamClosedError
from tornado.netutil import bind_sockets
from tornado.web import Application, RequestHandler
from tornado.websocket import WebSocketClosedError, WebSocketHandler

LOCAL = "127.0.0.1"
Key = tuple[str, ...]  # type of a command, path of the thing, property


def page(
    messages: Iterable[bytes], title: str, captions: Sequence[str] = (), fps: float = 1.0, live: bool = False
) -> str:
    """A stand-alone HTML page that draws the packed commands.

    title: what is to be seen, in words; captions: one line a frame, fps: frames a second [1/s], of a replay;
    live: go on listening to the server the page came from
    """
    template = Template(files(__package__).joinpath("page.html").read_text(encoding="utf-8"))
    library = files("meshcat").joinpath("viewer/dist/main.min.js").read_text(encoding="utf-8")
    packed = [base64.b64encode(message).decode("ascii") for message in messages]
    feed = json.dumps({"messages": packed, "captions": captions, "fps": fps, "live": live})
    # "</" would end the script element early
    return template.substitute(title=html.escape(title), library=library, feed=feed.replace("</", "<\\/"))


def pack(command: Any) -> tuple[Key, bytes]:
    """A meshcat command (`SetObject`, `SetTransform`, …) as its key and its message."""
    data = command.lower()
    return (data["type"], data["path"], data.get("property", "")), umsgpack.packb(data)


class Commands(dict[Key, bytes]):
    """The messages that make up a scene, by their keys; a window that only keeps what it is sent."""

    def send(self, command: Any) -> None:
        """Take a meshcat command."""
        self.keep(*pack(command))

    def keep(self, key: Key, message: bytes) -> None:
        """Add a message in place of an earlier one for the same thing; a ``delete`` removes all that it makes void."""
        if key[0] == "delete":
            for old in [k for k in self if (k[1] + "/").startswith(key[1] + "/")]:
                del self[old]
        self.pop(key, None)  # to the end: an animation, say, must follow the objects it moves
        self[key] = message


class LiveWindow:
    """Shows the scene at `url` in any number of browsers on this computer, whenever they come.

    Everything but `send` and `close` happens in one thread, so nothing needs a lock.
    """

    def __init__(self) -> None:
        self.commands = Commands()
        self.browsers: set[_Browser] = set()
        self._sockets = bind_sockets(0, address=LOCAL)
        self.url = f"http://{LOCAL}:{self._sockets[0].getsockname()[1]}/"
        started = threading.Event()
        self._thread = threading.Thread(target=lambda: asyncio.run(self._serve(started)), name=self.url, daemon=True)
        self._thread.start()
        started.wait()

    async def _serve(self, started: threading.Event) -> None:
        self._loop, self._stop = asyncio.get_running_loop(), asyncio.Event()
        app = Application(log_function=lambda handler: None)  # a learner's notebook is no place for a server's log
        # by this name only: a foreign page that has its own name point to this computer gets nothing
        app.add_handlers(r"127\.0\.0\.1", [("/", _Page), ("/scene", _Browser, {"window": self})])
        server = HTTPServer(app)
        server.add_sockets(self._sockets)
        started.set()
        await self._stop.wait()
        server.stop()
        for browser in list(self.browsers):
            browser.close()
        await server.close_all_connections()

    def send(self, command: Any) -> None:
        """Take a meshcat command and return at once. Raises RuntimeError after `close`."""
        if not self._thread.is_alive():
            raise RuntimeError("this live view is closed; make a new one")
        self._loop.call_soon_threadsafe(self._publish, *pack(command))

    def _publish(self, key: Key, message: bytes) -> None:
        self.commands.keep(key, message)
        for browser in self.browsers:
            browser.tell(key, message)

    def close(self) -> None:
        """Stop the server, free its port and wait until its thread has ended."""
        if self._thread.is_alive():
            self._loop.call_soon_threadsafe(self._stop.set)
            self._thread.join()


class _Page(RequestHandler):
    def get(self) -> None:
        self.write(page([], "Live 3D view", live=True))


class _Browser(WebSocketHandler):
    """One open page. What it has not yet been told waits in `news`, where newer replaces older: slow pages skip."""

    def initialize(self, window: LiveWindow) -> None:
        self.window = window

    # tornado's own check_origin refuses pages that came from elsewhere
    def open(self) -> None:
        self.news, self.more = Commands(self.window.commands), asyncio.Event()
        self.more.set()
        self.window.browsers.add(self)
        self.writer = asyncio.create_task(self._write())  # a reference, or it might be collected half way

    def tell(self, key: Key, message: bytes) -> None:
        self.news.keep(key, message)
        self.more.set()

    async def _write(self) -> None:
        with suppress(WebSocketClosedError, StreamClosedError):
            while await self.more.wait():
                self.more.clear()
                while self.news:
                    await self.write_message(self.news.pop(next(iter(self.news))), binary=True)

    def on_close(self) -> None:
        self.window.browsers.discard(self)
        self.writer.cancel()
