"""A page in a frame of a notebook; the frame is as high as the page and gives it the notebook's colours."""

from __future__ import annotations

from importlib.resources import files
from typing import Any

from rlrobot_edu.jupyter import anywidget, traitlets

_SHOW = """
export default {
  render({ model, el }) {
    const frame = document.createElement("iframe");
    frame.setAttribute("sandbox", "allow-scripts");
    Object.assign(frame, { title: model.get("title"), srcdoc: model.get("page") });
    Object.assign(frame.style, { width: "100%", height: "900px", border: 0 });
    el.append(frame);
    return hostPlayground(frame);
  },
};
"""


class PageFrame(anywidget.AnyWidget):
    """A page in a frame; its scripts run, but do not reach the notebook.

    page: its HTML; title: for readers who cannot see it
    """

    page = traitlets.Unicode().tag(sync=True)
    title = traitlets.Unicode().tag(sync=True)

    def __init__(self, **values: Any) -> None:
        host_page = files(__package__) / "host_page.js"
        self._esm = host_page.read_text("utf-8") + _SHOW
        super().__init__(**values)
