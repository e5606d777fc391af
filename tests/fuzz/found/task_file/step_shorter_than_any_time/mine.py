"""A task."""
from rlrobot_edu import InputVariable, OutputVariable, Task
import sys
nan, inf = float("nan"), float("inf")

def command(values):
    4.0068391785516156e-237

def reward(before, after):
    raise ValueError

def goal(readings):
    4.0068391785516156e-237

task = Task(
    robot='mobile_base', scene='square_2x2', inputs=[InputVariable('laser_front', cuts=[0.2], unit='m')], outputs=[OutputVariable(w, values=[-1, 1], unit='rad/s') for w in ('left_wheel', 'right_wheel')], rewards=[-0.02, 10], reward=reward, command=None,
    step_time=4.0068391785516156e-237, episode_steps=None, goal=None, goal_steps=1,
)

