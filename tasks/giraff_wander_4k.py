"""Giraff wanders in a small hexagon with six lasers and finer wheels: 4096 states, 25 actions.

Description: a Giraff robot drives about a hexagon of 1.5 × 1 m without coming too near to
             its walls.
Inputs:      six lasers (front, front left, left, right, front right, rear) in four bins
             each, cut at 0.08, 0.17 and 0.25 m: thirds of 0.25 m, as wander_4k has thirds
             of 0.80 m. The lowest bins stay empty, but for the rear: the safety stop
             holds the robot back before another laser reads 0.08 m or less.
Outputs:     speed of the left and the right wheel, −0.5, −0.25, 0, 0.25 or 0.5 rad/s
             (0.5 rad/s is about 0.04 m/s). Both backward means forward at double speed;
             one backward while the other stands still means no motion.
Rewards:     of the three front lasers, two or more below 0.15 m: −10, one: −2;
             moved more than 0.03 m: 10; else −0.02.
Episode end: none, the robot wanders on.
Scene:       hexagon_giraff, the robot starts in the middle. Its safety stop holds it back
             from driving forward when a front laser sees something nearer than 0.18 m.
Differs from the paper: the paper drove the real robot, on wander_1k alone; ours is
             simulated, a disc of 0.23 m radius.
"""

from rlrobot_edu import InputVariable, OutputVariable, Task
from rlrobot_edu.task.rewards import wander_reward
from rlrobot_edu.task.wheel_commands import no_reversing

CUTS = [0.08, 0.17, 0.25]


def reward(before, after):
    """Reward of one step from the readings before and after it."""
    return wander_reward(before, after, collision=0.15, moved=0.03)


task = Task(
    robot="giraff",
    scene="hexagon_giraff",
    inputs=[
        InputVariable("laser_front", cuts=CUTS, unit="m"),
        InputVariable("laser_front_left", cuts=CUTS, unit="m"),
        InputVariable("laser_left", cuts=CUTS, unit="m"),
        InputVariable("laser_right", cuts=CUTS, unit="m"),
        InputVariable("laser_front_right", cuts=CUTS, unit="m"),
        InputVariable("laser_rear", cuts=CUTS, unit="m"),
    ],
    outputs=[
        OutputVariable("left_wheel", values=[-0.5, -0.25, 0, 0.25, 0.5], unit="rad/s"),
        OutputVariable("right_wheel", values=[-0.5, -0.25, 0, 0.25, 0.5], unit="rad/s"),
    ],
    rewards=[-10, -2, -0.02, 10],
    reward=reward,
    command=no_reversing,
)
