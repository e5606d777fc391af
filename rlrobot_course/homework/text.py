"""Small text files as other programs write them: which encoding they are in is found out."""

from __future__ import annotations

import codecs
from pathlib import Path

MARKS = {codecs.BOM_UTF8: "utf-8-sig", codecs.BOM_UTF16_LE: "utf-16", codecs.BOM_UTF16_BE: "utf-16"}


def text_of(path: str) -> str:
    """The text of a file in UTF-8, in UTF-16 as PowerShell writes it, or else in the Latin letters of Windows.

    Raises OSError, or ValueError if it is a workbook or an archive, or cuts a letter short.
    """
    data = Path(path).read_bytes()
    if data.startswith(b"PK\x03\x04"):
        raise ValueError(f"{path} is a workbook or an archive, not a text: save the list as CSV")
    encoding = next((name for mark, name in MARKS.items() if data.startswith(mark)), "")
    if not encoding and b"\0" in data[:200]:  # every other byte of UTF-16 is 0, of the heading's letters at least
        encoding = "utf-16-be" if data[:1] == b"\0" else "utf-16-le"
    if encoding:
        try:
            return data.decode(encoding)
        except UnicodeDecodeError as error:
            raise ValueError(f"{path} begins as {encoding}, but is not: save it anew, as UTF-8 ({error})") from None
    for encoding in ("utf-8", "cp1252"):
        try:
            return data.decode(encoding)
        except UnicodeDecodeError:
            continue
    return data.decode("latin-1")
