"""From a task, or a model learnt from recordings, to an environment that an agent can act in."""

from __future__ import annotations

from pathlib import Path

import gymnasium

from rlrobot_edu.robots.robot_env import RobotEnv
from rlrobot_edu.task import Task, load_task


def make_env(task: Task | str | Path, seed: int | None = None, render_mode: None = None) -> gymnasium.Env:
    """The world of a task: its robot in its scene. Or the world that a sample model remembers.

    task: a `Task`, the name of one, the path of your own task file, or a `SampleModel`
    seed: makes the environment repeatable
    render_mode: always None; it is here because `gymnasium.make` hands it over

    Raises ValueError that names the file if the task cannot be run.
    """
    if render_mode is not None:
        raise ValueError("these worlds do not draw themselves: use rl.plot_scene, rl.show_scene or rl.film")
    if hasattr(task, "environment"):
        return task.environment(seed)
    return RobotEnv(load_task(task), seed)
