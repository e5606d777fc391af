"""What happened while an agent learned."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class History:
    """The record of one learning process of n steps.

    method: the agent's method, for legends
    rewards: array (n,), the reward of each step
    terminated, truncated: arrays (n,) of bool, whether an episode ended with that step
    q: array (n_states, n_actions), the action values at the end
    visits: array (n_states, n_actions) of int, how often the agent had tried each pair at the end
    seconds: wall-clock time of the whole process [s]
    """

    method: str
    rewards: np.ndarray
    terminated: np.ndarray
    truncated: np.ndarray
    q: np.ndarray
    visits: np.ndarray
    seconds: float

    def __len__(self) -> int:
        return len(self.rewards)

    def __repr__(self) -> str:
        last = f", average reward {self.average_reward[-1]:.3f}" if len(self) else ""
        return f"<History of {self.method}: {len(self)} steps{last}>"

    @property
    def average_reward(self) -> np.ndarray:
        """The paper's learning curve: mean of the rewards of steps 0..t, the current one included; array (n,)."""
        return np.cumsum(self.rewards) / np.arange(1, len(self) + 1)

    @property
    def policy(self) -> np.ndarray:
        """The action that was best in each state at the end, array (n_states,) of int."""
        return self.q.argmax(axis=1)

    @property
    def returns(self) -> np.ndarray:
        """Sum of the rewards of each finished episode, array (episodes,)."""
        ends = np.flatnonzero(self.terminated | self.truncated)
        totals = np.cumsum(self.rewards)[ends]
        return np.diff(totals, prepend=0.0)
