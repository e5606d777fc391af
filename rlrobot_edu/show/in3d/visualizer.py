"""``rl.meshcat``: a robot's world in a meshcat visualizer, as a still, a replay, or while the robot moves."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from functools import cached_property
from itertools import pairwise
from pathlib import Path
from weakref import WeakKeyDictionary

import meshcat as library
import numpy as np
from meshcat import geometry as g

from rlrobot_edu.checks import check_between, check_numbers
from rlrobot_edu.files import write_whole
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.learning.size import Env
from rlrobot_edu.robots.robot import Robot
from rlrobot_edu.robots.scene import Scene, Solid
from rlrobot_edu.show.describe import (
    as_scenes,
    describe,
    jumps,
    path_of,
    robot_of,
    rolls,
)
from rlrobot_edu.show.display import Displayed, Still
from rlrobot_edu.show.in3d import looks
from rlrobot_edu.show.in3d.camera import camera, surroundings
from rlrobot_edu.show.in3d.page_widget import PageWidget
from rlrobot_edu.show.in3d.replay import NO_REPLAY, places, replay
from rlrobot_edu.show.in3d.window import Window
from rlrobot_edu.show.painting import parts
from rlrobot_edu.show.painting.parts import Part
from rlrobot_edu.show.painting.room import painted
from rlrobot_edu.show.palette import ROLE

PIECE = 20  # steps in a piece of a live trail
PIECES = 100  # of a live trail; older ones are deleted
FLOOR = 0.012  # height of a trail above the floor [m]
_of_robot: WeakKeyDictionary[Robot, Visualizer] = WeakKeyDictionary()


class Visualizer(Displayed, library.Visualizer):  # type: ignore[misc]  # meshcat has no types
    """A `meshcat.Visualizer` of a robot's world, to which anything of meshcat can be added.

    A notebook shows it, to turn and to zoom, through the notebook's own connection: there is no server. A saved
    notebook keeps a picture.

    Parameters
    ----------
    scene : Scene
        What to show.

    Attributes
    ----------
    text : str
        The view in words.
    html : str
        A page of it; it works without a network.

    Notes
    -----
    Walls, things and robot are at their names: ``vis["robot/body"]``, ``vis["wall/0"]``. For all else see meshcat's own
    documentation: ``vis["mine"].set_object(meshcat.geometry.Sphere(0.1))``.
    """

    def __init__(self, scene: Scene) -> None:
        super().__init__(window=Window("A robot in 3D"))
        self._drawn: list[tuple[str, str, tuple[float, ...], bytes]] = []
        self._way = [scene]
        self._rewards: list[float] = []
        self._pieces: deque[str] = deque()  # of the trail, named by the steps before
        self._is_replay = False
        self.update(scene)
        self._way, self._rewards = [scene], []

    @property
    def text(self) -> str:
        """The view in words."""
        return str(self.window.title)

    @property
    def html(self) -> str:
        """A page of it."""
        return str(self.static_html())

    def __repr__(self) -> str:
        return self.text

    def update(self, scene: Scene, reward: float | None = None) -> None:
        """Show another instant.

        Parameters
        ----------
        scene : Scene
            What can be seen now: ``env.unwrapped.robot.scene()``.
        reward : float, optional
            Of the step that led here; it colours the trail. Without one, the robot was put here.
        """
        if self._is_replay:
            self.window.take(NO_REPLAY)
            self._is_replay = False
        described = [_fixed_of(solid) for solid in scene.solids]
        if described != self._drawn:
            self._draw(scene)
            self._drawn = described
        for name, place in places(scene).items():
            self[name].set_transform(place)
        self.window.title = describe(scene)
        self._way.append(scene)
        self._rewards.append(np.nan if reward is None else reward)
        if reward is not None:
            self.window.rewards.append(reward)
        if len(self._rewards) % PIECE == 0:
            self.lay_trail()

    def play(
        self,
        scenes: Sequence[Scene],
        rewards: Sequence[float],
        seconds_per_frame: float,
        notes: Sequence[str] = (),
        task: str = "",
        rules: str = "",
    ) -> None:
        """Replay scenes, from the first to the last.

        rewards, notes: one for each scene, or none at all; task: what the robot is to do; rules: what earns a reward
        """
        film = replay(scenes, rewards, seconds_per_frame, notes, "playing", task, rules)
        self.window.take(film)
        self._is_replay = True
        self._way = list(scenes)
        self._rewards = list(rewards or np.zeros(len(scenes)))[1:]
        self.window.rewards = list(rewards)
        self._band("trail/1", self._way, self._rewards)
        end = describe(scenes[-1])
        self.window.title = f"Replay of {len(scenes)} steps. At the end: {end}"

    def look_back(
        self,
        scenes: Sequence[Scene],
        seconds_per_frame: float,
        task: str,
        rules: str = "",
    ) -> None:
        """Make a replay of the last scenes that were shown, until there is another; it opens at its end."""
        self.lay_trail()
        rewards = self.window.rewards[-len(scenes) :]
        film = replay(scenes, rewards, seconds_per_frame, (), "at its end", task, rules)
        self.window.take(film)
        self._is_replay = True

    def lay_trail(self) -> None:
        """Show where the robot has been since the last time."""
        if not self._rewards:
            return
        steps_before = len(self.window.rewards) - len(self._rewards)
        self._pieces.append(f"trail/{steps_before}")
        self._band(self._pieces[-1], self._way, self._rewards)
        if len(self._pieces) > PIECES:
            self[self._pieces.popleft()].delete()
        self._way = self._way[-1:]
        self._rewards = []

    def save(self, path: str | Path) -> None:
        """Write the page to a file that any browser opens.

        Parameters
        ----------
        path : str or Path
            The file; a name that ends in ``.html`` opens by itself.
        """
        write_whole(path, self.html)

    @cached_property
    def widget(self) -> PageWidget:
        """The page in a frame of the notebook."""
        return PageWidget(self.window)

    def jupyter_cell(self, height: int = 520) -> PageWidget:
        """The view in a cell, as meshcat calls it; height: at most so many pixels."""
        self.widget.height = height
        return self.widget

    def still(self) -> Still:
        """The picture that a saved notebook keeps.

        Our own painter paints it, without what was added to the view.
        """
        return painted(self._way)._replace(alt=self.text)

    def _draw(self, scene: Scene) -> None:
        """Draw the room and all in it, the light and the camera."""
        groups = {name.partition("/")[0] for name, *_ in self._drawn}
        for path in ("floor", "trail", "beams", *groups):
            self[path].delete()
        self._pieces.clear()
        self["floor/grid"].set_object(looks.grid_lines(parts.grid(scene)))
        self._build("floor", parts.floor(scene))
        for solid in scene.solids:
            for part in parts.parts(solid):
                self._build(solid.name, part)
            self[solid.name].set_transform(solid.pose)
        x_min, y_min, x_max, y_max = scene.bounds
        self._span = max(x_max - x_min, y_max - y_min)
        for i in range(len(scene.beams)):
            view = self["beams"][str(i)]
            ray = g.Cylinder(1.0, self._span / 1000)
            view.set_object(ray, looks.flat(ROLE["beam"]))
            _cast_no_shadow(view)
        for path, key, value in surroundings(scene):
            self[path].set_property(key, value)
        lens, stands = camera(scene)
        self["/Cameras/default/rotated"].set_object(lens)
        self.window.take(stands)

    def _build(self, path: str, part: Part) -> None:
        """Draw a part of what is at this path."""
        shape, turned = looks.geometry(part.shape, part.size)
        view = self[path][part.name]
        view.set_object(shape, looks.material(part))
        view.set_transform(part.pose @ turned)

    def _band(self, path: str, way: Sequence[Scene], rewards: Sequence[float]) -> None:
        """A trail along the scenes' paths, if the robot has one and something was paid or lost."""
        points = path_of(way)
        if len(points) < 2:
            return
        wide = self._span / 70  # an arm leaves its trail in the air
        if rolls(way[0]):
            points[:, 2] = FLOOR
            wide = self._span / 130
        put = [jumps(a, b) for a, b in pairwise(way)]
        paid = np.where(put, np.nan, np.asarray(rewards, dtype=float))
        most = np.abs(self.window.rewards or [0.0]).max()
        band = looks.trail(points, paid, most, wide)
        self[path].set_object(band, g.MeshBasicMaterial(vertexColors=True))
        _cast_no_shadow(self[path])


