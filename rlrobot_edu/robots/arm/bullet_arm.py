"""The arm: three joints and a gripper over a table with an object, in PyBullet."""

from collections.abc import Mapping, Sequence

from rlrobot_edu.robots.arm.arm_body import (
    HOME,
    OBJECT_PLACE,
    URDF,
    Angles,
    object_at,
    readings_of,
)
from rlrobot_edu.robots.arm.kinematic_arm import KinematicArm
from rlrobot_edu.robots.engines.bullet.robot import BulletRobot, Motors
from rlrobot_edu.robots.engines.bullet.simulation import BulletSimulation
from rlrobot_edu.task.robot_cards import JOINTS

PHYSICS_HZ = 60


class ArmJoints:
    """The arm that is part of `body`: its joints obey speeds and stop at their limits.

    place: of the object [m]
    step_time: how long a command lasts [s]
    """

    def __init__(
        self,
        simulation: BulletSimulation,
        body: int,
        place: Sequence[float],
        step_time: float,
    ) -> None:
        self._simulation = simulation
        self._body = body
        self._place = place
        self._step_time = step_time
        self._motors = Motors(simulation, body, JOINTS)
        self._gripper = simulation.joints(body)["wrist"]
        home = HOME._asdict()
        for joint, i in self._motors.numbers.items():
            simulation.resetJointState(body, i, home[joint])

    def drive(self, command: Mapping[str, float]) -> None:
        """Set the motors' speeds to `command` [rad/s], slower where a limit would be passed within the step."""
        angles = self._motors.angles()
        speeds = {}
        for joint, (low, high) in self._motors.limits.items():
            slowest = (low - angles[joint]) / self._step_time
            fastest = (high - angles[joint]) / self._step_time
            speeds[joint] = min(max(command[joint], slowest), fastest)
        self._motors.drive(speeds)

    def readings(self) -> dict[str, float]:
        """Gripper and object in the scene [m], and the joints' angles [rad]."""
        gripper = self._simulation.link_pose(self._body, self._gripper)[:3, 3]
        angles = Angles(**self._motors.angles())
        return readings_of(gripper.tolist(), self._place, angles)


class Arm(BulletRobot):
    """An arm at the edge of a table. An object stands on the table, too heavy for the arm to push.

    scene: name of the scene, ``table``
    step_time: duration of one control step [s]
    """

    def __init__(self, scene: str, step_time: float) -> None:
        simulation = BulletSimulation(PHYSICS_HZ)
        simulation.add_floor()  # the table's top
        simulation.add(object_at(OBJECT_PLACE))
        body = simulation.load(URDF, (0, 0, 0), fixed=True)
        joints = ArmJoints(simulation, body, OBJECT_PLACE, step_time)
        twin = KinematicArm(scene, step_time)
        super().__init__("arm", simulation, body, [joints], step_time, twin)
