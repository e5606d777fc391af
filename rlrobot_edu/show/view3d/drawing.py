"""Drawing a scene into meshcat (three.js): bodies, laser beams, paths, light and camera, and what moves over time."""

from collections.abc import Sequence
from typing import Any

import meshcat
import numpy as np
from meshcat import geometry as g
from meshcat.animation import Animation

from rlrobot_edu.robots.scene import Scene, Solid, pose
from rlrobot_edu.show.palette import ROLE
from rlrobot_edu.show.scenes import path_of

# three.js cylinders lie along their y axis, ours stand along z: a quarter turn about x
_UPRIGHT = np.array([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1.0]])


def _span(scene: Scene) -> float:
    """The longer side of the scene's ground [m]."""
    return max(scene.bounds[2] - scene.bounds[0], scene.bounds[3] - scene.bounds[1])


def _node(solid: Solid) -> str:
    """A solid's place in meshcat's tree. Without slashes: there, ``robot/wheel`` would move along with ``robot``."""
    return "solids/" + solid.name.replace("/", " ")


def transforms(scene: Scene) -> dict[str, np.ndarray]:
    """Where everything goes: each node's homogeneous transform, array (4, 4) [m]."""
    places = {_node(s): s.pose @ _UPRIGHT if s.shape == "cylinder" else s.pose for s in scene.solids}
    for i, (start, end) in enumerate(scene.beams):
        places[f"beams/{i}"] = beam_transform(start, end)
    return places


def beam_transform(start: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Stretches a bar of length 1 m along x until it joins two points [m]; so a beam can be animated like a solid."""
    length = max(float(np.linalg.norm(end - start)), 1e-6)  # three.js cannot invert a bar of no length
    x = (end - start) / length if length > 1e-6 else np.array([1.0, 0, 0])
    y = np.cross((0, 0, 1) if abs(x[2]) < 0.99 else (0, 1, 0), x)
    y /= np.linalg.norm(y)
    transform = np.eye(4)
    transform[:3] = np.column_stack([length * x, y, np.cross(x, y), (start + end) / 2])
    return transform


def _put(vis: meshcat.Visualizer, node: str, shape: g.Geometry, colour: str, shaded: bool = True, **look: Any) -> None:
    """Place a body. Named by its node: the names that meshcat makes up are random and tell the computer's address."""
    material = g.MeshLambertMaterial if shaded else g.MeshBasicMaterial
    # three.js takes a colour as one number; side=0 draws the front only: the back would shimmer through
    mesh = g.Mesh(shape, material(int(colour.removeprefix("#"), 16), side=0, **look))
    mesh.uuid = mesh.geometry.uuid = mesh.material.uuid = node
    vis[node].set_object(mesh)


def draw(vis: meshcat.Visualizer, scenes: Sequence[Scene]) -> None:
    """Everything in the last scene, and the path through all."""
    scene, span = scenes[-1], _span(scenes[-1])
    for solid in scene.solids:
        size = [float(v) for v in solid.size]
        shape = {
            "box": g.Box,
            "cylinder": lambda s: g.Cylinder(s[1], s[0]),
            "sphere": lambda s: g.Sphere(s[0]),
            "prism": lambda s: _prism(np.reshape(s[:-1], (-1, 2)), s[-1]),
        }
        # the robot's nose is white, to tell front from back; a goal can be looked through
        colour = "#ffffff" if solid.name == "robot/nose" else ROLE[solid.role]
        _put(vis, _node(solid), shape[solid.shape](size), colour, opacity=0.5 if solid.role == "goal" else 1.0)
    for i in range(len(scene.beams)):
        _put(vis, f"beams/{i}", g.Box([1.0, span / 250, span / 250]), ROLE["beam"], shaded=False)
    for node, transform in transforms(scene).items():
        vis[node].set_transform(transform)
    path = path_of(scenes)
    if len(path) > 1:
        _put(vis, "path", _ribbon(path, span / 90), ROLE["path"], shaded=False)
    _draw_surroundings(vis, scene)


def _prism(base: np.ndarray, height: float) -> g.TriangularMeshGeometry:
    """An upright prism about the origin; base: array (n, 2), its corners counter-clockwise [m]."""
    n = len(base)
    corners = np.vstack([np.column_stack([base, np.full(n, z)]) for z in (-height / 2, height / 2)])
    i = np.arange(n)
    after, fan = (i + 1) % n, np.column_stack([np.zeros(n - 2, int), i[1:-1], i[2:]])
    sides = [np.column_stack([i, after, after + n]), np.column_stack([i, after + n, i + n])]
    return g.TriangularMeshGeometry(corners, np.vstack([*sides, fan + n, fan[:, ::-1]]))


def _ribbon(path: np.ndarray, width: float) -> g.TriangularMeshGeometry:
    """A flat band along the path, just above the floor [m]: a line would be one pixel wide whatever the zoom."""
    start, step = path[:-1, :2], np.diff(path[:, :2], axis=0)
    length = np.maximum(np.linalg.norm(step, axis=1, keepdims=True), 1e-9)
    along, side = step / length * width / 2, step[:, ::-1] * (-1, 1) / length * width / 2
    # each piece overlaps the next by half its width, so that bends have no gaps
    near, far = start - along, start + step + along
    corners = np.stack([near + side, near - side, far - side, far + side], axis=1).reshape(-1, 2)
    first = 4 * np.arange(len(start))[:, None]
    faces = np.vstack([first + (0, 1, 2), first + (0, 2, 3)])
    return g.TriangularMeshGeometry(np.column_stack([corners, np.full(len(corners), 0.003)]), faces)


def _draw_surroundings(vis: meshcat.Visualizer, scene: Scene) -> None:
    """Floor, a quiet background, light, and a camera that looks down on the middle from the south."""
    x_min, y_min, x_max, y_max = scene.bounds
    span = _span(scene)
    _put(vis, "floor", g.Box([x_max - x_min, y_max - y_min, 0.02]), "#ddd9cf")
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


def animation(vis: meshcat.Visualizer, scenes: Sequence[Scene], fps: float) -> Animation:
    """Key frames for all that may move; the browser fills in what lies between."""
    walls = {_node(solid) for solid in scenes[0].solids if solid.role == "wall"}
    film = Animation(default_framerate=fps)
    for i, scene in enumerate(scenes):
        frame = film.at_frame(vis, i)
        for node, transform in transforms(scene).items():
            if node in walls:
                continue
            scale = np.linalg.norm(transform[:3, :3], axis=0)
            frame[node].set_transform(transform / (*scale, 1))
            if node.startswith("beams/"):
                frame[node].set_property("scale", "vector3", scale.tolist())
    return film
