"""Files: where the toolkit keeps its own, and how it writes them: whole or not at all."""

import errno
import glob
import hashlib
import io
import json
import os
import re
import stat
import time
import uuid
import zipfile
from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

T = TypeVar("T")

# file of arrays, packed and unpacked [bytes]; most agents of ten million pairs (s, a) fit in
LARGEST = 256 * 2**20
# How files of some kinds begin. A file whose name promises another kind than it holds helps nobody.
BEGINNINGS = {
    ".npz": rb"PK",
    ".gif": rb"GIF8",
    ".png": rb"\x89PNG",
    ".html": rb"\s*<",
    ".json": rb"\s*[\[{]",
}
BEGINNINGS |= {
    ".csv": rb"(?!PK|GIF8|\x89PNG|PAR1|\s*<)",
    ".mp4": rb"....ftyp",
}  # csv: not as what is no text
# What the system says too shortly where a file cannot be written
BLOCKED = {
    errno.EACCES: "not writable; choose a folder of your own",
    errno.ENOTDIR: "part of it is a file",
}
SHORT = 40  # characters of a file's name in that of its temporary one, which must not become too long
ABANDONED = 3600  # age of a temporary file that nobody is writing any more [s]


def shipped(folder: str) -> Path:
    """Where the course's `folder` of tasks or datasets is: inside an installed package, or beside it in a checkout."""
    package = Path(__file__).parent
    return package / folder if (package / folder).is_dir() else package.parent / folder


def write_whole(path: str | Path, data: str | bytes) -> None:
    """Write one file whole or not at all, see `write_together`; text becomes UTF-8 with its line ends as they are."""
    write_together({path: data})


def write_together(files: Mapping[str | Path, str | bytes]) -> None:
    """Write several files, each whole or not at all, and put them in place in the given order.

    All data is on disk under temporary names before the first old file is replaced, so a full disk or an
    interruption while writing leaves every old file as it was. Missing folders are made. Old temporary files
    of these names, from processes that were killed, are removed.

    A link is followed. The new file has the mode of the old one, and belongs to who writes it; other names of the old
    one (hard links) keep the old content. A device, or a pipe that somebody reads, is written to as it is.

    Raises OSError that names the file, for root also if it is read-only; ValueError if the file's ending belongs to
    another kind of file.
    """
    temporary: dict[Path, Path] = {}
    is_first_in_place = False
    try:
        for path, data in files.items():
            data = data.encode() if isinstance(data, str) else data
            fits = [
                ending
                for ending, beginning in BEGINNINGS.items()
                if re.match(beginning, data)
            ]
            if Path(path).suffix in BEGINNINGS.keys() - fits:
                raise ValueError(
                    f"{path}: its content is no {Path(path).suffix} but {' or '.join(fits)}"
                )
            old = _what_is_at(Path(path))
            if old and not stat.S_ISREG(old.st_mode):
                # Not to wait for ever where nobody reads a pipe; once somebody does, he may take his time.
                with open(
                    os.open(path, os.O_WRONLY | getattr(os, "O_NONBLOCK", 0)), "wb"
                ) as file:
                    os.set_blocking(file.fileno(), True)
                    file.write(data)
                continue
            place = Path(os.path.realpath(path))
            place.parent.mkdir(parents=True, exist_ok=True)
            # The same folder, because a rename is atomic only within one file system.
            part = place.with_name(f".{place.name[:SHORT]}.{uuid.uuid4().hex}.part")
            temporary[part] = place
            with open(part, "xb") as file:
                if old:
                    part.chmod(stat.S_IMODE(old.st_mode))
                file.write(data)
                file.flush()
                os.fsync(file.fileno())
        for part, place in temporary.items():
            os.replace(part, place)
            is_first_in_place = True
            remove_old(
                parts_of(place), ABANDONED
            )  # those of a writer at work are seconds old
    except OSError as error:
        if error.errno is not None and (
            error.filename is None or str(error.filename).endswith(".part")
        ):
            error.filename = str(path)  # a full disk does not say what did not fit
        error.strerror = BLOCKED.get(error.errno or 0, error.strerror)
        raise
    finally:
        if (
            not is_first_in_place
        ):  # afterwards, a part that is left completes what has begun
            remove_old(
                temporary, -float("inf")
            )  # of any age; what is not there, or cannot go, is no fault here


