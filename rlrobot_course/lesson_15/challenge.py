"""Open challenge of lesson 15: a task of one's own, in which it pays to look and to learn."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from rlrobot_course.challenge import Challenge
from rlrobot_edu.environments import make_env
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.loop import learn
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import load_task
from rlrobot_edu.tools.blind import BLIND
from rlrobot_edu.tools.trial import acting

STEPS, LAST, MOST = 1000, 200, 25


def read(path: Any) -> Task:
    """The learner's task. Raises ValueError if it has more than 25 actions."""
    if not isinstance(path, str | Path):
        raise ValueError('the path of a task file is expected, as "my_tasks/lesson_15/follow_wall.py"')
    task = load_task(path)
    if task.actions.n > MOST or len(set(task.rewards)) < 2:
        raise ValueError(
            f"{task.actions.n} actions and {len(set(task.rewards))} rewards; at most {MOST} and at least 2"
        )
    return task


def gained(task: Task, seed: int) -> float:
    """What a robot that learns earns above the best of the stupid ones, in percent of what the rewards span."""

    def earns(method: Any, **settings: Any) -> float:
        agent, env = Agent(task, method, seed=seed, **settings), make_env(task, seed=seed)
        return float(learn(agent, env, steps=STEPS, progress=False).rewards[-LAST:].mean())

    ever = [float(acting(task, [a] * 40, seed).transitions.r.mean()) for a in range(task.actions.n)]
    stupid = max(*ever, earns("Q+RANDOM"), earns(BLIND, loop_evasion=False))
    return 100 * (earns("TOSL+QBIASSR") - stupid) / (max(task.rewards) - min(task.rewards))


challenge = Challenge(
    "15",
    "Give the path of a task file of your own. A robot learns it for 1,000 steps; beside it are three stupid ones: one "
    "at random, one that sees nothing, and one that repeats the best single action. What counts is how much more the "
    "learner earns in its last 200 steps than the best of these, in percent of the span of your rewards.",
    "% of the span", read, gained, seeds=6,
)  # fmt: skip
