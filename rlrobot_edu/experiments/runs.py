"""Finished repetitions, kept small: what is zero in Q takes no room, in memory or on disk."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from rlrobot_edu.learning.history import History
from rlrobot_edu.learning.size import Size


class Run(NamedTuple):
    """One repetition: a History whose Q and visits are listed for the pairs that the agent tried, and no others.

    rewards, terminated, truncated: arrays (steps,); pair, q, visits: arrays (pairs tried,), pair = s * n_actions + a
    seconds: array (1,) [s]; s, a, s_next: arrays (steps,) of int, or of no length where they were not to be kept
    """

    rewards: np.ndarray
    terminated: np.ndarray
    truncated: np.ndarray
    pair: np.ndarray
    q: np.ndarray
    visits: np.ndarray
    seconds: np.ndarray
    s: np.ndarray
    a: np.ndarray
    s_next: np.ndarray

    @classmethod
    def of(cls, history: History) -> Run:
        """The same without the zeros."""
        pair = np.flatnonzero(history.visits)
        nothing = np.zeros(0, dtype=np.int32)
        path = (history.s, history.a, history.s_next) if history.s is not None else (nothing, nothing, nothing)
        return cls(
            history.rewards, history.terminated, history.truncated, pair.astype(np.int32), history.q.ravel()[pair],
            history.visits.ravel()[pair].astype(np.int32), np.array([history.seconds]), *path,
        )  # fmt: skip

    def history(self, method: str, size: Size) -> History:
        """The History it came from."""
        shape = (size.n_states, size.n_actions)
        q, visits = np.zeros(shape), np.zeros(shape, dtype=np.int64)
        q.ravel()[self.pair], visits.ravel()[self.pair] = self.q, self.visits
        path = (self.s, self.a, self.s_next) if len(self.s) else (None, None, None)
        return History(
            method, self.rewards, self.terminated, self.truncated, q, visits, float(self.seconds[0]),
            size.r_max, size.episode_steps, *path,
        )  # fmt: skip


class Runs(Sequence):
    """The repetitions of one method, in order; each is a History, made when it is asked for."""

    def __init__(self, runs: Sequence[Run], method: str, size: Size) -> None:
        self._runs, self._method, self._size = tuple(runs), method, size

    def __len__(self) -> int:
        return len(self._runs)

    def __getitem__(self, i: int | slice) -> History | Runs:
        if isinstance(i, slice):
            return Runs(self._runs[i], self._method, self._size)
        return self._runs[i].history(self._method, self._size)

    def __repr__(self) -> str:
        return f"<{len(self)} repetitions of {self._method}>"

    @property
    def curves(self) -> np.ndarray:
        """Learning curves, array (repetitions, steps): average reward; in an episodic task, of the last episode."""
        name = "average_reward" if self._size.episode_steps is None else "last_episode"
        return np.array([getattr(self._without_q(run), name) for run in self._runs])

    @property
    def final(self) -> np.ndarray:
        """The final average reward of each repetition, array (repetitions,)."""
        return np.array([self._without_q(run).final_average_reward for run in self._runs])

    @property
    def rewards(self) -> list[np.ndarray]:
        """The rewards of each repetition, arrays (steps,)."""
        return [run.rewards for run in self._runs]

    @property
    def seconds(self) -> np.ndarray:
        """How long each repetition took, array (repetitions,) [s]."""
        return np.array([run.seconds[0] for run in self._runs])

    def _without_q(self, run: Run) -> History:
        nothing = np.zeros((0, self._size.n_actions))
        return History(self._method, *run[:3], nothing, nothing, 0.0, self._size.r_max, self._size.episode_steps)


def to_columns(runs: Sequence[Run]) -> dict[str, np.ndarray]:
    """All arrays of several runs one after the other, by name, and their lengths."""
    lengths = np.array([[len(array) for array in run] for run in runs])
    return {"lengths": lengths, **{name: np.concatenate([getattr(run, name) for run in runs]) for name in Run._fields}}


def from_columns(columns: dict[str, np.ndarray]) -> list[Run]:
    """The runs that `to_columns` wrote."""
    ends = np.cumsum(columns["lengths"], axis=0)
    parts = [np.split(columns[name], ends[:-1, i]) for i, name in enumerate(Run._fields)]
    return [Run(*arrays) for arrays in zip(*parts, strict=True)]
