"""Recordings as Minari datasets, in hdf5: its arrow format silently cuts episodes of 32,768 steps or more.

See `Recording.to_minari` and `Recording.from_minari`.
"""

import importlib
import json
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import gymnasium
import numpy as np
from numpy.typing import NDArray

from rlrobot_edu.checks import describe_error
from rlrobot_edu.files import LARGEST, sha256, write_together
from rlrobot_edu.learning.size import Size
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.models.columns import REMEDY, check_rows, count_episodes, to_csv
from rlrobot_edu.models.data_package import Parts, read_package, recorded_task, to_files
from rlrobot_edu.models.source import Source
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import available_tasks

ROWS, ABOUT = "main_data.hdf5", "metadata.json"  # Minari's own names
COLUMNS = ("observations", "actions", "rewards", "terminations", "truncations")
KEY = (
    "rlrobot_edu"  # under which the metadata keep the data package of `Recording.save`
)


def write(
    transitions: Transitions, source: Source, dataset_id: str, root: str | Path | None
) -> None:
    """What `Recording.to_minari` does."""
    minari = _needed("minari")
    storages = _needed("minari.dataset.minari_storage")
    folder = _folder(dataset_id, root)
    s, s_next = transitions.s, transitions.s_next
    _, step = count_episodes(transitions)
    breaks = (s_next[:-1] != s[1:]) & (step[1:] > 0)
    if breaks.any():
        row = int(breaks.argmax()) + 1
        begins = f"row {row} of the recording begins in state {s[row]}"
        before = f"the row before ended in state {s_next[row - 1]}"
        raise ValueError(
            f"{begins}, {before}: Minari keeps one state a step, so use Recording.save"
        )
    buffers = []
    for rows in np.split(np.arange(len(s)), np.flatnonzero(step == 0)[1:]):
        states = np.append(s[rows], s_next[rows[-1]])
        observations = np.stack(np.unravel_index(states, source.states.shape), axis=1)
        others = (
            getattr(transitions, name)[rows]
            for name in ("a", "r", "terminated", "truncated")
        )
        columns = dict(zip(COLUMNS, (observations, *others), strict=True))
        buffers.append(minari.data_collector.EpisodeBuffer(**columns))
    is_task = source.task_name in available_tasks()
    with TemporaryDirectory() as place:
        storage = storages.MinariStorage.new(
            place,
            gymnasium.spaces.MultiDiscrete(list(source.states.shape)),
            gymnasium.spaces.Discrete(source.actions.n),
            # of those that are known: `gymnasium.spec` would import what the name of a foreign one says
            gymnasium.registry.get(
                f"rlrobot/{source.task_name}-v0" if is_task else source.task_name
            ),
            data_format="hdf5",
        )
        about = {"dataset_id": dataset_id, "minari_version": minari.__version__}
        package = json.loads(to_files(source, transitions)[1])
        storage.update_metadata(
            {**about, "algorithm_name": source.method, KEY: package}
        )
        storage.update_episodes(buffers)
        # The metadata come last: they hold the fingerprint of the rows, so half a pair is refused when read.
        write_together(
            {folder / name: Path(place, name).read_bytes() for name in (ROWS, ABOUT)}
        )


def read(dataset_id: str, root: str | Path | None, task: Task | None) -> Parts:
    """What `Recording.from_minari` makes a recording of."""
    h5py = _needed("h5py")
    serialization = _needed("minari.serialization")
    folder = _folder(dataset_id, root)
    if not (folder / ABOUT).is_file():
        raise FileNotFoundError(
            f"{folder}: there is no Minari dataset {dataset_id!r}; nothing is downloaded"
        )
    try:
        about = json.loads((folder / ABOUT).read_text(encoding="utf-8"))
        if about["data_format"] != "hdf5":
            raise ValueError(
                f"its data_format is {about['data_format']!r:.80}, expected 'hdf5'"
            )
        env = gymnasium.Env[
            Any, Any
        ]()  # a dataset may name an environment, whose code we had better not run
        for name in ("observation_space", "action_space"):
            setattr(env, name, serialization.deserialize_space(about[name]))
        with h5py.File(folder / ROWS) as file:
            transitions = _joined(_episodes(file), env)
        source = None if KEY in about else _source(about, env, transitions)
    except Exception as error:  # of a damaged file anything may be the matter
        what = "this is not a whole Minari dataset of counted steps"
        raise ValueError(f"{folder}: {what} ({describe_error(error)})") from error
    digits = None
    if source is None:
        source, _, digits = read_package(json.dumps(about[KEY]), str(folder))
        task = recorded_task(source, task, folder)
    elif task is not None:
        its, due = Size.of(env), Size.of(task)
        if (its.shape, its.n_actions) != (due.shape, due.n_actions):
            there = f"its bins are {its.shape}, its actions {its.n_actions}"
            raise ValueError(
                f"{folder}: {there}; task {task.name} has {due.shape} and {due.n_actions}"
            )
        source = Source.of_task(task, method=source.method)
    check_rows(
        transitions._asdict(),
        source,
        lambda row: f"{folder}: row {row} of the recording",
    )
    if digits and sha256(to_csv(transitions).encode()) != digits:
        raise ValueError(
            f"{folder}: its rows are not the ones that its data package describes; {REMEDY}"
        )
    return transitions, source, task


