"""The widget that shows a page in a frame and tells it what is new; frame.js is its other half."""

import asyncio
import time
from collections.abc import Callable
from importlib.resources import files
from typing import Any

import anywidget
import ipywidgets
import traitlets

PAUSE = 0.05  # between two messages [s]; what comes meanwhile goes with the next


class CarriedPage(anywidget.AnyWidget):
    """A page in a frame.

    page: its HTML; so_far: tells what has come after a number of things, with the ``count`` of all
    """

    _esm = files(__package__).joinpath("frame.js").read_text(encoding="utf-8")
    _repr_mimebundle_ = ipywidgets.DOMWidget._repr_mimebundle_  # anywidget's is a tuple
    page = traitlets.Unicode().tag(sync=True)
    news = traitlets.Dict().tag(sync=True)

    def __init__(self, page: str, so_far: Callable[[int], dict[str, Any]]) -> None:
        first = so_far(0)
        super().__init__(page=page, news=first)
        self._so_far, self._count, self._told = so_far, first["count"], 0.0
        self._later: asyncio.TimerHandle | None = None

    def tell(self, *, at_once: bool = False) -> None:
        """Send what is new, or leave it to the next message if the last one was just sent."""
        if at_once or time.monotonic() - self._told >= PAUSE:
            self._send_news()
        elif self._later is None:
            try:  # where nothing comes after it, this does
                self._later = asyncio.get_running_loop().call_later(PAUSE, self._send_news)
            except RuntimeError:
                self._send_news()

    def _send_news(self) -> None:
        if self._later is not None:
            self._later.cancel()
        news = self._so_far(self._count)
        self._later, self._count, self._told = None, news["count"], time.monotonic()
        self.send(news)
