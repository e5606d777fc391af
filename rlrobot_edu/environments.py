"""From a task, or a model learned from recordings, to an environment that an agent can act in."""

from pathlib import Path
from typing import Any

import gymnasium
import numpy as np

from rlrobot_edu.models.model_env import SampleModelEnv
from rlrobot_edu.models.sample_model import SampleModel
from rlrobot_edu.robots.realism import Realism
from rlrobot_edu.robots.robot import LinkedRobot
from rlrobot_edu.robots.robot_env import RobotEnv
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import load_task


def make_env(
    task: Task | str | Path | SampleModel,
    seed: int | np.random.SeedSequence | None = None,
    *,
    engine: str | None = None,
    realism: Realism | None = None,
    render_mode: str | None = None,
    link: LinkedRobot | None = None,
    **options: Any,
) -> gymnasium.Env[np.ndarray, int]:
    """The environment of a task: its robot in its scene. Or the one that a sample model remembers.

    Parameters
    ----------
    task : Task, str, Path or SampleModel
        A task, the name of one, the path of your own task file, or a model learned from recordings.
    seed : int or numpy.random.SeedSequence, optional
        Makes the environment repeatable.
    engine : str, optional
        The simulator of the robot: ``pymunk``, ``pybullet`` or ``kinematic`` for a base, ``pybullet`` or ``kinematic``
        for an arm. None takes the robot's default: pymunk for a base; PyBullet for an arm and, where that is not
        installed, geometry alone (it says so on stderr).
    realism : Realism, optional
        Weaknesses that the robot shall have, such as ``rl.Realism(laser_noise=0.02)``; None is the ideal robot.
    render_mode : str, optional
        ``rgb_array`` lets ``env.render()`` draw the world from above, for `gymnasium.wrappers.RecordVideo` say.
    link : RobotLink, optional
        A robot that is on now, as ``rl.RobotLink("rosbridge")``; then nothing is simulated.
    **options
        Further arguments of the robot's class.

    Returns
    -------
    gymnasium.Env
        A `RobotEnv` or a `SampleModelEnv`.

    Raises
    ------
    ValueError
        If the task cannot be run (it names the file), or if the arguments do not fit together.
    ImportError
        If the engine that you ask for is missing; it says what to install.
    """
    if realism is not None and not isinstance(realism, Realism):
        raise ValueError(f"realism must be None or an rl.Realism(...), got {realism!r:.200}")
    if isinstance(task, SampleModel):
        of_a_robot = {"engine": engine, "realism": realism, "render_mode": render_mode, "link": link} | options
        if given := [name for name, value in of_a_robot.items() if value is not None]:
            raise ValueError(f"a sample model has no robot, so {given[0]} says nothing; give it with a task instead")
        return SampleModelEnv(task, seed)
    return RobotEnv(load_task(task), seed, engine, realism, render_mode, link, **options)
