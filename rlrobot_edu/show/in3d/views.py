"""Scenes in three dimensions: a still, a replay or a live view in the browser."""

import html
import sys
import time
import weakref
from collections import deque
from collections.abc import Sequence
from contextlib import AbstractContextManager
from functools import cached_property
from pathlib import Path
from typing import cast

import ipywidgets

from rlrobot_edu.files import write_whole
from rlrobot_edu.learning import loop
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.progress import watched
from rlrobot_edu.learning.size import Env
from rlrobot_edu.live.window import LiveWindow
from rlrobot_edu.robots.robot_env import RobotEnv
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.display import Displayed, Still
from rlrobot_edu.show.film import Film
from rlrobot_edu.show.in3d.feed import frame, room
from rlrobot_edu.show.in3d.window import page
from rlrobot_edu.show.scenes import as_scenes, describe, robot_of
from rlrobot_edu.show.top_down import plot_scene
from rlrobot_edu.task.messages import check_count
from rlrobot_edu.widgets.carried import CarriedPage

LAST = 100  # steps that a saved notebook keeps of those that were watched


def _iframe(text: str, frame: str) -> ipywidgets.HTML:
    """A page inside the notebook's; being a widget's, it is not saved with the notebook.

    The notebook's background is seen through it: browsers allow that to a frame that has the page's own color-scheme.
    """
    return ipywidgets.HTML(f'<iframe {frame} title="{html.escape(text)}" '
                           'style="width: 100%; height: 480px; border: 0; color-scheme: light"></iframe>')  # fmt: skip


class SceneView(Displayed):
    """A 3D picture or replay. A notebook shows it to turn and zoom, and keeps a small picture from above.

    Parameters
    ----------
    page : str
        The whole HTML page.
    text : str
        What is to be seen, in words.
    picture : Still
        The picture from above.

    Attributes
    ----------
    html : str
        The page; it works without a network.
    text : str
        What is to be seen, in words.
    """

    def __init__(self, page: str, text: str, picture: Still) -> None:
        self.html, self.text, self._picture = page, text, picture

    def __repr__(self) -> str:
        return self.text

    def save(self, path: str | Path) -> None:
        """Write the page to a file that any browser opens.

        Parameters
        ----------
        path : str or Path
            The file; a name that ends in ``.html`` opens by itself.
        """
        write_whole(path, self.html)

    @cached_property
    def widget(self) -> ipywidgets.HTML:
        """The page in a frame; no scripts of it may reach the notebook around it."""
        return _iframe(self.text, f'sandbox="allow-scripts" srcdoc="{html.escape(self.html)}"')

    def still(self) -> Still:
        """The picture from above."""
        return self._picture


def show_scene(
    scenes: Scene | Sequence[Scene], rewards: Sequence[float] | None = None, seconds_per_frame: float = 0.15
) -> SceneView:
    """One scene as a 3D picture, or several as a replay that starts to play at once.

    Parameters
    ----------
    scenes : Scene or sequence of Scene
        What to show, in the order of time.
    rewards : sequence of float, optional
        The reward of each scene's step, shown below the replay.
    seconds_per_frame : float
        How long the replay takes from one scene to the next [s].

    Returns
    -------
    SceneView
        What a notebook shows, and what `SceneView.save` writes to a file.

    Raises
    ------
    ValueError
        If there is no scene in `scenes`, or not one reward for each.
    ImportError
        If meshcat is not installed.
    """
    scenes = as_scenes(scenes)
    text = describe(scenes[-1])
    told: Sequence[float | None] = [None] * len(scenes) if rewards is None else rewards
    if len(told) != len(scenes):
        raise ValueError(f"one reward for each scene, please: {len(told)} rewards for {len(scenes)} scenes")
    if len(scenes) > 1:
        text = f"Replay of {len(scenes)} steps. At the end: {text}"
    frames = [frame(scene, reward) for scene, reward in zip(scenes, told, strict=True)]
    feed = {"room": room(scenes[-1]), "frames": frames, "seconds": seconds_per_frame}
    return SceneView(page(text, feed), text, plot_scene(scenes).still()._replace(alt=text))


class LiveView(Displayed, AbstractContextManager["LiveView", None]):
    """A 3D picture that follows a robot while it moves, in the notebook and in any browser on this computer.

    Attributes
    ----------
    url : str
        Address of the view.

    Raises
    ------
    ImportError
        If meshcat is not installed.
    RuntimeError
        If Python runs in a browser, where nothing can be served.

    Notes
    -----
    The view is served to this computer alone, until `close`, the end of a ``with`` block, or once nobody holds it.

    Examples
    --------
    ::

        live = rl.LiveView()
        live  # in a notebook: the picture; elsewhere open `live.url`
        live.follow(agent, env, steps=600, speed=50)  # in the next cell
    """

    def __init__(self) -> None:
        if sys.platform == "emscripten":
            raise RuntimeError("in a browser nothing can be served; watch rl.film(agent, env) or its .show3d() instead")
        self._window = LiveWindow(page("Live 3D view", {"live": "served"}))
        self._end = weakref.finalize(self, self._window.close)
        self.url = self._window.url

    def update(self, scene: Scene, reward: float | None = None, seconds: float = 0.0) -> None:
        """Show a scene; sending it never waits for a browser.

        Parameters
        ----------
        scene : Scene
            What there is to see now.
        reward : float, optional
            The reward of the step that led here: it colours the trail. Without one, this is not counted as a step.
        seconds : float
            For how long the picture moves on from the scene before to this one [s].

        Raises
        ------
        RuntimeError
            If the view has been closed.
        """
        self._window.show(room(scene), {**frame(scene, reward), "seconds": seconds})
        self._carry()

    def _carry(self, *, at_once: bool = False) -> None:
        """Let the notebook's views know what is new."""
        if "widget" in vars(self):
            self.widget.tell(at_once=at_once)

    def follow(self, agent: Agent, env: Env, steps: int, speed: float = 10.0) -> Film:
        """Watch an agent learn: each of its steps is shown, with its trail and a moving average of its reward.

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
        RuntimeError
            If the view has been closed.

        Notes
        -----
        The agent learns just as it does with `rlrobot_edu.learn`, only that it is slowed down to be watched;
        not so where RLROBOT_EDU_PROGRESS is 0, as while the course's notebooks are run to be saved.
        """
        if not speed > 0:
            raise ValueError(f"speed must be above 0: 1 is as fast as in reality, 100 a hundred times; got {speed}")
        loop.check_pair_of(agent, env)
        check_count("steps", steps)
        robot, seen = robot_of(env), deque[tuple[Scene, float]](maxlen=LAST)
        seconds, due = cast(RobotEnv, env.unwrapped).task.step_time / speed, time.monotonic()
        for step in loop.steps(agent, env, steps):
            seen.append((robot.scene(), step.r))
            self.update(*seen[-1], seconds)
            due = max(due + seconds, time.monotonic())
            time.sleep(max(0.0, due - time.monotonic()) if watched() else 0.0)
        self._carry(at_once=True)
        return Film([scene for scene, _ in seen], [reward for _, reward in seen])

    def close(self) -> None:
        """Stop the server behind `url`; pages that are open say that the view has ended."""
        self._end()
        self._carry(at_once=True)

    def __exit__(self, *error: object) -> None:
        self.close()

    def __repr__(self) -> str:
        return "<Live 3D view of a robot, where a kernel runs>"

    @cached_property
    def widget(self) -> CarriedPage:
        """The view in a frame; the notebook's own connection carries it, the address `url` is for other browsers."""
        return CarriedPage(page("Live 3D view", {"live": "carried"}), self._window.so_far)
