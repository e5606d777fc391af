"""Files: where the toolkit keeps its own, and writing so that a reader finds the old content or the new, no half."""

import hashlib
import io
import json
import os
import uuid
import zipfile
import zlib
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

T = TypeVar("T")


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
    interruption while writing leaves every old file as it was. Missing folders are made.
    """
    temporary: dict[Path, Path] = {}
    try:
        for path, data in files.items():
            path = Path(path)
            path.parent.mkdir(parents=True, exist_ok=True)
            # The same folder, because a rename is atomic only within one file system.
            temporary[path] = path.with_name(f".{path.name}.{uuid.uuid4().hex}.part")
            with open(temporary[path], "xb") as file:
                file.write(data.encode() if isinstance(data, str) else data)
                file.flush()
                os.fsync(file.fileno())
        for path, part in temporary.items():
            os.replace(part, path)
    finally:
        for part in temporary.values():
            part.unlink(missing_ok=True)


def sha256(data: bytes) -> str:
    """Fingerprint of `data`: 64 hexadecimal digits."""
    return hashlib.sha256(data).hexdigest()


def save_arrays(path: str | Path, kind: str, about: dict[str, Any], arrays: Mapping[str, np.ndarray]) -> None:
    """Write arrays, and what JSON can hold `about` them, to one ``.npz`` file, whole or not at all.

    kind: what the file is, such as "agent"; `load_arrays` asks for it
    """
    buffer = io.BytesIO()
    columns: dict[str, Any] = {"about": np.array(json.dumps({"kind": kind, **about})), **arrays}
    np.savez_compressed(buffer, **columns)
    write_whole(path, buffer.getvalue())


def load_arrays(path: str | Path, kind: str, make: Callable[[dict[str, Any], dict[str, np.ndarray]], T]) -> T:
    """What `make` builds of (about, arrays), which `save_arrays` wrote. Nothing is unpickled.

    Raises ValueError if the file is damaged, of another kind or not what `make` expects, FileNotFoundError if there is
    none.
    """
    try:
        with np.load(path, allow_pickle=False) as file:
            arrays = dict(file)
        about = json.loads(str(arrays.pop("about")))
        its_kind = about.pop("kind")
    except (ValueError, KeyError, TypeError, AttributeError, EOFError, zipfile.BadZipFile, zlib.error) as error:
        raise ValueError(f"{path}: this is not a whole file of one {kind}") from error
    if its_kind != kind:
        raise ValueError(f"{path}: this is the file of one {its_kind}, expected one {kind}")
    try:
        return make(about, arrays)
    except (ValueError, KeyError, TypeError) as error:
        raise ValueError(f"{path}: this {kind} was written by another version of the toolkit") from error
