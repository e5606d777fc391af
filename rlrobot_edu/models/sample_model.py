"""A sample model: a world that answers (s, a) with the outcomes seen there, each as often as it was seen."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray

from rlrobot_edu.checks import (
    LARGEST_NUMBER,
    all_in_range,
    check_index,
    check_name,
    check_parts,
    check_table,
)
from rlrobot_edu.files import load_arrays, save_arrays
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.models.diagnosis import Diagnosis, Suspects, find_loops
from rlrobot_edu.models.held_back import HeldBack, hold_back
from rlrobot_edu.models.recording import Recording
from rlrobot_edu.task.task import Task

Unseen = Literal["uniform", "stay", "siblings"]
UNSEEN: tuple[Unseen, ...] = get_args(Unseen)
# The fields that JSON can hold
ABOUT = ("shape", "n_actions", "unseen", "episode_steps", "time_limit")
DTYPES: dict[str, Any] = {
    "offsets": np.int64,
    "s_next": np.int64,
    "cumulative": np.int64,
    "starts": np.int64,
    "r": np.float64,
    "terminated": np.bool_,
    "rewards": np.float64,
}


@suggests_keywords
@dataclass(frozen=True, eq=False)
class SampleModel:
    """The outcomes seen after each pair (s, a), in compressed rows: memory grows with what was seen.

    A pair (s, a) has the number s * n_actions + a.

    Parameters
    ----------
    shape : tuple of int
        Bins of each input variable.
    n_actions : int
        Number of actions.
    offsets : int array (pairs + 1,)
        The outcomes of pair p are rows offsets[p] to offsets[p + 1] of the next four arrays.
    s_next, r, terminated : array (outcomes,)
        The outcomes.
    cumulative : int array (outcomes,)
        How often this outcome of the pair, or one before it, was seen.
    starts : int array (episodes,)
        The state each recorded episode began in.
    rewards : float array
        Every reward that the task can give, increasing.
    unseen : str
        The outcomes of a pair that was never tried: ``uniform`` (the paper's: any state and any reward with the
        same probability), ``siblings`` (an outcome of the states that share all inputs but one; uniform if these
        have none), or ``stay`` (the lowest reward, in the same state, so that a plan avoids the pair).
    episode_steps : int, optional
        Steps after which an episode is cut off; None if it goes on for ever. A goal counts for the rest of them.
    time_limit : int, optional
        The same for a world in which a goal counts once, as Gymnasium's TimeLimit sets it.
    task : Task, optional
        The task that was recorded, if it is available. A file does not hold it: give it to a loaded model with
        ``dataclasses.replace(model, task=rl.load_task(…))``.

    Raises
    ------
    ValueError
        If `unseen` is unknown, or if the arrays do not fit a recording.
    """

    shape: tuple[int, ...]
    n_actions: int
    offsets: NDArray[np.int64]
    s_next: NDArray[np.int64]
    r: NDArray[np.float64]
    terminated: NDArray[np.bool_]
    cumulative: NDArray[np.int64]
    starts: NDArray[np.int64]
    rewards: NDArray[np.float64]
    unseen: Unseen = "uniform"
    episode_steps: int | None = None
    time_limit: int | None = None
    task: Task | None = None

    def __post_init__(self) -> None:
        check_name(
            self.unseen, UNSEEN, "rule for unseen pairs called", "a sample model"
        )
        # The dataclass is frozen: only object.__setattr__ can still set its fields.
        object.__setattr__(self, "shape", tuple(self.shape))  # a file holds a list
        check_parts("sample model", self._numbers())
        check_table(self.n_states, self.n_actions)
        for name, dtype in DTYPES.items():
            array = np.asarray(getattr(self, name))
            is_castable = np.can_cast(array.dtype, dtype, "same_kind")
            check_parts("sample model", [(name, array.ndim == 1 and is_castable)])
            # One type for numba, so that kernels are compiled once.
            object.__setattr__(self, name, np.ascontiguousarray(array, dtype))
        check_parts("sample model", self._contents())

    def _numbers(self) -> Iterator[tuple[str, bool]]:
        """Whether the sizes and limits are whole numbers that a model can have."""
        limits = [n for n in (self.episode_steps, self.time_limit) if n is not None]
        for n in (*self.shape, self.n_actions, *limits):
            is_whole = isinstance(n, int | np.integer) and 1 <= n < 2**53
            yield "shape, n_actions, episode_steps or time_limit", is_whole

    def _contents(self) -> Iterator[tuple[str, object]]:
        """Each array, and whether it fits a model: the kernels that draw from it check no bounds."""
        outcomes = len(self.s_next)
        pairs = self.n_states * self.n_actions
        yield "rewards", len(self.rewards) > 0
        yield "rewards", (np.abs(self.rewards) <= LARGEST_NUMBER).all()
        yield "rewards", (np.diff(self.rewards) > 0).all()
        yield "r", len(self.r) == outcomes
        yield "r", np.isin(self.r, self.rewards).all()
        yield "terminated", len(self.terminated) == outcomes
        yield "s_next", all_in_range(self.s_next, self.n_states)
        yield "starts", len(self.starts) > 0
        yield "starts", all_in_range(self.starts, self.n_states)
        yield "offsets", len(self.offsets) == pairs + 1
        yield "offsets", self.offsets[0] == 0
        yield "offsets", self.offsets[-1] == outcomes
        yield "offsets", (np.diff(self.offsets) >= 0).all()
        yield "cumulative", len(self.cumulative) == outcomes
        # Floats, too, add numbers below 2**53 exactly; differences of huge ones would wrap around.
        yield "cumulative", all_in_range(self.cumulative, 2**53)
        yield "cumulative", (self.count >= 1).all()

    @classmethod
    def from_recording(
        cls, recording: Recording, unseen: Unseen = "uniform"
    ) -> "SampleModel":
        """Count the transitions of a recording. Time and memory are in proportion to its length.

        Parameters
        ----------
        recording : Recording
            The transitions.
        unseen : str
            The outcomes of a pair that was never tried, see the class.

        Returns
        -------
        SampleModel
            The model; it holds each transition once.

        Raises
        ------
        ValueError
            If `recording` is not a Recording, or if `unseen` is unknown.
        """
        if not isinstance(recording, Recording):
            raise ValueError(
                f"a sample model is made from a Recording, not from {recording!r:.200}"
            )
        source = recording.source
        n_actions = source.actions.n
        pairs = check_table(source.states.n, n_actions)
        steps = [
            recording.s * n_actions + recording.a,
            recording.s_next,
            recording.r,
            recording.terminated,
        ]
        order = np.lexsort(steps[::-1])  # by pair first
        steps = [column[order] for column in steps]
        is_new = np.any([column[1:] != column[:-1] for column in steps], axis=0)
        # The row of each outcome among the sorted steps, where it is seen first
        first = np.append(0, np.flatnonzero(is_new) + 1)
        pair, s_next, r, terminated = [column[first] for column in steps]
        offsets = np.searchsorted(pair, np.arange(pairs + 1))
        # Steps up to the last one of each outcome, without those of the pairs before
        total = np.append(first[1:], len(recording))
        before = np.append(0, total)[offsets[pair]]
        return cls(
            shape=source.states.shape,
            n_actions=n_actions,
            offsets=offsets,
            s_next=s_next,
            r=r,
            terminated=terminated,
            cumulative=total - before,
            starts=recording.s[recording.step == 0],
            rewards=np.unique(source.rewards),
            unseen=unseen,
            episode_steps=source.episode_steps,
            time_limit=source.time_limit,
            task=recording.task,
        )

    def __repr__(self) -> str:
        seen = np.count_nonzero(np.diff(self.offsets))
        return f"<SampleModel of {self.n_states} states, {self.n_actions} actions: {seen} pairs seen>"

    @property
    def n_states(self) -> int:
        """Number of states."""
        return math.prod(self.shape)

    @property
    def r_max(self) -> float:
        """Largest reward that the task can give."""
        return float(self.rewards[-1])

    @property
    def count(self) -> NDArray[np.int64]:
        """How often each outcome was seen, int array (outcomes,)."""
        count = np.diff(self.cumulative, prepend=np.int64(0))
        was_tried = np.diff(self.offsets) > 0
        first = self.offsets[:-1][was_tried]
        count[first] = self.cumulative[first]
        return count

    @property
    def pair(self) -> NDArray[np.intp]:
        """The pair s * n_actions + a that each outcome belongs to, int array (outcomes,)."""
        pairs = np.arange(self.n_states * self.n_actions)
        outcomes = np.diff(self.offsets).astype(np.intp)
        return np.repeat(pairs, outcomes)

    @property
    def pair_count(self) -> NDArray[np.int64]:
        """How often each pair was tried, int array (n_states, n_actions)."""
        count = self.sum_by_pair(1).astype(np.int64)
        return count.reshape(self.n_states, self.n_actions)

    def sum_by_pair(self, x: float | NDArray[Any]) -> NDArray[Any]:
        """Sum a quantity over the samples of each pair.

        Parameters
        ----------
        x : float or array (outcomes,)
            The quantity, one number for each outcome; it is added as often as the outcome was seen.

        Returns
        -------
        float array (n_states * n_actions,)
            The sums, 0 for a pair that was never tried.
        """
        pairs = len(self.offsets) - 1
        return np.bincount(self.pair, weights=self.count * x, minlength=pairs)

    def outcomes(self, s: int, a: int) -> list[tuple[int, float, bool, int]]:
        """The outcomes seen after (s, a).

        Parameters
        ----------
        s, a : int
            Numbers of a state and an action.

        Returns
        -------
        list of tuple (int, float, bool, int)
            The outcomes (s', r, terminated, count); empty for a pair that was never tried.

        Raises
        ------
        ValueError
            If there is no such state or action.
        """
        s = check_index("state", s, self.n_states)
        a = check_index("action", a, self.n_actions)
        pair = s * self.n_actions + a
        rows = slice(self.offsets[pair], self.offsets[pair + 1])
        return list(
            zip(
                self.s_next[rows].tolist(),
                self.r[rows].tolist(),
                self.terminated[rows].tolist(),
                self.count[rows].tolist(),
                strict=True,
            )
        )

    def diagnose(self) -> Diagnosis:
        """The gaps of the model, and the loops in which it may promise too much.

        A pair is suspect if all its recorded outcomes lead to one state, with a mean reward above the recording's
        mean, and there are at most three of them. See `Loop` for what suspect pairs can make.

        Returns
        -------
        Diagnosis
            Coverage and suspect loops; it shows itself in words.

        Notes
        -----
        A model without suspect loops can still promise what no robot can keep, for example where a state lumps
        together places that differ. `hold_back` looks for that.
        """
        pair_count = self.pair_count.ravel()
        reward = self.sum_by_pair(self.r)
        mean_reward = reward.sum() / pair_count.sum()

        seen = np.flatnonzero(pair_count)
        first = self.offsets[seen].astype(np.intp)
        lowest = np.minimum.reduceat(self.s_next, first)
        highest = np.maximum.reduceat(self.s_next, first)
        ends = np.add.reduceat(self.terminated, first) > 0
        is_certain = (lowest == highest) & ~ends
        is_good = reward[seen] / pair_count[seen] > mean_reward
        is_rare = pair_count[seen] <= 3
        is_suspect = is_certain & is_good & is_rare
        suspects = Suspects(
            pair=seen[is_suspect],
            s=seen[is_suspect] // self.n_actions,
            s_next=lowest[is_suspect],
            samples=pair_count[seen[is_suspect]],
            reward=reward[seen[is_suspect]],
        )
        return Diagnosis(
            n_states=self.n_states,
            states_seen=len(np.union1d(seen // self.n_actions, self.s_next)),
            n_pairs=pair_count.size,
            pairs_seen=len(seen),
            pairs_seen_once=int((pair_count == 1).sum()),
            mean_reward=float(mean_reward),
            loops=find_loops(suspects, self.n_states, self.n_actions),
        )

    @staticmethod
    def hold_back(recording: Recording) -> HeldBack:
        """Make a model of the first four fifths of a recording, and compare what it says of the last fifth.

        The model guesses what comes next after (s, a): the next state, the reward and the end. Where states tell all
        that matters, nobody can guess better by the step before. If that does help, states lump together what differs.
        Then a plan or an agent can chain steps in the model that no robot can do one after the other.

        Parameters
        ----------
        recording : Recording
            The transitions, in the order in which they came.

        Returns
        -------
        HeldBack
            Rewards and guesses, and what may be concluded; it shows itself in words.

        Raises
        ------
        ValueError
            If the recording has one row only.
        """
        return hold_back(recording)

    def save(self, path: str | Path) -> None:
        """Write the model to one ``.npz`` file, whole or not at all.

        Parameters
        ----------
        path : str or Path
            The file.

        Raises
        ------
        ValueError
            If the file would be too large to be read again, or its name ends like that of another kind of file.
        OSError
            If the file cannot be written.
        """
        about = {name: getattr(self, name) for name in ABOUT}
        arrays = {name: getattr(self, name) for name in DTYPES}
        save_arrays(path, "sample model", about, arrays)

    @classmethod
    def load(cls, path: str | Path) -> "SampleModel":
        """The model that `save` wrote.

        Parameters
        ----------
        path : str or Path
            The file.

        Returns
        -------
        SampleModel
            The same model, without its task.

        Raises
        ------
        ValueError
            If the file is damaged or of another kind.
        FileNotFoundError
            If there is none.
        """

        def make(about: dict[str, Any], arrays: dict[str, Any]) -> SampleModel:
            return cls(**(about | arrays))

        return load_arrays(path, "sample model", make)
