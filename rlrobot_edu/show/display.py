"""What a notebook shows of an object: a sentence, a picture, and a widget where a kernel runs."""

import base64
from typing import Any, NamedTuple

Mimebundle = dict[str, Any]  # by kind of content, what IPython asks for


class Still(NamedTuple):
    """A picture as a file.

    alt: a sentence for readers who cannot see it; mime: what kind of file `data` is
    """

    alt: str
    data: bytes
    mime: str = "image/png"


class Displayed:
    """Shown in a notebook as its `widget`, if it has one, and where no widget lives as its still twin.

    A saved notebook, a page on GitHub and the docs show the still picture, and its sentence to whoever cannot see it.
    """

    widget: Any = None

    def still(self) -> Still | None:
        """The picture to keep; None where there is nothing to see yet."""
        return None

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> tuple[Mimebundle, Mimebundle]:
        live = {} if self.widget is None else self.widget._repr_mimebundle_()
        data, still = {**live, "text/plain": repr(self)}, self.still()
        if still is None:
            return data, {}
        return {**data, still.mime: base64.b64encode(still.data).decode("ascii")}, {still.mime: {"alt": still.alt}}
