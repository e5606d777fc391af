"""Recordings: each step that a robot took, in files that other programs can read, too."""

from pathlib import Path
from typing import Any

import numpy as np

from rlrobot_edu.checks import check_count
from rlrobot_edu.files import BEGINNINGS, check_path, write_together
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.learning import loop
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.size import Env, task_of, time_limit
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.models.data_package import (
    CSV_NAME,
    PACKAGE_NAME,
    count_episodes,
    read_folder,
    to_files,
)
from rlrobot_edu.models.own_rows import transitions_of
from rlrobot_edu.models.source import THIS_COMPUTER, Source
from rlrobot_edu.models.tables import table_of
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import load_task

DTYPES = {
    "r": np.float64,
    "terminated": np.bool_,
    "truncated": np.bool_,
}  # all other columns are np.int64


@suggests_keywords
class Recording:
    """Transitions (s, a, r, s'), one a row, and where they come from. ``len(recording)`` is their number, n.

    Parameters
    ----------
    transitions : Transitions
        The rows. The recording keeps copies of its columns that cannot be changed.
    source : Source
        What the numbers mean (``source.states``, ``source.actions``, ``source.rewards``), and who recorded
        them (``source.method``, ``source.seed``).
    task : Task, optional
        The task itself; None if it is not at hand.

    Attributes
    ----------
    s, a, s_next : int array (n,)
        Numbers of states and actions.
    r : float array (n,)
        Rewards.
    terminated, truncated : bool array (n,)
        Whether the step ended its episode, for good or by running out of time.
    episode, step : int array (n,)
        Number of the episode and of the step in it, from 0.

    Raises
    ------
    ValueError
        If a row is impossible: the message names the first one and what was expected there.
    """

    def __init__(
        self, transitions: Transitions, source: Source, task: Task | None = None
    ) -> None:
        if not isinstance(transitions, Transitions) or not isinstance(source, Source):
            raise ValueError(
                "a Recording is made of Transitions and a Source; "
                "rl.Recording.from_rows makes one of your own rows"
            )
        given = {
            name: np.asarray(column) for name, column in transitions._asdict().items()
        }
        lengths = {name: column.shape for name, column in given.items()}
        if (
            len(set(lengths.values())) > 1
            or given["s"].ndim != 1
            or not len(given["s"])
        ):
            raise ValueError(
                f"a recording is made of columns of one length, at least 1, got {lengths}"
            )
        words = [
            name for name, column in given.items() if column.dtype.kind not in "biuf"
        ]
        if words:
            raise ValueError(
                f"the columns of a recording are real numbers, {', '.join(words)} are not"
            )
        source.check_rows(given, lambda row: f"row {row} of the recording")
        copies: list[Any] = [
            np.array(column, DTYPES.get(name, np.int64))
            for name, column in given.items()
        ]
        self.transitions = Transitions(*copies)
        self.source = source
        self.task = task
        self.s, self.a, self.r, self.s_next, self.terminated, self.truncated = (
            self.transitions
        )
        self.episode, self.step = count_episodes(self.transitions)
        for column in (*self.transitions, self.episode, self.step):
            column.flags.writeable = False

    def __len__(self) -> int:
        return len(self.s)

    def __repr__(self) -> str:
        return f"Recording of {self.source.task_name} with {self.source.method}: {len(self):,} steps"

    @classmethod
    def from_rows(cls, rows: Any, task: str | Path | Task) -> "Recording":
        """The recording that your own rows make.

        Parameters
        ----------
        rows : list of dict, list of tuple, array (n, 3 to 6), dict of columns, or data frame
            One row a transition, in the order in which they came. The columns have these names; values without
            names have the order s, a, r, s_next, terminated, truncated, of which the first three are needed.

            - ``s`` and ``s_next``: numbers of the states before and after the step, from 0. In their place you can
              give what the robot read [in the units of the task]: a column for each of the task's inputs, such as
              ``laser_front``, and one with ``_next`` for what it read after the step.
            - ``a``: number of the action, from 0; or a column for each of the task's outputs with the value that
              it had [in the units of the task].
            - ``r``: the reward of the step, one of the task's.
            - ``terminated``, ``truncated``: 1 or True if the episode ended with this step, for good or because it
              was cut off; may be missing.
            - ``episode``: its number; may be missing. Without it, an episode also ends where the next row does not
              begin in the state that this one led to.
            - ``step``: number of the step in its episode, from 0; may be missing.

            If no column gives the state after a step, that of the next row is meant. Then each episode ends with
            a row whose action and reward are empty (None, NaN or ""), and the last one does so, too.
        task : str, Path or Task
            The task that the rows are of, see `load_task`.

        Returns
        -------
        Recording
            Every row, checked.

        Raises
        ------
        ValueError
            In one sentence, for the first row or column that is wrong. Rows count from 0. Also if a column has
            another name than these.
        FileNotFoundError
            If there is no file of the task.

        See Also
        --------
        read_recording : Reads such rows from a CSV file.
        """
        task = load_task(task)
        transitions = transitions_of(table_of(rows), task)
        return cls(transitions, Source.of_task(task), task)

    def save(self, folder: str | Path) -> None:
        """Write transitions.csv and datapackage.json, each whole: for the same recording the same bytes.

        Parameters
        ----------
        folder : str or Path
            Where the two files go; it is made if it is not there.

        Raises
        ------
        ValueError
            If the folder's name is that of a file.
        OSError
            If a file cannot be written.
        """
        folder = check_path(folder)
        if folder.suffix in BEGINNINGS:
            raise ValueError(
                f"{folder}: a recording is a folder, whose name does not end like this"
            )
        csv, package = to_files(self.source, self.transitions)
        # The package comes last: it holds the fingerprint of the rows, so half a pair is refused when read.
        write_together({folder / CSV_NAME: csv, folder / PACKAGE_NAME: package})

    @classmethod
    def load(
        cls, path: str | Path, task: str | Path | Task | None = None
    ) -> "Recording":
        """The recording that `save` wrote.

        Parameters
        ----------
        path : str or Path
            The folder, its datapackage.json or transitions.csv.
        task : str, Path or Task, optional
            The task that the recording must be of.

        Returns
        -------
        Recording
            Every row, checked.

        Raises
        ------
        ValueError
            In one sentence, for a file that is not whole and right or that is of another task.
        FileNotFoundError
            If one of its two files is missing.
        """
        path = check_path(path)
        folder = path.parent if path.name in (CSV_NAME, PACKAGE_NAME) else path
        return cls(*read_folder(folder, None if task is None else load_task(task)))


