"""Many arms learn, one after the other; what counts is how they end."""

from typing import NamedTuple

import numpy as np

from rlrobot_course.play.report import averages
from rlrobot_course.worlds.arm_world import ArmWorld
from rlrobot_edu import Agent, Task, learn


class Ends(NamedTuple):
    """The last episodes of several arms: rewards, array (arms, steps), and the share of steps in contact, (arms,)."""

    rewards: np.ndarray
    contact: np.ndarray

    @property
    def means(self) -> np.ndarray:
        """Mean reward of each arm, array (arms,)."""
        return self.rewards.mean(axis=1)


def last_episodes(
    task: Task | str,
    method: str = "TOSL+QBIASSR",
    arms: int = 30,
    episodes: int = 10,
    seed: int = 0,
) -> Ends:
    """Let `arms` agents learn for some episodes in the arm of geometry; how their last episodes went.

    seed: the first agent's; the next ones have the next numbers
    """
    world = ArmWorld(task)
    n, contact, rewards, touched = (
        world.episode_steps,
        world.places.distance <= 0.05,
        [],
        [],
    )
    for i in range(arms):
        agent = Agent(world, method, seed=seed + i)
        history = learn(agent, world, steps=n * episodes, progress=False, keep=True)
        where, _ = last_path(world, history.a[-n:])
        rewards.append(history.rewards[-n:])
        touched.append(contact[where[1:]].mean())
    return Ends(np.array(rewards), np.array(touched))


def last_path(world: ArmWorld, actions: np.ndarray) -> tuple[list[int], np.ndarray]:
    """An episode once more, by its actions: the places before and after each step, and the rewards."""
    where, paid = [0], []
    for a in actions:
        paid.append(world.rewards[where[-1], a])
        where.append(int(world.places.next[where[-1], a]))
    return where, np.array(paid)


def stored_means(
    experiment: str = "robot_arm_1k", length: str = "10 episodes"
) -> dict[str, np.ndarray]:
    """The final average rewards in the report of the reproduction, arrays (repetitions,) by method.

    They come from arms in PyBullet, and took many minutes.
    """
    return averages()[experiment, length]
