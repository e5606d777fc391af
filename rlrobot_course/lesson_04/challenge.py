"""Open challenge of lesson 04: an exploration rule of one's own."""

from typing import Any

import numpy as np

from rlrobot_course.play.challenge import Challenge, Watched, array, mean_reward
from rlrobot_edu import Agent


def earned(rule: Watched, seed: int) -> float:
    """Reward a step of a robot of Q-learning in its first 1,000 steps."""

    def choose(agent: Agent, s: int, t: int, tries: np.ndarray) -> Any:
        return rule(agent.q[s].copy(), tries[s].copy(), t)

    return mean_reward(choose, 1000, seed)


challenge = Challenge(
    "04",
    "Write my_rule(q_s, tries_s, t), which returns nine probabilities: from the nine values of the state, how often "
    "each action was tried there, and the number of the step. With it the robot of section 7 learns by Q-learning, but "
    "no wall holds it. What counts is the reward a step in its first 1,000 steps.",
    "reward a step", lambda rule: Watched(rule, "my_rule(q_s, tries_s, t)", array(9, 1, sums_to=1)), earned,
)  # fmt: skip
