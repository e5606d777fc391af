"""The mobile manipulator: the arm on top of the mobile base, one body, in a room with a table. In PyBullet."""

import shutil
import xml.etree.ElementTree as ET
from pathlib import Path
from tempfile import TemporaryDirectory

from rlrobot_edu.robots.arm import bullet_arm as arm
from rlrobot_edu.robots.arm.arm_body import URDF, object_at
from rlrobot_edu.robots.arm.kinematic_manipulator import (
    MOUNT,
    OBJECT_PLACE,
    KinematicManipulator,
)
from rlrobot_edu.robots.engines.bullet import mobile_base as bullet_base
from rlrobot_edu.robots.engines.bullet.robot import BulletRobot
from rlrobot_edu.robots.engines.bullet.simulation import BulletSimulation
from rlrobot_edu.robots.engines.kinematic.base import KinematicBase


def joined_urdf() -> str:
    """The URDF of base and arm as one robot: all links and joints of both, and one joint that holds them together."""
    robot = ET.parse(bullet_base.URDF).getroot()
    robot.extend(part for part in ET.parse(URDF).getroot() if part.tag != "material")
    mount = ET.SubElement(robot, "joint", name="mount", type="fixed")
    ET.SubElement(mount, "parent", link="chassis")
    ET.SubElement(mount, "child", link="foot")
    ET.SubElement(mount, "origin", xyz=" ".join(map(str, MOUNT)))
    return ET.tostring(robot, encoding="unicode")


class MobileManipulator(BulletRobot):
    """The mobile base with the arm on its back. An object stands near the edge of a table as high as the base.

    scene: name of the scene, ``table_room``
    step_time: duration of one control step [s]
    """

    def __init__(self, scene: str, step_time: float) -> None:
        simulation = BulletSimulation(bullet_base.PHYSICS_HZ)
        level = KinematicBase(scene, step_time)
        bullet_base.add_arena(simulation, level.arena)
        simulation.add(object_at(OBJECT_PLACE))
        with TemporaryDirectory() as folder:
            urdf = Path(folder, "mobile_manipulator.urdf")
            urdf.write_text(joined_urdf(), encoding="utf-8")
            shutil.copy(bullet_base.URDF.with_name("hull.obj"), folder)
            body = bullet_base.load(simulation, urdf, level.arena)
        wheels = bullet_base.Wheels(simulation, body, level)
        joints = arm.ArmJoints(simulation, body, OBJECT_PLACE, step_time)
        twin = KinematicManipulator(scene, step_time)
        super().__init__(
            "mobile_manipulator", simulation, body, [wheels, joints], step_time, twin
        )
