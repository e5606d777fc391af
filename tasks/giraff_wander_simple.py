"""Giraff wanders in a small hexagon, the smallest way: four states and four actions.

Description: a Giraff robot drives about a hexagon of 1.5 × 1 m without coming too near to
             its walls.
Inputs:      two lasers, 45° to the left and to the right of the front; each near (up to
             0.25 m) or far.
Outputs:     speed of the left and the right wheel, −0.5 or 0.5 rad/s (about 0.04 m/s);
             both backward means stop.
Rewards:     both lasers below 0.15 m: −10; one of them below 0.15 m: −2;
             moved more than 0.03 m: 10; else −0.02.
Episode end: none, the robot wanders on.
Scene:       hexagon_giraff, the robot starts in the middle. Its safety stop holds it back
             from driving forward when a front laser sees something nearer than 0.18 m.
Differs from the paper: the paper drove the real robot, on wander_1k alone. One limit for
             both penalties, where wander_simple has two: twice 0.15 m would be further
             than this robot looks.
"""

from rlrobot_edu import InputVariable, OutputVariable, Task
from rlrobot_edu.task.rewards import distance_moved


def command(wheels):
    """Both wheels backward means stop: the robot has no eyes in its back."""
    if wheels["left_wheel"] < 0 and wheels["right_wheel"] < 0:
        return {"left_wheel": 0.0, "right_wheel": 0.0}
    return wheels


def reward(before, after):
    """Reward of one step from the readings before and after it."""
    left, right = after["laser_front_left"], after["laser_front_right"]
    if left < 0.15 and right < 0.15:
        return -10.0
    if left < 0.15 or right < 0.15:
        return -2.0
    return 10.0 if distance_moved(before, after) > 0.03 else -0.02


task = Task(
    robot="giraff",
    scene="hexagon_giraff",
    inputs=[
        InputVariable("laser_front_left", cuts=[0.25], unit="m"),
        InputVariable("laser_front_right", cuts=[0.25], unit="m"),
    ],
    outputs=[
        OutputVariable("left_wheel", values=[-0.5, 0.5], unit="rad/s"),
        OutputVariable("right_wheel", values=[-0.5, 0.5], unit="rad/s"),
    ],
    rewards=[-10, -2, -0.02, 10],
    reward=reward,
    command=command,
)
