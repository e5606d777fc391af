"""An idea that the reader moves: live in a notebook, as a page of its own, and as a still."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cached_property
from importlib.resources import files
from pathlib import Path
from typing import Any

from rlrobot_edu.files import write_whole
from rlrobot_edu.jupyter import anywidget, traitlets
from rlrobot_edu.show.display import Displayed, Still
from rlrobot_edu.show.picture import Picture
from rlrobot_edu.show.room.tokens import look
from rlrobot_edu.widgets.javascript.program import program as kernels_script
from rlrobot_edu.widgets.page_file import page_html, read_text

_SHOW = """
function standalone(feed, place) {
  mount(handle, feed, place);
}
"""
_RENDER = """
export default {
  render({ model, el }) {
    return mount(handle, model.get("feed"), el);
  },
};
"""


class Handle(Displayed):
    """A picture that the reader moves; a saved notebook keeps a still of its opening.

    name: what it shows, in a few words
    folder: the package in which the program lies, such as ``rlrobot_course.lesson_02``
    program: names of its files, such as ``["gamma.js"]``; the last one defines ``handle``, see kit.js
    feed: the numbers that the program is given, as JSON has them
    picture: the still, with a sentence for readers who cannot see it
    kernels: functions of Python that the program calls, translated, as ``kernels.NAME``
    """

    def __init__(
        self,
        name: str,
        folder: str,
        program: list[str],
        feed: dict[str, Any],
        picture: Picture,
        kernels: Mapping[str, Callable[..., Any]] | None = None,
    ) -> None:
        self.name = name
        self.feed = feed
        self.picture = picture
        self._folder = folder
        self._program = program
        self._kernels = kernels or {}

    def __repr__(self) -> str:
        return f"<Handle: {self.name}>"

    @cached_property
    def script(self) -> str:
        """The program with all that it needs."""
        own = [files(self._folder).joinpath(name) for name in self._program]
        shared = [files(__package__).joinpath(name) for name in ("marks.js", "kit.js")]
        texts = [
            read_text("stepper/page/numerals.js"),
            *[path.read_text("utf-8") for path in shared],
            f"const kernels = {kernels_script(self._kernels)};",
            *[path.read_text("utf-8") for path in own],
        ]
        return "\n".join(texts)

    def save(self, path: str | Path) -> None:
        """Write it to a page that any browser opens, without a kernel and a network, whole or not at all.

        Raises ValueError if the file's name ends like that of another kind of file, OSError if it cannot be written.
        """
        page = page_html(
            self.name, self.picture.alt, self.feed, self.script + _SHOW, style()
        )
        write_whole(path, page)

    def still(self) -> Still:
        """The picture of its opening."""
        return self.picture.still()

    @cached_property
    def widget(self) -> HandleWidget:
        """What a running notebook shows."""
        return HandleWidget(self.script, self.feed)


class HandleWidget(anywidget.AnyWidget):
    """A view of a handle; what the reader moves stays on the page.

    feed: see `Handle`
    """

    feed = traitlets.Dict().tag(sync=True)

    def __init__(self, script: str, feed: dict[str, Any]) -> None:
        self._esm = script + _RENDER
        self._css = style()
        super().__init__(feed=feed)


def style() -> str:
    """How all handles look."""
    return look() + files(__package__).joinpath("style.css").read_text("utf-8")
