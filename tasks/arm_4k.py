"""Reach an object on a table with all three joints of an arm: 4096 states, 27 actions.

Description: an arm at the edge of a table moves its gripper to an object that stands there.
Inputs:      gripper_x in four bins of 3 cm (cuts at 0.23, 0.26 and 0.29 m) and gripper_y in
             eight of 4 cm (cuts from −0.12 to 0.12 m), which cover a field of 12 × 32 cm
             before the arm; object_x and object_y in the same bins. The object keeps its
             place, and so its bins.
             gripper_z in four bins of 5 cm (cuts at 0.05, 0.10 and 0.15 m above the table).
Outputs:     speed of the joints arm (turns everything to the left), −0.14, 0 or 0.14 rad/s,
             biceps (leans forward), −0.125, 0 or 0.125 rad/s, and forearm (bends the elbow),
             −0.13, 0 or 0.13 rad/s. A step of one joint moves the gripper by about one bin.
Rewards:     gripper within 0.05 m of the object: 10; further away than before by more than
             0.02 m: −1; nearer by more than 0.02 m: 5; else −0.02. The 5 is the paper's
             min(5, round(1 + 4 / distance)), the same everywhere on this table.
Episode end: cut off after 120 steps.
Scene:       table, the gripper begins at the right-hand side, the object stands at the left.
Differs from the paper: the arm is our own drawing of the WidowX, and slower. In the authors' scene
             the joints turn at 1 rad/s within a narrow range (arm ±0.419, biceps 1.222 to 1.571,
             forearm −1.396 to −0.698 rad): one action goes from end to end, and the object,
             0.284 m from the start, is reached in one or two of them. Rewards, the 2 cm, the
             5 cm and the 120 steps are theirs; their bins are about 10, 5.7 and 6.7 cm.
"""

from rlrobot_edu import InputVariable, OutputVariable, Task
from rlrobot_edu.task.rewards import approach_reward, gripper_to_object

X_CUTS = [0.23, 0.26, 0.29]
Y_CUTS = [-0.12, -0.08, -0.04, 0.0, 0.04, 0.08, 0.12]
Z_CUTS = [0.05, 0.10, 0.15]


def reward(before, after):
    """Reward of one step from the readings before and after it."""
    distance = gripper_to_object(after)
    if distance <= 0.05:
        return 10.0
    return approach_reward(gripper_to_object(before), distance, gained=0.02, idle=-0.02)


task = Task(
    robot="arm",
    scene="table",
    inputs=[
        InputVariable("gripper_x", cuts=X_CUTS, unit="m"),
        InputVariable("gripper_y", cuts=Y_CUTS, unit="m"),
        InputVariable("object_x", cuts=X_CUTS, unit="m"),
        InputVariable("object_y", cuts=Y_CUTS, unit="m"),
        InputVariable("gripper_z", cuts=Z_CUTS, unit="m"),
    ],
    outputs=[
        OutputVariable("arm", values=[-0.14, 0, 0.14], unit="rad/s"),
        OutputVariable("biceps", values=[-0.125, 0, 0.125], unit="rad/s"),
        OutputVariable("forearm", values=[-0.13, 0, 0.13], unit="rad/s"),
    ],
    rewards=[-1, -0.02, 5, 10],
    reward=reward,
    episode_steps=120,
)
