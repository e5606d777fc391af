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
from meshcat import geometry as g
from meshcat.animation import Animation, AnimationClip, AnimationTrack
from scipy.spatial.transform import Rotation

from rlrobot_edu.files import write_whole
from rlrobot_edu.robots.scene import Scene, Solid, pose
from rlrobot_edu.show.meshcat_window import LiveWindow, StillWindow
from rlrobot_edu.show.palette import rgb_number
from rlrobot_edu.show.top_down import as_scenes, describe, path_of, plot_scene

if TYPE_CHECKING:
    import gymnasium

    from rlrobot_edu.learning.loop import Step

# three.js cylinders lie along their y axis, ours stand along z: a quarter turn about x
_UPRIGHT = np.array([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1.0]])


def _span(scene: Scene) -> float:
    """The longer side of the scene's ground [m]."""
    return max(scene.bounds[2] - scene.bounds[0], scene.bounds[3] - scene.bounds[1])


def _node(solid: Solid) -> str:
    """A solid's place in meshcat's tree. Without slashes: there, ``robot/wheel`` would move along with ``robot``."""
    return "solids/" + solid.name.replace("/", " ")


def _transforms(scene: Scene) -> dict[str, np.ndarray]:
    """Where everything goes: each node's homogeneous transform, array (4, 4) [m]."""
    places = {_node(s): s.pose @ _UPRIGHT if s.shape == "cylinder" else s.pose for s in scene.solids}
    for i, (start, end) in enumerate(scene.beams):
        places[f"beams/{i}"] = _beam_transform(start, end)
    return places


