"""What the robots in PyBullet do alike: rest, begin again, move, and how they look; and the motors in their joints."""

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any, Protocol, Self

import numpy as np

from rlrobot_edu.robots.engines.bullet.simulation import BulletSimulation, transform
from rlrobot_edu.robots.mobile_base import PIONEER
from rlrobot_edu.robots.robot import SimulatedRobot
from rlrobot_edu.robots.scene import Solid
from rlrobot_edu.task.robot_cards import ROBOTS


class Motors:
    """The motors in the joints `names` of the robot that is `body` in `simulation`: their commands are speeds.

    numbers: of the joints, by name; limits: lowest and highest angle of each [rad]; torques: the most that each motor
        can give [N m], in their order
    """

    def __init__(self, simulation: BulletSimulation, body: int, names: Sequence[str]) -> None:
        self._simulation, self._body = simulation, body
        joints = simulation.joints(body)
        self.numbers = {name: joints[name] for name in names}
        about = {name: simulation.getJointInfo(body, i) for name, i in self.numbers.items()}
        self.limits = {name: facts[8:10] for name, facts in about.items()}
        self.torques = [facts[10] for facts in about.values()]

    def angles(self) -> dict[str, float]:
        """Angle of each joint [rad]."""
        states = self._simulation.getJointStates(self._body, [*self.numbers.values()])
        return {name: state[0] for name, state in zip(self.numbers, states, strict=True)}

    def drive(self, speeds: Mapping[str, float]) -> None:
        """Turn the joints at `speeds` [rad/s] from now on."""
        told = [speeds[name] for name in self.numbers]
        self._simulation.setJointMotorControlArray(
            self._body, [*self.numbers.values()], self._simulation.VELOCITY_CONTROL, targetVelocities=told,
            forces=self.torques,
        )  # fmt: skip


class Part(Protocol):
    """What a robot is made of, such as wheels or an arm: motors to drive, and sensors."""

    def drive(self, command: Mapping[str, float]) -> None:
        """Set the motors' speeds; a part picks its own from the robot's `command`."""

    def readings(self) -> dict[str, float]:
        """What the part's sensors say now."""


class BulletRobot(SimulatedRobot):
    """A robot of several parts that is one `body` in a simulation of its own.

    name: of the robot's card
    step_time: duration of one control step [s]
    leader: name of the link whose first shape leaves the path in pictures
    """

    _built: Callable[[], "BulletRobot"]  # builds such a robot once more

    def __new__(cls, *arguments: Any, **options: Any) -> Self:
        robot = super().__new__(cls)
        robot._built = partial(cls, *arguments, **options)
        return robot

    def __init__(
        self, name: str, simulation: BulletSimulation, body: int, parts: Sequence[Part], step_time: float, leader: str
    ) -> None:
        super().__init__(ROBOTS[name])
        self._simulation, self._body, self._parts = simulation, body, parts
        self._step_time, self._leader = step_time, leader
        self._stand_still()
        simulation.run(1.0)  # until nothing moves any more
        self._beginning = simulation.saveState()
        self._readings = self._sense()

    # A copy, or a robot in another process, is built anew in a simulation of its own and then goes on from here.
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
        return {name: reading for part in self._parts for name, reading in part.readings().items()}

    def solids(self) -> tuple[Solid, ...]:
        """The robot's visual shapes where they are now; dark ones are drawn as wheels."""
        there, body = self._simulation, self._body
        names = [there.getJointInfo(body, i)[12].decode() for i in range(there.getNumJoints(body))]
        names.append(there.getBodyInfo(body)[0].decode())  # of link -1
        solids: list[Solid] = []
        seen: Counter[int] = Counter()
        for _, link, kind, size, _, position, turned, colour, *_ in there.getVisualShapeData(body):
            name = f"robot/{names[link]}" + (f"_{seen[link] + 1}" if seen[link] else "")
            if names[link] == self._leader and not seen[link]:
                name = "robot/body"
            seen[link] += 1
            shapes = {
                there.GEOM_BOX: ("box", size),
                there.GEOM_CYLINDER: ("cylinder", (size[1], size[0])),
                there.GEOM_SPHERE: ("sphere", size[:1]),
                there.GEOM_MESH: PIONEER.body(),  # the only mesh
            }
            role = "wheel" if max(colour[:3]) < 0.3 else "robot"
            solids.append(Solid(name, *shapes[kind], there.link_pose(body, link) @ transform(position, turned), role))
        return tuple(solids)

    def close(self) -> None:
        """End the simulation."""
        self._simulation.close()
