"""The cliff (Sutton & Barto, example 6.6): an environment in which Q-learning and SARSA learn different ways."""

from __future__ import annotations

from functools import cache

import gymnasium
import numpy as np

from rlrobot_edu.models.sample_model import SampleModel

SHAPE = (4, 12)  # rows and columns; state = 12 · row + column
START, GOAL = 36, 47
CLIFF = range(START + 1, GOAL)
MOVES = ("up", "right", "down", "left")  # actions 0 to 3
SHORTEST = -13  # sum of the rewards of the shortest way


@cache
def cliff_model() -> SampleModel:
    """Gymnasium's ``CliffWalking-v1``, copied from its table of outcomes into a model that learns compiled.

    An episode is cut off after 500 steps; the original has no such limit.
    """
    env = gymnasium.make("CliffWalking-v1")
    pairs = [
        (s, a)
        for s in range(env.observation_space.n)
        for a in range(env.action_space.n)
    ]
    # without slipping every pair has one outcome: probability 1, s', r, terminated
    outcomes = [env.unwrapped.P[s][a][0] for s, a in pairs]
    _, s_next, r, terminated = (
        np.array(column) for column in zip(*outcomes, strict=True)
    )
    return SampleModel(
        shape=SHAPE,
        n_actions=len(MOVES),
        offsets=np.arange(len(pairs) + 1),
        s_next=s_next.astype(np.int64),
        r=r.astype(float),
        terminated=terminated.astype(bool),
        cumulative=np.ones(len(pairs), dtype=np.int64),
        starts=np.array([START]),
        rewards=np.unique(r).astype(float),
        episode_steps=500,
    )


def greedy_path(q: np.ndarray) -> tuple[int, ...]:
    """States from start to goal of an agent that always takes its best action and does not learn any more.

    q: array (48, 4). Where the way comes back to a state it has passed, it would go round for ever: it ends there.
    """
    model, path = cliff_model(), [START]
    while path[-1] != GOAL and len(set(path)) == len(path):
        path.append(model.outcomes(path[-1], int(q[path[-1]].argmax()))[0][0])
    return tuple(path)
