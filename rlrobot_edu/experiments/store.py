"""A folder in which finished repetitions stay: an experiment that was cut off goes on where it was."""

import json
import warnings
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from rlrobot_edu.experiments.repeat import Batch
from rlrobot_edu.experiments.runs import from_columns, to_columns
from rlrobot_edu.files import load_arrays, parts_of, save_arrays, sha256, write_whole
from rlrobot_edu.learning.size import Size

with warnings.catch_warnings():
    warnings.simplefilter("ignore")  # in a browser it warns of its locks; there is one process only
    import filelock

ABOUT, LOCK, KIND = "store.json", ".lock", "batch of repetitions"


class Store:
    """The repetitions of one experiment on disk: ``store.json`` says of which, every ``.npz`` file holds a few.

    folder: where; it is made if there is none
    facts: what the experiment is, by name, all of it text and numbers
    size: of the world

    The name of a file is ``method-first.npz``: the position of its method in ``store.json`` and the number of its first
    repetition; what it is stands in the file, too. It appears under this name once it is whole.
    Raises ValueError if the folder holds something else, or another experiment; it says what differs.
    """

    def __init__(self, folder: str | Path, facts: dict[str, Any], size: Size) -> None:
        self.folder, self._size = Path(folder), size
        self._facts = json.loads(json.dumps(facts))
        self._labels = list(self._facts["methods"])
        self._name = sha256(json.dumps(self._facts, sort_keys=True).encode())[:16]  # of the experiment

    @contextmanager
    def open(self) -> Iterator[None]:
        """Nobody else writes here inside. Raises ValueError if somebody does, or if this is no place for the store."""
        about = self.folder / ABOUT
        if self.folder.is_dir() and not about.is_file() and any(p.name[0] != "." for p in self.folder.iterdir()):
            raise ValueError(f"{self.folder}: this folder holds other files and no {ABOUT}; give store= a new folder")
        self.folder.mkdir(parents=True, exist_ok=True)
        with ExitStack() as held:
            try:  # the lock is the operating system's: it ends with the process, whatever ends that
                held.enter_context(filelock.FileLock(self.folder / LOCK, timeout=0))
                for part in (*parts_of(about), *self.folder.glob(".*.npz.*.part")):
                    part.unlink()  # whoever wrote it was killed
            except filelock.Timeout:
                raise ValueError(
                    f"{self.folder}: another process is at work on this store; wait until it is done, then the same "
                    "call finds all its repetitions here, or give store= another folder"
                ) from None
            except OSError:
                if not about.is_file():  # a store in a read-only folder can still be read
                    raise
            if about.is_file():
                self._compare(about)
            else:
                write_whole(about, json.dumps(self._facts, indent=1, ensure_ascii=False) + "\n")
            yield

    def _path(self, label: str, first: int) -> Path:
        return self.folder / f"{self._labels.index(label):02d}-{first:06d}.npz"

    def save(self, batch: Batch) -> None:
        """Keep these repetitions, which follow one another under one label. They are on disk on return."""
        label, first = next(iter(batch))
        about, columns = {"experiment": self._name, "label": label, "first": first}, to_columns([*batch.values()])
        save_arrays(self._path(label, first), KIND, about, columns, packed=False)  # packing takes long

    def load(self) -> Iterator[Batch]:
        """What was kept. Raises ValueError that names a damaged file."""

        def make(about: dict[str, Any], columns: dict[str, np.ndarray]) -> Batch:
            label, first = about["label"], about["first"]
            if about["experiment"] != self._name or path != self._path(label, first):
                raise ValueError("it is of another experiment or has the name of another file")
            histories = from_columns(columns, self._facts["methods"][label]["method"], self._size)
            return {(label, i): history for i, history in enumerate(histories, first)}

        for path in sorted(self.folder.glob("*.npz")):
            try:
                yield load_arrays(path, KIND, make)
            except ValueError as error:
                raise ValueError(
                    f"this file of the store is damaged: {error}; delete it, and the same call runs its repetitions "
                    "again and keeps all others"
                ) from error

    def _compare(self, about: Path) -> None:
        """Raises ValueError unless what the store says of itself is what the facts say."""
        wanted = _flat(self._facts)
        try:
            facts = json.loads(about.read_text(encoding="utf-8"))
            stored = _flat(facts)
        except Exception as error:  # of a damaged file anything may be the matter
            raise ValueError(f"{about}: this file of the store is damaged ({error!s:.200})") from error
        for name in wanted | stored:
            there, here = (one.get(name, "missing") for one in (stored, wanted))
            if there != here:
                there, here = (" ".join(str(fact).split())[:200] for fact in (there, here))  # in one line
                raise ValueError(
                    f"{self.folder}: this store is of another experiment: {name} is {there} in the store, {here} in "
                    "this call; give the same arguments, or another folder"
                )
        self._labels = list(facts["methods"])  # its files are numbered in the order of the first call


def _flat(facts: dict[str, Any]) -> dict[str, Any]:
    """The facts without a dictionary in a dictionary: ``alpha of Q+SR``, and the most telling first."""
    methods = facts["methods"]
    each = {f"{name} of {label}": value for label, about in methods.items() for name, value in about.items()}
    return {"the list of methods": sorted(methods), **each, **{k: v for k, v in facts.items() if k != "methods"}}
