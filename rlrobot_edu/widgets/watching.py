"""``rl.watch``: an agent learns in three dimensions, in the cell that runs it."""

from __future__ import annotations

import sys

from IPython.display import display

from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.size import Env
from rlrobot_edu.show.film import Film, film
from rlrobot_edu.widgets.live_view import LiveView

open_views: list[LiveView] = []  # the latest one, which a page that is late, or comes back, can still ask


def watch(agent: Agent, env: Env, steps: int, speed: float = 10.0) -> Film:
    """Watch an agent learn in 3D, below the cell that runs this.

    Where Python itself runs in a browser there is no live view: there the steps are shown once they are done.

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
        The last steps, at most 100; this is what a saved notebook keeps.

    Raises
    ------
    ValueError
        If the environment has no robot to look at, `steps` is below 1, or `speed` is not above 0.
    ImportError
        If meshcat is not installed.

    Notes
    -----
    The agent learns as it does with `rlrobot_edu.learn`. The view stays open until the next one, or the end of the
    kernel.
    """
    if sys.platform == "emscripten":
        whole = film(agent, env, steps)
        display(whole.show3d())
        return whole
    live = LiveView()
    while open_views:
        open_views.pop().close()
    open_views.append(live)
    display(live)
    return live.follow(agent, env, steps, speed)
