"""A task with a target that moves: the robot is to keep its distance from a spot of light that walks on a circle.

Description: a mobile base in the 2 × 2 m room. A lamp throws a spot of light on the floor, which walks round the middle
             on a circle. It is no body: no laser sees it, and the robot may drive over it.
Inputs:      distance from the robot to the spot in five bins, and bearing, the direction in which the robot sees it, in
             eight sectors (0 is straight ahead, they count to the left). Both come from a camera under the ceiling.
Outputs:     speed of the left and the right wheel, 0 or 1 rad/s (0 or about 0.1 m/s).
Rewards:     distance between 0.3 and 0.6 m: 10; else −0.3.
Episode end: none.

The readings of a robot stand on its card, and no robot of the library sees a spot. So this is no task file but a
Gymnasium environment: the same parts, inputs, outputs and a reward of the readings before and after the step, and
`reset` and `step`, which a task file need not write. Agents and films take it like any other.
"""

import math
from typing import Any

import gymnasium
import numpy as np

from rlrobot_edu.robots.mobile_base import MobileBase
from rlrobot_edu.robots.scene import Scene, Solid, pose
from rlrobot_edu.task.spaces import ActionSpace, StateSpace
from rlrobot_edu.task.variables import InputVariable, OutputVariable

NEAR, FAR = 0.3, 0.6  # between these the distance is right [m]
SPOT = 0.08  # radius of the spot [m]

INPUTS = StateSpace(
    [
        InputVariable("distance", cuts=[NEAR, 0.45, FAR, 1.0], unit="m"),
        InputVariable("bearing", sectors=8, unit="rad"),
    ]
)
OUTPUTS = ActionSpace([OutputVariable(f"{side}_wheel", values=[0, 1], unit="rad/s") for side in ("left", "right")])


def reward(before: dict[str, float], after: dict[str, float]) -> float:
    """Reward of one step, from the readings before and after it."""
    return 10.0 if NEAR < after["distance"] <= FAR else -0.3


class RobotAndSpot(MobileBase):
    """The mobile base, and a spot of light that goes round the middle of its room.

    radius: of the spot's circle [m]; lap: time that it takes for one round [s]
    """

    def __init__(self, radius: float, lap: float) -> None:
        self.radius, self.lap, self.seconds = radius, lap, 0
        super().__init__("square_2x2", step_time=1.0)

    def _begin(self, rng: np.random.Generator) -> None:
        super()._begin(rng)
        self.seconds = 0

    def _move(self, command: Any) -> None:
        super()._move(command)
        self.seconds += 1

    @property
    def spot(self) -> tuple[float, float]:
        """Where the spot is now [m]."""
        angle = 2 * math.pi * self.seconds / self.lap
        return self.radius * math.cos(angle), self.radius * math.sin(angle)

    def _sense(self) -> dict[str, float]:
        own = super()._sense()
        x, y = self.spot
        dx, dy = x - own["x"], y - own["y"]
        bearing = math.remainder(math.atan2(dy, dx) - own["theta"], 2 * math.pi)
        return own | {"distance": math.hypot(dx, dy), "bearing": bearing}

    def scene(self) -> Scene:
        """The room, the robot, its laser beams, and the spot."""
        scene = super().scene()
        spot = Solid("spot", "cylinder", (SPOT, 0.01), pose(*self.spot, 0.005), "object")
        return scene._replace(solids=(*scene.solids, spot))


class MovingTarget(gymnasium.Env[np.ndarray, int]):
    """The robot and the spot as a Gymnasium environment; see the top of this file.

    radius: of the spot's circle [m]; lap: time that it takes for one round [s]
    """

    r_max, episode_steps = 10.0, None  # what an agent asks for beside the two spaces

    def __init__(self, radius: float = 0.8, lap: float = 100.0) -> None:
        self.robot = RobotAndSpot(radius, lap)
        self.observation_space = gymnasium.spaces.MultiDiscrete(list(INPUTS.shape))
        self.action_space = gymnasium.spaces.Discrete(OUTPUTS.n)

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[np.ndarray, dict[str, Any]]:
        """Put robot and spot at their starts: the robot in the middle of the room, the spot at the right of it."""
        super().reset(seed=seed)
        readings = self.robot.reset(self.np_random)
        return observed(readings), {"readings": readings}

    def step(self, action: int) -> tuple[np.ndarray, float, bool, bool, dict[str, Any]]:
        """Let the robot act for one second, in which the spot walks on."""
        before = self.robot.readings
        after = self.robot.act(OUTPUTS.decode(action))
        return observed(after), reward(before, after), False, False, {"readings": after}


def observed(readings: dict[str, float]) -> np.ndarray:
    """The bin of each input, array (2,)."""
    return np.array(INPUTS.bins(INPUTS.encode(readings)))
