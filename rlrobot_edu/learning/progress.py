"""The progress bar of anything that may take long."""

import io
import os
import sys
from html import escape
from typing import Any

from tqdm import tqdm

if sys.platform == "emscripten":
    tqdm.monitor_interval = 0  # in a browser no thread can watch bars

LOOK = "width: 16em; vertical-align: middle"
WORDS = "{desc}: {percentage:.0f} %, {n_fmt} of {total_fmt}, {elapsed} so far, {remaining} to go"


class Interrupted(KeyboardInterrupt):
    """Ctrl-C, which a notebook shows in one line."""

    def _render_traceback_(self) -> list[str]:
        return [str(self)]


class NotebookBar(tqdm):  # type: ignore[misc]  # tqdm has no types
    """A bar in a notebook, made of HTML; when it closes, its output is empty.

    tqdm's own bar for notebooks is a widget. Its view stays in the notebook when the widget is gone, and shows an error
    when the saved notebook is opened again.
    """

    def __init__(self, **about: Any) -> None:
        self._output: Any = None
        super().__init__(file=io.StringIO(), bar_format=WORDS, **about)

    def display(self, msg: str | None = None, pos: int | None = None) -> None:
        """Show how far it is; an empty `msg` is tqdm's way to say that the bar has closed."""
        if msg == "":
            self._show({"text/html": "", "text/plain": ""})
            return
        words = str(self)
        shown = escape(words)
        bar = f'<progress max="{self.total}" value="{self.n}" aria-label="{shown}" style="{LOOK}"></progress>'
        self._show({"text/html": f"{bar} {shown}", "text/plain": words})

    def _show(self, content: dict[str, str]) -> None:
        from IPython.display import display

        if self._output is None:
            self._output = display(content, raw=True, display_id=True)  # type: ignore[no-untyped-call]
        else:
            self._output.update(content, raw=True)


def watched() -> bool:
    """Whether somebody may be watching. Not if RLROBOT_EDU_PROGRESS is 0, as when notebooks are run to be saved."""
    return os.environ.get("RLROBOT_EDU_PROGRESS") != "0"


def progress_bar(total: int, shown: bool, delay: float = 1, **about: Any) -> Any:
    """A progress bar that appears after `delay` seconds and leaves nothing behind.

    It stays hidden if it is not `shown`, or if nobody is watching.
    """
    is_shown = shown and watched()
    bar = NotebookBar if is_shown and in_a_notebook() else tqdm
    return bar(total=total, delay=delay, leave=False, disable=not is_shown, **about)


def in_a_notebook() -> bool:
    """Whether this Python is the kernel of a notebook, in a browser, too."""
    if sys.modules.get("IPython") is None:
        return False
    from IPython import get_ipython

    return getattr(get_ipython(), "kernel", None) is not None
