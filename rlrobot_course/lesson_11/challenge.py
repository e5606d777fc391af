"""Open challenge of lesson 11: a set of sensors of one's own, with at most 64 states."""

from dataclasses import replace
from typing import Any

from rlrobot_course.play.challenge import Challenge
from rlrobot_edu import Agent, InputVariable, Task, learn, load_task, make_env
from rlrobot_edu.task.robot_cards import LASERS

MOST = 64  # states


def read(sensors: Any) -> Task:
    """wander_1k with the learner's sensors. Raises ValueError for what is no laser, or above 64 states."""
    if not isinstance(sensors, dict) or not sensors:
        raise ValueError(
            'a dict of sensors and cut points is expected, as {"laser_front": [0.5]}'
        )
    others = [name for name in sensors if name not in LASERS]
    if others:
        raise ValueError(
            f"{others[0]} is none of the eight lasers: {', '.join(LASERS)}"
        )
    inputs = [
        InputVariable(name, cuts=cuts, unit="m") for name, cuts in sensors.items()
    ]
    task = replace(load_task("wander_1k"), inputs=inputs)
    if task.states.n > MOST:
        raise ValueError(
            f"these sensors make {task.states.n} states, and at most {MOST} are allowed"
        )
    return task


def earned(task: Task, seed: int) -> float:
    """Reward a step of a robot in its first 1,000 steps."""
    return float(
        learn(
            Agent(task, seed=seed),
            make_env(task, seed=seed),
            steps=1000,
            progress=False,
        ).rewards.mean()
    )


challenge = Challenge(
    "11",
    'Write my_sensors, such as {"laser_front": [0.5], "laser_left": [0.3, 0.6]}: any of the eight lasers with their '
    "cut points in metres, in all at most 64 states. All else is wander_1k, and the robot learns by TOSL+QBIASSR. What "
    "counts is the reward a step in its first 1,000 steps.",
    "reward a step", read, earned,
)  # fmt: skip
