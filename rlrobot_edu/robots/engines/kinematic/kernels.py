"""A robot of geometry and its task as a world of kernels. A template, with a robot that stands still.

In each kernel `world` is what robot.py describes.
"""

from rlrobot_edu.jit.dispatcher import compiled
from rlrobot_edu.robots.engines.kinematic.compiled_task import state_of


@compiled
def move(parts, command):
    """The part of a robot: drive or move as `command` says, array (n,), for one control step."""


@compiled
def sense(parts, readings):
    """The part of a robot: fill in its readings, array (n,)."""


@compiled
def begin(world, rng):
    """Put the robot at its start; the state there."""
    world.parts.place[:] = world.start
    sense(world.parts, world.numbers[0])
    world.at_goal[0] = 0
    return state_of(world.inputs, world.cuts, world.numbers[0])


@compiled
def outcome(world, s, a, rng):
    """What happens after (s, a): (s', r, terminated). Where the task fails, nothing has moved, and s' is −1.

    Then the plain loop takes this step, and says what is wrong.
    """
    before, after = world.numbers[0], world.numbers[1]
    world.place[:] = world.parts.place
    move(world.parts, world.commands[a])
    sense(world.parts, after)
    s_next = state_of(world.inputs, world.cuts, after)
    r, is_there = world.judge(world.records[0], world.records[1])
    if s_next < 0 or r not in world.rewards:
        world.parts.place[:] = world.place
        return -1, r, False
    before[:] = after
    world.at_goal[0] = world.at_goal[0] + 1 if is_there else 0
    return s_next, r, world.at_goal[0] >= world.goal_steps
