"""What an agent knows each time it arrives in a state: its values there, the bias, and how often it was there."""

from __future__ import annotations

from typing import NamedTuple

import gymnasium
import numpy as np
from matplotlib.axes import Axes

from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.loop import steps
from rlrobot_edu.learning.qbiassr import compute_bias
from rlrobot_edu.show.curves import mean_interval

GROUPS = np.array([0, 1, 2, 4, 8, 16, 32, 64])  # smallest number of earlier visits in each group
LABELS = ["never", "1", "2–3", "4–7", "8–15", "16–31", "32–63", "64 …"]


class Arrivals(NamedTuple):
    """One entry for each of n steps: the state it led to, and what was known about this state then.

    s: array (n,) of int; visits: array (n,) of int, how often an action had been tried in s
    q, bias: arrays (n, n_actions), Q(s) and bias(s)
    """

    s: np.ndarray
    visits: np.ndarray
    q: np.ndarray
    bias: np.ndarray


def watch_arrivals(agent: Agent, env: gymnasium.Env, n_steps: int) -> Arrivals:
    """Let `agent` learn in `env` for `n_steps` steps and note what it knows about each state it comes to."""
    n_actions = agent.q.shape[1]
    seen = Arrivals(*np.zeros((2, n_steps), dtype=np.int64), *np.zeros((2, n_steps, n_actions)))
    for step in steps(agent, env, n_steps):
        s = step.s_next
        seen.s[step.t], seen.visits[step.t], seen.q[step.t] = s, agent.visits[s].sum(), agent.q[s]
        compute_bias(agent.q, agent.memory.shape, s, seen.bias[step.t])
    return seen


def mean_by_visits(visits: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Mean of the `values`, those that are NaN left out, in each group of `visits`, both arrays (n,).

    Returns an array (groups,), NaN for a group without values.
    """
    known = ~np.isnan(values)
    group = np.searchsorted(GROUPS, visits[known], side="right") - 1
    total = np.bincount(group, values[known], minlength=len(GROUPS))
    count = np.bincount(group, minlength=len(GROUPS))
    return np.divide(total, count, out=np.full(len(GROUPS), np.nan), where=count > 0)


def draw_by_visits(ax: Axes, values: np.ndarray, label: str, colour: str, style: str) -> str:
    """A curve over the groups, with 95 % intervals; returns its means in words.

    A group that fewer than half of the repetitions reached is left out: these are not like the others.
    values: array (repetitions, groups); style: mark and dashes
    """
    x, means, halves = [], [], []
    for g, column in enumerate(values.T):
        known = column[~np.isnan(column)]
        if len(known) > 1 and 2 * len(known) >= len(values):
            mean, half = mean_interval(known)
            x, means, halves = [*x, g], [*means, mean], [*halves, half]
    ax.errorbar(x, means, halves, fmt=style, color=colour, capsize=4, label=label)
    ax.set_xticks(range(len(GROUPS)), LABELS)
    ax.set_xlim(-0.4, max(x) + 0.4)
    ax.set_xlabel("how often the agent had been in the state before")
    ax.grid(alpha=0.3)
    return f"{label}: " + ", ".join(f"{LABELS[g]} {mean:.3g}" for g, mean in zip(x, means, strict=True))
