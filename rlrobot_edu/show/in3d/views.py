"""Scenes in three dimensions: a still or a replay."""

import html
from collections.abc import Sequence
from functools import cached_property
from pathlib import Path

import ipywidgets

from rlrobot_edu.files import write_whole
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.display import Displayed, Still
from rlrobot_edu.show.in3d.feed import frame, room
from rlrobot_edu.show.in3d.window import page
from rlrobot_edu.show.scenes import as_scenes, describe
from rlrobot_edu.show.top_down import plot_scene


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
