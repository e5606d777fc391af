"""What all robots in PyBullet do in the same way: rest, begin again, and move; and the motors in their joints."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any, Protocol, Self

import numpy as np

from rlrobot_edu.robots.engines.bullet.simulation import BulletSimulation
from rlrobot_edu.robots.robot import SimulatedRobot
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.task.robot_cards import ROBOTS


class Motors:
    """The motors in the joints `names` of the robot that is `body` in `simulation`: their commands are speeds.

    numbers: the simulation's number of each joint; limits: lowest and highest angle of each joint [rad]
    torques: the largest of each motor [N m], in the order of the joints
    """

    def __init__(
        self, simulation: BulletSimulation, body: int, names: Sequence[str]
    ) -> None:
        self._simulation = simulation
        self._body = body
        joints = simulation.joints(body)
        self.numbers = {name: joints[name] for name in names}
        self.limits = {}
        self.torques = []
        for name, i in self.numbers.items():
            facts = simulation.getJointInfo(body, i)
            self.limits[name] = facts[8:10]
            self.torques.append(facts[10])

    def angles(self) -> dict[str, float]:
        """Angle of each joint [rad]."""
        joints = list(self.numbers.values())
        states = self._simulation.getJointStates(self._body, joints)
        angles = [state[0] for state in states]
        return dict(zip(self.numbers, angles, strict=True))

    def drive(self, speeds: Mapping[str, float]) -> None:
        """Turn the joints at `speeds` [rad/s] from now on."""
        self._simulation.setJointMotorControlArray(
            self._body,
            list(self.numbers.values()),
            self._simulation.VELOCITY_CONTROL,
            targetVelocities=[speeds[name] for name in self.numbers],
            forces=self.torques,
        )


class Part(Protocol):
    """A part of a robot, such as its wheels or its arm: motors to drive, and sensors."""

    def drive(self, command: Mapping[str, float]) -> None:
        """Set the motors' speeds; a part picks its own from the robot's `command`."""

    def readings(self) -> dict[str, float]:
        """What the part's sensors read now."""


class BulletRobot(SimulatedRobot):
    """A robot of several parts that is one `body` in a simulation of its own.

    name: of the robot's card
    step_time: duration of one control step [s]
    twin: the same robot without PyBullet, which draws the scene that the readings describe
    """

    _built: Callable[[], "BulletRobot"]  # builds such a robot once more

    def __new__(cls, *arguments: Any, **options: Any) -> Self:
        robot = super().__new__(cls)
        robot._built = partial(cls, *arguments, **options)
        return robot

    def __init__(
        self,
        name: str,
        simulation: BulletSimulation,
        body: int,
        parts: Sequence[Part],
        step_time: float,
        twin: SimulatedRobot,
    ) -> None:
        super().__init__(ROBOTS[name])
        self._simulation = simulation
        self._body = body
        self._parts = parts
        self._step_time = step_time
        self._twin = twin
        self._stand_still()
        simulation.run(1.0)  # until nothing moves any more
        self._beginning = simulation.saveState()
        self._readings = self._sense()

    # A copy, or a robot in another process, is built in a simulation of its own and then goes on from this state.
    def __reduce__(self) -> tuple[Any, ...]:
        return self._built, (), (self._simulation.state(), self._readings)

    def __setstate__(self, state: tuple[bytes, dict[str, float]]) -> None:
        world, self._readings = state
        self._simulation.resume(world)

    def _stand_still(self) -> None:
        self._drive(dict.fromkeys(self._card.commands, 0.0))

    def _drive(self, command: Mapping[str, float]) -> None:
        for part in self._parts:
            part.drive(command)

    def _begin(self, rng: np.random.Generator) -> None:
        self._simulation.restoreState(self._beginning)
        self._stand_still()

    def _move(self, command: Mapping[str, float]) -> None:
        self._drive(command)
        self._simulation.run(self._step_time)

    def _sense(self) -> dict[str, float]:
        readings: dict[str, float] = {}
        for part in self._parts:
            readings |= part.readings()
        return readings

    def scene(self) -> Scene:
        """The scene at the place that the readings give; the robot is drawn level."""
        self._twin._readings = self._readings
        return self._twin.scene()

    def close(self) -> None:
        """End the simulation."""
        self._simulation.close()
