"""Drive to a place and stay there: position, heading and three lasers, 1024 states, 9 actions.

Description: a mobile base finds its way from one corner of a 4 × 4 m room, around three
             walls, to the goal in the opposite corner.
Inputs:      x and y in four bins each, cut at −1, 0 and 1 m; heading theta in eight equal
             sectors; three lasers (front, front left, front right), each near (up to
             0.20 m) or far.
Outputs:     speed of the left and the right wheel, −1, 0 or 1 rad/s (about 0.1 m/s).
             Both backward means forward at double speed; one backward while the other
             stands still means no motion.
Rewards:     within 0.5 m of the goal: 10; else, of the three front lasers, two or more
             below 0.08 m: −10, one: −2; else, away from the goal by more than 0.07 m: −1;
             nearer by more than 0.07 m: 2, 3, 4 or 5, most beside the goal; else −0.1. The
             reward for nearer is min(5, round(1 + 4 / distance)).
Episode end: terminated at the sixth step in a row within 0.5 m of the goal; cut off after
             3600 steps (one hour).
Scene:       maze_4x4_goal, the robot starts in the corner (−1.5, −1.475), heading along x;
             the goal is at (1.65, 1.575).
Differs from the paper: all bins of x, y and theta can be reached; those of the paper's
             program reached only part of the room.
"""

from rlrobot_edu import InputVariable, OutputVariable, Task
from rlrobot_edu.task.rewards import approach_reward, collision_reward, length
from rlrobot_edu.task.wheel_commands import no_reversing

GOAL_X, GOAL_Y, GOAL_RADIUS = 1.65, 1.575, 0.5  # as the scene draws it [m]


def distance(readings):
    """From the robot to the goal [m]."""
    return length(readings["x"] - GOAL_X, readings["y"] - GOAL_Y)


def at_goal(readings):
    """Whether the robot is where it should be."""
    return distance(readings) < GOAL_RADIUS


def reward(before, after):
    """Reward of one step from the readings before and after it."""
    if at_goal(after):
        return 10.0
    return collision_reward(after, nearer_than=0.08) or approach_reward(
        distance(before), distance(after), gained=0.07, idle=-0.1
    )


task = Task(
    robot="mobile_base",
    scene="maze_4x4_goal",
    inputs=[
        InputVariable("x", cuts=[-1, 0, 1], unit="m"),
        InputVariable("y", cuts=[-1, 0, 1], unit="m"),
        InputVariable("theta", sectors=8, unit="rad"),
        InputVariable("laser_front", cuts=[0.20], unit="m"),
        InputVariable("laser_front_left", cuts=[0.20], unit="m"),
        InputVariable("laser_front_right", cuts=[0.20], unit="m"),
    ],
    outputs=[
        OutputVariable("left_wheel", values=[-1, 0, 1], unit="rad/s"),
        OutputVariable("right_wheel", values=[-1, 0, 1], unit="rad/s"),
    ],
    rewards=[-10, -2, -1, -0.1, 2, 3, 4, 5, 10],
    reward=reward,
    command=no_reversing,
    episode_steps=3600,
    goal=at_goal,
    goal_steps=6,
)
