"""Open challenge of lesson 13a: the 60 steps from which the best model is made."""

from __future__ import annotations

from typing import Any

import numpy as np

from rlrobot_course.challenge import Challenge, Watched, array, rewards_of
from rlrobot_course.lesson_13a.worlds import drive
from rlrobot_edu.environments import make_env
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.loop import learn
from rlrobot_edu.learning.transitions import Transitions
from rlrobot_edu.models.recording import Recording
from rlrobot_edu.models.sample_model import SampleModel
from rlrobot_edu.models.source import Source
from rlrobot_edu.task.task_file import load_task

ROWS = 60


def read(driver: Any) -> Watched:
    """The learner's driver, which returns three probabilities."""
    return Watched(driver, "my_driver(tries_s, paid_s, t)", array(3, 1, sums_to=1))


def earned(driver: Watched, seed: int) -> float:
    """Reward a step, in 300 steps on the robot, of an agent that has learned 20,000 steps in the driver's model."""
    task, rows = load_task("worked_example"), []
    tries, paid = np.zeros((task.states.n, 3), dtype=int), np.zeros((task.states.n, 3))

    def choose(s: int, t: int) -> Any:
        return driver(tries[s].copy(), paid[s] / np.maximum(1, tries[s]), t)

    def note(s: int, a: int, r: float, s_next: int, a_next: int, terminated: bool) -> None:
        tries[s, a], paid[s, a] = tries[s, a] + 1, paid[s, a] + r
        rows.append((s, a, r, s_next, terminated, False))

    rewards_of(make_env(task, seed=seed), choose, note, ROWS, seed)
    recording = Recording(Transitions(*map(np.array, zip(*rows, strict=True))), Source.of_task(task), task)
    model, agent = SampleModel.from_recording(recording, unseen="stay"), Agent(task, seed=seed)
    learn(agent, make_env(model, seed=seed), steps=20_000, progress=False)
    return drive(agent, make_env(task, seed=seed), 300)


challenge = Challenge(
    "13a",
    "Write my_driver(tries_s, paid_s, t), which returns three probabilities: from how often each action was tried in "
    "this state, what it paid there on average, and the number of the step. It drives the robot in its four cells for "
    "60 steps, and an agent learns in the model of these. What counts is its reward a step on the robot, without "
    "learning on.",
    "reward a step", read, earned, seeds=60,
)  # fmt: skip
