"""What a notebook shows of an object: a sentence, a picture, and a widget where a kernel runs."""

import base64
from html import escape
from typing import Any, NamedTuple

from rlrobot_edu.show.palette import WHITE

# A light card, also on a dark page, because figures are drawn in black on white
_BORDER = (
    f"box-sizing: border-box; padding: 6px; background: {WHITE}; border-radius: 8px"
)
CARD = f"max-width: 100%; height: auto; {_BORDER}"


def address(data: bytes, mime: str) -> str:
    """The address of a file of this kind for a page that holds the file itself."""
    return f"data:{mime};base64,{base64.b64encode(data).decode('ascii')}"


class Still(NamedTuple):
    """A picture as a file.

    alt: a sentence for readers who cannot see it; width: on the page [pixels of a page], data may hold more
    mime: what kind of file `data` is
    """

    alt: str
    data: bytes
    width: int
    mime: str = "image/png"

    @property
    def html(self) -> str:
        """The picture on a page. No other kind of output gives its alt text to every reader of a notebook."""
        source = address(self.data, self.mime)
        return f'<img alt="{escape(self.alt)}" width="{self.width + 12}" style="{CARD}" src="{source}">'


class Displayed:
    """Shown in a notebook as its `widget`, if it has one, and as a still picture wherever widgets do not run.

    A saved notebook, a page on GitHub and the docs show the still picture, with its sentence for a reader who cannot
    see it.
    """

    widget: Any = None

    def still(self) -> Still | None:
        """The picture to keep; None if there is nothing to see yet."""
        return None

    def _as_html(self) -> str:
        """What a page without a kernel shows: the still picture, or the object in words."""
        still = self.still()
        return still.html if still else f"<p>{escape(repr(self))}</p>"

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> Any:
        """The contents for IPython, by their kind; on Colab with the metadata that its widgets need."""
        live: Any = {}
        if self.widget is not None:
            live = self.widget._repr_mimebundle_()
        data, metadata = live if isinstance(live, tuple) else (live, {})
        data = {**data, "text/plain": repr(self), "text/html": self._as_html()}
        return (data, metadata) if metadata else data
