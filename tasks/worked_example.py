"""The paper's worked example: a robot in four cells, 24 states, 3 actions. Small enough to see every number.

Description: a robot moves about 2 × 2 cells; a box stands in one of them and moves to
             another now and then.
Inputs:      cell X and cell Y, 0 or 1; heading theta, 0, 90 or −90 degrees; d, 1 if a
             wall or the box is ahead.
Outputs:     move: 0 advance, 1 spin left, 2 spin right. A spin beyond ±90 degrees
             changes nothing.
Rewards:     advanced to another cell: 10; bumped into a wall or the box: −2; else (it
             turned): −0.02.
Episode end: after 30 steps, because the robot cannot turn round: no heading leads it
             back to X = 0.
Scene:       four_cells, the robot starts in cell (0, 0) with heading 0, the box in (1, 1).
Differs from the paper: the paper gives the inputs and outputs alone; the box and the
             rewards are ours.
"""

from rlrobot_edu import InputVariable, OutputVariable, Task

ADVANCE, SPIN_LEFT, SPIN_RIGHT = 0, 1, 2


def command(values):
    """The robot's command for a move."""
    return {
        ADVANCE: {"advance": 1, "spin": 0},
        SPIN_LEFT: {"advance": 0, "spin": 90},
        SPIN_RIGHT: {"advance": 0, "spin": -90},
    }[values["move"]]


def reward(before, after):
    """Reward of one step from the readings before and after it."""
    if after["bumped"]:
        return -2.0
    advanced = (after["X"], after["Y"]) != (before["X"], before["Y"])
    return 10.0 if advanced else -0.02


task = Task(
    robot="cell_robot",
    scene="four_cells",
    inputs=[
        InputVariable("X", values=[0, 1]),
        InputVariable("Y", values=[0, 1]),
        InputVariable("theta", values=[0, 90, -90], unit="deg"),
        InputVariable("d", values=[0, 1]),
    ],
    outputs=[
        OutputVariable(
            "move",
            values=[ADVANCE, SPIN_LEFT, SPIN_RIGHT],
            words=["advance", "spin left", "spin right"],
        )
    ],
    rewards=[-2, -0.02, 10],
    reward=reward,
    command=command,
    episode_steps=30,
)