def _fixed_of(solid: Solid) -> tuple[str, str, tuple[float, ...], bytes]:
    """What of a solid does not change as long as the scene is the same one; a wall does not move either."""
    place = solid.pose.tobytes() if solid.role == "wall" else b""
    return solid.name, solid.shape, solid.size, place


def _cast_no_shadow(view: library.Visualizer) -> None:
    view["<object>"].set_property(looks.Name("castShadow"), False)


@suggests_keywords
def meshcat(thing: Env | Scene) -> Visualizer:
    """A robot's world in a genuine meshcat visualizer, to look at and to add to.

    Parameters
    ----------
    thing : gymnasium.Env or Scene
        A scene, or an environment with a robot. Each such environment has one visualizer, which `rlrobot_edu.watch`
        moves.

    Returns
    -------
    Visualizer
        A `meshcat.Visualizer`. A notebook shows it; `Visualizer.save` writes a page.

    Raises
    ------
    ValueError
        If the environment has no robot to look at.
    ImportError
        If meshcat is not installed.

    Examples
    --------
    >>> vis = rl.meshcat(env)
    >>> vis["extra"].set_object(meshcat.geometry.Box([1, 1, 1]))
    """
    if isinstance(thing, Scene):
        return Visualizer(thing)
    robot = robot_of(thing)
    if robot in _of_robot:
        _of_robot[robot].update(robot.scene())
    else:
        _of_robot[robot] = Visualizer(robot.scene())
    return _of_robot[robot]


