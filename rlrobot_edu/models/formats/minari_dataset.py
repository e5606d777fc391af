"""Recordings as Minari datasets, in hdf5: its arrow format silently cuts episodes of 32,768 steps or more."""

import json
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, cast

import gymnasium
import numpy as np
from numpy.typing import NDArray

from rlrobot_edu.files import write_together
from rlrobot_edu.learning.size import Size
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.models.data_package import to_files
from rlrobot_edu.models.formats.described import KEY, check_size, from_package, from_rows, needed
from rlrobot_edu.models.recording import Recording
from rlrobot_edu.models.source import Source
from rlrobot_edu.task.messages import in_words
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import available_tasks, load_task

ROWS, ABOUT = "main_data.hdf5", "metadata.json"  # Minari's own names
COLUMNS = ("observations", "actions", "rewards", "terminations", "truncations")


def to_minari(recording: Recording, dataset_id: str, root: str | Path | None = None) -> None:
    """Write a recording as a Minari dataset, whole or not at all.

    Parameters
    ----------
    recording : Recording
        What to write. Each step must begin in the state in which the one before has ended, or begin an episode.
    dataset_id : str
        Minari's name for it, such as ``wander_1k/tosl-v0``. A dataset of this name is replaced.
    root : str or Path, optional
        Where datasets are kept; None is Minari's own place, see its ``MINARI_DATASETS_PATH``.

    Raises
    ------
    ValueError
        If Minari does not take the name, or if the steps of an episode do not follow each other.
    ImportError
        If Minari is missing; it says what to install.

    Notes
    -----
    Observations are the bins of each input (MultiDiscrete), actions are numbers (Discrete). The data package, which
    says what they mean, stands under ``rlrobot_edu`` in metadata.json.
    """
    minari, storages = needed("minari"), needed("minari.dataset.minari_storage")
    folder, source, episode = _folder(dataset_id, root), recording.source, recording.episode
    breaks = (recording.s_next[:-1] != recording.s[1:]) & (episode[:-1] == episode[1:])
    if breaks.any():
        row = int(breaks.argmax()) + 1
        raise ValueError(
            f"row {row} of the recording begins in state {recording.s[row]}, the row before ended in state "
            f"{recording.s_next[row - 1]}: Minari keeps one state a step, so use Recording.save"
        )
    shape, buffers = source.states.shape, []
    for rows in np.split(np.arange(len(recording)), np.flatnonzero(recording.step == 0)[1:]):
        states = np.append(recording.s[rows], recording.s_next[rows[-1]])
        observations = np.stack(np.unravel_index(states, shape), axis=1)
        columns = (getattr(recording, name)[rows] for name in ("a", "r", "terminated", "truncated"))
        values = dict(zip(COLUMNS, (observations, *columns), strict=True))
        buffers.append(minari.data_collector.EpisodeBuffer(**values))
    is_task = source.task_name in available_tasks()
    with TemporaryDirectory() as place:
        storage = storages.MinariStorage.new(
            place,
            gymnasium.spaces.MultiDiscrete(list(shape)),
            gymnasium.spaces.Discrete(source.actions.n),
            # of those that are known: `gymnasium.spec` would import what the name of a foreign one says
            gymnasium.registry.get(f"rlrobot/{source.task_name}-v0" if is_task else source.task_name),
            data_format="hdf5",
        )
        names = {"dataset_id": dataset_id, "minari_version": minari.__version__, "algorithm_name": source.method}
        storage.update_metadata({**names, KEY: json.loads(to_files(source, recording.transitions)[1])})
        storage.update_episodes(buffers)
        # The metadata come last: they hold the fingerprint of the rows, so half a pair is refused when read.
        write_together({folder / name: Path(place, name).read_bytes() for name in (ROWS, ABOUT)})


