"""Figures that also say in words what they show."""

from __future__ import annotations

import base64
import io

from matplotlib.figure import Figure


class Picture(Figure):
    """A matplotlib figure whose notebook output carries `alt`, a sentence for readers who cannot see it."""

    alt = "A figure"

    def png(self, dpi: float = 90) -> bytes:
        """The picture as a PNG file."""
        buffer = io.BytesIO()
        self.savefig(buffer, format="png", dpi=dpi)
        return buffer.getvalue()

    def _repr_mimebundle_(self, include=None, exclude=None) -> tuple[dict, dict]:
        data = {"text/plain": f"<Picture: {self.alt}>", "image/png": base64.b64encode(self.png()).decode("ascii")}
        return data, {"image/png": {"alt": self.alt}}
