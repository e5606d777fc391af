"""The same task with its rewards in other units: what a softmax makes of it with and without normalised values."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import gymnasium

from rlrobot_edu.course.lesson_03.side_by_side import plot_side_by_side
from rlrobot_edu.environments import make_env
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.history import History
from rlrobot_edu.learning.loop import learn
from rlrobot_edu.show.picture import Picture
from rlrobot_edu.task.task import Task


def learn_in_units(
    task: Task, factor: float, normalised: bool, repetitions: int, steps: int, seed: int
) -> list[History]:
    """Let Q+SR agents learn `task` with all rewards times `factor`; the histories are in the task's own units again.

    normalised: whether the agents are told the largest reward in the new units. If not, they normalise with the old
        one, which is the same factor for all units: as good as none
    """
    histories = []
    for i in range(repetitions):
        env = gymnasium.wrappers.TransformReward(make_env(task, seed=seed + i), lambda r: r * factor)
        r_max = max(task.rewards) * (factor if normalised else 1)
        history = learn(Agent(task, "Q+SR", r_max=r_max, seed=seed + i), env, steps, progress=False)
        histories.append(replace(history, rewards=history.rewards / factor))
    return histories


def plot_units(
    task: Task, factors: Sequence[float], *, repetitions: int = 10, steps: int = 600, seed: int = 0
) -> Picture:
    """Learning curves for rewards times each of `factors`: on the left without normalising, on the right with it."""
    panels = {
        f"{name} ({repetitions} repetitions)": [
            learn_in_units(task, factor, name == "normalised", repetitions, steps, seed) for factor in factors
        ]
        for name in ("not normalised", "normalised")
    }
    labels = [f"rewards × {factor:g}" for factor in factors]
    return plot_side_by_side(
        panels, labels, "Without normalising, the unit of the reward decides how the robot behaves"
    )
