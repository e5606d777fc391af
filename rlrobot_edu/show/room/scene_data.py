"""A robot's scene as JSON, for room.js: bounds, walls, solids, beams and the robot's place, in metres."""

from __future__ import annotations

import math
from functools import cache
from importlib.resources import files
from typing import Any

import numpy as np

from rlrobot_edu.robots.scene import Scene, Solid
from rlrobot_edu.show.top_down import footprint
from rlrobot_edu.task.robot_cards import LASERS
from rlrobot_edu.task.task import Task

Data = dict[str, Any]
BODY, NOSE = "robot/body", "robot/nose"
_ORDER = ("goal", "object", "wheel", "robot")  # from below to the top


@cache
def room_script() -> str:
    """The program that draws a room."""
    return files(__package__).joinpath("room.js").read_text("utf-8")


def scene_data(scene: Scene) -> Data:
    """All that room.js draws of one instant."""
    return {**constant_data(scene), **moving_data(scene)}


def constant_data(scene: Scene) -> Data:
    """What stays: the bounds, the walls, and the outline of a robot that drives, as seen from its middle."""
    walls = [_points(footprint(each)) for each in scene.solids if each.role == "wall"]
    driver = _driver(scene)
    outline = None if driver is None else _points(_outline(driver))
    return {"bounds": list(scene.bounds), "walls": walls, "outline": outline}


def moving_data(scene: Scene) -> Data:
    """What may move: each solid's role and outline, the beams, and the place of a robot that drives: x, y, heading.

    Such a robot is drawn as one sign, so its parts are left out.
    """
    driver = _driver(scene)
    place = None if driver is None else _place(driver)
    shown = [each for each in scene.solids if each.role != "wall"]
    if driver is not None:
        shown = [each for each in shown if not each.name.startswith("robot/")]
    shown.sort(key=lambda each: _ORDER.index(each.role))
    return {
        "solids": [[each.role, _points(footprint(each))] for each in shown],
        "beams": _points(scene.beams[:, :, :2].reshape(-1, 4)),
        "place": place,
    }


def near_of(task: Task) -> list[float] | None:
    """For each laser of the base, the distance [m] below which the task tells readings apart; 0 if it uses none.

    None if the task uses no laser: then nothing is known of what is near.
    """
    cuts = {each.name: max(each.cuts) for each in task.inputs if each.cuts}
    near = [cuts.get(name, 0.0) for name in LASERS]
    return near if any(near) else None


def _driver(scene: Scene) -> Solid | None:
    """The body of a robot that drives, which is one with a nose."""
    named = {solid.name: solid for solid in scene.solids}
    return named[BODY] if BODY in named and NOSE in named else None


def _place(body: Solid) -> list[float]:
    x, y = body.pose[:2, 3].tolist()
    heading = math.atan2(body.pose[1, 0], body.pose[0, 0])
    return [round(x, 4), round(y, 4), round(heading, 4)]


def _outline(body: Solid) -> np.ndarray:
    """The body's outline from its own middle, x ahead; array (n, 2) [m]."""
    ahead = body.pose[:2, :2]
    return np.asarray((footprint(body) - body.pose[:2, 3]) @ ahead)


def _points(xy: np.ndarray) -> list[list[float]]:
    points: list[list[float]] = np.round(xy, 3).tolist()
    return points
