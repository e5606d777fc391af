"""The mobile manipulator: the arm on top of the mobile base, one body, in a room with a table. In PyBullet."""

import shutil
import xml.etree.ElementTree as ET
from pathlib import Path
from tempfile import TemporaryDirectory

from rlrobot_edu.robots.arenas import ARENAS
from rlrobot_edu.robots.arm import bullet_arm as arm
from rlrobot_edu.robots.arm.arm_body import OBJECT, URDF
from rlrobot_edu.robots.arm.kinematic_manipulator import MOUNT, OBJECT_PLACE
from rlrobot_edu.robots.engines.bullet import mobile_base as bullet_base
from rlrobot_edu.robots.engines.bullet.robot import BulletRobot
from rlrobot_edu.robots.engines.bullet.simulation import BulletSimulation
from rlrobot_edu.robots.mobile_base import PIONEER, beams
from rlrobot_edu.robots.scene import Scene, Solid, pose


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
        self._arena = ARENAS[scene]
        simulation = BulletSimulation(bullet_base.PHYSICS_HZ)
        bullet_base.add_arena(simulation, self._arena)
        self._object = Solid("object", "cylinder", OBJECT, pose(*OBJECT_PLACE), "object")
        simulation.add(self._object)
        with TemporaryDirectory() as folder:
            urdf = Path(folder, "mobile_manipulator.urdf")
            urdf.write_text(joined_urdf(), encoding="utf-8")
            shutil.copy(bullet_base.URDF.with_name("hull.obj"), folder)
            body = bullet_base.load(simulation, urdf, self._arena)
        wheels = bullet_base.Wheels(simulation, body, self._arena)
        joints = arm.ArmJoints(simulation, body, OBJECT_PLACE, step_time)
        super().__init__("mobile_manipulator", simulation, body, [wheels, joints], step_time, leader="chassis")

    def scene(self) -> Scene:
        """The room with its table, the object, the robot and its laser beams at this instant."""
        solids = (*self._arena.solids(), self._object, *self.solids())
        return Scene(solids, beams(self._readings, PIONEER), self._arena.bounds)
