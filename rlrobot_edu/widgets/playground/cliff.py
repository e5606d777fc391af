"""The cliff (Sutton & Barto, example 6.6): an environment in which Q-learning and SARSA learn different paths."""

from __future__ import annotations

from functools import cache

import gymnasium
import numpy as np

from rlrobot_edu.models.sample_model import SampleModel

SHAPE = (4, 12)  # rows and columns; state = 12 · row + column
START, GOAL = 36, 47
CLIFF = range(START + 1, GOAL)
MOVES = ("up", "right", "down", "left")  # actions 0 to 3
SHORTEST = -13  # sum of the rewards on the shortest path


@cache
def cliff_model() -> SampleModel:
    """Gymnasium's ``CliffWalking-v1``, copied from its table of outcomes into a model that learns compiled.

    An episode is cut off after 500 steps; the original has no such limit.
    """
    env = gymnasium.make("CliffWalking-v1")
    s_next, r, terminated = [], [], []
    for s in range(env.observation_space.n):
        for a in range(env.action_space.n):
            # Without slipping, every pair has one outcome of probability 1.
            _, its_s_next, its_r, is_end = env.unwrapped.P[s][a][0]
            s_next.append(its_s_next)
            r.append(its_r)
            terminated.append(is_end)
    n_pairs = len(s_next)
    return SampleModel(
        shape=SHAPE,
        n_actions=len(MOVES),
        offsets=np.arange(n_pairs + 1),
        s_next=np.array(s_next, dtype=np.int64),
        r=np.array(r, dtype=float),
        terminated=np.array(terminated, dtype=bool),
        cumulative=np.ones(n_pairs, dtype=np.int64),
        starts=np.array([START]),
        rewards=np.unique(np.array(r, dtype=float)),
        episode_steps=500,
    )


def greedy_path(q: np.ndarray) -> tuple[int, ...]:
    """States from start to goal of an agent that always takes its best action and does not learn any more.

    q: array (48, 4). The path ends at the first state that it reaches again: from there it would go round for ever.
    """
    model = cliff_model()
    path = [START]
    while path[-1] != GOAL and path[-1] not in path[:-1]:
        s = path[-1]
        best = int(q[s].argmax())
        s_next, *_ = model.outcomes(s, best)[0]
        path.append(s_next)
    return tuple(path)
