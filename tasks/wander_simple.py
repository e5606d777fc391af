"""Wander in a small square: the smallest task, four states and four actions.

Description: a mobile base drives about a 2 × 2 m arena and must not bump into its walls.
Inputs:      two lasers, 45° to the left and to the right of the front; each near (up to
             0.20 m) or far.
Outputs:     speed of the left and the right wheel, −1 or 1 rad/s (about 0.1 m/s); both
             backward means stop.
Rewards:     both lasers below 0.05 m: −10; one of them below 0.10 m: −2;
             moved more than 0.07 m: 10; else −0.02.
             −10 does not occur: the lasers stand inside the hull, and where it touches walls
             one of the two reads 0.05 m or more.
Episode end: none, the robot wanders on.
Scene:       square_2x2, the robot starts in the middle.
Differs from the paper: the paper does not print the limits; these are our choice.
"""

from rlrobot_edu import InputVariable, OutputVariable, Task
from rlrobot_edu.task.rewards import length


def command(wheels):
    """Both wheels backward means stop: the robot has no eyes in its back."""
    if wheels["left_wheel"] < 0 and wheels["right_wheel"] < 0:
        return {"left_wheel": 0.0, "right_wheel": 0.0}
    return wheels


def reward(before, after):
    """Reward of one step from the readings before and after it."""
    left, right = after["laser_front_left"], after["laser_front_right"]
    if left < 0.05 and right < 0.05:
        return -10.0
    if left < 0.10 or right < 0.10:
        return -2.0
    moved = length(after["x"] - before["x"], after["y"] - before["y"])
    return 10.0 if moved > 0.07 else -0.02


task = Task(
    robot="mobile_base",
    scene="square_2x2",
    inputs=[
        InputVariable("laser_front_left", cuts=[0.20], unit="m"),
        InputVariable("laser_front_right", cuts=[0.20], unit="m"),
    ],
    outputs=[
        OutputVariable("left_wheel", values=[-1, 1], unit="rad/s"),
        OutputVariable("right_wheel", values=[-1, 1], unit="rad/s"),
    ],
    rewards=[-10, -2, -0.02, 10],
    reward=reward,
    command=command,
)
