"""From a task, or a model learned from recordings, to an environment that an agent can act in."""

from __future__ import annotations

from pathlib import Path

import gymnasium
import numpy as np

from rlrobot_edu.models.sample_model import SampleModel
from rlrobot_edu.robots.realism import Realism
from rlrobot_edu.robots.robot_env import RobotEnv
from rlrobot_edu.task.task import Task, load_task


def make_env(
    task: Task | str | Path | SampleModel,
    seed: int | np.random.SeedSequence | None = None,
    *,
    robot: str | None = None,
    realism: Realism | None = None,
    render_mode: None = None,
    **options,
) -> gymnasium.Env:
    """The world of a task: its robot in its scene. Or the world that a sample model remembers.

    task: a `Task`, the name of one, the path of your own task file, or a `SampleModel`
    seed: an int or a ``numpy.random.SeedSequence``, makes the environment repeatable
    robot: who simulates the robot, ``pymunk`` or ``pybullet``; None takes the robot's default
    realism: weaknesses that the robot shall have, such as ``rl.Realism(laser_noise=0.02)``; None: the ideal robot
    render_mode: always None; it is here because `gymnasium.make` hands it over
    options: further arguments of the robot's class

    Raises ValueError that names the file if the task cannot be run, or that says what does not fit together.
    """
    if render_mode is not None:
        raise ValueError("a world does not draw itself: give env.robot.scene() to rl.plot_scene or rl.show_scene")
    if isinstance(task, SampleModel):
        if realism is not None:
            raise ValueError("a sample model has no robot that realism could act on: record with realism instead")
        from rlrobot_edu.models.model_env import SampleModelEnv

        return SampleModelEnv(task, seed)
    return RobotEnv(load_task(task), seed, robot, realism, **options)
