"""A folder of histories in which an experiment that was cut off goes on: ``experiment.json``, ``TOSL+SR/0007.npz`` …"""

import json
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

from rlrobot_edu.files import sha256, write_whole
from rlrobot_edu.learning.history import History
from rlrobot_edu.models.sample_model import SampleModel
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import load_task

ABOUT, MODEL = "experiment.json", "model.npz"
NEEDED = {"methods": dict, "seed": int, "world": str}  # of a description, what opening the store without the call takes
_ODD = re.compile(r'^\.|[%/\\:*?"<>|\x00-\x1f]')  # in a label, what cannot stand in the name of a folder everywhere


class Store:
    """The repetitions of one experiment on disk. Each file is written whole, so several processes may use a store.

    folder: where; facts: what the experiment is, by name, the most telling first, all of it text and numbers; its
    ``methods`` are those of the agents, by label

    A history keeps its origin, so a file of another experiment, or under another name, is found out.
    """

    def __init__(self, folder: str | Path, facts: dict[str, Any]) -> None:
        self.folder, self.facts = Path(folder), json.loads(json.dumps(facts))
        self._name = sha256(json.dumps(self.facts, sort_keys=True).encode())[:16]

    @classmethod
    def at(cls, folder: str | Path) -> "Store":
        """The store in `folder`. Raises ValueError if there is none, or if its description is damaged."""
        folder = Path(folder)
        path = folder / ABOUT
        if not path.is_file():
            what = f"holds no {ABOUT}, so it is no store"
            if (folder / "store.json").is_file():
                what = "is a store of an earlier layout, so its comparison must be run again"
            raise ValueError(f"{folder}: this folder {what}; give another folder")
        try:
            facts = json.loads(path.read_text(encoding="utf-8"))
            if not all(isinstance(facts[name], kind) for name, kind in NEEDED.items()):
                raise ValueError(f"it needs {', '.join(NEEDED)}")
            return cls(folder, facts)
        except Exception as error:  # of a damaged file anything may be the matter
            raise ValueError(f"{path}: this file of the store is damaged ({error!s:.200})") from error

    def begin(self, world: object) -> None:
        """Go on with the experiment in this folder, or begin it; a model in which it is done is kept with it.

        Raises ValueError that says what differs if the folder holds another experiment, or something else.
        """
        if any(path.name[0] != "." for path in self.folder.glob("*")):
            stored = Store.at(self.folder).facts
            for name in self.facts | stored:
                there, here = (facts.get(name, "missing") for facts in (stored, self.facts))
                if there != here:
                    there, here = (" ".join(str(fact).split())[:200] for fact in (there, here))  # in one line
                    raise ValueError(
                        f"{self.folder / ABOUT}: this store is of another experiment: {name} is {there} in the store, "
                        f"{here} in this call; give the same arguments, or another folder"
                    )
        else:
            write_whole(self.folder / ABOUT, json.dumps(self.facts, indent=1, ensure_ascii=False) + "\n")
        if isinstance(world, SampleModel) and not (self.folder / MODEL).is_file():
            world.save(self.folder / MODEL)

    def path(self, label: str, number: int) -> Path:
        """The file of one repetition."""
        return self.folder / _ODD.sub(lambda odd: f"%{ord(odd[0]):02X}", label) / f"{number:04d}.npz"

    def _origin(self, label: str, number: int) -> str:
        return f"repetition {number} of {label} of experiment {self._name}"

    def save(self, label: str, number: int, history: History) -> None:
        """Keep one repetition. It is on disk on return."""
        replace(history, origin=self._origin(label, number)).save(self.path(label, number))

    def load(self, label: str, number: int) -> History | None:
        """One repetition; None if it has not been kept yet. Raises ValueError that names a damaged file."""
        path = self.path(label, number)
        if not path.is_file():
            return None
        try:
            history = History.load(path)
            if history.origin != (due := self._origin(label, number)):
                raise ValueError(f"{path}: it holds {history.origin or 'any history'!r:.200}, expected {due!r:.200}")
        except ValueError as error:
            raise ValueError(
                f"{error}; delete this file of the store, and the same call runs its repetition again and keeps all "
                "others"
            ) from error
        return history

    def histories(self, label: str) -> list[History]:
        """All repetitions of one method that have been kept, in order. Raises ValueError that names a damaged file."""
        names = [path.stem for path in self.path(label, 0).parent.glob("*.npz")]
        found = (self.load(label, i) for i in sorted(int(name) for name in names if name.isdecimal()))
        return [history for history in found if history is not None]

    def world(self, task: Task | str | Path | None = None) -> Task | SampleModel:
        """Where the methods learned: the model that is kept here, or the task, which is the toolkit's or given."""
        if (self.folder / MODEL).is_file():
            return SampleModel.load(self.folder / MODEL)
        return load_task(self.facts["world"].removeprefix("the task ") if task is None else task)
