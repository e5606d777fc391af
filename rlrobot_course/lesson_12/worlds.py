"""Worlds in which the shape of the reward decides: a corridor, and the robot with another reward."""

from collections.abc import Callable

from rlrobot_course.worlds.own_reward import OwnReward as OwnReward
from rlrobot_course.worlds.tapes import with_action
from rlrobot_edu import InputVariable, OutputVariable, Task
from rlrobot_edu.robots.scene import Scene, Solid, pose

CorridorReward = Callable[[int, int, bool], float]

AWAY, NEARER = 0, 1  # actions in the corridor
LANE_START, LANE_CELLS, STEP = (
    -1.5,
    7,
    0.195,
)  # where the robot in its lane begins, cells, way of a step [m]
LANE_GOAL = LANE_START + STEP * (LANE_CELLS - 1.5)  # x from which on it has arrived [m]


class Corridor:
    """Cells in a row, with the goal beyond the last one, where an episode terminates.

    reward: of a step, from the cell before it, the cell after it, and whether that is the goal
    n_cells: how many; cell number n_cells is the goal
    reset() -> state, the first cell; step(action) -> state, reward, terminated, truncated. At its far end it is closed.
    """

    def __init__(self, reward: CorridorReward, n_cells: int = 6) -> None:
        self.reward, self.n_cells = reward, n_cells
        self.s, self.goals = 0, 0

    def reset(self) -> int:
        """Start an episode in the first cell."""
        self.s = 0
        return self.s

    @with_action
    def step(self, a: int) -> tuple[int, float, bool, bool]:
        """Go a cell nearer to the goal, or away from it."""
        s, self.s = self.s, max(0, self.s + (1 if a == NEARER else -1))
        terminated = self.s == self.n_cells
        self.goals += terminated
        return self.s, self.reward(s, self.s, terminated), terminated, False


def lane() -> Task:
    """The corridor with the robot in it: it drives straight on or straight back along the lower wall of the arena.

    Its state is where it is along x, in cells as long as a step; the last one is the goal and ends the episode.
    """
    return Task(
        robot="mobile_base",
        scene="maze_4x4_goal",
        inputs=[
            InputVariable(
                "x",
                cuts=[LANE_START + STEP * (i - 0.5) for i in range(LANE_CELLS)],
                unit="m",
            )
        ],
        outputs=[
            OutputVariable(
                "drive", values=[-2, 2], unit="rad/s", words=["back", "forward"]
            )
        ],
        rewards=[-0.1, 10],
        reward=lambda before, after: 10.0 if after["x"] > LANE_GOAL else -0.1,
        command=lambda told: {
            "left_wheel": told["drive"],
            "right_wheel": told["drive"],
        },
        episode_steps=400,
        goal=lambda readings: readings["x"] > LANE_GOAL,
        name="lane",
    )


def lane_scene(scene: Scene) -> Scene:
    """A scene of the lane with its own goal in it, where the arena's is drawn otherwise."""
    x, y = LANE_GOAL, scene.bounds[1]
    goal = Solid("goal", "box", (0.3, 1.0, 0.01), pose(x + 0.4, y + 0.5, 0.005), "goal")
    return scene._replace(
        solids=(*(solid for solid in scene.solids if solid.role != "goal"), goal)
    )
