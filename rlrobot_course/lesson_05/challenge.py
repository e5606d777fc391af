"""Open challenge of lesson 05: a bias of one's own."""

import numpy as np

from rlrobot_course.play.challenge import Challenge, Watched, array, mean_reward
from rlrobot_edu import Agent


def earned(bias: Watched, seed: int) -> float:
    """Reward a step of a Q-learner that chooses by softmax with that bias, in its first 1200 steps."""

    def choose(agent: Agent, s: int, t: int, tries: np.ndarray) -> np.ndarray:
        x = agent.q[s] + bias(agent.q.copy(), tries.copy(), agent.shape, s)
        powers = np.exp(x - x.max())
        return powers / powers.sum()

    return mean_reward(choose, 1200, seed)


challenge = Challenge(
    "05",
    "Write my_bias(q, tries, shape, s): nine numbers that are added to q[s] before the softmax. tries is a table like "
    "q, of how often each pair was tried. A robot of wander_1k learns with it by Q-learning, T = 1. What counts is the "
    "reward a step in its first 1200 steps.",
    "reward a step", lambda bias: Watched(bias, "my_bias(q, tries, shape, s)", array(9, 1000)), earned,
)  # fmt: skip
