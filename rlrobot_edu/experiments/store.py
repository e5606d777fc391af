"""A folder in which finished repetitions stay: an experiment that was cut off goes on where it was."""

import hashlib
import io
import json
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from rlrobot_edu.experiments.runs import from_columns, to_columns
from rlrobot_edu.files import sha256, write_whole
from rlrobot_edu.learning.history import History
from rlrobot_edu.learning.size import Size

ABOUT = "store.json"


class Store:
    """The repetitions of one experiment on disk: ``store.json`` says of which, every ``.npz`` file holds a few.

    folder: where; it is made if there is none
    facts: what the experiment is, by name, all of it text and numbers
    size: of the world

    The name of a file is ``method-first-fingerprint.npz``: the position of its method in ``store.json``, the number of
    its first repetition, and the beginning of the SHA-256 of its content. It appears under this name once it is whole.
    Raises ValueError if the folder holds something else, or another experiment; it says what differs.
    """

    def __init__(self, folder: str | Path, facts: dict[str, Any], size: Size) -> None:
        self.folder, self._size = Path(folder), size
        facts = json.loads(json.dumps(facts))
        about = self.folder / ABOUT
        if about.is_file():
            self._compare(about, facts)
        elif self.folder.is_dir() and any(self.folder.iterdir()):
            raise ValueError(f"{self.folder}: this folder holds other files and no {ABOUT}; give store= a new folder")
        else:
            write_whole(about, json.dumps(facts, indent=1, ensure_ascii=False) + "\n")
            self._facts: dict[str, Any] = facts
        self._labels = list(self._facts["methods"])

    def save(self, label: str, first: int, histories: Sequence[History]) -> None:
        """Keep these histories, repetitions `first` and following of `label`. They are on disk on return."""
        buffer = io.BytesIO()
        columns: dict[str, Any] = to_columns(histories)
        np.savez(buffer, **columns)
        data = buffer.getvalue()
        write_whole(self.folder / f"{self._labels.index(label):02d}-{first:06d}-{sha256(data)[:16]}.npz", data)

    def load(self) -> Iterator[tuple[str, int, list[History]]]:
        """What was kept: label, first repetition, histories. Raises ValueError that names a damaged file."""
        for path in sorted(self.folder.glob("*.npz")):
            data = path.read_bytes()
            try:
                method, first, fingerprint = path.stem.split("-")
                if not fingerprint or sha256(data)[:16] != fingerprint:
                    raise ValueError("its content does not agree with the fingerprint in its name")
                with np.load(io.BytesIO(data), allow_pickle=False) as columns:
                    label = self._labels[int(method)]
                    name = self._facts["methods"][label]["method"]
                    yield label, int(first), from_columns(columns, name, self._size)
            except (ValueError, IndexError, KeyError) as error:
                raise ValueError(
                    f"{path}: this file of the store is damaged ({error}); delete it, and the same call runs its "
                    "repetitions again and keeps all others"
                ) from error

    def _compare(self, about: Path, facts: dict[str, Any]) -> None:
        """Take what the store says of itself; it must be what `facts` say."""
        try:
            self._facts = json.loads(about.read_text(encoding="utf-8"))
            stored = _flat(self._facts)
        except (ValueError, KeyError, TypeError, AttributeError) as error:
            raise ValueError(f"{about}: this file of the store is damaged ({error})") from error
        wanted = _flat(facts)
        for name in wanted | stored:
            there, here = (one.get(name, "missing") for one in (stored, wanted))
            if there != here:
                raise ValueError(
                    f"{self.folder}: this store is of another experiment: {name} is {there} in the store, {here} in "
                    "this call; give the same arguments, or another folder"
                )


def _flat(facts: dict[str, Any]) -> dict[str, Any]:
    """The facts without a dictionary in a dictionary: ``alpha of Q+SR``, and the most telling first."""
    methods = facts["methods"]
    each = {f"{name} of {label}": value for label, about in methods.items() for name, value in about.items()}
    return {"the list of methods": sorted(methods), **each, **{k: v for k, v in facts.items() if k != "methods"}}


def fingerprint(*arrays: np.ndarray) -> str:
    """Short name of the content of arrays, different for different contents: 16 hexadecimal digits."""
    digest = hashlib.sha256()
    for array in arrays:
        digest.update(f"{array.dtype.str}{array.shape}".encode() + np.ascontiguousarray(array).tobytes())
    return digest.hexdigest()[:16]