def _beam_transform(start: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Stretches a bar of length 1 m along x until it joins two points [m]; so a beam can be animated like a solid."""
    length = max(float(np.linalg.norm(end - start)), 1e-6)  # three.js cannot invert a bar of no length
    x = (end - start) / length if length > 1e-6 else np.array([1.0, 0, 0])
    y = np.cross((0, 0, 1) if abs(x[2]) < 0.99 else (0, 1, 0), x)
    y /= np.linalg.norm(y)
    transform = np.eye(4)
    transform[:3] = np.column_stack([length * x, y, np.cross(x, y), (start + end) / 2])
    return transform


def _put(vis: meshcat.Visualizer, node: str, shape: g.Geometry, material: g.Material) -> None:
    """Place a body. Named by its node: the names that meshcat makes up are random and tell the computer's address."""
    mesh = g.Mesh(shape, material)
    mesh.uuid = mesh.geometry.uuid = mesh.material.uuid = node
    vis[node].set_object(mesh)


def _matt(solid: Solid) -> g.Material:
    """For bodies. The robot's nose is white, to tell front from back; a goal can be looked through."""
    colour = 0xFFFFFF if solid.name == "robot/nose" else rgb_number(solid.role)
    # side=0 draws the front only: the back would shimmer through
    return g.MeshLambertMaterial(colour, opacity=0.5 if solid.role == "goal" else 1.0, side=0)


def _glowing(role: str) -> g.Material:
    """For what is no body and takes no shade."""
    return g.MeshBasicMaterial(rgb_number(role))


def _draw(vis: meshcat.Visualizer, scenes: Sequence[Scene]) -> None:
    """Everything in the last scene, and the path through all."""
    scene, span = scenes[-1], _span(scenes[-1])
    for solid in scene.solids:
        size = [float(v) for v in solid.size]
        shape = {"box": g.Box, "cylinder": lambda s: g.Cylinder(s[1], s[0]), "sphere": lambda s: g.Sphere(s[0])}
        _put(vis, _node(solid), shape[solid.shape](size), _matt(solid))
    for i in range(len(scene.beams)):
        _put(vis, f"beams/{i}", g.Box([1.0, span / 250, span / 250]), _glowing("beam"))
    for node, transform in _transforms(scene).items():
        vis[node].set_transform(transform)
    path = path_of(scenes)
    if len(path) > 1:
        _put(vis, "path", _ribbon(path, span / 90), _glowing("path"))
    _draw_surroundings(vis, scene)


def _ribbon(path: np.ndarray, width: float) -> g.TriangularMeshGeometry:
    """A flat band along the path, just above the floor [m]: a line would be one pixel wide whatever the zoom."""
    start, step = path[:-1, :2], np.diff(path[:, :2], axis=0)
    length = np.maximum(np.linalg.norm(step, axis=1, keepdims=True), 1e-9)
    along, side = step / length * width / 2, step[:, ::-1] * (-1, 1) / length * width / 2
    # each piece overlaps the next by half its width, so that bends have no gaps
    near, far = start - along, start + step + along
    corners = np.stack([near - side, near + side, far + side, far - side], axis=1).reshape(-1, 2)
    first = 4 * np.arange(len(start))[:, None]
    faces = np.vstack([first + (0, 1, 2), first + (0, 2, 3)])
    return g.TriangularMeshGeometry(np.column_stack([corners, np.full(len(corners), 0.003)]), faces)


def _draw_surroundings(vis: meshcat.Visualizer, scene: Scene) -> None:
    """Floor, a quiet background, light, and a camera that looks down on the middle from the south."""
    x_min, y_min, x_max, y_max = scene.bounds
    span = _span(scene)
    _put(vis, "floor", g.Box([x_max - x_min, y_max - y_min, 0.02]), g.MeshLambertMaterial(0xDDD9CF))
    middle = (x_min + x_max) / 2, (y_min + y_max) / 2
    vis["floor"].set_transform(pose(*middle, -0.01 - span / 1000))  # lower than all that lies on it, or both shimmer
    for clutter in ("/Grid", "/Axes"):
        vis[clutter].set_property("visible", False)
    vis["/Background"].set_property("top_color", [0.86, 0.90, 0.94])
    vis["/Background"].set_property("bottom_color", [0.97, 0.97, 0.97])
    for lamp, side in (("PointLightNegativeX", 1), ("PointLightPositiveX", -1)):
        light = vis[f"/Lights/{lamp}/<object>"]
        light.set_property("distance", 0.0)  # as bright in a hall as in a small room
        light.set_property("position", [middle[0] + side * 0.8 * span, middle[1] + side * 0.8 * span, span])
    vis["/Cameras/default"].set_transform(pose(middle[0], middle[1] - 0.06 * span, 0))
    camera = vis["/Cameras/default/rotated/<object>"]
    camera.set_property("fov", 45)
    camera.set_property("position", [0.0, 1.2 * span, 0.9 * span])  # its y is our z, its z our -y


def _animation(scenes: Sequence[Scene], fps: float) -> Animation:
    """Key frames for all that may move; the browser fills in what lies between."""
    walls = {_node(s) for s in scenes[0].solids if s.role == "wall"}
    moves = [_transforms(scene) for scene in scenes]
    film, frames = Animation(default_framerate=fps), list(range(len(scenes)))
    for node in [n for n in moves[0] if n not in walls]:
        m = np.array([places[node] for places in moves])
        scale = np.linalg.norm(m[:, :3, :3], axis=1)
        turn = Rotation.from_matrix(m[:, :3, :3] / scale[:, None, :]).as_quat()
        tracks = {"position": ("vector3", m[:, :3, 3]), "quaternion": ("quaternion", turn), "scale": ("vector3", scale)}
        if not node.startswith("beams/"):
            del tracks["scale"]
        tracks = {n: AnimationTrack(n, kind, frames, values.round(5).tolist()) for n, (kind, values) in tracks.items()}
        film.clips[meshcat.path.Path(("meshcat", *node.split("/")))] = AnimationClip(tracks, fps)
    return film


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
    _draw(vis, scenes)
    if len(scenes) > 1:
        vis.set_animation(_animation(scenes, 1 / seconds_per_frame), repetitions=float("inf"))
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
        places = _transforms(scene)
        world = [solid[:3] for solid in scene.solids], len(scene.beams), scene.bounds
        if world != self._world:
            self._vis.delete()
            _draw(self._vis, [scene])
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
