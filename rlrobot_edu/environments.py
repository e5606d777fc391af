"""Make an environment from a task, a sample model or a Gymnasium id."""

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, Union

import gymnasium
import numpy as np
from gymnasium.envs.registration import EnvSpec

from rlrobot_edu.learning.resolve import resolve
from rlrobot_edu.robots.realism import Realism
from rlrobot_edu.robots.robot import LinkedRobot
from rlrobot_edu.robots.robot_env import RenderMode, RobotEnv
from rlrobot_edu.seeds import ENVIRONMENT, generator
from rlrobot_edu.task.robot_cards import Engine
from rlrobot_edu.task.task import Task

# Models are loaded where one is given: a robot in its scene needs none of their ten modules
if TYPE_CHECKING:
    from rlrobot_edu.models.sample_model import SampleModel

World = Union[Task, "SampleModel", EnvSpec, Callable[..., gymnasium.Env[Any, Any]]]


def as_world(world: World | str | Path) -> World:
    """The task, the model, or what makes a Gymnasium environment: its spec or a function.

    Raises ValueError if it is none of these and not the name or path of a task, and gymnasium.error.Error for an
    unknown id.
    """
    world = resolve(world)
    if isinstance(world, gymnasium.Env):
        raise ValueError(
            f"{world} must be a new one each time: give its id, or a function that makes it"
        )
    if isinstance(world, Task | EnvSpec) or callable(world):
        return world
    from rlrobot_edu.models.sample_model import SampleModel

    if isinstance(world, SampleModel):
        return world
    raise ValueError(
        f"a world is a task, a sample model, an id of Gymnasium or a function, not {world!r:.200}"
    )


def make_env(
    task: World | str | Path,
    seed: int | np.random.SeedSequence | None = None,
    *,
    engine: Engine | None = None,
    realism: Realism | None = None,
    render_mode: RenderMode | None = None,
    link: LinkedRobot | None = None,
    **options: Any,
) -> gymnasium.Env[np.ndarray, int]:
    """The environment of a task, with its robot in its scene; or that of a sample model, or one of Gymnasium.

    Parameters
    ----------
    task : Task, str, Path, SampleModel, EnvSpec or function
        A task, the name of one, the path of your own task file, or a model learned from recordings. Also the id of a
        Gymnasium environment, such as ``"CliffWalking-v1"``, its spec, or a function that returns a new environment.
    seed : int or numpy.random.SeedSequence, optional
        Makes the environment repeatable.
    engine : Engine, optional
        The simulator of the robot: ``pymunk``, ``pybullet`` or ``kinematic`` for a base, ``pybullet`` or ``kinematic``
        for an arm. None takes the robot's default: pymunk for a base; PyBullet for an arm and, where that is not
        installed, geometry alone (it says so on stderr).
    realism : Realism, optional
        Imperfections to simulate, such as ``rl.Realism(laser_noise=0.02)``; None is the ideal robot.
    render_mode : RenderMode, optional
        ``rgb_array`` lets ``env.render()`` draw the world from above, for example for `gymnasium.wrappers.RecordVideo`;
        ``ansi`` lets it say in words where the robot is and what it reads.
    link : RobotLink, optional
        A link to a real robot that is switched on, a ``rlrobot_ros.RobotLink``; then nothing is simulated.
    **options
        Further arguments of the robot's class, of ``gymnasium.make`` or of the function.

    Returns
    -------
    gymnasium.Env
        A `RobotEnv`, a `SampleModelEnv`, or what Gymnasium or the function makes.

    Raises
    ------
    ValueError
        If the task cannot be run (it names the file), or if the arguments do not fit together.
    FileNotFoundError
        If there is no such task file.
    ImportError
        If the engine that you ask for is missing; it says what to install.
    gymnasium.error.Error
        If Gymnasium has no environment of this id.
    """
    if realism is not None and not isinstance(realism, Realism):
        raise ValueError(
            f"realism must be None or an rl.Realism(...), got {realism!r:.200}"
        )
    world = as_world(task)
    is_gymnasiums = isinstance(world, EnvSpec) or callable(world)
    if "max_episode_steps" in options and not is_gymnasiums:
        raise ValueError(
            "a world's time limit is a wrapper: gymnasium.wrappers.TimeLimit(rl.make_env(…), max_episode_steps=…)"
        )
    if isinstance(world, Task):
        return RobotEnv(world, seed, engine, realism, render_mode, link, **options)
    if (engine, realism, link) != (None, None, None):
        raise ValueError(
            "only a task has a robot: leave engine, realism and link out of any other world"
        )
    if render_mode is not None:
        options["render_mode"] = render_mode
    if isinstance(world, EnvSpec):
        env = gymnasium.make(world, **options)
    elif callable(world):
        env = world(**options)
    else:
        from rlrobot_edu.models.model_env import SampleModelEnv

        return SampleModelEnv(world, seed, **options)
    if not isinstance(env, gymnasium.Env):
        raise ValueError(
            f"{world!r:.200} must return a new environment of Gymnasium, not {env!r:.200}"
        )
    if seed is not None:
        its_seed = generator(seed, ENVIRONMENT).integers(2**31)
        env.reset(seed=int(its_seed))
    return env
