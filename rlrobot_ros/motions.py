"""The action of a task that a velocity command means."""

import math

import numpy as np

from rlrobot_edu.robots.chassis import CHASSIS, Chassis
from rlrobot_edu.task.robot_cards import ROBOTS, WHEELS
from rlrobot_edu.task.task import Task


def chassis_of(task: Task) -> Chassis:
    """Dimensions of the task's robot. Raises ValueError if it is not commanded by its wheels alone."""
    wheels = set(WHEELS)
    drivable = [robot for robot in CHASSIS if set(ROBOTS[robot].commands) == wheels]
    if task.robot not in drivable:
        raise ValueError(
            f"cmd_vel commands wheels alone, and {task.name} the robot {task.robot!r}; "
            f"choose a task of {' or '.join(drivable)}"
        )
    return CHASSIS[task.robot]


class Motions:
    """The motion of each action of a task: v ahead [m/s] and ω to the left [rad/s].

    tolerance: how far a command may be from an action's motion, as part of the task's largest v and largest ω
    max_speed: the largest v, forward or backward [m/s]
    distinct: those that differ, rounded

    Raises ValueError for a task whose robot is not commanded by its wheels alone.
    """

    def __init__(self, task: Task, tolerance: float) -> None:
        self.chassis = chassis_of(task)
        self._tolerance = tolerance
        if not (
            isinstance(tolerance, int | float | np.number) and 0 <= tolerance < math.inf
        ):
            raise ValueError(
                f"tolerance must be a number of at least 0, got {tolerance!r:.200}"
            )
        commands = task.commands
        # Of actions with the same motion the plainest counts: its outputs are the wheels' commands.
        numbers = range(len(commands))
        plain = [a for a in numbers if task.actions.decode(a) == commands[a]]
        others = [a for a in numbers if a not in plain]
        self._actions = [*plain, *others]
        motions = np.array([self.chassis.twist(commands[a]) for a in self._actions])
        rounded = [(round(v, 3), round(omega, 3)) for v, omega in motions.tolist()]
        self.distinct = tuple(dict.fromkeys(rounded))
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
        is_near = miss <= self._tolerance + 1e-9  # false for NaN
        return self._actions[best] if is_near else None