@suggests_keywords
def show_scene(
    scenes: Scene | Sequence[Scene],
    rewards: Sequence[float] | None = None,
    seconds_per_frame: float = 0.15,
    notes: Sequence[str] = (),
    task: str = "",
    rules: str = "",
) -> Visualizer:
    """One scene as a 3D picture, or several as a replay that starts at once.

    Parameters
    ----------
    scenes : Scene or sequence of Scene
        What to show, in the order of time.
    rewards : sequence of float, optional
        The reward of each scene's step, shown below the replay.
    seconds_per_frame : float
        How long the replay takes from one scene to the next [s].
    notes : sequence of str
        A note for each scene, such as ``T = 0.5``, shown with its reward; none if empty.
    task : str
        What the robot is to do, for the title of a replay; none if empty.
    rules : str
        What earns which reward, parted by semicolons, for the key of a replay; none if empty.

    Returns
    -------
    Visualizer
        What a notebook shows, and what `Visualizer.save` writes to a file.

    Raises
    ------
    ValueError
        If there is no scene in `scenes`, if the rewards are more or fewer than the scenes, or if
        `seconds_per_frame` is not between 0.001 and 1000.
    ImportError
        If meshcat is not installed.
    """
    scenes = as_scenes(scenes)
    check_between("seconds_per_frame", seconds_per_frame, 0.001, 1000)
    if rewards is not None:
        rewards = check_numbers("rewards", rewards)
        if len(rewards) != len(scenes):
            raise ValueError(
                f"got {len(rewards)} rewards for {len(scenes)} scenes; give one for each"
            )
    view = Visualizer(scenes[-1])
    if len(scenes) > 1:
        paid = [] if rewards is None else rewards
        view.play(scenes, paid, seconds_per_frame, notes, task, rules)
    return view
