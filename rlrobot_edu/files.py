"""Files: where the toolkit keeps its own, and how it writes them: whole or not at all."""

import errno
import glob
import hashlib
import io
import json
import os
import time
import uuid
import zipfile
from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

T = TypeVar("T")

LARGEST = 256 * 2**20  # file of arrays, packed and unpacked [bytes]; most agents of ten million pairs (s, a) fit in
ABANDONED = 3600  # age of a temporary file that nobody is writing any more [s]


def shipped(folder: str) -> Path:
    """Where the course's `folder` of tasks or datasets is: inside an installed package, or beside it in a checkout."""
    package = Path(__file__).parent
    return package / folder if (package / folder).is_dir() else package.parent / folder


def write_whole(path: str | Path, data: str | bytes) -> None:
    """Write one file whole or not at all; text becomes UTF-8 with its line ends as they are."""
    write_together({path: data})


def write_together(files: Mapping[str | Path, str | bytes]) -> None:
    """Write several files, each whole or not at all, and put them in place in the given order.

    All data is on disk under temporary names before the first old file is replaced, so a full disk or an
    interruption while writing leaves every old file as it was. Missing folders are made. What a killed
    process has left of these files is removed. Raises OSError that names the file.
    """
    temporary: dict[Path, Path] = {}
    is_first_in_place = False
    try:
        for path, data in files.items():
            path = Path(path)
            if path.is_dir():
                raise IsADirectoryError(errno.EISDIR, "this is a folder; give the name of a file", str(path))
            path.parent.mkdir(parents=True, exist_ok=True)
            # The same folder, because a rename is atomic only within one file system.
            temporary[path] = path.with_name(f".{path.name}.{uuid.uuid4().hex}.part")
            with open(temporary[path], "xb") as file:
                file.write(data.encode() if isinstance(data, str) else data)
                file.flush()
                os.fsync(file.fileno())
        for path, part in temporary.items():
            os.replace(part, path)
            is_first_in_place = True
            remove_old(parts_of(path), ABANDONED)  # those of a writer at work are seconds old
    except OSError as error:
        if error.errno is not None and error.filename is None:
            error.filename = str(path)  # a full disk does not say what did not fit
        raise
    finally:
        if not is_first_in_place:  # afterwards, a part that is left completes what has begun
            for part in temporary.values():
                part.unlink(missing_ok=True)


def parts_of(path: Path) -> list[Path]:
    """Temporary files of writers of `path`, at work or killed."""
    return sorted(path.parent.glob(f".{glob.escape(path.name)}.*.part"))


def remove_old(paths: Iterable[Path], age: float) -> None:
    """Remove those of the files that nobody has written or touched for so long [s]."""
    for path in paths:
        with suppress(OSError):  # another process was faster
            if time.time() - path.stat().st_mtime >= age:
                path.unlink()


def sha256(data: bytes) -> str:
    """Fingerprint of `data`: 64 hexadecimal digits."""
    return hashlib.sha256(data).hexdigest()


def fit_in_a_file(arrays: Iterable[np.ndarray], more: float = 0) -> bool:
    """Whether arrays, and so many bytes more, can be saved with headers and read again; packing may add, too."""
    return more + sum(1000 + 1.001 * array.nbytes for array in arrays) <= LARGEST


def save_arrays(
    path: str | Path, kind: str, about: dict[str, Any], arrays: Mapping[str, np.ndarray], packed: bool = True
) -> None:
    """Write arrays, and what JSON can hold `about` them, to one ``.npz`` file, whole or not at all.

    kind: what the file is, such as "agent"; `load_arrays` asks for it; packed: whether it should rather be small than
    quick to write
    """
    buffer = io.BytesIO()
    columns: dict[str, Any] = {"about": np.array(json.dumps({"kind": kind, **about})), **arrays}
    if not fit_in_a_file(columns.values()):
        raise ValueError(f"{path}: one {kind} of more than {LARGEST >> 20} MB would not be read again; make it smaller")
    (np.savez_compressed if packed else np.savez)(buffer, **columns)
    write_whole(path, buffer.getvalue())


def load_arrays(path: str | Path, kind: str, make: Callable[[dict[str, Any], dict[str, np.ndarray]], T]) -> T:
    """What `make` builds of (about, arrays), which `save_arrays` wrote. Nothing is unpickled.

    Raises ValueError if the file is damaged, claims to be huge, is of another kind or not what `make` expects;
    FileNotFoundError if there is none.
    """
    path = Path(path)
    if not path.is_file():
        raise FileNotFoundError(f"{path}: there is no such file of one {kind}")
    if path.stat().st_size > LARGEST:
        raise ValueError(f"{path}: this file is larger than {LARGEST >> 20} MB, so it is not one {kind}")
    data = io.BytesIO(path.read_bytes())
    try:
        with zipfile.ZipFile(data) as archive:
            if sum(entry.file_size for entry in archive.infolist()) > LARGEST:
                raise ValueError(f"it claims to hold more than {LARGEST >> 20} MB")
        with np.load(data, allow_pickle=False) as file:
            arrays = dict(file)
        about = json.loads(str(arrays.pop("about")))
        its_kind = about.pop("kind")
    except Exception as error:  # of a damaged file anything may be the matter
        raise ValueError(f"{path}: this is not a whole file of one {kind} ({error!s:.200}); save it again") from error
    if its_kind != kind:
        raise ValueError(f"{path}: this is the file of one {its_kind!r:.100}, expected one {kind}")
    try:
        return make(about, arrays)
    except Exception as error:
        raise ValueError(
            f"{path}: this {kind} is damaged, or of another version of the toolkit ({error!s:.200}); save it again"
        ) from error