def _what_is_at(path: Path) -> os.stat_result | None:
    """What is known of a file to be written; None if there is none. Raises OSError for a folder or a protected file."""
    try:
        old = path.stat()
    except FileNotFoundError:
        return None
    if stat.S_ISDIR(old.st_mode):
        raise IsADirectoryError(
            errno.EISDIR, "this is a folder; give the name of a file", str(path)
        )
    # root may write everywhere, but had better not
    if not old.st_mode & 0o222 or not os.access(path, os.W_OK):
        raise PermissionError(
            errno.EPERM, "protected from writing; give another name", str(path)
        )
    return old


def parts_of(path: Path) -> list[Path]:
    """Temporary files of those who are writing `path`, which is no link, or were killed as they wrote."""
    return sorted(path.parent.glob(f".{glob.escape(path.name[:SHORT])}.*.part"))


def remove_old(paths: Iterable[Path], age: float) -> None:
    """Remove those of the files that nobody has written or touched for so long [s]."""
    for path in paths:
        with suppress(OSError):  # another process was faster
            if time.time() - path.stat().st_mtime >= age:
                path.unlink()


def sha256(data: bytes) -> str:
    """Fingerprint of `data`: 64 hexadecimal digits."""
    return hashlib.sha256(data).hexdigest()


def save_arrays(
    path: str | Path,
    kind: str,
    about: dict[str, Any],
    arrays: Mapping[str, np.ndarray],
    packed: bool = True,
) -> None:
    """Write arrays, and what JSON can hold `about` them, to one ``.npz`` file, whole or not at all.

    kind: what the file is, such as "agent"; `load_arrays` asks for it; packed: whether it should rather be small than
    quick to write
    """
    buffer = io.BytesIO()
    text = json.dumps(
        {"kind": kind, **about}, default=np.generic.item
    )  # NumPy's numbers become Python's
    columns: dict[str, Any] = {"about": np.array(text), **arrays}
    if (
        sum(1000 + 1.001 * array.nbytes for array in columns.values()) > LARGEST
    ):  # headers; packing may add, too
        raise ValueError(
            f"{path}: more than {LARGEST >> 20} MB of one {kind} would not be read again"
        )
    (np.savez_compressed if packed else np.savez)(buffer, **columns)
    write_whole(path, buffer.getvalue())


def load_arrays(
    path: str | Path,
    kind: str,
    make: Callable[[dict[str, Any], dict[str, np.ndarray]], T],
) -> T:
    """What `make` builds of (about, arrays), which `save_arrays` wrote. Nothing is unpickled.

    Raises ValueError if the file is damaged, claims to be huge, is of another kind or not what `make` expects;
    FileNotFoundError if there is none.
    """
    path = Path(path)
    if not path.is_file():
        raise FileNotFoundError(f"{path}: there is no such file of one {kind}")
    try:
        with zipfile.ZipFile(path) as archive:
            claimed = sum(entry.file_size for entry in archive.infolist())
        if max(claimed, path.stat().st_size) > LARGEST:
            raise ValueError(f"it claims to hold more than {LARGEST >> 20} MB")
        with np.load(path, allow_pickle=False) as file:
            arrays = dict(file)
        about = json.loads(str(arrays.pop("about")))
        if (its_kind := about.pop("kind")) != kind:
            raise ValueError(f"it is the file of one {its_kind!r:.100}")
        return make(about, arrays)
    except Exception as error:  # a damaged file may raise anything
        fault = f"this {kind} is damaged, or of another version of the toolkit ({error!s:.200})"
        raise ValueError(f"{path}: {fault}; save it again") from error
