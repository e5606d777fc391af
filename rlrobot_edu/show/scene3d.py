"""Scenes in three dimensions: a still, a replay or a live view, drawn by meshcat (three.js) in the browser."""

from __future__ import annotations

import base64
import html
import io
import time
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import ipywidgets
import meshcat
import numpy as np

from rlrobot_edu.files import write_whole
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.drawing3d import animation, draw, transforms
from rlrobot_edu.show.meshcat_window import LiveWindow, StillWindow
from rlrobot_edu.show.top_down import as_scenes, describe, plot_scene

if TYPE_CHECKING:
    import gymnasium

    from rlrobot_edu.learning.loop import Step


def step_captions(rewards: Sequence[float]) -> list[str]:
    """One line a frame, so that the reward is told in words and numbers, not by a colour."""
    return [f"step {i} of {len(rewards)}: reward {reward:+.4g}" for i, reward in enumerate(rewards, start=1)]


def _widget(text: str, frame: str) -> dict[str, object]:
    """Output of a notebook cell: an iframe inside a widget, whose content a notebook does not save."""
    widget = ipywidgets.HTML(f'<iframe {frame} title="{html.escape(text)}" '
                             'style="width: 100%; height: 420px; border: 0"></iframe>')  # fmt: skip
    bundle = widget._repr_mimebundle_()
    return {**bundle, "text/plain": text}


class SceneView:
    """A 3D picture or replay. A notebook shows it to turn and zoom, and keeps a small picture from above.

    html: the whole page, works without a network; text: what is to be seen, in words
    """

    def __init__(self, page: str, text: str, still: bytes) -> None:
        self.html, self.text, self._still = page, text, still

    def __repr__(self) -> str:
        return f"<3D view: {self.text}>"

    def save(self, path: str | Path) -> None:
        """Write the page to a file that any browser opens."""
        write_whole(path, self.html)

    def _repr_mimebundle_(self, include=None, exclude=None) -> tuple[dict, dict]:
        # no scripts of the picture may reach the notebook around it
        bundle = _widget(self.text, f'sandbox="allow-scripts" srcdoc="{html.escape(self.html)}"')
        return {**bundle, "image/png": base64.b64encode(self._still).decode("ascii")}, {"image/png": {"alt": self.text}}


def show_scene(
    scenes: Scene | Sequence[Scene], rewards: Sequence[float] | None = None, seconds_per_frame: float = 0.15
) -> SceneView:
    """One scene as a 3D picture, or several as a replay that starts to play at once.

    rewards: the reward of each scene's step, shown below the replay
    seconds_per_frame: how long the replay takes from one scene to the next [s]
    Raises ValueError for an empty sequence.
    """
    scenes = as_scenes(scenes)
    still = io.BytesIO()
    plot_scene(scenes).savefig(still, dpi=72)
    window, text, captions = StillWindow(), describe(scenes[-1]), []
    vis = meshcat.Visualizer(window=window)
    draw(vis, scenes)
    if len(scenes) > 1:
        vis.set_animation(animation(scenes, 1 / seconds_per_frame), repetitions=float("inf"))
        captions = [f"step {i} of {len(scenes)}" for i in range(1, len(scenes) + 1)]
        captions = captions if rewards is None else step_captions(rewards)
        text = f"Replay of {len(scenes)} steps. At the end: {text}"
    return SceneView(window.html(text, captions, 1 / seconds_per_frame), text, still.getvalue())


class LiveView:
    """A 3D picture that follows a robot while it moves; `url` opens in any browser on this computer.

    with rl.LiveView() as live:
        for step in live.follow(rl.steps(agent, env, steps=100_000), env):
            pass
    """

    def __init__(self) -> None:
        self._window = LiveWindow()
        self.url = self._window.url
        self._vis = meshcat.Visualizer(window=self._window)
        self._world: tuple | None = None
        self._places: dict[str, np.ndarray] = {}

    def update(self, scene: Scene) -> None:
        """Show `scene`: only what has moved is sent, and sending never waits for a browser."""
        places = transforms(scene)
        world = [solid[:3] for solid in scene.solids], len(scene.beams), scene.bounds
        if world != self._world:
            self._vis.delete()
            draw(self._vis, [scene])
        else:
            for node, transform in places.items():
                if not np.array_equal(transform, self._places[node]):
                    self._vis[node].set_transform(transform)
        self._world, self._places = world, places

    def follow(self, steps: Iterable[Step], env: gymnasium.Env, frames_per_second: float = 30) -> Iterator[Step]:
        """Pass on `steps` as they come and show what the robot of `env` does, at most so many frames a second.

        The learning process hardly notices: between two frames its steps go by unseen.
        """
        next_frame = 0.0
        for step in steps:
            if time.monotonic() >= next_frame:
                self.update(env.unwrapped.robot.scene())
                next_frame = time.monotonic() + 1 / frames_per_second
            yield step

    def close(self) -> None:
        """Stop the server behind `url`; pages that are open say that the view has ended."""
        self._window.close()

    def __enter__(self) -> LiveView:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def __repr__(self) -> str:
        return "<Live 3D view>"

    def _repr_mimebundle_(self, include=None, exclude=None) -> dict[str, object]:
        return _widget("Live 3D view of the robot", f'src="{self.url}"')
