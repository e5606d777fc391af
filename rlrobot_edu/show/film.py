"""A film: a small animated picture of what a robot did, which a notebook keeps and every page can show."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

from PIL import Image

from rlrobot_edu.checks import check_between, check_count, check_numbers
from rlrobot_edu.files import write_whole
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.learning import loop
from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.learning.progress import in_a_notebook, watched
from rlrobot_edu.learning.size import Env
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.show.describe import (
    describe,
    key_words,
    robot_of,
    rules_of,
    task_of,
)
from rlrobot_edu.show.display import Displayed, Still
from rlrobot_edu.show.film_card import Reel, card, swatch
from rlrobot_edu.show.images import few_colours, gif_of, png_of, reduced
from rlrobot_edu.show.painting.frames import closer, frames
from rlrobot_edu.show.painting.parts import squares
from rlrobot_edu.show.story import caption, finding, key_steps

if TYPE_CHECKING:
    from rlrobot_edu.show.in3d.visualizer import Visualizer

WIDTH = 540  # of a film [pixels of a page]
STEP_WIDTH = 265  # of a single step [pixels of a page]
KEY_STEPS = 4  # as large together as the film; on a phone more could not be read
COLOURS = 32  # of a film
KEY = (
    f"Its way is {swatch('green')} after a gain, {swatch('red')} after a big loss, "
    f"{swatch('grey')} otherwise."
)


@suggests_keywords
@dataclass(frozen=True, eq=False)
class Film(Displayed):
    """Scenes in the order of time, with the reward of each step.

    A running notebook shows it in 3D, to turn, to pause and to step through, if meshcat is installed. A saved one keeps
    a moving picture.

    Parameters
    ----------
    frames : list of Scene
        The scene after each step.
    rewards : list of float
        The reward of each step.
    seconds_per_frame : float
        How long each frame is shown [s].
    notes : sequence of str
        A note for the caption of each frame, such as ``T = 0.5``; none if empty.
    task : str
        What the robot is to do, such as ``Wander in a maze``, for the title; none if empty.
    rules : str
        What earns which reward, parted by semicolons, such as ``moved more than 0.07 m: 10; else −0.02``; the key tells
        those that were met. None if empty.

    Raises
    ------
    ValueError
        If `frames` is no list of scenes, or empty, if the rewards are no numbers, or the notes no texts, if there are
        more or fewer of them than frames, or if `seconds_per_frame` is not between 0.001 and 1000.
    """

    frames: list[Scene]
    rewards: list[float]
    seconds_per_frame: float = 0.15
    notes: Sequence[str] = ()
    task: str = ""
    rules: str = ""

    def __post_init__(self) -> None:
        self._check_list("frames", self.frames, Scene, "scenes")
        if not self.frames:
            raise ValueError("a film without steps shows nothing; film at least 1 step")
        check_numbers("rewards", self.rewards)
        self._check_length("rewards", self.rewards)
        check_between("seconds_per_frame", self.seconds_per_frame, 0.001, 1000)
        self._check_list("notes", self.notes, str, "texts")
        if self.notes:
            self._check_length("notes", self.notes)

    def _check_list(self, name: str, given: Any, kind: type, kinds: str) -> None:
        """Raises ValueError unless it is a list, or a tuple, of things of this kind."""
        # a scene is a tuple, too
        is_list = isinstance(given, list | tuple) and not isinstance(given, Scene)
        if not is_list or not all(isinstance(thing, kind) for thing in given):
            raise ValueError(
                f"{name} of a film must be a list of {kinds}, got {given!r:.200}"
            )

    def _check_length(self, name: str, given: Sequence[object]) -> None:
        """Raises ValueError unless there is one for each frame."""
        if len(given) != len(self.frames):
            raise ValueError(
                f"got {len(given)} {name} for {len(self.frames)} scenes; give one for each"
            )

    @classmethod
    def of(
        cls, shots: Iterable[tuple[Scene, float]], task: str = "", rules: str = ""
    ) -> "Film":
        """The film of some scenes, each with its reward.

        Parameters
        ----------
        shots : iterable of (Scene, float)
            The scene after each step, and the step's reward.
        task : str
            What the robot is to do, for the title.
        rules : str
            What earns which reward, for the key.

        Returns
        -------
        Film
            The film.

        Raises
        ------
        ValueError
            If there are no frames.
        """
        scenes, rewards = [], []
        for scene, reward in shots:
            scenes.append(scene)
            rewards.append(reward)
        return cls(scenes, rewards, task=task, rules=rules)

    def __repr__(self) -> str:
        return f"<Film of {len(self.frames)} steps>"

    @property
    def finding(self) -> str:
        """What became of it in one sentence, such as ``Reward +10 in 41 of 60 steps, 3 bumps (−2 each)``."""
        return finding(self.frames, self.rewards, self.task, self.rules)

    @property
    def told(self) -> str:
        """Its story for readers who cannot see it: the finding, the steps that tell most, and the end."""
        told = [caption(self.frames, self.rewards, i) for i in self._key_steps()]
        end = describe(self.frames[-1])
        return f"Film of a robot. {self.finding}. {'. '.join(told)}. At the end: {end}"

    def pictures(self, width: int = WIDTH) -> Iterator[Image.Image]:
        """The pictures of the steps, with the way so far and the step's reward.

        Parameters
        ----------
        width : int
            Of each picture [pixels].

        Returns
        -------
        iterator of PIL.Image.Image
            One for each step.
        """
        return frames(self.frames, self.rewards, self.notes, width)

    def gif(self, width: int = WIDTH) -> bytes:
        """The film as an animated GIF that plays for ever; the same film gives the same bytes.

        Parameters
        ----------
        width : int
            Of the picture [pixels].

        Returns
        -------
        bytes
            The GIF file.
        """
        return self._gif(list(self.pictures(width)))

    def _gif(self, pictures: Sequence[Image.Image]) -> bytes:
        """The GIF of these pictures."""
        return gif_of(pictures, COLOURS, round(1000 * self.seconds_per_frame))

    def steps(self) -> list[tuple[str, Still]]:
        """The steps that tell most, at most four: the first, the last, losses, the goal.

        Returns
        -------
        list of (str, Still)
            Of each what happens in it, and its picture.
        """
        return self._steps(list(self.pictures()))

    def _steps(self, pictures: Sequence[Image.Image]) -> list[tuple[str, Still]]:
        """See `steps`; pictures: of all steps"""
        chosen = self._key_steps()
        near = list(closer(self.frames, [pictures[i] for i in chosen], STEP_WIDTH))
        colours = few_colours(near, COLOURS)
        shown = []
        for i, picture in zip(chosen, near, strict=True):
            small = png_of(reduced(picture, colours))
            still = Still(describe(self.frames[i]), small, STEP_WIDTH)
            shown.append((caption(self.frames, self.rewards, i), still))
        return shown

    def _key_steps(self) -> list[int]:
        """The steps that tell most, counted from 0."""
        return key_steps(self.frames, self.rewards, self.rules, KEY_STEPS)

    def save(self, path: str | Path) -> None:
        """Write the film to an animated GIF. For a page on which it can be paused, see `show3d`.

        Parameters
        ----------
        path : str or Path
            The file, such as ``film.gif``.

        Raises
        ------
        ValueError
            If the name ends like that of another kind of file, such as ``.html``.
        OSError
            If the file cannot be written.
        """
        write_whole(path, self.gif())

    def show3d(self) -> "Visualizer":
        """The film in three dimensions, to save as a page and to add things to; a running notebook shows it anyway.

        Returns
        -------
        Visualizer
            See `rlrobot_edu.show_scene`.

        Raises
        ------
        ImportError
            If meshcat is not installed.
        """
        # Imported here: everything else works without meshcat.
        from rlrobot_edu.show.in3d.visualizer import show_scene

        return show_scene(
            self.frames,
            self.rewards,
            self.seconds_per_frame,
            self.notes,
            self.task,
            self.rules,
        )

    @cached_property
    def widget(self) -> Any:
        """The film in 3D for a running notebook; None where nobody watches, and without meshcat or its widget."""
        if not (watched() and in_a_notebook()):
            return None
        try:
            return self.show3d().widget
        except ImportError:
            return None

    def still(self) -> Still:
        """The moving picture, and its story in words.

        Returns
        -------
        Still
            The GIF and its description.
        """
        return Still(self.told, self.gif(), WIDTH, "image/gif")

    def _as_html(self) -> str:
        """What became of it, the moving picture, and, where it is paused, the steps that tell most."""
        pictures = list(self.pictures())
        moving = Still(self.told, self._gif(pictures), WIDTH, "image/gif")
        reel = Reel(moving, self._steps(pictures))
        last = self.frames[-1]
        key = f"{key_words(last, self.rules, self.rewards)} {squares(last)}"
        return card(self.finding, KEY, [reel], escape(key), WIDTH)


@suggests_keywords
def film(agent: Agent, env: Env, steps: int = 60) -> Film:
    """Film the agent from the start of an episode while it acts and learns.

    Parameters
    ----------
    agent : Agent
        The agent that acts.
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
    loop.check_pair_of(agent, env)
    robot_of(env)  # refused now, before the agent has learned a step
    steps = check_count("steps", steps)
    shots = []
    for step in loop.steps(agent, env, steps=steps):
        shots.append((robot_of(env).scene(), step.r))
    return Film.of(shots, task_of(env), rules_of(env))
