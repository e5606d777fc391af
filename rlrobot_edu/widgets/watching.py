"""``rl.watch``: an agent learns in three dimensions, in the cell that runs it."""

from __future__ import annotations

import sys
import time
from collections import deque
from numbers import Real
from typing import cast

from rlrobot_edu.checks import check_count
from rlrobot_edu.jupyter import display
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.learning import loop
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.progress import watched
from rlrobot_edu.learning.size import Env
from rlrobot_edu.robots.robot_env import RobotEnv
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.describe import robot_of, rules_of, task_of
from rlrobot_edu.show.film import Film, film
from rlrobot_edu.show.in3d.visualizer import meshcat

LAST = 100  # steps that a saved notebook keeps


@suggests_keywords
def watch(agent: Agent, env: Env, steps: int, speed: float = 10.0) -> Film:
    """Watch an agent learn in 3D, below the cell that runs this. Then the view is a film of the last steps.

    If Python itself runs in a browser, there is no live view: the steps are shown after the last one.

    Parameters
    ----------
    agent : Agent
        The agent that acts and learns.
    env : gymnasium.Env
        An environment with a robot.
    steps : int
        How many steps.
    speed : float
        How many times as fast as in reality, usually 1 to 100; the computer may be slower than that.

    Returns
    -------
    Film
        The last steps, at most 100.

    Raises
    ------
    ValueError
        If the environment has no robot to look at, `steps` is below 1, or `speed` is not above 0.
    ImportError
        If meshcat is not installed.

    Notes
    -----
    The agent learns as with `rlrobot_edu.learn`. The view is the environment's, see `rlrobot_edu.meshcat`: it contains
    what was added to it, and all cells that show it show the same.
    """
    if sys.platform == "emscripten":
        whole = film(agent, env, steps)
        display(whole.show3d())
        return whole
    if not (isinstance(speed, Real) and speed > 0):
        raise ValueError(
            f"speed must be above 0: 1 is as fast as in reality, 100 a hundred times; got {speed!r:.200}"
        )
    loop.check_pair_of(agent, env)
    steps = check_count("steps", steps)
    robot = robot_of(env)
    view = meshcat(env)
    seen = deque[tuple[Scene, float]](maxlen=LAST)
    if watched():
        display(view)
    seconds = cast(RobotEnv, env.unwrapped).task.step_time / speed
    due = time.monotonic()
    for step in loop.steps(agent, env, steps):
        seen.append((robot.scene(), step.r))
        view.update(*seen[-1])
        due = max(due + seconds, time.monotonic())
        if watched():
            time.sleep(max(0.0, due - time.monotonic()))
    last_steps = Film.of(seen, task_of(env), rules_of(env))
    seconds = last_steps.seconds_per_frame
    view.look_back(last_steps.frames, seconds, last_steps.task, last_steps.rules)
    if watched():
        view.widget.settle()
    else:
        display(view)  # a saved notebook keeps how it ended
    return last_steps
