"""Files: where the toolkit keeps its own, and how it writes them: whole or not at all."""

import errno
import glob
import hashlib
import io
import json
import math
import os
import re
import shutil
import stat
import time
import uuid
import zipfile
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
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
    ".csv": rb"(?!PK|GIF8|\x89PNG|PAR1|\s*<)",  # not as what is no text
    ".mp4": rb"....ftyp",
}
# Where the message of the system is too short
ADVICE = {
    errno.EACCES: "not writable; choose a folder of your own",
    errno.ENOTDIR: "part of it is a file",
}
SHORT = 40  # characters of a file's name in that of its temporary one, which must not become too long
ABANDONED = 3600  # age of a temporary file that nobody is writing any more [s]


def shipped(name: str) -> Path:
    """Where a folder or file of the repository's root is: inside an installed package, or beside it in a checkout."""
    package = Path(__file__).parent
    return package / name if (package / name).exists() else package.parent / name


def check_path(path: object) -> Path:
    """`path` as a Path. Raises ValueError unless it is one, or a text."""
    if not isinstance(path, str | os.PathLike):
        raise ValueError(
            f"a file or folder is given by its name or Path, got {path!r:.200}"
        )
    return Path(path)


def write_whole(path: str | Path, data: str | bytes) -> None:
    """Write one file whole or not at all, see `write_together`."""
    write_together({check_path(path): data})


def write_together(files: Mapping[str | Path, str | bytes]) -> None:
    """Write several files, each whole or not at all, and put them in place in the given order.

    All data is on disk under temporary names before the first old file is replaced, so a full disk or an
    interruption while writing leaves every old file as it was. Text becomes UTF-8 with its line ends as they are.
    Missing folders are made. Old temporary files of these names, from processes that were killed, are removed.

    A link is followed. The new file has the mode of the old one, and belongs to who writes it; other names of the old
    one (hard links) keep the old content.

    Raises OSError that names the file if it cannot be written, is read-only (for root, too), a folder, a device or a
    pipe; ValueError if the file's ending belongs to another kind of file.
    """
    places: dict[Path, Path] = {}  # where each temporary file goes
    is_first_in_place = False
    try:
        for path, data in files.items():
            if isinstance(data, str):
                data = data.encode()
            _check_ending(Path(path), data)
            with _errors_name(path):
                _check_replaceable(Path(path))
                place = Path(os.path.realpath(path))
                place.parent.mkdir(parents=True, exist_ok=True)
                # The same folder, because a rename is atomic only within one file system.
                part = place.with_name(f".{place.name[:SHORT]}.{uuid.uuid4().hex}.part")
                places[part] = place
                _write_part(part, place, data)
        for part, place in places.items():
            with _errors_name(place):
                part.replace(place)
            is_first_in_place = True
            remove_old(parts_of(place), ABANDONED)
    finally:
        # Once a file is in place, a part that is left completes what has begun.
        if not is_first_in_place:
            remove_old(places, age=-math.inf)


def _check_ending(path: Path, data: bytes) -> None:
    """Raises ValueError if the name ends as those of another kind of file."""
    kinds = [kind for kind, begins in BEGINNINGS.items() if re.match(begins, data)]
    if path.suffix in BEGINNINGS and path.suffix not in kinds:
        raise ValueError(
            f"{path}: its content is no {path.suffix} but {' or '.join(kinds)}"
        )


def _check_replaceable(path: Path) -> None:
    """Raises OSError if what is at `path` is no file, or must not be replaced."""
    try:
        mode = path.stat().st_mode
    except FileNotFoundError:
        return
    if stat.S_ISDIR(mode):
        fault, advice = errno.EISDIR, "this is a folder; give the name of a file"
        raise IsADirectoryError(fault, advice, str(path))
    if not stat.S_ISREG(mode):
        advice = "this is a device or a pipe; give the name of a file"
        raise OSError(errno.EINVAL, advice, str(path))
    is_read_only = not mode & 0o222
    # root may write everywhere, but had better not
    if is_read_only or not os.access(path, os.W_OK):
        fault, advice = errno.EPERM, "protected from writing; give another name"
        raise PermissionError(fault, advice, str(path))


def _write_part(part: Path, place: Path, data: bytes) -> None:
    """Write the temporary file `part`, with the mode of the file that it will replace."""
    with open(part, "xb") as file:
        if place.exists():
            shutil.copymode(place, part)
        file.write(data)
        file.flush()
        os.fsync(file.fileno())


@contextmanager
def _errors_name(path: str | Path) -> Iterator[None]:
    """An OSError names this file, not its temporary one; a full disk would name none."""
    try:
        yield
    except OSError as error:
        if error.errno is not None:
            error.filename = str(path)
            error.strerror = ADVICE.get(error.errno, error.strerror)
        raise


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
    # NumPy's numbers become Python's
    text = json.dumps({"kind": kind, **about}, default=np.generic.item)
    columns: dict[str, Any] = {"about": np.array(text), **arrays}
    # each has a header, and packing may add a thousandth
    size = sum(1000 + 1.001 * array.nbytes for array in columns.values())
    if size > LARGEST:
        raise ValueError(
            f"{path}: this {kind} is larger than a file may be, {LARGEST >> 20} MB"
        )
    buffer = io.BytesIO()
    save = np.savez_compressed if packed else np.savez
    save(buffer, **columns)
    write_whole(path, buffer.getvalue())


def load_arrays(
    path: str | Path,
    kind: str,
    make: Callable[[dict[str, Any], dict[str, np.ndarray]], T],
) -> T:
    """What `make` builds of (about, arrays), which `save_arrays` wrote. Reading it unpickles nothing.

    Raises ValueError if the file is damaged, claims to be huge, is of another kind or not what `make` expects;
    FileNotFoundError if there is none.
    """
    path = check_path(path)
    if not path.is_file():
        raise FileNotFoundError(f"{path}: there is no such {kind} file")
    try:
        with zipfile.ZipFile(path) as archive:
            claimed = sum(entry.file_size for entry in archive.infolist())
            names = archive.namelist()
        if len(set(names)) < len(names):
            raise ValueError("it holds two arrays of one name")
        if max(claimed, path.stat().st_size) > LARGEST:
            raise ValueError(f"it claims to hold more than {LARGEST >> 20} MB")
        with np.load(path, allow_pickle=False) as file:
            arrays = dict(file)
        about = json.loads(str(arrays.pop("about")))
        its_kind = about.pop("kind")
        if its_kind != kind:
            raise ValueError(f"it holds {its_kind!r:.100}, not {kind!r}")
        return make(about, arrays)
    except Exception as error:  # a damaged file may raise anything
        fault = f"this {kind} is damaged, or of another version of the toolkit ({error!s:.200})"
        raise ValueError(f"{path}: {fault}; save it again") from error
