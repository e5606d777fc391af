"""What a notebook shows of an object: a sentence, a picture, and a widget where a kernel runs."""

import base64
from html import escape
from typing import Any, NamedTuple

# a light card, in the dark theme too: figures are drawn in black on white
_BORDER = "box-sizing: border-box; padding: 6px; background: #fff; border-radius: 8px"
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
        """The picture on a page. It is the only kind of output whose alt text reaches every reader of a notebook."""
        source = address(self.data, self.mime)
        return f'<img alt="{escape(self.alt)}" width="{self.width + 12}" style="{CARD}" src="{source}">'


class Displayed:
    """Shown in a notebook as its `widget`, if it has one, and where no widget lives as its still twin.

    A saved notebook, a page on GitHub and the docs show the still picture, and its sentence for a reader who cannot
    see it.
    """

    widget: Any = None

    def still(self) -> Still | None:
        """The picture to keep; None where there is nothing to see yet."""
        return None

    def _as_html(self) -> str:
        """What a page shows that is not running: the still picture, or the thing in words."""
        still = self.still()
        return still.html if still else f"<p>{escape(repr(self))}</p>"

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> Any:
        """By kind of content, what IPython asks for; with it what Colab must know of a widget, where this is Colab."""
        live = {} if self.widget is None else self.widget._repr_mimebundle_()
        data, metadata = live if isinstance(live, tuple) else (live, {})
        data = {**data, "text/plain": repr(self), "text/html": self._as_html()}
        return (data, metadata) if metadata else data
