"""Open challenge of lesson 11: a reward of one's own that leads to the goal."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from rlrobot_course.challenge import Challenge, Watched, number
from rlrobot_course.paid import Paid
from rlrobot_edu.environments import make_env
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.loop import learn
from rlrobot_edu.task.task_file import load_task

# fewer inputs, and geometry in place of physics: it finds the goal within the hour, and the score within seconds
TASK = replace(load_task("navigation_1k"), inputs=load_task("navigation_1k").inputs[:4])


def read(reward: Any) -> Watched:
    """The learner's reward, a number from −10 to 10."""
    return Watched(reward, "my_reward(before, after)", number(-10, 10))


def arrivals(reward: Watched, seed: int) -> float:
    """How often a robot arrives at the goal in an hour."""

    def pay(before: Any, after: Any, r: float, terminated: bool) -> float:
        return 10.0 if r == 10 else float(reward(dict(before), dict(after)))

    env = Paid(make_env(TASK, seed=seed, engine="kinematic"), pay)
    return float(learn(Agent(env, seed=seed), env, steps=3600, progress=False).terminated.sum())


challenge = Challenge(
    "11",
    "Write my_reward(before, after), any number from −10 to 10. Within 0.5 m of the goal, (1.65, 1.575), 10 is paid; "
    "elsewhere the robot of navigation_1k gets yours. The readings are x, y, theta and eight lasers. Its own state is "
    "x, y, theta and the front laser. What counts is how often it arrives in its first hour.",
    "arrivals", read, arrivals, seeds=8,
)  # fmt: skip
