"""A base on two wheels, whichever engine moves it: its dimensions, where it is, and how both look."""

from rlrobot_edu.robots.arenas import Place, arena_of
from rlrobot_edu.robots.chassis import PIONEER, Chassis, laser_beams
from rlrobot_edu.robots.robot import SimulatedRobot
from rlrobot_edu.robots.scene import ON_ITS_SIDE, Scene, Solid, pose
from rlrobot_edu.task.robot_cards import LASERS, ROBOTS

TYRE_WIDTH = 0.04  # [m]
TOUCH = 0.05  # a laser that finds something nearer says that the hull touches it, as in the paper's rewards [m]


class WheeledBase(SimulatedRobot):
    """A body on two wheels with eight lasers, in an arena.

    A subclass says how it begins, moves and senses, and calls `reset` at the end of its own ``__init__``.

    scene: name of an arena, or a room
    step_time: duration of one control step [s]
    chassis: the robot's dimensions; by default those of its class
    arena: where the robot is; another one counts from the next `reset` on
    """

    name = "mobile_base"
    chassis = PIONEER

    def __init__(
        self, scene: Place, step_time: float, chassis: Chassis | None = None
    ) -> None:
        super().__init__(ROBOTS[self.name])
        if chassis is not None:
            self.chassis = chassis
        self.arena = arena_of(scene)
        self._step_time = step_time

    def solids(self) -> tuple[Solid, ...]:
        """The robot's parts, with their poses on the robot."""
        shape, size = self.chassis.body()
        nose_at = pose(self.chassis.radius - 0.075, 0, 0.26)
        half = self.chassis.wheel_separation / 2
        return (
            Solid("robot/body", shape, size, pose(0, 0, 0.16), "robot"),
            Solid("robot/nose", "box", (0.14, 0.06, 0.04), nose_at, "robot"),
            self._wheel("robot/left_wheel", half),
            self._wheel("robot/right_wheel", -half),
        )

    def _wheel(self, name: str, y: float) -> Solid:
        radius = self.chassis.wheel_radius
        place = pose(self.chassis.axle, y, radius) @ ON_ITS_SIDE
        return Solid(name, "cylinder", (radius, TYRE_WIDTH), place, "wheel")

    def scene(self) -> Scene:
        """The arena, the robot and its laser beams at this instant."""
        readings = self._readings
        here = pose(readings["x"], readings["y"], 0.0, readings["theta"])
        robot = [solid._replace(pose=here @ solid.pose) for solid in self.solids()]
        beams = laser_beams(readings, self.chassis)
        solids = (*self.arena.solids(), *robot)
        bumped = any(readings[laser] < TOUCH for laser in LASERS)
        return Scene(solids, beams, self.arena.bounds, bumped)
