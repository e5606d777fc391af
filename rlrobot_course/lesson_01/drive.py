"""Robots of wander_simple that learn by a learner's own reward."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

from rlrobot_course.drives.by_your_code import Reel, number
from rlrobot_course.exercises.design import Pay, Readings, paid_by
from rlrobot_course.lesson_01.design import PAIRS
from rlrobot_edu import Agent, learn, load_task, make_env, steps
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.film import Film
from rlrobot_edu.task.rewards import distance_moved
from rlrobot_grading.answers.values import Function


@dataclass(frozen=True)
class Drive:
    """What a robot did in some steps. scenes, readings: one more than steps; rewards: one a step"""

    scenes: Sequence[Scene]
    readings: Sequence[Mapping[str, float]]
    rewards: Sequence[float]

    def film(self, n: int) -> Film:
        """The first `n` steps as a moving picture."""
        return Film(list(self.scenes[1 : n + 1]), list(self.rewards[:n]))

    def ways(self) -> list[float]:
        """How far each step moved the robot [m]."""
        return [
            distance_moved(before, after) for before, after in pairwise(self.readings)
        ]


def drive_by(reward: Pay, seed: int = 0) -> Drive:
    """The 100 steps of a robot after 1000 steps of learning by `reward`, with Q-learning and softmax regression.

    The reward counts as the nearest of those paid in the situations of `design`; see `paid_by`.
    """
    env = make_env(paid_by(load_task("wander_simple"), reward, PAIRS), seed=seed)
    agent = Agent(env.unwrapped.task, "Q+SR", loop_evasion=False, seed=seed)
    learn(agent, env, steps=1000, progress=False)
    scenes, readings, rewards = [env.robot.scene()], [env.robot.readings], []
    for step in steps(agent, env, 100, resume=True):
        scenes.append(env.robot.scene())
        readings.append(env.robot.readings)
        rewards.append(step.r)
    return Drive(scenes, readings, rewards)


def by_reward(reward: Function, reel: Reel) -> None:
    """The robot of `drive_by`; the film tells what the task's own reward would pay."""

    def pays(before: Readings, after: Readings) -> float:
        return number(reward(before, after))

    drive = drive_by(pays)
    own = load_task("wander_simple").reward_for
    readings = zip(drive.scenes[1:], pairwise(drive.readings), strict=True)
    for scene, (before, after) in readings:
        reel.take(scene, own(before, after))


drives = {"reward": by_reward}
