"""Follow wall: one sentence that says what the robot is to do.

Description: where the robot is and what it should do there.
Inputs:      what it perceives, in which bins, and why these.
Outputs:     what it can do, with what speed.
Rewards:     what each is given for, the largest last.
Episode end: none, or after how many steps, or at which goal.
Scene:       square_2x2; mobile_base knows square_2x2, maze_6x6, maze_4x4_goal, rl.Drawing.

This file works as it stands. Change one part, save, and ask what has become of it, in a notebook or in a terminal:
    rl.check_task("follow_wall.py")
    python -m rlrobot_edu check-task follow_wall.py
"""

# What the robot senses: each reading's name, range and unit. A joint's range is where its motor stops.
#   laser_front        0 to 5 m
#   laser_front_left   0 to 5 m
#   laser_left         0 to 5 m
#   laser_rear_left    0 to 5 m
#   laser_rear         0 to 5 m
#   laser_rear_right   0 to 5 m
#   laser_right        0 to 5 m
#   laser_front_right  0 to 5 m
#   x                  -inf to inf m
#   y                  -inf to inf m
#   theta              -3.14159 to 3.14159 rad

# What it obeys:
#   left_wheel         -2 to 2 rad/s
#   right_wheel        -2 to 2 rad/s

from math import hypot

from rlrobot_edu import InputVariable, OutputVariable, Task


def reward(before, after):
    near = min(after["laser_front"], after["laser_front_right"], after["laser_right"])
    moved = hypot(after["x"] - before["x"], after["y"] - before["y"])
    if near < 0.05:
        return -0.6
    beside = 0.10 < after["laser_right"] <= 0.40
    return 10 if beside and moved > 0.07 else -0.4


task = Task(
    robot="mobile_base",
    scene="square_2x2",
    # A state is one bin of each input. cuts=[0.2, 0.5] makes three bins: up to 0.2 m, up to 0.5 m, beyond.
    # Each input multiplies the number of states, so begin with few.
    inputs=[
        InputVariable("laser_front_left", cuts=[0.20], unit="m"),
        InputVariable("laser_front_right", cuts=[0.20], unit="m"),
    ],
    # An action is one value of each output.
    outputs=[
        OutputVariable("left_wheel", values=[0, 1], unit="rad/s"),
        OutputVariable("right_wheel", values=[0, 1], unit="rad/s"),
    ],
    reward=reward,
    rewards=[-0.6, -0.4, 10],
    step_time=1.0,  # seconds from one decision to the next
    # episode_steps=100,  # an episode is cut off after so many steps; without this line it goes on for ever
    # goal=lambda readings: hypot(readings["x"], readings["y"]) < 0.3,  # and where it ends for good
)
