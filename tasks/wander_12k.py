"""Wander in a maze with six lasers in finer bins: 12,500 states, 25 actions. The largest task.

Description: a mobile base drives about a 6 × 6 m maze as far as it can without bumping.
Inputs:      five lasers (front, front left, left, right, front right) in five bins each,
             cut at 0.20, 0.40, 0.60 and 0.80 m; the rear one in four, cut at 0.27, 0.53
             and 0.80 m.
Outputs:     speed of the left and the right wheel, −1, −½, 0, ½ or 1 rad/s (1 rad/s is
             about 0.1 m/s). Both backward means forward at double speed; one backward
             while the other stands still means no motion.
Rewards:     of the three front lasers, two or more below 0.05 m: −10, one: −2;
             moved more than 0.07 m: 10; else −0.02.
             A wall that the hull touches is at least 0.03 m from every laser, so −10
             does not occur, or hardly ever; V-REP's robot never got it either.
Episode end: none, the robot wanders on.
Scene:       maze_6x6, the robot starts in the middle.
Differs from the paper: the paper has no task of this size. It shows what more states
             cost: most of them are seldom seen or never.
"""

from rlrobot_edu import InputVariable, OutputVariable, Task
from rlrobot_edu.task.rewards import wander_reward
from rlrobot_edu.task.wheel_commands import no_reversing

CUTS = [0.20, 0.40, 0.60, 0.80]
REAR_CUTS = [0.27, 0.53, 0.80]


def reward(before, after):
    """Reward of one step from the readings before and after it."""
    return wander_reward(before, after, collision=0.05, moved=0.07)


task = Task(
    robot="mobile_base",
    scene="maze_6x6",
    inputs=[
        InputVariable("laser_front", cuts=CUTS, unit="m"),
        InputVariable("laser_front_left", cuts=CUTS, unit="m"),
        InputVariable("laser_left", cuts=CUTS, unit="m"),
        InputVariable("laser_right", cuts=CUTS, unit="m"),
        InputVariable("laser_front_right", cuts=CUTS, unit="m"),
        InputVariable("laser_rear", cuts=REAR_CUTS, unit="m"),
    ],
    outputs=[
        OutputVariable("left_wheel", values=[-1, -0.5, 0, 0.5, 1], unit="rad/s"),
        OutputVariable("right_wheel", values=[-1, -0.5, 0, 0.5, 1], unit="rad/s"),
    ],
    rewards=[-10, -2, -0.02, 10],
    reward=reward,
    command=no_reversing,
)
