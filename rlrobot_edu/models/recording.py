"""Recordings: what a robot lived through, step by step, kept in a file that others can read."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import gymnasium
import numpy as np

from rlrobot_edu.files import write_together
from rlrobot_edu.learning import loop
from rlrobot_edu.models.columns import DTYPES, Columns, checked, to_csv
from rlrobot_edu.models.data_package import CSV_NAME, PACKAGE_NAME, describe
from rlrobot_edu.models.legacy import read_legacy
from rlrobot_edu.models.reading import read_folder
from rlrobot_edu.models.source import Source, here
from rlrobot_edu.task.task import Task, load_task


@dataclass(frozen=True, eq=False, repr=False)
class Recording:
    """Transitions (s, a, r, s'), one a row, and where they come from. The arrays are read-only.

    episode, step: int arrays (n,); both count from 0, and `step` starts afresh in each episode
    s, a, s_next: int arrays (n,), numbers of states and actions
    r: float array (n,), rewards
    terminated: bool array (n,), whether the step reached the end of its episode
    source: what the numbers mean, and who recorded them
    task: the task itself; None if it is not at hand

    Raises ValueError that names the first row that cannot be.
    """

    episode: np.ndarray
    step: np.ndarray
    s: np.ndarray
    a: np.ndarray
    r: np.ndarray
    s_next: np.ndarray
    terminated: np.ndarray
    source: Source
    task: Task | None = None

    def __post_init__(self) -> None:
        for name, column in checked(self._columns(), self.source, lambda row: f"row {row} of the recording").items():
            object.__setattr__(self, name, column)

    def __len__(self) -> int:
        return len(self.s)

    def __repr__(self) -> str:
        return f"Recording of {self.source.task_name} with {self.method}: {len(self):,} steps"

    def _columns(self) -> Columns:
        return {name: getattr(self, name) for name in DTYPES}

    @property
    def shape(self) -> tuple[int, ...]:
        """Bins of each input."""
        return self.source.states.shape

    @property
    def n_states(self) -> int:
        """Number of states, seen or not."""
        return self.source.states.n

    @property
    def n_actions(self) -> int:
        """Number of actions, seen or not."""
        return self.source.actions.n

    @property
    def rewards(self) -> tuple[float, ...]:
        """Every reward that a row may have."""
        return self.source.rewards

    @property
    def episode_steps(self) -> int | None:
        """Steps after which an episode is cut off; None if it goes on for ever."""
        return self.source.episode_steps

    @property
    def method(self) -> str:
        """Method of the agent that acted, such as "TOSL+SR"."""
        return self.source.method

    @property
    def seed(self) -> int | None:
        """Seed of the agent that acted."""
        return self.source.seed

    @property
    def version(self) -> str:
        """Version of the toolkit that recorded."""
        return self.source.version

    def save(self, folder: str | Path) -> None:
        """Write transitions.csv and datapackage.json into `folder`, the same bytes for the same recording."""
        csv = to_csv(self._columns()).encode()
        package = describe(self.source, csv, rows=len(self), initial_state=int(self.s[0]))
        # The package comes last: it holds the fingerprint of the rows, so half a pair is refused when read.
        write_together({Path(folder) / CSV_NAME: csv, Path(folder) / PACKAGE_NAME: package})


def record(env: gymnasium.Env, agent, steps: int | None = None, *, episodes: int | None = None) -> Recording:
    """Let `agent` learn in `env` for a number of steps, or of whole episodes, and keep every transition.

    Raises ValueError unless exactly one of `steps` and `episodes` is given, and for episodes that never end.
    """
    if (steps is None) == (episodes is None):
        raise ValueError("give either steps or episodes")
    wanted = episodes if steps is None else steps
    if wanted < 1:
        raise ValueError(f"{'episodes' if steps is None else 'steps'} must be at least 1, got {wanted}")
    task = getattr(env.unwrapped, "task", None)
    if episodes is not None and isinstance(task, Task) and task.episode_steps is None and task.goal is None:
        raise ValueError(f"{task.name} goes on for ever, it has no episodes; give steps")
    rows = list(_rows(loop.steps(agent, env, steps=steps or sys.maxsize), episodes))
    columns = {
        name: np.array(column, dtype)
        for (name, dtype), column in zip(DTYPES.items(), zip(*rows, strict=True), strict=True)
    }
    seed = agent.seed if isinstance(agent.seed, int) else None  # a SeedSequence is no number that JSON could keep
    acting = {"method": agent.method, "seed": seed, **here()}
    if isinstance(task, Task):
        source = Source.of_task(task, **acting)
    else:
        task, source = None, Source.of_env(env, np.unique(columns["r"]), **acting)
    return Recording(**columns, source=source, task=task)


def _rows(walk: Iterator[loop.Step], episodes: int | None) -> Iterator[tuple]:
    """One row a step, in the order of the columns, up to the end of so many episodes (None: of the walk)."""
    episode = in_episode = 0
    for step in walk:
        yield episode, in_episode, step.s, step.a, step.r, step.s_next, step.terminated
        over = step.terminated or step.truncated
        episode, in_episode = (episode + 1, 0) if over else (episode, in_episode + 1)
        if episode == episodes:
            return


def read_recording(
    path: str | Path, legacy: bool = False, task: str | Path | Task | None = None, inputs: Sequence[str] | None = None
) -> Recording:
    """The recording in a folder, or the one of this name that comes with the toolkit.

    path: the folder, its datapackage.json or transitions.csv; with `legacy`, the paper's own array (.npy)
    task: the task that the recording must be of; needed with `legacy`, which does not say
    inputs: with `legacy`, names of the inputs in the array's order where it is not the task's

    Raises ValueError in one sentence for a file that is not whole and right, FileNotFoundError if there is none.
    """
    if legacy:
        if task is None:
            raise ValueError(f"{path}: the paper's format does not say which task was recorded; give task=")
        task = load_task(task)
        return Recording(**read_legacy(Path(path), task, inputs), source=Source.of_task(task), task=task)
    if inputs is not None:
        raise ValueError(f"{path}: inputs= is for legacy=True; this format names its inputs itself")
    columns, source, known = read_folder(Path(path), None if task is None else load_task(task))
    return Recording(**columns, source=source, task=known)
