"""A robot's life episode by episode: where it went, how long it took, what it was paid."""

from typing import NamedTuple

import numpy as np

from rlrobot_edu import Agent, steps
from rlrobot_edu.learning.size import Env
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.describe import robot_of


class Episode(NamedTuple):
    """One episode.

    path: array (n + 1, 2), where the robot was before and after each of its n steps [m]
    rewards: array (n,); terminated: whether the goal ended it, or else the clock; scenes: what there was to see
    """

    path: np.ndarray
    rewards: np.ndarray
    terminated: bool
    scenes: list[Scene]

    def __len__(self) -> int:
        return len(self.rewards)


def drive_episodes(
    agent: Agent, env: Env, n: int, most: int = 100_000
) -> list[Episode]:
    """Let the agent learn for `n` episodes, or for `most` steps if that is sooner; an unfinished one is left out."""
    robot, episodes = robot_of(env), list[Episode]()
    rewards, scenes, path = list[float](), list[Scene](), list[tuple[float, float]]()
    start = env.unwrapped.reset()[1]["readings"]  # every episode begins here
    for step in steps(agent, env, most):
        here = robot.readings
        path.append((here["x"], here["y"]))
        rewards.append(step.r)
        scenes.append(robot.scene())
        if step.terminated or step.truncated:
            way = np.array([(start["x"], start["y"]), *path])
            episodes.append(
                Episode(way, np.array(rewards), step.terminated, scenes[-200:])
            )
            rewards, scenes, path = [], [], []
        if len(episodes) == n:
            break
    return episodes
