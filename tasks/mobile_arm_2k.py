"""Drive to a table and reach the object on it: an arm on a mobile base, 2048 states, 36 actions.

Description: a mobile base with an arm on its back crosses a room to a table, and moves the
             gripper to an object that stands there.
Inputs:      of the base, x (cuts at −0.20, 0.30 and 0.65 m), y (cuts at −0.25, 0 and 0.25 m)
             and theta in eight sectors; of the arm, the joints arm (cuts at −0.35, 0 and
             0.35 rad) and forearm (cuts at 0.16, 0.33 and 0.50 rad).
Outputs:     speed of the left and the right wheel, −1 or 1 rad/s (about 0.1 m/s), both
             backward means stop; of the joint arm, −0.30, 0 or 0.30 rad/s, and of forearm,
             −0.16, 0 or 0.16 rad/s.
Rewards:     gripper within 0.20 m of the object: 10; further away than before by more than
             0.02 m: −5; nearer by more than 0.02 m: 5; else −0.02. To and fro in equal steps earns
             nothing: with the arm tasks' −1 for away, the agent did little else.
Episode end: cut off after 120 steps.
Scene:       table_room, 3 × 3 m, the table at the right-hand wall; the robot starts about
             1 m before the object, to its right.
Differs from the paper: the paper has both robots on one body, but no task that needs both.
"""

from rlrobot_edu import InputVariable, OutputVariable, Task
from rlrobot_edu.task.rewards import gripper_to_object


def command(speeds):
    """Both wheels backward means stop; the biceps stands still."""
    if speeds["left_wheel"] < 0 and speeds["right_wheel"] < 0:
        speeds = {**speeds, "left_wheel": 0.0, "right_wheel": 0.0}
    return {**speeds, "biceps": 0.0}


def reward(before, after):
    """Reward of one step from the readings before and after it."""
    distance = gripper_to_object(after)
    if distance <= 0.20:
        return 10.0
    gained = gripper_to_object(before) - distance
    return 5.0 if gained > 0.02 else -5.0 if gained < -0.02 else -0.02


task = Task(
    robot="mobile_manipulator",
    scene="table_room",
    inputs=[
        InputVariable("x", cuts=[-0.20, 0.30, 0.65], unit="m"),
        InputVariable("y", cuts=[-0.25, 0.0, 0.25], unit="m"),
        InputVariable("theta", sectors=8, unit="rad"),
        InputVariable("arm", cuts=[-0.35, 0.0, 0.35], unit="rad"),
        InputVariable("forearm", cuts=[0.16, 0.33, 0.50], unit="rad"),
    ],
    outputs=[
        OutputVariable("left_wheel", values=[-1, 1], unit="rad/s"),
        OutputVariable("right_wheel", values=[-1, 1], unit="rad/s"),
        OutputVariable("arm", values=[-0.30, 0, 0.30], unit="rad/s"),
        OutputVariable("forearm", values=[-0.16, 0, 0.16], unit="rad/s"),
    ],
    rewards=[-5, -0.02, 5, 10],
    reward=reward,
    command=command,
    episode_steps=120,
)
