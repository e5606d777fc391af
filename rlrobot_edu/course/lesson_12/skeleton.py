"""The arm as its URDF file describes it: joints with their limits, and solids to draw. Needs no PyBullet."""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from functools import cache
from pathlib import Path
from typing import NamedTuple

import numpy as np

import rlrobot_edu.robots
from rlrobot_edu.robots.scene import Scene, Solid, pose
from rlrobot_edu.task.robot_cards import JOINTS

URDF = Path(rlrobot_edu.robots.__file__).parent / "bullet" / "arm.urdf"
HOME = (-0.42, 0.9, 0.26)  # where the joints arm, biceps and forearm begin [rad]
OBJECT, OBJECT_PLACE = (0.02, 0.05), (0.27, 0.09, 0.025)  # radius and height, and middle [m]
FIELD = (0.20, -0.16, 0.32, 0.16)  # the part of the table that matters: x_min, y_min, x_max, y_max [m]
TABLE = (-0.10, -0.26, 0.42, 0.26)


class Joint(NamedTuple):
    """A joint: the links that it joins, where it stands in the first, its axis, and its limits [rad]."""

    parent: str
    child: str
    origin: np.ndarray
    axis: np.ndarray
    limits: tuple[float, float]


@cache
def _file() -> ET.Element:
    return ET.parse(URDF).getroot()


@cache
def joints() -> dict[str, Joint]:
    """The joints by name, from the foot to the gripper."""
    found = {}
    for part in _file().iter("joint"):
        axis, limit = part.find("axis"), part.find("limit")
        found[part.attrib["name"]] = Joint(
            part.find("parent").attrib["link"], part.find("child").attrib["link"], _origin(part),
            np.zeros(3) if axis is None else _numbers(axis.attrib["xyz"]),
            (0.0, 0.0) if limit is None else (float(limit.attrib["lower"]), float(limit.attrib["upper"])),
        )  # fmt: skip
    return found


def link_poses(angles: tuple[float, ...]) -> dict[str, np.ndarray]:
    """Homogeneous transform of each link, arrays (4, 4), for the angles of arm, biceps and forearm [rad].

    The origin of the link `gripper` is the point between the fingertips.
    """
    turned = dict(zip(JOINTS, angles, strict=True))
    there = {"foot": np.eye(4)}
    for name, joint in joints().items():
        there[joint.child] = there[joint.parent] @ joint.origin @ _turn(joint.axis, turned.get(name, 0.0))
    return there


def scene_of(angles: tuple[float, ...]) -> Scene:
    """The table with its field, the object and the arm, as PyBullet's arm shows them."""
    x_min, y_min, x_max, y_max = FIELD
    middle = pose((x_min + x_max) / 2, (y_min + y_max) / 2, 0.001)
    field = Solid("field", "box", (x_max - x_min, y_max - y_min, 0.002), middle, "wall")
    thing = Solid("object", "cylinder", OBJECT, pose(*OBJECT_PLACE), "object")
    there, solids = link_poses(angles), []
    for link in _file().iter("link"):
        name = link.attrib["name"]
        for i, visual in enumerate(link.iter("visual")):
            shape, size, role = _looks(visual)
            title = "body" if name == "gripper" and i == 0 else f"{name}_{i}"  # the gripper leaves the path
            solids.append(Solid(f"robot/{title}", shape, size, there[name] @ _origin(visual), role))
    return Scene((field, thing, *solids), np.empty((0, 2, 3)), TABLE)


def _looks(visual: ET.Element) -> tuple[str, tuple[float, ...], str]:
    """Shape, size and role of a visual element; dark ones are drawn as wheels."""
    role = "wheel" if visual.find("material").attrib["name"] == "dark" else "robot"
    form = visual.find("geometry")[0]
    if form.tag == "box":
        return "box", tuple(_numbers(form.attrib["size"]).tolist()), role
    return "cylinder", (float(form.attrib["radius"]), float(form.attrib["length"])), role


def _numbers(text: str) -> np.ndarray:
    return np.array([float(x) for x in text.split()])


def _origin(part: ET.Element) -> np.ndarray:
    """The place and the turn of an element in its link."""
    origin = part.find("origin").attrib
    place = pose(*_numbers(origin["xyz"]))
    for axis, angle in zip(np.eye(3)[::-1], _numbers(origin.get("rpy", "0 0 0"))[::-1], strict=True):
        place = place @ _turn(axis, angle)  # about z, then y, then x
    return place


def _turn(axis: np.ndarray, angle: float) -> np.ndarray:
    """A turn about an axis of length 1 (or 0: no turn). Source: Rodrigues' formula."""
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    matrix = np.eye(4)
    matrix[:3, :3] += math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross
    return matrix
