"""The widget that shows a visualizer's page in a frame and tells it what is new; frame.js is its other half."""

from __future__ import annotations

import asyncio
import time
from importlib.resources import files
from typing import Any

import anywidget
import traitlets

from rlrobot_edu.show.in3d.window import Key, Window

PAUSE = 0.05  # between two messages [s]; what comes meanwhile goes with the next
KEPT = 2000  # rewards for a page that comes late


class PageWidget(anywidget.AnyWidget):
    """A window's page in a frame, `height` pixels high."""

    _esm = files(__package__).joinpath("frame.js").read_text(encoding="utf-8")
    page = traitlets.Unicode().tag(sync=True)
    height = traitlets.Int(480).tag(sync=True)
    # asked for whenever a browser wants the state, also by one that comes back: so the answer is the state then
    scene = traitlets.Any().tag(sync=True, to_json=lambda _, widget: widget.whole())

    def __init__(self, window: Window) -> None:
        self._window, self._told = window, 0.0
        self._news: dict[Key, bytes] = {}
        self._later: asyncio.TimerHandle | None = None
        super().__init__(page=window.page(live=True))
        window.listeners.append(self._hear)

    def whole(self) -> dict[str, Any]:
        """The whole view."""
        return self._message(all_of_it := self._window.commands()) | {
            "packed": [packed for _, packed in all_of_it]
        }

    def tell(self) -> None:
        """Send what is new."""
        if self._later is not None:
            self._later.cancel()
        self._later, self._told = None, time.monotonic()
        news, self._news = list(self._news.items()), {}
        self.send(self._message(news), buffers=[packed for _, packed in news])

    def _message(self, commands: list[tuple[Key, bytes]]) -> dict[str, Any]:
        rewards = self._window.rewards
        return {
            "keys": [key for key, _ in commands],
            "rewards": rewards[-KEPT:],
            "count": len(rewards),
        }

    def _hear(self, key: Key, packed: bytes) -> None:
        """Note a command in the place of one that it replaces; send it now, or with the next message."""
        self._news.pop(key, None)
        self._news[key] = packed
        if (
            time.monotonic() - self._told >= PAUSE
        ):  # at once: while a cell runs, the loop calls nothing
            self.tell()
        elif self._later is None:
            try:  # where nothing comes after it, this does
                self._later = asyncio.get_running_loop().call_later(PAUSE, self.tell)
            except RuntimeError:
                self.tell()
