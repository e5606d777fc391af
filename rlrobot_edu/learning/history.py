"""What happened while an agent learned."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rlrobot_edu.checks import LARGEST_NUMBER, all_in_range, check_parts
from rlrobot_edu.files import load_arrays, save_arrays
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.learning.resume import ResumePoint
from rlrobot_edu.learning.size import Size
from rlrobot_edu.learning.transitions import Transitions

# All other columns are integers
DTYPES = {
    "r": np.float64,
    "q": np.float64,
    "terminated": np.bool_,
    "truncated": np.bool_,
}


class Learned(NamedTuple):
    """What an agent has learned, listed for the pairs (s, a) that it knows: what is zero takes no room.

    pair: array (pairs,) of int, s * n_actions + a
    q, visits: arrays (pairs,), action value and number of visits
    """

    pair: NDArray[np.int32]
    q: NDArray[np.float64]
    visits: NDArray[np.int32]

    @classmethod
    def of(cls, q: NDArray[np.float64], visits: NDArray[np.int64]) -> "Learned":
        """The same without the zeros; q, visits: arrays (n_states, n_actions)."""
        pair = np.flatnonzero((q != 0) | (visits != 0))
        return cls(
            pair.astype(np.int32),
            q.ravel()[pair],
            visits.ravel()[pair].astype(np.int32),
        )


@suggests_keywords
@dataclass(frozen=True, eq=False, repr=False)
class History:
    """The record of one learning process of n steps, as `learn` returns it.

    Parameters
    ----------
    method : str
        The agent's method, for legends.
    transitions : Transitions
        Columns, arrays (n,): rewards and ends of episodes, and states and actions where they were kept.
    learned : Learned
        What the agent knew at the end.
    seconds : float
        Wall-clock time of the whole process [s].
    size : Size
        States, actions, largest reward and steps of an episode of the world.
    origin : str
        Which repetition of which experiment it is; empty for any other.
    before : ResumePoint
        Of a process that was resumed: ``before.steps``, the steps that its first episode had already had, and
        ``before.reward``, the sum of their rewards. They are not in this history, but count in `returns`, in
        `last_episode`, and in how long the rest of the episode is.
    """

    method: str
    transitions: Transitions
    learned: Learned
    seconds: float
    size: Size
    origin: str = ""
    before: ResumePoint = ResumePoint()

    def __len__(self) -> int:
        return len(self.rewards)

    def __repr__(self) -> str:
        text = f"History of {self.method}: {len(self)} steps"
        if len(self):
            text += f", average reward {self.average_reward[-1]:.3f}"
        return f"<{text}>"

    @property
    def rewards(self) -> NDArray[np.float64]:
        """The reward of each step, array (n,)."""
        return self.transitions.r

    @property
    def terminated(self) -> NDArray[np.bool_]:
        """Whether an episode ended for good with each step, array (n,)."""
        return self.transitions.terminated

    @property
    def truncated(self) -> NDArray[np.bool_]:
        """Whether an episode was cut off with each step, array (n,)."""
        return self.transitions.truncated

    @property
    def s(self) -> NDArray[np.integer] | None:
        """The state before each step, array (n,) of int; None unless ``learn(..., keep=True)`` kept it."""
        return self._kept(self.transitions.s)

    @property
    def a(self) -> NDArray[np.integer] | None:
        """The action of each step, array (n,) of int; None unless ``learn(..., keep=True)`` kept it."""
        return self._kept(self.transitions.a)

    @property
    def s_next(self) -> NDArray[np.integer] | None:
        """The state after each step, array (n,) of int; None unless ``learn(..., keep=True)`` kept it."""
        return self._kept(self.transitions.s_next)

    def _kept(self, column: NDArray[np.integer]) -> NDArray[np.integer] | None:
        return column if len(column) == len(self) else None

    @cached_property
    def q(self) -> NDArray[np.float64]:
        """The action values at the end, array (n_states, n_actions)."""
        return self._table(self.learned.q)

    @cached_property
    def visits(self) -> NDArray[np.int64]:
        """How often the agent had tried each pair at the end, array (n_states, n_actions)."""
        return self._table(self.learned.visits.astype(np.int64))

    def _table(self, entries: np.ndarray) -> np.ndarray:
        table = np.zeros((self.size.n_states, self.size.n_actions), dtype=entries.dtype)
        table.ravel()[self.learned.pair] = entries
        return table

    @property
    def average_reward(self) -> NDArray[np.float64]:
        """The paper's learning curve: mean of the rewards of steps 0..t, the current one included; array (n,).

        A step that reaches the goal of an episodic task stands for the rest of its episode, too: Rmax a step.
        """
        after, rest = self._rest()
        total = np.cumsum(self.rewards) + np.cumsum(after * rest)
        steps = np.arange(1, len(self) + 1) + np.cumsum(rest)
        return np.divide(total, steps)

    @property
    def last_episode(self) -> np.ndarray:
        """The learning curve within the last finished episode, its goal counted as above; array (episode_steps,).

        If no episode has ended yet, it is the curve of the steps so far. If the episode began before this history, the
        curve begins after the steps `before`, which count in each average.
        """
        ends = self._ends()
        first = 0
        before = self.before
        if len(ends) > 1:
            first = ends[-2] + 1
            before = ResumePoint()
        last = ends[-1] if len(ends) else len(self) - 1
        after, rest = self._rest()
        goal = np.repeat(after[last : last + 1], rest[last : last + 1])
        rewards = np.append(self.rewards[first : last + 1], goal)
        total = before.reward + np.cumsum(rewards)
        steps = before.steps + np.arange(1, len(rewards) + 1)
        return total / steps

    @property
    def final_average_reward(self) -> float:
        """The number by which the paper compares methods: over all steps, or over an episodic task's last episode.

        Raises
        ------
        ValueError
            If there are no steps.
        """
        if not len(self):
            raise ValueError(
                "a history without steps has no average reward; learn for at least 1 step"
            )
        if self.size.episode_steps is None:
            return float(self.average_reward[-1])
        return float(self.last_episode[-1])

    @property
    def returns(self) -> np.ndarray:
        """Sum of the rewards of each finished episode, from its first step, array (episodes,).

        So an episode that was resumed counts once, in the history in which it ends.
        """
        totals = np.cumsum(self.rewards)[self._ends()]
        return np.diff(totals, prepend=-self.before.reward)

    def save(self, path: str | Path) -> None:
        """Write the history to one ``.npz`` file, whole or not at all.

        Parameters
        ----------
        path : str or Path
            The file.

        Raises
        ------
        ValueError
            If the file could not be read again, because it would be too large or a number is not finite; or if its
            name ends like that of another kind of file.
        OSError
            If the file cannot be written.
        """
        for name, is_sound in self._parts():
            if not is_sound:
                raise ValueError(
                    f"{path}: {name} of this history is not finite or out of range, so it could not be read again; "
                    "nothing was saved"
                )
        about = {
            "method": self.method,
            "seconds": self.seconds,
            "size": self.size,
            "origin": self.origin,
            "before": self.before,
        }
        arrays = {**self.transitions._asdict(), **self.learned._asdict()}
        save_arrays(path, "history", about, arrays, packed=False)  # packing takes long

    @classmethod
    def load(cls, path: str | Path) -> "History":
        """The history that `save` wrote.

        Parameters
        ----------
        path : str or Path
            The file.

        Returns
        -------
        History
            The same history.

        Raises
        ------
        ValueError
            If the file is damaged or of another kind.
        FileNotFoundError
            If there is none.
        """

        def make(about: dict[str, Any], arrays: dict[str, np.ndarray]) -> History:
            about["size"] = Size.of(Size(*about["size"]))
            about["before"] = ResumePoint(*about["before"])
            columns = [arrays[name] for name in Transitions._fields]
            transitions = Transitions._make(columns)
            learned = Learned._make(arrays[name] for name in Learned._fields)
            history = cls(transitions=transitions, learned=learned, **about)
            check_parts("history", history._parts())
            return history

        return load_arrays(path, "history", make)

    def _parts(self) -> Iterator[tuple[str, object]]:
        """Each part that came from a file, and whether it can be of such a history."""
        yield "method", isinstance(self.method, str)
        yield "origin", isinstance(self.origin, str)
        yield "seconds", isinstance(self.seconds, float) and self.seconds >= 0
        yield "before", type(self.before.steps) is int and self.before.steps >= 0
        most = self.before.steps * LARGEST_NUMBER
        yield "before", abs(self.before.reward) <= most
        n_states = self.size.n_states
        n_actions = self.size.n_actions
        limits = {
            "s": n_states,
            "a": n_actions,
            "s_next": n_states,
            "pair": n_states * n_actions,
            "visits": np.iinfo(np.int64).max,
        }
        columns = self.transitions._asdict() | self.learned._asdict()
        for name, column in columns.items():
            dtype = np.dtype(DTYPES.get(name, np.int64))
            yield name, column.dtype.kind == dtype.kind
            n = len(self.learned.pair if name in Learned._fields else self.rewards)
            is_left_out = name in ("s", "a", "s_next") and column.size == 0
            yield name, is_left_out or column.shape == (n,)
            yield name, np.isfinite(column).all()
            if name == "r":
                # a small float of NumPy overflows beside 1e100
                yield name, (np.abs(column.astype(float)) <= LARGEST_NUMBER).all()
            if name in limits:
                yield name, all_in_range(column, limits[name])

    def _ends(self) -> np.ndarray:
        """Numbers of the steps that ended an episode."""
        return np.flatnonzero(self.terminated | self.truncated)

    def _rest(self) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
        """How each step counts for the rest of its episode: the reward of a step of that rest, and its number of steps.

        There is a rest only if the step terminated the episode before its `episode_steps` were over. After a positive
        reward, which is that of a goal, each step of the rest earns Rmax. Any other end (a hole in the ice) repeats
        its reward.
        """
        ends = self._ends()
        lengths = np.diff(ends, prepend=-1 - self.before.steps)  # of the episodes
        left = np.maximum((self.size.episode_steps or 0) - lengths, 0)
        rest = np.zeros(len(self), dtype=np.int64)
        rest[ends] = left * self.terminated[ends]
        after = np.where(self.rewards > 0, self.size.r_max, self.rewards)
        return after, rest
