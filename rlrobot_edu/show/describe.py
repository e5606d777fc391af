"""What all views of a robot's scenes share, from above or in 3D: the scenes, the path, a description in words."""

import math
from collections.abc import Iterable, Sequence

import gymnasium
import numpy as np

from rlrobot_edu.learning.size import Env
from rlrobot_edu.robots.robot import Robot
from rlrobot_edu.robots.scene import Scene

Scenes = Scene | Sequence[Scene]  # one, or several in the order of time


def robot_of(env: Env) -> Robot:
    """The robot of an environment, behind its wrappers. Raises ValueError if there is none."""
    robot: Robot | None = getattr(getattr(env, "unwrapped", None), "robot", None)
    if robot is None:
        kind = type(env).__name__
        raise ValueError(
            f"there is no robot to look at: give an environment that rl.make_env(task) makes, got {kind}"
        )
    return robot


def as_scenes(given: Scenes | Env) -> list[Scene]:
    """The given scenes, or the one that an environment shows now.

    Raises ValueError if there is none, and for anything else.
    """
    if isinstance(given, gymnasium.Env):
        return [robot_of(given).scene()]
    if isinstance(given, Scene):
        return [given]
    several = list(given) if isinstance(given, Iterable) else []
    if not several or not all(isinstance(scene, Scene) for scene in several):
        kind = type(given).__name__
        raise ValueError(
            f"a picture needs an environment with a robot, or one scene or several, got {kind}"
        )
    return several


def path_of(scenes: Sequence[Scene]) -> np.ndarray:
    """Where ``robot/body`` was in each scene; array (n, 3) [m], n = 0 where there is no such solid."""
    places = []
    for scene in scenes:
        for solid in scene.solids:
            if solid.name == "robot/body":
                places.append(solid.pose[:3, 3])
    return np.reshape(places, (-1, 3))


def describe(scene: Scene) -> str:
    """The scene in one sentence, for readers who hear a page instead of seeing it."""
    x_min, y_min, x_max, y_max = scene.bounds
    is_arm = any(solid.name == "robot/upper_arm" for solid in scene.solids)
    if is_arm:
        place, mover, digits = "table", "gripper", 2
    else:
        place, mover, digits = "room", "robot", 1
    text = f"A {place} of {x_max - x_min:.1f} by {y_max - y_min:.1f} metres"
    for solid in scene.solids:
        if solid.name == "robot/body":
            yaw = math.degrees(math.atan2(solid.pose[1, 0], solid.pose[0, 0]))
            x, y = solid.pose[:2, 3]
            text += f", the {mover} at x = {x:.{digits}f}, y = {y:.{digits}f}, heading {yaw:.0f} degrees"
    return text + "."
