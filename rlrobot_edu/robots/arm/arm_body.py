"""The arm as its URDF file describes it: joints with their limits, and solids to draw. And the table that it stands at.

The arm's lengths and limits are in arm.urdf alone, which is read here without PyBullet.
"""

import math
import xml.etree.ElementTree as ET
from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from pathlib import Path
from types import MappingProxyType
from typing import NamedTuple

import numpy as np

from rlrobot_edu.robots.scene import Scene, Solid, pose

URDF = Path(__file__).parent / "arm.urdf"

OBJECT = (0.02, 0.05)  # radius and height of the cylinder [m]
OBJECT_PLACE = (0.27, 0.09, OBJECT[1] / 2)  # its middle [m]
# x_min, y_min, x_max, y_max [m]. The top of the table is the floor here (z = 0)
TABLE = (-0.10, -0.26, 0.42, 0.26)
FIELD = (0.20, -0.16, 0.32, 0.16)  # painted on the table, about the object


class Angles(NamedTuple):
    """The joints' angles [rad]."""

    arm: float
    biceps: float
    forearm: float


HOME = Angles(-0.42, 0.9, 0.26)  # where the joints begin


class Joint(NamedTuple):
    """A joint: the links that it joins, where it stands in the first, its axis, and its limits [rad]."""

    parent: str
    child: str
    origin: np.ndarray
    axis: np.ndarray
    limits: tuple[float, float]


@cache
def joints() -> Mapping[str, Joint]:
    """The joints by name. As the file lists them: each stands on a link that an earlier one carries."""
    found = {}
    for part in _file().iter("joint"):
        axis = np.zeros(3)  # of a joint that does not turn
        limits = (0.0, 0.0)
        limit = part.find("limit")
        if limit is not None:
            axis = _numbers(_one(part, "axis").attrib["xyz"])
            limits = (float(limit.attrib["lower"]), float(limit.attrib["upper"]))
        parent = _one(part, "parent").attrib["link"]
        child = _one(part, "child").attrib["link"]
        origin = _origin(part)
        axis.flags.writeable = False  # one joint for all callers
        origin.flags.writeable = False
        found[part.attrib["name"]] = Joint(parent, child, origin, axis, limits)
    return MappingProxyType(found)


def link_poses(angles: Angles) -> dict[str, np.ndarray]:
    """Homogeneous transform of each link from the foot, arrays (4, 4).

    The origin of the link `gripper` is the point between the fingertips.
    """
    angle_of = angles._asdict()
    there = {"foot": np.eye(4)}
    for name, joint in joints().items():
        turn = _turn(joint.axis, angle_of.get(name, 0.0))
        there[joint.child] = there[joint.parent] @ joint.origin @ turn
    return there


def solids_of(angles: Angles) -> list[Solid]:
    """The arm's solids, from the foot."""
    there = link_poses(angles)
    return [solid._replace(pose=there[link] @ solid.pose) for link, solid in _visuals()]


def readings_of(
    gripper_place: Iterable[float], object_place: Iterable[float], angles: Angles
) -> dict[str, float]:
    """The readings of an arm: x, y, z of gripper and object [m], and the angles of the joints [rad]."""
    readings = {}
    for name, place in {"gripper": gripper_place, "object": object_place}.items():
        for axis, coordinate in zip("xyz", place, strict=True):
            readings[f"{name}_{axis}"] = float(coordinate)
    return readings | angles._asdict()


def object_at(place: tuple[float, float, float]) -> Solid:
    """The object, whose middle is at this place [m]."""
    return Solid("object", "cylinder", OBJECT, pose(*place), "object")


def scene_of(arm: Sequence[Solid]) -> Scene:
    """The table with its field, the object, and the arm.

    Its gripper becomes ``robot/body``, because viewers draw the path of that.
    """
    parts = []
    for solid in arm:
        if solid.name == "robot/gripper":
            solid = solid._replace(name="robot/body")
        parts.append(solid)
    x_min, y_min, x_max, y_max = FIELD
    size = (x_max - x_min, y_max - y_min, 0.002)
    middle = pose((x_min + x_max) / 2, (y_min + y_max) / 2, 0.001)
    field = Solid("field", "box", size, middle, "wall")
    no_beams = np.empty((0, 2, 3))
    return Scene((field, object_at(OBJECT_PLACE), *parts), no_beams, TABLE)


@cache
def _file() -> ET.Element:
    return ET.parse(URDF).getroot()


@cache
def _visuals() -> tuple[tuple[str, Solid], ...]:
    """Each visible part with its link and its pose there; the second part of a link is called ``robot/link_2``."""
    found = []
    for part in _file().iter("link"):
        link = part.attrib["name"]
        for i, visual in enumerate(part.iter("visual"), start=1):
            name = f"robot/{link}" if i == 1 else f"robot/{link}_{i}"
            found.append((link, _solid(name, visual)))
    return tuple(found)


def _solid(name: str, visual: ET.Element) -> Solid:
    """A visual element as a solid; a dark one is drawn like a wheel."""
    is_dark = _one(visual, "material").attrib["name"] == "dark"
    role = "wheel" if is_dark else "robot"
    form = _one(visual, "geometry")[0]
    size: tuple[float, ...]
    if form.tag == "box":
        shape = "box"
        size = tuple(_numbers(form.attrib["size"]).tolist())
    else:
        shape = "cylinder"
        size = (float(form.attrib["radius"]), float(form.attrib["length"]))
    return Solid(name, shape, size, _origin(visual), role)


def _one(part: ET.Element, tag: str) -> ET.Element:
    """The element of this kind in `part`. Raises ValueError if there is none."""
    found = part.find(tag)
    if found is None:
        raise ValueError(f"{URDF}: a {part.tag} has no {tag}")
    return found


def _numbers(text: str) -> np.ndarray:
    return np.array([float(x) for x in text.split()])


def _origin(part: ET.Element) -> np.ndarray:
    """The place and the turn of an element in its link."""
    origin = _one(part, "origin").attrib
    place: np.ndarray = pose(*_numbers(origin["xyz"]))
    about_x, about_y, about_z = _numbers(origin.get("rpy", "0 0 0"))
    x_axis, y_axis, z_axis = np.eye(3)
    place = place @ _turn(z_axis, about_z)
    place = place @ _turn(y_axis, about_y)
    place = place @ _turn(x_axis, about_x)
    return place


def _turn(axis: np.ndarray, angle: float) -> np.ndarray:
    """A turn about an axis of length 1 (or 0: no turn). Source: Rodrigues' formula."""
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    matrix = np.eye(4)
    matrix[:3, :3] += math.sin(angle) * cross + ((1 - math.cos(angle)) * cross) @ cross
    return matrix
