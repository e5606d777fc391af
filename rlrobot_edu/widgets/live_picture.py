"""A picture that follows a slider: at once as a draft, and once the slider rests as a fine one."""

from __future__ import annotations

import asyncio
from collections.abc import Callable

import ipywidgets

from rlrobot_edu.show.display import Still
from rlrobot_edu.show.picture import DPI, Picture

REST = (
    0.4  # so long must a slider stay where it is before the fine picture is drawn [s]
)


class LivePicture:
    """The place of a picture on the page, which `draw` draws anew at every `update`.

    A page sends the next place of a slider only once the last one has been answered, so the draft keeps up with it.

    widget: shows the picture, with its alt text
    """

    def __init__(self, draw: Callable[[], Picture]) -> None:
        self._draw = draw
        self.widget = ipywidgets.HTML()
        self._rest: asyncio.TimerHandle | None = None
        self._figure = draw()
        self._show_fine()

    def update(self) -> None:
        """Draw it anew; outside a notebook, where nothing runs later, the fine one at once."""
        if self._rest is not None:
            self._rest.cancel()
        self._figure = self._draw()
        try:
            loop = asyncio.get_running_loop()
        except RuntimeError:
            self._show_fine()
            return
        draft = Still(
            self._figure.alt,
            self._figure.png(0.8 * DPI),
            round(DPI * self._figure.get_figwidth()),
        )
        self.widget.value = draft.html
        self._rest = loop.call_later(REST, self._show_fine)

    def still(self) -> Still:
        """The picture as it is now."""
        return self._figure.still()

    def _show_fine(self) -> None:
        self.widget.value = self.still().html
