"""Two small windows for ``meshcat.Visualizer(window=…)``, in place of meshcat's own server process.

meshcat draws by commands (dictionaries packed with msgpack). `StillWindow` keeps them and writes one HTML page that
works offline. `LiveWindow` also hands them to browsers on this computer, from a thread that ends with `close`.
"""

from __future__ import annotations

import asyncio
import base64
import html
import json
import threading
from importlib.resources import files
from string import Template

import umsgpack
from tornado.httpserver import HTTPServer
from tornado.iostream import StreamClosedError
from tornado.netutil import bind_sockets
from tornado.web import Application, RequestHandler
from tornado.websocket import WebSocketClosedError, WebSocketHandler

LOCAL = "127.0.0.1"
_PAGE = Template("""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>$title</title><style>
body { margin: 0; overflow: hidden; font: 15px sans-serif; color: #000 }
#view { width: 100vw; height: 100vh }
#bar { position: absolute; bottom: 0; width: 100%; box-sizing: border-box; padding: 6px 10px; display: flex;
       gap: 10px; align-items: center; background: rgba(255, 255, 255, .85) }
#bar[hidden] { display: none }
#time { flex: 1; min-width: 4em } #play { width: 5em }
</style></head><body>
<div id="view" role="img" aria-label="$title"></div>
<div id="bar" hidden><button id="play">Pause</button>
<input id="time" type="range" min="0" value="0" aria-label="step of the replay"><span id="caption"></span></div>
<script>$library</script>
<script>
const [bar, play, time, caption] = ["bar", "play", "time", "caption"].map(id => document.getElementById(id));
const feed = $feed;
function say(text) { bar.hidden = false; play.hidden = time.hidden = true; caption.textContent = text; }
let viewer;
try { viewer = new MeshCat.Viewer(document.getElementById("view")); }
catch (error) { say("This browser shows no 3D pictures: WebGL is switched off."); throw error; }
viewer.gui.domElement.style.display = "none";
const draw = bytes => viewer.handle_command_bytearray(bytes);
for (const text of feed.messages) draw(Uint8Array.from(atob(text), c => c.charCodeAt(0)));
if (feed.captions.length) {
  const film = viewer.animator, last = feed.captions.length - 1;
  bar.hidden = false;
  time.max = last;
  play.onclick = () => film.playing ? film.pause() : film.play();
  time.oninput = () => { film.pause(); film.time = time.value / feed.fps; film.seek(film.time); };
  (function tick() {
    const frame = Math.min(last, Math.round(film.time * feed.fps));
    time.value = frame;
    caption.textContent = feed.captions[frame];
    play.textContent = film.playing ? "Pause" : "Play";
    requestAnimationFrame(tick);
  })();
}
if (feed.live) {
  const line = new WebSocket("ws://" + location.host + "/scene");
  line.binaryType = "arraybuffer";
  line.onmessage = event => draw(new Uint8Array(event.data));
  line.onclose = () => say("The live view has ended.");
}
</script></body></html>
""")


def page(messages: list[bytes], title: str, captions: list[str], fps: float, live: bool = False) -> str:
    """A stand-alone HTML page that draws the packed commands.

    title: what is to be seen, in words; captions: one line a frame, fps: frames a second [1/s], of a replay;
    live: go on listening to the server the page came from
    """
    library = files("meshcat").joinpath("viewer/dist/main.min.js").read_text(encoding="utf-8")
    feed = {"messages": [base64.b64encode(m).decode("ascii") for m in messages],
            "captions": captions, "fps": fps, "live": live}  # fmt: skip
    # "</" would end the script element early
    return _PAGE.substitute(title=html.escape(title), library=library, feed=json.dumps(feed).replace("</", "<\\/"))


class StillWindow:
    """Keeps the commands that make up the scene; a later one for the same thing takes the place of the earlier."""

    def __init__(self) -> None:
        self.messages: dict[tuple[str, ...], bytes] = {}

    def send(self, command) -> None:
        """Take a meshcat command (`SetObject`, `SetTransform`, …)."""
        keep(self.messages, *_pack(command))

    def html(self, title: str = "3D view", captions: list[str] = (), fps: float = 1.0) -> str:
        """The scene as a page that needs neither server nor network; see `page`."""
        return page(list(self.messages.values()), title, list(captions), fps)


def _pack(command) -> tuple[tuple[str, ...], bytes]:
    """A command's key, (type, path, property), and its packed message."""
    data = command.lower()
    return (data["type"], data["path"], data.get("property", "")), umsgpack.packb(data)


def keep(messages: dict[tuple[str, ...], bytes], key: tuple[str, ...], message: bytes) -> None:
    """Add a message to those that make up a scene; a ``delete`` removes all that it makes void."""
    if key[0] == "delete":
        for old in [k for k in messages if (k[1] + "/").startswith(key[1] + "/")]:
            del messages[old]
    messages.pop(key, None)  # to the end: an animation, say, must follow the objects it moves
    messages[key] = message


class LiveWindow:
    """Shows the scene at `url` in any number of browsers on this computer, whenever they come.

    Everything but `send` and `close` happens in one thread, so nothing needs a lock.
    """

    def __init__(self) -> None:
        self.messages: dict[tuple[str, ...], bytes] = {}
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

    def send(self, command) -> None:
        """Take a meshcat command and return at once. Raises RuntimeError after `close`."""
        if not self._thread.is_alive():
            raise RuntimeError("this live view is closed; make a new one")
        self._loop.call_soon_threadsafe(self._publish, *_pack(command))

    def _publish(self, key: tuple[str, ...], message: bytes) -> None:
        keep(self.messages, key, message)
        for browser in self.browsers:
            browser.tell(key, message)

    def close(self) -> None:
        """Stop the server, free its port and wait until its thread has ended."""
        if self._thread.is_alive():
            self._loop.call_soon_threadsafe(self._stop.set)
            self._thread.join()

    def __enter__(self) -> LiveWindow:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()


class _Page(RequestHandler):
    def get(self) -> None:
        self.write(page([], "Live 3D view", [], 1.0, live=True))


class _Browser(WebSocketHandler):
    """One open page. What it has not yet been told waits in `news`, where newer replaces older: slow pages skip."""

    def initialize(self, window: LiveWindow) -> None:
        self.window = window

    # tornado's own check_origin refuses pages that came from elsewhere
    def open(self) -> None:
        self.news, self.busy = dict(self.window.messages), False
        self.window.browsers.add(self)
        self._start()

    def tell(self, key: tuple[str, ...], message: bytes) -> None:
        keep(self.news, key, message)
        self._start()

    def _start(self) -> None:
        if not self.busy:
            self.busy = True
            self.writer = asyncio.ensure_future(self._write())  # a reference, or it might be collected half way

    async def _write(self) -> None:
        try:
            while self.news:
                await self.write_message(self.news.pop(next(iter(self.news))), binary=True)
        except (WebSocketClosedError, StreamClosedError):
            self.on_close()
        self.busy = False

    def on_close(self) -> None:
        self.window.browsers.discard(self)
