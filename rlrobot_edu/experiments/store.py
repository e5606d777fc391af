"""A folder of histories from which a stopped experiment goes on: experiment.json, TOSL+SR/0007.npz …"""

import json
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import joblib
import numpy as np
from gymnasium.envs.registration import EnvSpec

from rlrobot_edu.checks import first_difference
from rlrobot_edu.environments import World, as_world
from rlrobot_edu.files import check_path, sha256, write_whole
from rlrobot_edu.jit.fingerprint import code_of
from rlrobot_edu.learning.history import History
from rlrobot_edu.models.sample_model import ABOUT, DTYPES, SampleModel
from rlrobot_edu.task.task import Task

DESCRIPTION = "experiment.json"
MODEL = "model.npz"
# These facts are needed to open a store without the call that made it.
NEEDED = {"methods": dict, "seed": int, "world": str}
# Such a name can be a folder's on every system.
METHOD = re.compile(r"[A-Z0-9-]{1,30}\+[A-Z0-9-]{1,30}")


class Store:
    """The repetitions of one experiment on disk. Files are written whole, so several processes may use it.

    folder: its place; facts: the description of the experiment, by name, the most telling first, in texts and
    numbers; its ``methods`` are those of the agents, by label

    A history keeps its origin, so we notice a file of another experiment, or one under another name.
    """

    def __init__(self, folder: str | Path, facts: dict[str, Any]) -> None:
        self.folder = check_path(folder)
        # NumPy's numbers become Python's.
        text = json.dumps(facts, default=np.generic.item)
        self.facts: dict[str, Any] = json.loads(text)
        self._name = sha256(json.dumps(self.facts, sort_keys=True).encode())[:16]

    @classmethod
    def at(cls, folder: str | Path) -> "Store":
        """The store in `folder`. Raises ValueError if there is none, or if its description is damaged."""
        path = check_path(folder) / DESCRIPTION
        if not path.is_file():
            raise ValueError(
                f"{folder}: this folder holds no {DESCRIPTION}, so it is no store; give another"
            )
        try:
            facts = json.loads(path.read_text(encoding="utf-8"))
            if not all(isinstance(facts[name], kind) for name, kind in NEEDED.items()):
                raise ValueError(f"it needs {', '.join(NEEDED)}")
            return cls(folder, facts)
        except Exception as error:  # of a damaged file anything may be the matter
            raise ValueError(
                f"{path}: this file of the store is damaged ({error!s:.200})"
            ) from error

    def begin(self, world: World) -> None:
        """Go on with the experiment in this folder, or begin it. If its world is a model, the store keeps the model.

        Raises ValueError that says what differs if the folder has another experiment, or something else.
        """
        if any(path.name[0] != "." for path in self.folder.glob("*")):
            there = Store.at(self.folder).facts
            differ = first_difference(there, self.facts, "store")
            if differ:
                raise ValueError(
                    f"{self.folder} has another experiment: {differ} in this call; take another"
                )
        else:
            text = json.dumps(self.facts, indent=1, ensure_ascii=False)
            write_whole(self.folder / DESCRIPTION, f"{text}\n")
        if (self.folder / MODEL).is_file():
            self.world()
        elif isinstance(world, SampleModel):
            world.save(self.folder / MODEL)

    def path(self, label: str, number: int) -> Path:
        """The file of one repetition."""
        if not METHOD.fullmatch(label):
            readable = re.sub(r"[^A-Za-z0-9+=-]+", "_", label)[:40]
            unique = sha256(label.encode())[:8]
            label = f"{readable}_{unique}"
        return self.folder / label / f"{number:04d}.npz"

    def _origin(self, label: str, number: int) -> str:
        return f"repetition {number} of {label} of experiment {self._name}"

    def save(self, label: str, number: int, history: History) -> None:
        """Keep one repetition. It is on disk on return."""
        kept = replace(history, origin=self._origin(label, number))
        kept.save(self.path(label, number))

    def load(self, label: str, number: int) -> History | None:
        """One repetition; None if it has not been kept yet. Raises ValueError that names a damaged file."""
        path = self.path(label, number)
        if not path.is_file():
            return None
        due = self._origin(label, number)
        try:
            history = History.load(path)
            if history.origin != due:
                raise ValueError(
                    f"{path}: it is {history.origin or 'of none'!r:.200}, expected {due!r:.200}"
                )
        except ValueError as error:
            raise ValueError(
                f"{error}; delete this file, and the same call runs it again"
            ) from error
        return history

    def histories(self, label: str) -> list[History]:
        """The repetitions of one method that are kept, in order. Raises ValueError that names a damaged file."""
        stems = [path.stem for path in self.path(label, 0).parent.glob("*.npz")]
        numbers = sorted({int(stem) for stem in stems if stem.isdecimal()})
        kept = [self.load(label, number) for number in numbers]
        return [history for history in kept if history is not None]

    def world(self, world: World | str | Path | None = None) -> World:
        """The world in which the methods learned: the given one, else the model kept here or the one in the facts.

        Raises ValueError that says what differs if it is not what the store was made with.
        """
        path = self.folder / MODEL
        if world is None and path.is_file():
            world = SampleModel.load(path)
        elif world is None:
            named = str(self.facts["world"])
            world = named.removeprefix("the task ").removeprefix("the environment ")
            if world == named:
                raise ValueError(
                    f"{self.folder}: it was made in {named}, which it lacks; give it as world="
                )
        world = as_world(world)
        here = self.facts | Store("", facts_of(world)).facts
        differ = first_difference(self.facts, here, "store")
        if differ:
            raise ValueError(
                f"{self.folder} was made in another world: {differ} here; give it as world="
            )
        return world


def facts_of(world: World) -> dict[str, Any]:
    """The description of a world, by name, the most telling first."""
    if isinstance(world, SampleModel):
        about = {name: getattr(world, name) for name in ABOUT}
        recorded = joblib.hash([getattr(world, name) for name in DTYPES])
        return {
            "world": "a sample model",
            **about,
            "what the model has recorded": recorded,
        }
    if isinstance(world, EnvSpec):
        maker = code_of((str(world), world.entry_point))
        return {
            "world": f"the environment {world.id}",
            "kwargs": str(world.kwargs),
            "what makes it": maker,
        }
    if not isinstance(world, Task):
        return {"world": "what a function makes", "what makes it": code_of(world)}
    facts = {
        "world": f"the task {world.name}",
        "robot": world.robot,
        "scene": str(world.scene),
        "inputs": str(world.inputs),
        "outputs": str(world.outputs),
        "rewards": str(world.rewards),
        "step_time": str(world.step_time),
        "episode_steps": str(world.episode_steps),
        "goal_steps": str(world.goal_steps),
    }
    facts["the content of the task's file"] = world.fingerprint[:16]
    for name in ("reward", "command", "goal"):
        facts[f"the function {name}"] = code_of(getattr(world, name), file=world.path)
    return facts
