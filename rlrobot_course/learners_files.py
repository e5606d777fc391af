"""Files of the learner's that the toolkit writes to, too: what it does not understand in them is never lost.

What cannot be read is put aside, under a name beside it that did not exist before, and the learner is told.
"""

import codecs
import errno
import io
import json
import time
import tokenize
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from itertools import count
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

from rlrobot_course.grading.values import safely
from rlrobot_edu.files import write_whole

T = TypeVar("T")

ABANDONED = 10.0  # age of a lock whose holder has been killed [s]; it is held for a few milliseconds
MARKS = {  # at the beginning of a file; those of UTF-32 first, for they begin as those of UTF-16 do
    codecs.BOM_UTF32_LE: "utf-32-le", codecs.BOM_UTF32_BE: "utf-32-be", codecs.BOM_UTF8: "utf-8",
    codecs.BOM_UTF16_LE: "utf-16-le", codecs.BOM_UTF16_BE: "utf-16-be",
}  # fmt: skip


class Text(NamedTuple):
    """The text of a file, with what is needed to write it as it was: its encoding, and the mark in front of it."""

    text: str
    encoding: str = "utf-8"
    mark: bytes = b""

    @classmethod
    def of(cls, data: bytes) -> "Text | None":
        """The text of these bytes in the encoding that they declare; None where it is no text.

        What is not UTF-8 and declares nothing is taken for Latin-1, whose 256 characters are the 256 bytes.
        """
        mark = next((mark for mark in MARKS if data.startswith(mark)), b"")
        wanted = (
            MARKS[mark] if mark else safely("utf-8", lambda: tokenize.detect_encoding(io.BytesIO(data).readline)[0])
        )
        for encoding, before in ((wanted, mark), ("latin-1", b"")):
            text = safely(None, data[len(before) :].decode, encoding)
            if text is not None and "\0" not in text and safely(b"", text.encode, encoding) == data[len(before) :]:
                return cls(text, encoding, before)
        return None

    def data(self) -> bytes:
        """The bytes of the file. Raises ValueError if a character is not in its encoding."""
        try:
            return self.mark + self.text.encode(self.encoding)
        except UnicodeEncodeError as error:
            sign = error.object[error.start]
            raise ValueError(
                f"its encoding {self.encoding} has no {sign!r}; save it as UTF-8, and check again"
            ) from None


def put_aside(path: Path) -> str:
    """Copy a file to a name beside it that did not exist before; returns a sentence that says so."""
    for n in count(1):
        copy = path.with_name(f"{path.stem}.old{n if n > 1 else ''}{path.suffix}")
        with suppress(FileExistsError), copy.open("xb") as file:
            file.write(path.read_bytes())
            return f"What {path.name} was until now is in {copy.name}."
    raise AssertionError("there is always another number")


@contextmanager
def alone_with(path: Path) -> Iterator[None]:
    """Have all other notebooks wait that want to change the same file. Raises OSError if none may be changed here."""
    lock, begun = path.with_name(f".{path.name}.lock"), time.monotonic()
    path.parent.mkdir(parents=True, exist_ok=True)
    while True:
        try:
            lock.mkdir()
            break
        except FileExistsError:
            if time.monotonic() - begun > 2 * ABANDONED:
                raise TimeoutError(errno.ETIMEDOUT, "another notebook holds this; remove it", str(lock)) from None
            with suppress(OSError):  # another one was faster
                if time.time() - lock.stat().st_mtime > ABANDONED:
                    lock.rmdir()
            time.sleep(0.01)
    try:
        yield
    finally:
        with suppress(OSError):
            lock.rmdir()


def entries(path: str | Path, valid: Callable[[Any], T]) -> dict[str, T]:
    """The entries of a JSON file, by name; those that are missing or damaged are left out.

    valid: makes of an entry what it should be; raises for a damaged one
    """
    found = {name: safely(None, valid, entry) for name, entry in (_all_of(Path(path)) or {}).items()}
    return {name: entry for name, entry in found.items() if entry is not None}


def enter(path: str | Path, name: str, entry: Any, valid: Callable[[Any], Any]) -> str:
    """Write one entry of a JSON file, and leave all others as they are; returns what the learner should be told.

    A file that is damaged, or whose entry of this name is, is put aside first.
    """
    path = Path(path)
    try:
        with alone_with(path):
            known = _all_of(path)
            is_damaged = known is None or (name in known and safely(None, valid, known[name]) is None)
            told = put_aside(path) if is_damaged else ""
            text = json.dumps({**(known or {}), name: entry}, indent=1, ensure_ascii=False) + "\n"
            write_whole(path, text.encode("utf-8", "surrogatepass"))
    except OSError as error:
        return f"{path.name} cannot be written: {error}."
    return told


def _all_of(path: Path) -> dict[str, Any] | None:
    """All entries of a JSON file, by name; none where there is no file; None where it is damaged."""
    if not path.exists():
        return {}
    known = safely(None, lambda: json.loads(path.read_bytes()))
    return known if isinstance(known, dict) else None
