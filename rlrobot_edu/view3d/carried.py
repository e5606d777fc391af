"""A live view that the notebook's own connection carries, so that it is seen wherever the notebook is."""

import asyncio
import time
from typing import Any

import anywidget
import traitlets

from rlrobot_edu.view3d.window import LiveWindow, page

PAUSE = 0.05  # between two messages [s]; what comes meanwhile goes with the next
# All that has come is kept for views that are opened later, also while the kernel is busy or when it has ended.
_FRAME = """
const told = { room: null, frames: [], closed: false };
function keep({ room, frames, closed }) {
  if (room) Object.assign(told, { room, frames: [] });
  told.frames = [...told.frames, ...frames].slice(-2000);
  told.closed = closed;
}
export default {
  initialize({ model }) {
    keep(model.get("news"));
    model.on("msg:custom", keep);
  },
  render({ model, el }) {
    const frame = Object.assign(document.createElement("iframe"), { title: "Live 3D view of the robot" });
    frame.sandbox = "allow-scripts"; // no script of it reaches the notebook around it
    frame.style = "width: 100%; height: 480px; border: 0; color-scheme: light";
    frame.srcdoc = model.get("page");
    const pass = (news) => frame.contentWindow?.postMessage(news, "*");
    const answer = ({ source }) => { if (source === frame.contentWindow) pass(told); };
    addEventListener("message", answer);
    model.on("msg:custom", pass);
    el.append(frame);
    return () => {
      removeEventListener("message", answer);
      model.off("msg:custom", pass);
    };
  },
};
"""


class CarriedView(anywidget.AnyWidget):
    """The page of a live view in a frame; `tell` sends it what is new in `window`."""

    _esm = _FRAME
    page = traitlets.Unicode().tag(sync=True)
    news = traitlets.Dict().tag(sync=True)

    def __init__(self, window: LiveWindow) -> None:
        first = window.so_far(0)
        super().__init__(page=page("Live 3D view", {"live": "carried"}), news=first)
        self._window, self._count, self._told = window, first["count"], 0.0
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
        news = self._window.so_far(self._count)
        self._later, self._count, self._told = None, news["count"], time.monotonic()
        self.send(news)

    def _repr_mimebundle_(self, **kinds: Any) -> dict[str, Any]:
        """As other widgets have it, without what anywidget says beside it."""
        bundle: dict[str, Any] = super()._repr_mimebundle_(**kinds)[0]
        return bundle