@suggests_keywords
def record(
    agent: Agent, env: Env, steps: int | None = None, *, episodes: int | None = None
) -> Recording:
    """Let `agent` learn in `env` for a number of steps or episodes, and keep every transition.

    Parameters
    ----------
    agent : Agent
        The agent that acts; it learns while it is recorded.
    env : gymnasium.Env
        Where the agent acts, see `make_env`.
    steps, episodes : int, optional
        How many steps or whole episodes to record, as in `learn`.

    Returns
    -------
    Recording
        Every transition, in the order in which they came.

    Raises
    ------
    ValueError
        If `steps` is below 1, if neither is given, or if agent and environment do not fit.
    KeyboardInterrupt
        After Ctrl-C, in one line; what was learned is kept, the recording is not.
    """
    check_count("steps", steps, or_none=True)
    history = loop.learn(
        agent, env, steps, episodes=episodes, keep=True, progress=False
    )
    # a SeedSequence is no number that JSON could keep
    seed = int(agent.seed) if isinstance(agent.seed, int | np.integer) else None
    acting = {
        "method": agent.method.name,
        "seed": seed,
        "time_limit": time_limit(env),
        **THIS_COMPUTER,
    }
    task = task_of(env)
    source = (
        Source.of_task(task, **acting)
        if task
        else Source.of_env(env, history.rewards, **acting)
    )
    return Recording(history.transitions, source, task)
