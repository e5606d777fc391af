"""Scenes in three dimensions: a still, a replay or a live view in the browser."""

import html
import time
import weakref
from collections.abc import Iterable, Iterator, Sequence
from contextlib import AbstractContextManager
from functools import cached_property
from pathlib import Path
from typing import Any

import ipywidgets
import meshcat
import numpy as np

from rlrobot_edu.files import write_whole
from rlrobot_edu.learning.loop import Step
from rlrobot_edu.learning.size import Env
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.display import Displayed, Still
from rlrobot_edu.show.scenes import as_scenes, captions, describe, robot_of
from rlrobot_edu.show.top_down import plot_scene
from rlrobot_edu.show.view3d.drawing import animation, draw, transforms
from rlrobot_edu.show.view3d.window import LiveWindow, StillWindow, page


def _iframe(text: str, frame: str) -> ipywidgets.HTML:
    """A page inside the notebook's; being a widget's, it is not saved with the notebook."""
    return ipywidgets.HTML(f'<iframe {frame} title="{html.escape(text)}" '
                           'style="width: 100%; height: 420px; border: 0"></iframe>')  # fmt: skip


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
        If there is no scene in `scenes`.
    ImportError
        If meshcat is not installed.
    """
    scenes = as_scenes(scenes)
    window, text, told, fps = StillWindow(), describe(scenes[-1]), [], 1 / seconds_per_frame
    vis = meshcat.Visualizer(window=window)
    draw(vis, scenes)
    if len(scenes) > 1:
        vis.set_animation(animation(vis, scenes, fps), repetitions=float("inf"))
        text, told = f"Replay of {len(scenes)} steps. At the end: {text}", captions(len(scenes), rewards)
    return SceneView(page(window.since(), text, told, fps), text, plot_scene(scenes).still()._replace(alt=text))


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

    Notes
    -----
    The view is served to this computer alone, until `close`, the end of a ``with`` block, or once nobody holds it.

    Examples
    --------
    ::

        with rl.LiveView() as live:
            for step in live.follow(rl.steps(agent, env, steps=100_000), env):
                pass
    """

    def __init__(self) -> None:
        self._window = LiveWindow()
        self._end = weakref.finalize(self, self._window.close)
        self.url = self._window.url
        self._vis = meshcat.Visualizer(window=self._window)
        self._drawn: Any = None  # the bodies and beams that the browsers have
        self._places: dict[str, np.ndarray] = {}

    def update(self, scene: Scene) -> None:
        """Show a scene: only what has moved is sent, and sending never waits for a browser.

        Parameters
        ----------
        scene : Scene
            What there is to see now.

        Raises
        ------
        RuntimeError
            If the view has been closed.
        """
        places = transforms(scene)
        bodies = [solid[:3] for solid in scene.solids], len(scene.beams), scene.bounds
        if bodies != self._drawn:
            self._vis.delete()
            draw(self._vis, [scene])
        else:
            for node, transform in places.items():
                if not np.array_equal(transform, self._places[node]):
                    self._vis[node].set_transform(transform)
        self._drawn, self._places = bodies, places

    def follow(self, steps: Iterable[Step], env: Env, frames_per_second: float = 30) -> Iterator[Step]:
        """Pass on steps as they come, and show what the robot does.

        Parameters
        ----------
        steps : iterable of Step
            A learning process, see `rlrobot_edu.steps`.
        env : gymnasium.Env
            The environment of that process; it has a robot.
        frames_per_second : float
            How many scenes are shown, at most [1/s].

        Yields
        ------
        Step
            Each of `steps`, unchanged.

        Raises
        ------
        ValueError
            If the environment has no robot to look at.

        Notes
        -----
        The learning process hardly notices: between two frames its steps go by unseen.
        """
        next_frame = 0.0
        for step in steps:
            if time.monotonic() >= next_frame:
                self.update(robot_of(env).scene())
                next_frame = time.monotonic() + 1 / frames_per_second
            yield step

    def close(self) -> None:
        """Stop the server behind `url`; pages that are open say that the view has ended."""
        self._end()

    def __exit__(self, *error: object) -> None:
        self.close()

    def __repr__(self) -> str:
        return "<Live 3D view>"

    @cached_property
    def widget(self) -> ipywidgets.HTML:
        """The view in a frame."""
        return _iframe("Live 3D view of the robot", f'src="{self.url}"')
