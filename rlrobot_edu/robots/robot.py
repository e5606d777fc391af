"""What an environment asks of a robot, and what all our simulated robots do in the same way."""

from abc import abstractmethod
from collections.abc import Mapping, Sequence
from typing import Protocol, runtime_checkable

import numpy as np

from rlrobot_edu.learning.kernel_world import KernelWorld
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.task.robot_cards import RobotCard
from rlrobot_edu.task.task import Task


class Robot(Protocol):
    """What an environment asks of a robot. Readings and commands have the names and the units of the robot's card."""

    @property
    def readings(self) -> dict[str, float]:
        """What the sensors read now."""

    def reset(self, rng: np.random.Generator) -> dict[str, float]:
        """Put the robot at its start and return the readings. All random numbers from now on come from `rng`."""

    def act(self, command: Mapping[str, float]) -> dict[str, float]:
        """Carry out `command` for one control step and return the readings. Raises ValueError if it cannot."""

    def scene(self) -> Scene:
        """What can be seen at this instant."""

    def close(self) -> None:
        """End the robot's simulator, if it has one."""


class LinkedRobot(Robot, Protocol):
    """A robot that exists already, such as a real one."""

    def prepare(self, task: Task) -> None:
        """Get ready for a task. Raises ValueError, which names the task's file, if the robot cannot carry it out."""


@runtime_checkable
class KernelRobot(Protocol):
    """What a robot offers besides if kernels move it, so that the compiled loop of learning can run it.

    It is no `Robot` here: to ask whether a robot is of this kind, Python 3.11 would read its `readings`, which a robot
    has only after its first reset.
    """

    def kernel_world(
        self, task: Task, commands: Sequence[Mapping[str, float]], at_goal: int
    ) -> KernelWorld | None:
        """The robot as it stands there, with its task. None if this robot or this task has no kernels after all.

        commands: the command of each action; at_goal: steps at the goal without a break
        """

    def look(self) -> dict[str, float]:
        """Sense again, because the kernels have moved the robot, and return the readings."""


class SimulatedRobot(Robot):
    """A robot that checks each command against its card, moves, and senses once a step.

    A subclass defines how the robot begins (`_begin`), moves (`_move`) and senses (`_sense`). Copies of a robot
    (`copy.deepcopy`, `pickle`) are in the same state, each in a world of its own.

    card: what the robot can sense and do
    """

    def __init__(self, card: RobotCard) -> None:
        self._card = card
        self._readings: dict[str, float] = {}

    @property
    def readings(self) -> dict[str, float]:
        """What the sensors read now, by the names and in the units of the robot's card."""
        return dict(self._readings)

    def reset(self, rng: np.random.Generator | None = None) -> dict[str, float]:
        """Put the robot at its start and return the readings. All random numbers from now on come from `rng`."""
        self._begin(np.random.default_rng(rng))
        return self.look()

    def act(self, command: Mapping[str, float]) -> dict[str, float]:
        """Carry out `command` for one control step and return the readings.

        Raises ValueError for an unknown name, a missing one, NaN, or a number out of range; then nothing has moved.
        """
        self._card.check_command(command)
        self._move(command)
        return self.look()

    def look(self) -> dict[str, float]:
        """Sense again, because something else has moved the robot, and return the readings."""
        self._readings = self._sense()
        return self.readings

    def close(self) -> None:
        """Do nothing: this robot has no simulator to close."""

    @abstractmethod
    def _begin(self, rng: np.random.Generator) -> None:
        """Take the starting place."""

    @abstractmethod
    def _move(self, command: Mapping[str, float]) -> None:
        """Carry out a command that is on the card, for one control step."""

    @abstractmethod
    def _sense(self) -> dict[str, float]:
        """What the sensors read now."""
