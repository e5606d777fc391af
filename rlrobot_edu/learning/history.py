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
    r_max: largest reward of the task; episode_steps: steps of a whole episode, None where a task goes on for ever
    s, a, s_next: arrays (n,) of int, the transitions; None unless ``learn(..., keep=True)`` kept them
    """

    method: str
    rewards: np.ndarray
    terminated: np.ndarray
    truncated: np.ndarray
    q: np.ndarray
    visits: np.ndarray
    seconds: float
    r_max: float = 1.0
    episode_steps: int | None = None
    s: np.ndarray | None = None
    a: np.ndarray | None = None
    s_next: np.ndarray | None = None

    def __len__(self) -> int:
        return len(self.rewards)

    def __repr__(self) -> str:
        last = f", average reward {self.average_reward[-1]:.3f}" if len(self) else ""
        return f"<History of {self.method}: {len(self)} steps{last}>"

    @property
    def average_reward(self) -> np.ndarray:
        """The paper's learning curve: mean of the rewards of steps 0..t, the current one included; array (n,).

        A step that reaches the goal of an episodic task stands for the rest of its episode, too: Rmax a step.
        """
        total, count = np.cumsum(self.rewards), np.arange(1, len(self) + 1)
        if self.episode_steps is None or not self.terminated.any():
            return total / count
        after, rest = self._rest()
        return (total + np.cumsum(after * rest)) / (count + np.cumsum(rest))

    @property
    def last_episode(self) -> np.ndarray:
        """The learning curve within the last finished episode, its goal counted as above; array (episode_steps,).

        Where no episode has ended yet it is that of the steps so far.
        """
        ends = self._ends()
        first = ends[-2] + 1 if len(ends) > 1 else 0
        last = ends[-1] if len(ends) else len(self) - 1
        rewards = self.rewards[first : last + 1]
        if len(ends) and self.episode_steps is not None:
            after, rest = self._rest()
            rewards = np.concatenate([rewards, np.full(rest[last], after[last])])
        return np.cumsum(rewards) / np.arange(1, len(rewards) + 1)

    @property
    def final_average_reward(self) -> float:
        """The number by which the paper compares methods: over all steps, or over an episodic task's last episode."""
        return float((self.average_reward if self.episode_steps is None else self.last_episode)[-1])

    @property
    def policy(self) -> np.ndarray:
        """The action that was best in each state at the end, array (n_states,) of int."""
        return self.q.argmax(axis=1)

    @property
    def returns(self) -> np.ndarray:
        """Sum of the rewards of each finished episode, array (episodes,)."""
        totals = np.cumsum(self.rewards)[self._ends()]
        return np.diff(totals, prepend=0.0)

    def _ends(self) -> np.ndarray:
        """Numbers of the steps that ended an episode."""
        return np.flatnonzero(self.terminated | self.truncated)

    def _rest(self) -> tuple[np.ndarray, np.ndarray]:
        """For each step: the reward of a step after it, and how many such steps its terminated episode had left.

        An end with a positive reward is the goal; any other end (a hole in the ice) repeats its reward.
        """
        ends = self._ends()
        done = np.diff(ends, prepend=-1)  # length of each episode
        rest = np.zeros(len(self), dtype=np.int64)
        rest[ends] = np.where(self.terminated[ends], np.maximum(self.episode_steps - done, 0), 0)
        return np.where(self.rewards > 0, self.r_max, self.rewards), rest
