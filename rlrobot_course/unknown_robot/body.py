"""A robot with the weaknesses of a secret, in an arena with a wall that is on no map. It logs what it truly earns."""

from collections import deque
from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from rlrobot_course.unknown_robot.secret import Secret
from rlrobot_edu.robots.robot import LinkedRobot
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.task.task import Task
from rlrobot_ros.live.safety import within
from rlrobot_ros.live.served_body import TICK, ServedBody


class SecretBody(ServedBody, LinkedRobot):
    """The robot that nobody has seen: as a body to be served, or as a link to be driven without ROS and much faster.

    It drives no faster than the task's fastest actions.

    log: for each tick the reward of the step that ends there, from where the robot really was and what its lasers would
    have said without noise
    seed: of its noise; None is a new one each time

    Raises ValueError for a task with episodes, or whose robot is not one on two wheels.
    """

    def __init__(
        self, task: str | Task, secret: Secret, seed: int | None = None
    ) -> None:
        super().__init__(task, secret.realism, seed)
        if self.task.episode_steps is not None:
            raise ValueError(
                f"{self.task.name} has episodes, and nobody would carry the robot back; choose another task"
            )
        self._base.arena = secret.with_wall(self._base.arena, self.chassis.radius)
        self._robot.reset(self._rng)
        motions = [
            self.chassis.twist(self.task.command_for(a))
            for a in range(self.task.actions.n)
        ]
        self._fastest = np.abs(motions).max(axis=0).tolist()
        self._ticks = round(self.task.step_time / TICK)
        self._past = deque([self._base.readings], maxlen=self._ticks + 1)
        self.log: list[float] = []

    def move(self, v: float, omega: float) -> None:
        """Drive at v [m/s] and turn at omega [rad/s] for a tick, and log what was earned."""
        super().move(*within(v, omega, *self._fastest))
        self._past.append(self._base.readings)
        self.log.append(self.task.reward_for(self._past[0], self._past[-1]))

    @property
    def readings(self) -> dict[str, float]:
        """What its sensors say, by name: its lasers themselves, while `RobotLink` makes them of its scan."""
        return self._robot.readings

    def reset(self, rng: np.random.Generator | None = None) -> dict[str, float]:
        """The readings; it stays where it is."""
        return self.readings

    def act(self, command: Mapping[str, float]) -> dict[str, float]:
        """Drive for one control step, with no safety rule of a link's."""
        for _ in range(self._ticks):
            self.move(*self.chassis.twist(command))
        return self.readings

    def scene(self) -> Scene:
        """Where everything really is, the wall included."""
        return self._robot.scene()

    def prepare(self, task: Task) -> None:
        """It is ready."""

    def close(self) -> None:
        """Nothing is to be ended."""


def rewards_of(
    log: Sequence[float] | NDArray[np.float64], ticks: int
) -> NDArray[np.float64]:
    """The rewards of whole steps of so many ticks, from the beginning at which they are worth most.

    A robot is not told when its driver's steps begin.
    """
    whole = len(log) // ticks - 1
    return max(
        (np.array(log[i::ticks][:whole]) for i in range(ticks)),
        key=lambda rewards: float(rewards.mean()),
    )
