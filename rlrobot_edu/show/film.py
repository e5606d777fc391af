"""What a robot did, as a small animated picture that a notebook keeps and every page can show."""

import io
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from PIL import Image

from rlrobot_edu.files import write_whole
from rlrobot_edu.learning import loop
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.size import Env
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.display import Displayed, Still
from rlrobot_edu.show.picture import FEW_COLOURS, Picture
from rlrobot_edu.show.scenes import captions, describe, path_of, robot_of
from rlrobot_edu.show.top_down import Camera, plot_scene

if TYPE_CHECKING:
    from rlrobot_edu.show.view3d.views import SceneView

PIXELS = 360  # width and height of a film


@dataclass(frozen=True)
class Film(Displayed):
    """Scenes in the order of time, with the reward of each step; a notebook shows and keeps it as a moving picture.

    Parameters
    ----------
    frames : list of Scene
        What was to be seen after each step.
    rewards : list of float
        One number a frame.
    seconds_per_frame : float
        How long each frame stays on the screen [s].
    """

    frames: list[Scene]
    rewards: list[float]
    seconds_per_frame: float = 0.15

    def __repr__(self) -> str:
        return f"<Film of {len(self.frames)} steps>"

    def _pictures(self, pixels: int) -> list[Image.Image]:
        """Each frame from above, in few colours."""
        camera, path = Camera(self.frames[0], pixels), path_of(self.frames)
        camera.view.beams.set(linestyle=(0, (1, 6)), antialiased=False)  # dots make a film half as large as lines do
        texts = captions(len(self.frames), self.rewards)
        # one palette for all frames: what did not move keeps its colour, so only the changes are stored
        palette = Image.fromarray(camera.frame(self.frames[-1], texts[-1], path)).quantize(24, FEW_COLOURS)
        pictures = (Image.fromarray(camera.frame(scene, text, path[: i + 1]))
                    for i, (scene, text) in enumerate(zip(self.frames, texts, strict=True)))  # fmt: skip
        return [picture.quantize(palette=palette, dither=Image.Dither.NONE) for picture in pictures]

    def gif(self, path: str | Path | None = None, pixels: int = PIXELS) -> bytes:
        """The film as an animated GIF that plays for ever; the same film gives the same bytes.

        Parameters
        ----------
        path : str or Path, optional
            A file to write it to as well.
        pixels : int
            Width and height of the picture.

        Returns
        -------
        bytes
            The GIF file.
        """
        (first, *rest), buffer = self._pictures(pixels), io.BytesIO()
        duration = round(1000 * self.seconds_per_frame)
        first.save(buffer, "GIF", save_all=True, append_images=rest, loop=0, duration=duration, optimize=True)
        if path is not None:
            write_whole(path, buffer.getvalue())
        return buffer.getvalue()

    def picture(self) -> Picture:
        """The last frame from above, with the path through all of them.

        Returns
        -------
        Picture
            A matplotlib figure.
        """
        title = f"{len(self.frames)} steps, average reward {np.mean(self.rewards):+.2f} per step"
        return plot_scene(self.frames, title=title)

    def show3d(self) -> "SceneView":
        """The film in three dimensions, to turn, to pause and to step through.

        Returns
        -------
        SceneView
            See `rlrobot_edu.show_scene`.

        Raises
        ------
        ImportError
            If meshcat is not installed.
        """
        from rlrobot_edu.show.view3d.views import show_scene  # here, because all else does without meshcat

        return show_scene(self.frames, self.rewards, self.seconds_per_frame)

    def still(self) -> Still:
        """The moving picture, which says in words how the film ends."""
        alt = f"Film of a robot from above, {len(self.frames)} steps. At the end: {describe(self.frames[-1])}"
        return Still(alt, self.gif(), PIXELS, "image/gif")


def film(agent: Agent, env: Env, steps: int = 60) -> Film:
    """Film the agent from the start of an episode while it acts, and goes on learning.

    Parameters
    ----------
    agent : Agent
        Who acts.
    env : gymnasium.Env
        An environment with a robot.
    steps : int
        Length of the film, at least 1.

    Returns
    -------
    Film
        One frame a step.

    Raises
    ------
    ValueError
        If the environment has no robot to look at, or `steps` is below 1.
    """
    robot_of(env)  # better now than after a step has been learned
    if steps < 1:
        raise ValueError(f"a film needs at least 1 step, got {steps}")
    frames, rewards = [], []
    for step in loop.steps(agent, env, steps=steps):
        frames.append(robot_of(env).scene())
        rewards.append(step.r)
    return Film(frames, rewards)
