"""Imperfections that an ideal simulator leaves out: noise, wheels that slip, late commands, walls with friction."""

from collections import deque
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Self

import numpy as np

from rlrobot_edu.checks import LARGEST_NUMBER, check_between, check_count
from rlrobot_edu.keywords import suggests_keywords
from rlrobot_edu.robots.robot import Robot, SimulatedRobot
from rlrobot_edu.robots.scene import Scene
from rlrobot_edu.task.robot_cards import LASERS, WHEELS, RobotCard


@suggests_keywords
@dataclass(frozen=True)
class Realism:
    """Imperfections of a robot; all 0 is the ideal robot.

    Parameters
    ----------
    laser_noise : float [m]
        Standard deviation of each laser reading.
    wheel_slip : float
        Standard deviation of the speed of each wheel or joint, relative to the commanded speed.
    delay : int
        Control steps that a command takes to arrive; until the first one does, the robot stands still.
    lag : float [s]
        Time from a command's arrival until it acts, less than a step; until then the command before it acts.
    wall_friction : float
        Coefficient of friction between walls and the robot's body.

    Raises
    ------
    ValueError
        For a negative number, NaN, infinity, or a delay that is not whole.

    Notes
    -----
    Noise is Gaussian. Readings stay within the sensor's range and speeds within the robot's: they are cut off there.
    """

    laser_noise: float = 0.0
    wheel_slip: float = 0.0
    delay: int = 0
    lag: float = 0.0
    wall_friction: float = 0.0

    @classmethod
    def vrep(cls) -> Self:
        """A lag and a friction as in the paper's V-REP scenes: see docs/studies/vrep_comparison.md.

        Returns
        -------
        Realism
            A lag of 0.1 s and a wall friction of 0.72.
        """
        return cls(lag=0.1, wall_friction=0.72)

    def __post_init__(self) -> None:
        for name in ("laser_noise", "wheel_slip", "lag", "wall_friction"):
            check_between(name, getattr(self, name), 0, LARGEST_NUMBER)
        check_count("delay", self.delay, least=0)

    def check(self, card: RobotCard, engine: str, step_time: float) -> None:
        """Check that a robot has what these imperfections act on.

        Parameters
        ----------
        card : RobotCard
            What the robot can sense and do.
        engine : str
            The simulator of the robot.
        step_time : float [s]
            Duration of a control step.

        Raises
        ------
        ValueError
            If one of the imperfections has nothing to act on, or if the lag is not shorter than a step.
        """
        has_lasers = card.sensors.keys() >= set(LASERS)
        turns = all(quantity.unit == "rad/s" for quantity in card.commands.values())
        is_base = card.commands.keys() == set(WHEELS)
        meets_walls = is_base and engine in ("pymunk", "kinematic")
        no_walls = "it needs a base with engine='pymunk' or engine='kinematic'"
        for name, is_met, why_not in (
            ("laser_noise", has_lasers, "this robot has no lasers"),
            ("wheel_slip", turns, "this robot has neither wheels nor joints that turn"),
            ("lag", meets_walls, no_walls),
            ("wall_friction", meets_walls, no_walls),
        ):
            if getattr(self, name) and not is_met:
                raise ValueError(f"{name} has nothing to act on: {why_not}")
        if self.lag >= step_time:
            raise ValueError(
                f"lag must be below {step_time:g} s, a control step, got {self.lag}; see delay"
            )


def realistic(robot: Robot, card: RobotCard, realism: Realism) -> Robot:
    """The robot with `realism`; it is the same one if there is nothing to add to what it simulates itself."""
    if realism.laser_noise or realism.wheel_slip or realism.delay:
        return RealisticRobot(robot, card, realism)
    return robot


class RealisticRobot(SimulatedRobot):
    """A robot with the imperfections of `realism`; a task uses it like the robot itself.

    Its random numbers come from the generator given to `reset`, after those that the robot draws there. A command that
    cannot be carried out is refused when it is given, not when it would arrive.
    The rewards of a task come from these readings too. `scene` shows where the robot really is.

    robot: the ideal robot; lag and friction, which its own physics simulates, it has already. card: its card
    """

    def __init__(self, robot: Robot, card: RobotCard, realism: Realism) -> None:
        super().__init__(card)
        self._robot = robot
        self._realism = realism

    def _begin(self, rng: np.random.Generator) -> None:
        stand_still = dict.fromkeys(self._card.commands, 0.0)
        self._on_the_way = deque([stand_still] * self._realism.delay)
        self._rng = rng
        self._robot.reset(rng)

    def _move(self, command: Mapping[str, float]) -> None:
        """One control step, with the command of `delay` steps ago."""
        self._on_the_way.append(dict(command))
        arrived = self._on_the_way.popleft()
        if self._realism.wheel_slip:
            arrived = {
                name: self._slipped(name, speed) for name, speed in arrived.items()
            }
        self._robot.act(arrived)

    def _slipped(self, name: str, speed: float) -> float:
        _, low, high = self._card.commands[name]
        slip = self._rng.normal(0.0, self._realism.wheel_slip)
        return min(max(speed * (1 + slip), low), high)

    def _sense(self) -> dict[str, float]:
        readings = self._robot.readings
        if self._realism.laser_noise:
            for laser in LASERS:
                _, low, high = self._card.sensors[laser]
                noise = self._rng.normal(0.0, self._realism.laser_noise)
                readings[laser] = min(max(readings[laser] + noise, low), high)
        return readings

    def scene(self) -> Scene:
        """Where everything really is, without noise."""
        return self._robot.scene()

    def close(self) -> None:
        """End the robot's simulator, if it has one."""
        self._robot.close()
