"""Files of the learner's that the toolkit writes to, too: what it does not understand in them is never lost.

What cannot be read is put aside, under a name beside it that did not exist before, and the learner gets a message.
"""

import errno
import json
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from itertools import count
from pathlib import Path
from typing import Any, TypeVar

from rlrobot_edu.files import write_whole
from rlrobot_grading.answers.values import safely

T = TypeVar("T")

ABANDONED = 10.0  # age of a lock whose holder has been killed [s]; it is held for a few milliseconds


def beside_the_lessons(file: str | Path) -> Path:
    """Where a learner's file lies: beside the lessons, and so for a notebook in `more/` one folder up."""
    path = Path(file)
    folder = path.resolve().parent
    return folder.parent / path.name if folder.name == "more" else path


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
                raise TimeoutError(
                    errno.ETIMEDOUT, "another notebook holds this; remove it", str(lock)
                ) from None
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
    found = {
        name: safely(None, valid, entry)
        for name, entry in (_all_of(beside_the_lessons(path)) or {}).items()
    }
    return {name: entry for name, entry in found.items() if entry is not None}


def enter(path: str | Path, name: str, entry: Any, valid: Callable[[Any], Any]) -> str:
    """Write one entry of a JSON file, and leave all others as they are; returns what the learner should be told.

    A file that is damaged, or whose entry of this name is, is put aside first.
    """
    path = beside_the_lessons(path)
    try:
        with alone_with(path):
            known = _all_of(path)
            is_damaged = known is None or (
                name in known and safely(None, valid, known[name]) is None
            )
            told = put_aside(path) if is_damaged else ""
            text = (
                json.dumps({**(known or {}), name: entry}, indent=1, ensure_ascii=False)
                + "\n"
            )
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
