"""Text files as spreadsheets and editors write them."""

from __future__ import annotations

from pathlib import Path

INVISIBLE = "\0\ufeff\u200b"  # what programs leave before and behind a text


def text_of(path: str | Path) -> str:
    """Return the text of a file in UTF-8, or else in the Latin letters of Windows. Raises OSError."""
    data = Path(path).read_bytes()
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError:
        text = data.decode("cp1252", errors="replace")
    return text.strip(INVISIBLE)
