"""The widget that shows a visualizer's page in a frame and sends it what is new; frame.js is its other half."""

from __future__ import annotations

import asyncio
import time
from importlib.resources import files
from typing import Any

from rlrobot_edu.jupyter import anywidget, ipywidgets, traitlets
from rlrobot_edu.show.in3d.window import Key, Window, live_page

PAUSE = 0.05  # between two messages [s]; what is new in between goes with the second
KEPT = 2000  # rewards for a page that is opened late


class ViewerWidget(anywidget.AnyWidget):
    """The page without a scene, meshcat's viewer in it; all views of a notebook take it from this one widget."""

    _esm = "export default {};"
    page = traitlets.Unicode().tag(sync=True)
    _only: ViewerWidget | None = None

    @classmethod
    def only(cls) -> ViewerWidget:
        """The one of this kernel; another if somebody has closed it."""
        if cls._only is None or cls._only.comm is None:
            cls._only = cls(page=live_page())
        return cls._only


class PageWidget(anywidget.AnyWidget):
    """A window's page in a frame as wide as the cell, at most `height` pixels high."""

    _esm = files(__package__).joinpath("frame.js").read_text(encoding="utf-8")
    viewer = traitlets.Instance(ViewerWidget).tag(
        sync=True, **ipywidgets.widget_serialization
    )
    height = traitlets.Int(520).tag(sync=True)
    # A browser asks for it whenever it needs the state, also when it comes back; it gets the state of that moment.
    scene = traitlets.Any().tag(sync=True, to_json=lambda _, widget: widget.whole())

    def __init__(self, window: Window) -> None:
        self._window = window
        self._sent_at = 0.0  # time of the last message [s]
        self._news: dict[Key, bytes] = {}
        self._later: asyncio.TimerHandle | None = None
        super().__init__(viewer=ViewerWidget.only())
        window.listeners.append(self._hear)

    def whole(self) -> dict[str, Any]:
        """The whole view; a browser adds to `keys` and `news` what comes later."""
        return {
            **self._message([]),
            "packed": self._window.packed(),
            "news": [],
        }

    def tell(self) -> None:
        """Send what is new."""
        if self._later is not None:
            self._later.cancel()
        self._later = None
        self._sent_at = time.monotonic()
        news = list(self._news.items())
        self._news = {}
        self.send(self._message(news), buffers=[packed for _, packed in news])

    def settle(self) -> None:
        """Send what is new, and then the whole view, packed: so little is saved with the notebook."""
        self.tell()
        self.send_state("scene")

    def _message(self, news: list[tuple[Key, bytes]]) -> dict[str, Any]:
        rewards = self._window.rewards
        return {
            "keys": [key for key, _ in news],
            "rewards": rewards[-KEPT:],
            "count": len(rewards),
            "title": self._window.title,
        }

    def _hear(self, key: Key, packed: bytes) -> None:
        """Note a command, which replaces an older one with this key; send it now or with the next message."""
        self._news.pop(key, None)
        self._news[key] = packed
        if time.monotonic() - self._sent_at >= PAUSE:
            self.tell()  # at once, because the loop does not run while a cell does
        elif self._later is None:
            try:  # if no command follows, this sends the last one
                loop = asyncio.get_running_loop()
                self._later = loop.call_later(PAUSE, self.tell)
            except RuntimeError:
                self.tell()
