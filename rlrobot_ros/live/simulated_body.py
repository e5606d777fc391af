"""The simulated body of a served robot: it drives a tenth of a second at a time, and looks around with its scanner."""

from pathlib import Path

import numpy as np

from rlrobot_edu.robots.giraff import Giraff
from rlrobot_edu.robots.mobile_base import MobileBase
from rlrobot_edu.robots.realism import Realism, RealisticRobot
from rlrobot_edu.task.robot_cards import LASER_RANGE, ROBOTS
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.task_file import load_task
from rlrobot_ros.motions import chassis_of

ROBOT_CLASSES = {"mobile_base": MobileBase, "giraff": Giraff}
TICK = 0.1  # time between two messages of the robot, and in which it carries out a command [s]
RAYS = 360  # of its scanner, which stands midway between its wheels
RANGE_MAX = 2 * LASER_RANGE  # of its scanner [m]


class SimulatedBody:
    """The robot of a task in pymunk, as `ServedRobot` serves it, and without ROS.

    realism: its imperfections, in control steps of a tenth of a second; seed: makes them repeatable

    Raises ValueError for a task or imperfections that the robot cannot have.
    """

    def __init__(
        self, task: str | Path | Task, realism: Realism | None, seed: int | None
    ) -> None:
        task = load_task(task)
        realism = realism or Realism()
        self.chassis = chassis_of(task)
        self._card = ROBOTS[task.robot]
        self._base = ROBOT_CLASSES[task.robot](task.scene, TICK, realism=realism)
        self._robot = RealisticRobot(self._base, self._card, realism)
        self._rng = np.random.default_rng(seed)
        self._noise = realism.laser_noise
        self._robot.reset(self._rng)

    def move(self, v: float, omega: float) -> None:
        """Drive at v [m/s] and turn to the left at omega [rad/s] for a tick, as far as its wheels can."""
        speeds = self.chassis.wheel_speeds(v, omega)
        possible = {}
        for wheel, command in self._card.commands.items():
            possible[wheel] = min(max(speeds[wheel], command.low), command.high)
        self._robot.act(possible)

    def pose(self) -> tuple[float, float, float]:
        """The pose of the point midway between its wheels by odometry: x, y [m], theta [rad]."""
        readings = self._robot.readings
        theta = readings["theta"]
        return *self.chassis.axle_at(readings["x"], readings["y"], theta), theta

    def look(self) -> list[float]:
        """The scanner's measurements now [m], at most its range; with noise, each look draws random numbers."""
        ranges = np.array(self._base.look_around(RAYS))
        if self._noise:
            ranges = np.maximum(self._rng.normal(ranges, self._noise), 1e-3)
        # JSON cannot distinguish infinity from NaN
        shortened: list[float] = np.minimum(ranges, RANGE_MAX).tolist()
        return shortened
