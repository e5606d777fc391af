"""A task."""
from rlrobot_edu import InputVariable, OutputVariable, Task
import sys
nan, inf = float("nan"), float("inf")

def command(values):
    return values

def reward(before, after):
    return -0.02

def goal(readings):
    return False

task = Task(
    robot='mobile_base', scene='square_2x2', inputs=[InputVariable('laser_front', cuts=[0.2], unit='m')], outputs=[OutputVariable(w, values=[-1, 1], unit='rad/s') for w in ('left_wheel', 'right_wheel')], rewards=[-0.02, 10], reward=reward, command=command,
    step_time=1.0, episode_steps=None, goal=goal, goal_steps=1,
)

