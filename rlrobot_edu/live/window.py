"""A page that this computer's browsers follow, served by a thread.

meshcat brings a server of its own, which listens to the whole network.
"""

import json
import threading
from collections import deque
from contextlib import suppress
from functools import partial
from http.server import BaseHTTPRequestHandler
from socketserver import ThreadingTCPServer
from typing import Any

HOST = "127.0.0.1"
PATIENCE = 1.0  # for how long a browser's question waits for news [s]
FRAME = 0.02  # what comes within this time is told together [s]
KEPT = 2000  # frames that a browser gets that comes late: as long is the trail

Told = dict[str, Any]


class LiveWindow:
    """Shows `page` and frames at `url` in any number of browsers on this computer, whenever they come.

    Each browser asks again and again for what is new, and gets the room when it does not have it yet.
    """

    def __init__(self, page: str) -> None:
        self.page = page
        self.changed = threading.Condition()  # a thread holds it while it uses the fields below
        self.count = 0  # of frames so far
        self.closed = False
        self._room: Told = {}
        self._room_since = 0  # how many frames there had been in other rooms
        self._steps = 0  # that paid something in this room; a start is none
        self._frames: deque[Told] = deque(maxlen=KEPT)
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

    def show(self, room: Told, frame: Told) -> None:
        """Take what there is to see now and return at once. Raises RuntimeError after `close`."""
        with self.changed:
            if self.closed:
                raise RuntimeError("this live view is closed; make a new one")
            if room != self._room:
                self._room, self._room_since, self._steps = room, self.count, 0
                self._frames.clear()
            self.count += 1
            self._steps += frame["reward"] is not None
            self._frames.append({**frame, "step": self._steps})
            self.changed.notify_all()

    def news(self, seen: int) -> Told:
        """What a browser lacks that has `seen` so many frames; waits a while until there is something."""
        with self.changed:
            self.changed.wait_for(lambda: self.count > seen or self.closed, PATIENCE)
            self.changed.wait_for(lambda: self.closed, FRAME)
        return self.so_far(seen)

    def so_far(self, seen: int) -> Told:
        """What a browser lacks that has `seen` so many frames, at once."""
        with self.changed:
            frames = list(self._frames)[-(self.count - seen) :] if self.count > seen else []
            room = self._room if seen <= self._room_since else None
            return {"count": self.count, "room": room, "frames": frames, "closed": self.closed}

    def close(self) -> None:
        """Stop the server and free its port; the pages that wait for news are told."""
        with self.changed:
            self.closed = True
            self.changed.notify_all()
        if threading.current_thread() is not self._thread:  # the garbage collector may call from any thread
            self._thread.join()


class _Answer(BaseHTTPRequestHandler):
    """One question of a browser: ``/`` for the page, ``/news?n`` for what came after the first n frames."""

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
            self._send("text/html; charset=utf-8", window.page)
        elif own and path == "/news" and seen.isdecimal():
            self._send("application/json", json.dumps(window.news(int(seen))))
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
