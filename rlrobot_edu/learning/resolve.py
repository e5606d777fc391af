"""What a world may be given as: a task, its name or file, a model, an environment, or what makes one."""

from pathlib import Path
from typing import Any

import gymnasium
from gymnasium.envs.registration import EnvSpec

from rlrobot_edu.task.task_file import load_task


def resolve(world: Any) -> Any:
    """The task of a name or path, the spec of a Gymnasium id; anything else as it is.

    Raises FileNotFoundError if there is no such task file; ValueError if the toolkit has no task of this name, if the
    file holds no sound task, or for an id without its version; gymnasium.error.Error if Gymnasium has no such id.
    """
    if not isinstance(world, str | Path):
        return world
    # No name of a task has a hyphen, so a name with a version is an id.
    has_version = isinstance(world, str) and world.rpartition("-v")[2].isdecimal()
    if has_version or world in gymnasium.registry:
        return gymnasium.spec(str(world))
    ids = [each for each in gymnasium.registry if each.rpartition("-v")[0] == world]
    if ids:
        raise ValueError(
            f"an id of Gymnasium ends in its version; did you mean {ids[-1]!r}?"
        )
    return load_task(world)


def sized_world(world: Any) -> Any:
    """A task, model or environment whose size is known, for whatever `make_env` takes.

    What makes an environment makes one for this, which is then closed: so a function must make a new one each time.
    """
    world = resolve(world)
    if isinstance(world, EnvSpec):
        env = gymnasium.make(world)
    elif callable(world) and not isinstance(world, gymnasium.Env):
        env = world()
    else:
        return world
    if isinstance(env, gymnasium.Env):
        env.close()
    return env