def from_minari(dataset_id: str, root: str | Path | None = None, task: str | Path | Task | None = None) -> Recording:
    """The recording in a Minari dataset on this computer; nothing is downloaded.

    Parameters
    ----------
    dataset_id : str
        Its name, such as ``wander_1k/tosl-v0``. It may be anybody's dataset in hdf5 whose observations and actions can
        be counted, MultiDiscrete or Discrete.
    root : str or Path, optional
        Where datasets are kept; None is Minari's own place, see its ``MINARI_DATASETS_PATH``.
    task : str, Path or Task, optional
        The task that the recording must be of; without it, another program's dataset has inputs without names, and
        the rewards that were seen.

    Returns
    -------
    Recording
        Every row, checked.

    Raises
    ------
    ValueError
        In one sentence, for a dataset that is not whole and right or that is of another task.
    FileNotFoundError
        If there is no such dataset.
    ImportError
        If Minari is missing; it says what to install.
    """
    h5py, serialization = needed("h5py"), needed("minari.serialization")
    folder, task = _folder(dataset_id, root), None if task is None else load_task(task)
    if not (folder / ABOUT).is_file():
        raise FileNotFoundError(f"{folder}: there is no Minari dataset {dataset_id!r} here; nothing is downloaded")
    try:
        about = json.loads((folder / ABOUT).read_text(encoding="utf-8"))
        if about["data_format"] != "hdf5":
            raise ValueError(f"its data_format is {about['data_format']!r:.80}, expected 'hdf5'")
        env = gymnasium.Env[Any, Any]()  # a dataset may name an environment, whose code we had better not run
        spaces = {name: serialization.deserialize_space(about[name]) for name in ("observation_space", "action_space")}
        vars(env).update(spaces)
        with h5py.File(folder / ROWS) as file:
            groups = [file[f"episode_{i}"] for i in range(len(file))]
            columns = [group[name] for group in groups for name in COLUMNS]
            check_size(sum(column.nbytes for column in columns))
            if any(column.dtype.kind not in "biuf" for column in columns):
                raise ValueError("some of its columns are no numbers")
            transitions = _joined([{name: group[name][()] for name in COLUMNS} for group in groups], env)
        package = about.get(KEY)
        source = None if package is not None else _source(about, env, transitions)
    except Exception as error:  # of a damaged file anything may be the matter
        raise ValueError(
            f"{folder}: this is not a whole Minari dataset of counted steps ({in_words(error)})"
        ) from error
    if source is None:
        return from_package(folder, transitions, json.dumps(package), task)
    if task is not None:
        size = Size.of(env)
        if (size.shape, size.n_actions) != (task.states.shape, task.actions.n):
            raise ValueError(
                f"{folder}: its bins are {size.shape}, its actions {size.n_actions}; task {task.name} has "
                f"{task.states.shape} and {task.actions.n}"
            )
        source = Source.of_task(task, method=source.method)
    return from_rows(folder, transitions, source, task)


def _folder(dataset_id: str, root: str | Path | None) -> Path:
    """Where the dataset's files are. Raises ValueError for a name that Minari does not take."""
    datasets = needed("minari.dataset.minari_dataset")
    try:
        datasets.parse_dataset_id(dataset_id)
    except (ValueError, TypeError):
        example = "letters, digits, - and _, perhaps namespaces before a /, and a version, such as 'wander_1k/tosl-v0'"
        raise ValueError(f"a Minari dataset's name is {example}, got {dataset_id!r:.200}") from None
    if root is None:
        root = needed("minari.storage.datasets_root_dir").get_dataset_path()
    return Path(root) / dataset_id / "data"


def _source(about: dict[str, Any], env: gymnasium.Env[Any, Any], transitions: Transitions) -> Source:
    """What another program's dataset says of itself."""
    spec, rewards = json.loads(about.get("env_spec", "{}")), np.unique(transitions.r).tolist()
    source = Source.of_env(env, rewards, method=str(about.get("algorithm_name", "unknown")))
    name = str(spec.get("id", about["dataset_id"]))
    return replace(source, task_name=name, time_limit=spec.get("max_episode_steps"))


def _joined(episodes: list[dict[str, NDArray[Any]]], env: gymnasium.Env[Any, Any]) -> Transitions:
    """The rows of all episodes. Raises ValueError for columns that are none of such an environment."""
    size, space = Size.of(env), cast(gymnasium.spaces.MultiDiscrete, env.observation_space)
    parts = []
    for i, episode in enumerate(episodes):
        n = len(episode["actions"])
        lengths = [array.shape for array in episode.values()]
        if lengths[1:] != [(n,)] * 4 or lengths[0] not in [(n + 1,), (n + 1, len(size.shape))]:
            raise ValueError(f"the columns of episode {i} have the shapes {lengths}")
        bins = episode["observations"].reshape(n + 1, -1) - space.start
        states = np.ravel_multi_index(tuple(bins.T), size.shape)
        terminated, truncated = (episode[name].astype(bool) for name in ("terminations", "truncations"))
        if n and i + 1 < len(episodes):
            truncated[-1] |= not terminated[-1]  # another episode follows
        parts.append((states[:-1], episode["actions"], episode["rewards"], states[1:], terminated, truncated))
    return Transitions(*map(np.concatenate, zip(*parts, strict=True)))