def _needed(module: str) -> Any:
    """A module of the extra "all". Raises ImportError that says what to install."""
    try:
        return importlib.import_module(module)
    except ImportError:
        install = "run pip install 'minari[hdf5]'; everything else works without it"
        raise ImportError(
            f"{module.partition('.')[0]} is not installed: {install}"
        ) from None


def _folder(dataset_id: str, root: str | Path | None) -> Path:
    """Where the dataset's files are. Raises ValueError for a name that Minari does not take."""
    try:
        _needed("minari.dataset.minari_dataset").parse_dataset_id(dataset_id)
    except (ValueError, TypeError):
        expected = "letters, digits, - and _, perhaps with /, and a version, such as 'wander_1k/tosl-v0'"
        raise ValueError(
            f"a Minari dataset's name is {expected}, got {dataset_id!r:.200}"
        ) from None
    if root is None:
        root = _needed("minari.storage.datasets_root_dir").get_dataset_path()
    return Path(root) / dataset_id / "data"


def _source(
    about: dict[str, Any], env: gymnasium.Env[Any, Any], transitions: Transitions
) -> Source:
    """What another program's dataset says of itself."""
    spec = json.loads(about.get("env_spec", "{}"))
    source = Source.of_env(
        env, transitions.r, method=str(about.get("algorithm_name", "unknown"))
    )
    name = str(spec.get("id", about["dataset_id"]))
    return replace(source, task_name=name, time_limit=spec.get("max_episode_steps"))


def _episodes(file: Any) -> list[list[NDArray[Any]]]:
    """The columns of each episode in an open file. Raises ValueError for too many, or for what is no number."""
    groups = [file[f"episode_{i}"] for i in range(len(file))]
    columns = [group[name] for group in groups for name in COLUMNS]
    if sum(column.nbytes for column in columns) > LARGEST:
        raise ValueError(f"it claims to hold more than {LARGEST >> 20} MB of rows")
    if any(column.dtype.kind not in "biuf" for column in columns):
        raise ValueError("some of its columns are no numbers")
    return [[group[name][()] for name in COLUMNS] for group in groups]


def _joined(
    episodes: list[list[NDArray[Any]]], env: gymnasium.Env[Any, Any]
) -> Transitions:
    """The rows of all episodes. Raises ValueError for columns that are none of such an environment."""
    shape = Size.of(env).shape
    start = getattr(env.observation_space, "start", 0)
    parts = []
    for i, columns in enumerate(episodes):
        observations, actions, rewards, terminations, truncations = columns
        n = len(actions)
        lengths = [column.shape for column in columns]
        if lengths[1:] != [(n,)] * 4 or lengths[0] not in [
            (n + 1,),
            (n + 1, len(shape)),
        ]:
            raise ValueError(f"the columns of episode {i} have the shapes {lengths}")
        states = np.ravel_multi_index(
            tuple((observations.reshape(n + 1, -1) - start).T), shape
        )
        terminated, truncated = terminations.astype(bool), truncations.astype(bool)
        if n and i + 1 < len(episodes):
            truncated[-1] |= not terminated[-1]  # another episode follows
        parts.append((states[:-1], actions, rewards, states[1:], terminated, truncated))
    return Transitions(*map(np.concatenate, zip(*parts, strict=True)))
