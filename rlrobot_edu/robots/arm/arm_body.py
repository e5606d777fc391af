"""The arm as its URDF file describes it: joints with their limits, and solids to draw. And the table that it stands at.

All lengths and limits are said once, in arm.urdf; to read them takes no PyBullet.
"""

import math
import xml.etree.ElementTree as ET
from collections import Counter
from collections.abc import Iterable, Sequence
from functools import cache
from pathlib import Path
from typing import NamedTuple

import numpy as np

from rlrobot_edu.robots.scene import Scene, Solid, pose

URDF = Path(__file__).parent / "arm.urdf"

OBJECT = (0.02, 0.05)  # radius and height of the cylinder [m]
OBJECT_PLACE = (0.27, 0.09, OBJECT[1] / 2)  # its middle [m]
FIELD = (
    0.20,
    -0.16,
    0.32,
    0.16,
)  # the part of the table that matters: x_min, y_min, x_max, y_max [m]
TABLE = (
    -0.10,
    -0.26,
    0.42,
    0.26,
)  # x_min, y_min, x_max, y_max [m]; its top is the floor here, z = 0


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
def joints() -> dict[str, Joint]:
    """The joints by name, from the foot to the gripper."""
    found = {}
    for part in _file().iter("joint"):
        limit = part.find("limit")
        found[part.attrib["name"]] = Joint(
            _one(part, "parent").attrib["link"],
            _one(part, "child").attrib["link"],
            _origin(part),
            np.zeros(3)
            if limit is None
            else _numbers(_one(part, "axis").attrib["xyz"]),
            (0.0, 0.0)
            if limit is None
            else (float(limit.attrib["lower"]), float(limit.attrib["upper"])),
        )
    return found


def link_poses(angles: Angles) -> dict[str, np.ndarray]:
    """Homogeneous transform of each link from the foot, arrays (4, 4).

    The origin of the link `gripper` is the point between the fingertips.
    """
    turned, there = angles._asdict(), {"foot": np.eye(4)}
    for name, joint in joints().items():
        there[joint.child] = (
            there[joint.parent]
            @ joint.origin
            @ _turn(joint.axis, turned.get(name, 0.0))
        )
    return there


def solids_of(angles: Angles) -> list[Solid]:
    """The arm's solids, from the foot."""
    there = link_poses(angles)
    return [solid._replace(pose=there[link] @ solid.pose) for link, solid in _visuals()]


def readings_of(
    gripper: Iterable[float], thing: Iterable[float], angles: Angles
) -> dict[str, float]:
    """What an arm senses: the places x, y, z of gripper and object [m], and the joints' angles [rad]."""
    places = {"gripper": gripper, "object": thing}
    there = {
        f"{what}_{axis}": float(v)
        for what, place in places.items()
        for axis, v in zip("xyz", place, strict=True)
    }
    return there | angles._asdict()


def object_at(place: tuple[float, float, float]) -> Solid:
    """The object, whose middle is at this place [m]."""
    return Solid("object", "cylinder", OBJECT, pose(*place), "object")


def scene_of(arm: Sequence[Solid]) -> Scene:
    """The table with its field, the object, and the arm, whose gripper leaves the path."""
    arm = [
        solid._replace(name="robot/body") if solid.name == "robot/gripper" else solid
        for solid in arm
    ]
    x_min, y_min, x_max, y_max = FIELD
    middle = pose((x_min + x_max) / 2, (y_min + y_max) / 2, 0.001)
    field = Solid("field", "box", (x_max - x_min, y_max - y_min, 0.002), middle, "wall")
    return Scene((field, object_at(OBJECT_PLACE), *arm), np.empty((0, 2, 3)), TABLE)


@cache
def _file() -> ET.Element:
    return ET.parse(URDF).getroot()


@cache
def _visuals() -> tuple[tuple[str, Solid], ...]:
    """What there is to see, each with its link and its pose there; the second of a link is called ``robot/link_2``."""
    found, seen = [], Counter[str]()
    for part in _file().iter("link"):
        for visual in part.iter("visual"):
            link = part.attrib["name"]
            seen[link] += 1
            name = f"robot/{link}" + (f"_{seen[link]}" if seen[link] > 1 else "")
            found.append((link, Solid(name, *_looks(visual))))
    return tuple(found)


def _looks(visual: ET.Element) -> tuple[str, tuple[float, ...], np.ndarray, str]:
    """Shape, size, pose and role of a visual element; dark ones are drawn as wheels."""
    role = "wheel" if _one(visual, "material").attrib["name"] == "dark" else "robot"
    form = _one(visual, "geometry")[0]
    if form.tag == "box":
        return (
            "box",
            tuple(_numbers(form.attrib["size"]).tolist()),
            _origin(visual),
            role,
        )
    return (
        "cylinder",
        (float(form.attrib["radius"]), float(form.attrib["length"])),
        _origin(visual),
        role,
    )


def _one(part: ET.Element, tag: str) -> ET.Element:
    return next(part.iter(tag))


def _numbers(text: str) -> np.ndarray:
    return np.array([float(x) for x in text.split()])


def _origin(part: ET.Element) -> np.ndarray:
    """The place and the turn of an element in its link."""
    origin = _one(part, "origin").attrib
    place = pose(*_numbers(origin["xyz"]))
    for axis, angle in zip(
        np.eye(3)[::-1], _numbers(origin.get("rpy", "0 0 0"))[::-1], strict=True
    ):
        place = place @ _turn(axis, angle)  # about z, then y, then x
    return place


def _turn(axis: np.ndarray, angle: float) -> np.ndarray:
    """A turn about an axis of length 1 (or 0: no turn). Source: Rodrigues' formula."""
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    matrix = np.eye(4)
    matrix[:3, :3] += math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross
    return matrix
