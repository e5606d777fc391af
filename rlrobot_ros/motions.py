"""Which action of a task a velocity command is."""

import math

import numpy as np

from rlrobot_edu.robots.chassis import CHASSIS, Chassis
from rlrobot_edu.task.robot_cards import ROBOTS, WHEELS
from rlrobot_edu.task.task import Task


def chassis_of(task: Task) -> Chassis:
    """Dimensions of the task's robot. Raises ValueError if that is commanded otherwise than by wheels alone."""
    drivable = [
        robot for robot in CHASSIS if set(ROBOTS[robot].commands) == set(WHEELS)
    ]
    if task.robot not in drivable:
        raise ValueError(
            f"cmd_vel commands wheels alone, and {task.name} the robot {task.robot!r}; choose a task of "
            + " or ".join(drivable)
        )
    return CHASSIS[task.robot]


class Motions:
    """The motions that a task's actions are: v ahead [m/s] and ω to the left [rad/s].

    tolerance: how far a command may be from an action's motion, as part of the task's largest v and largest ω
    max_speed: the largest v, forward or backward [m/s]

    Raises ValueError for a task whose robot is commanded otherwise than by its wheels.
    """

    def __init__(self, task: Task, tolerance: float) -> None:
        self.chassis, self._tolerance = chassis_of(task), tolerance
        if not 0 <= tolerance < math.inf:
            raise ValueError(
                f"tolerance must be a number of at least 0, got {tolerance!r:.200}"
            )
        commands = task.commands
        # of actions with the same motion the plainest counts: its outputs are the wheels' commands
        plain = [
            task.actions.decode(a) == command for a, command in enumerate(commands)
        ]
        self._actions = sorted(range(len(commands)), key=lambda a: (not plain[a], a))
        motions = np.array([self.chassis.twist(commands[a]) for a in self._actions])
        largest = np.abs(motions).max(axis=0)
        self.max_speed = float(largest[0])
        self._unit = np.where(largest > 0, largest, 1.0)
        self._motions = motions / self._unit

    def action(self, v: float, omega: float, aside: float = 0.0) -> int | None:
        """Number of the action nearest to a command that also drives aside [m/s]; None if none is near enough."""
        given = np.array([v, omega]) / self._unit
        misses = np.abs(self._motions - given).max(axis=1)
        best = int(np.argmin(misses))
        miss = np.maximum(misses[best], abs(aside) / self._unit[0])
        return (
            self._actions[best] if miss <= self._tolerance + 1e-9 else None
        )  # false for NaN
