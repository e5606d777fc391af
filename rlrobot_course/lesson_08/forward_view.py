"""The forward view of λ, done online: the ideal that SARSA(λ) comes near and true online SARSA(λ) meets."""

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from rlrobot_edu.learning.agent import Agent

# the three ways to mark a pair as visited: method and settings of an Agent
TRACES = {
    "accumulating": ("SL+SR", {"accumulating": True}),
    "replacing": ("SL+SR", {}),
    "dutch": ("TOSL+SR", {}),
}


def lambda_return(
    rewards: Sequence[float], values: Sequence[float], gamma: float, lam: float
) -> float:
    """The λ-return as far as it is known after n steps: a weighted mean of all k-step returns.

    rewards, values: lists (n,); values[k - 1] is what the pair reached after k steps was worth
    Source: Sutton & Barto, sections 12.1 and 12.3.
    """
    g = values[-1]
    for r, v in zip(reversed(rewards), reversed(values), strict=True):
        g = r + gamma * ((1 - lam) * v + lam * g)
    return g


def online_lambda_return(
    steps: Sequence[tuple], q_start: np.ndarray, alpha: float, gamma: float, lam: float
) -> Iterator[np.ndarray]:
    """The online λ-return algorithm: at every step, all updates are done again.

    steps: list of (s, a, r, s', a', terminated), one episode; q_start: array (n_states, n_actions)
    Yields Q after each step, an array like `q_start`. Source: Sutton & Barto, section 12.4.
    """
    q, values = q_start, []
    for h in range(1, len(steps) + 1):
        *_, s_next, a_next, terminated = steps[h - 1]
        values.append(
            0.0 if terminated else q[s_next, a_next]
        )  # noted on arrival, never changed again
        q = q_start.copy()
        for t in range(h):
            s, a, *_ = steps[t]
            rewards = [r for _, _, r, *_ in steps[t:h]]
            q[s, a] += alpha * (
                lambda_return(rewards, values[t:], gamma, lam) - q[s, a]
            )
        yield q


def replay(
    trace: str, steps: Sequence[tuple], world: Any, **settings: Any
) -> Iterator[Agent]:
    """A new agent that learns from recorded steps of one episode, by the library's own update; yields it after each.

    trace: ``accumulating``, ``replacing`` (both SARSA(λ)) or ``dutch`` (true online SARSA(λ))
    steps: list of (s, a, r, s', a', terminated); world, settings: of the `Agent`
    """
    method, more = TRACES[trace]
    agent = Agent(world, method, **more, **settings)
    for step in steps:
        agent.update(*step)
        yield agent
