"""Text files as other programs write them: which encoding they are in is found out."""

from __future__ import annotations

import json
from pathlib import Path

ZIP = b"PK\x03\x04"  # the beginning of an archive, and of a workbook
INVISIBLE = "\0\x1a\ufeff\u200b\u200e\u200f\u2060"  # what programs leave before and behind a text


def text_of(path: str | Path) -> str:
    """The text of a file in UTF-8, in UTF-16 as PowerShell writes it, or else in the Latin letters of Windows.

    Raises OSError, or ValueError if it is a workbook or an archive, or cuts a letter short.
    """
    data = Path(path).read_bytes()
    if data.startswith(ZIP):
        raise ValueError(
            "this is a workbook or an archive: save a list as CSV, and unpack an archive"
        )
    encoding = json.detect_encoding(
        data
    )  # any of Unicode's, with a mark at the beginning or without
    try:
        return data.decode(encoding).strip(INVISIBLE)
    except UnicodeDecodeError as error:
        if encoding != "utf-8":
            raise ValueError(
                f"this begins as {encoding}, but is not: save it anew, as UTF-8 ({error})"
            ) from None
    try:
        return data.decode("cp1252")
    except UnicodeDecodeError:
        return data.decode("latin-1")
