"""A robot of geometry alone as kernels, and its world for the compiled loop of learning."""

import math
from abc import abstractmethod
from collections import namedtuple
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from typing import Any

import numpy as np

from rlrobot_edu.jit.dispatcher import IS_PLAIN, compiled
from rlrobot_edu.learning.compiled_loop import NEVER
from rlrobot_edu.robots.engines.kinematic.compiled_task import INPUT, judge_of, state_of
from rlrobot_edu.robots.robot import SimulatedRobot
from rlrobot_edu.task.task import Task

# What the loop is given.
# parts, start: the robot's; place: array, where it was before the step
# commands: array (actions, n), see `command_array`
# numbers: array (2, n), readings before and after a step; records: the same memory, in which readings have names
# inputs: array (n_inputs,) of INPUT; cuts: array (n_inputs, n), the cuts of each, then infinity
# judge: (record before, record after) -> reward, NaN where the task's functions fail, and whether it is at the goal
# at_goal: array (1,), steps at the goal without a break; rewards, goal_steps, episode_steps: the task's
World = namedtuple(
    "World",
    "parts start place commands numbers records inputs cuts judge at_goal rewards goal_steps episode_steps",
)


class KinematicRobot(SimulatedRobot):
    """A robot that kernels move and that they let sense.

    kernels: move (parts, command as `command_array` makes it), for one control step; and sense (parts, readings), which
        fills in what is on the card, array (n,). Whoever inherits has its own, or is not compiled into the loop
    parts: its arrays and numbers; ``parts.place`` alone says where it is
    """

    kernels: tuple[Callable[..., None], Callable[..., None]]
    parts: Any

    @abstractmethod
    def start(self) -> np.ndarray | None:
        """The place at which each episode begins, from now on; None if they differ, or are not known yet."""

    @abstractmethod
    def command_array(self, command: Mapping[str, float]) -> np.ndarray:
        """A command as the kernels know it, array (n,)."""

    def _move(self, command: Mapping[str, float]) -> None:
        self.kernels[0](self.parts, self.command_array(command))

    def _sense(self) -> dict[str, float]:
        readings = np.empty(len(self._card.sensors))
        self.kernels[1](self.parts, readings)
        return dict(zip(self._card.sensors, readings.tolist(), strict=True))


def world_of(
    task: Task, robot: Any, commands: Sequence[Mapping[str, float]], at_goal: int
) -> World | None:
    """What the compiled loop is given of a task and its robot, as it stands there; None where there is no such loop."""
    start = robot.start() if "kernels" in vars(type(robot)) else None
    if IS_PLAIN or start is None or any(v.values is not None for v in task.inputs):
        return None
    names = tuple(robot.readings)
    judge = judge_of(task, names)
    if judge is None:
        return None
    numbers = np.array([[*robot.readings.values()]] * 2)
    records = numbers.view([(name, float) for name in names])[:, 0]
    width = max(v.n_bins for v in task.inputs)
    cuts = [
        [*(v.cuts or ()), *[math.inf] * (width - len(v.cuts or ()))]
        for v in task.inputs
    ]
    inputs = [
        (names.index(v.name), v.low, v.high, v.sectors or 0, v.n_bins)
        for v in task.inputs
    ]
    told = [robot.command_array(command) for command in commands]
    return World(
        parts=robot.parts, start=start, place=start.copy(), commands=np.array(told),
        numbers=numbers, records=records, inputs=np.array(inputs, INPUT), cuts=np.array(cuts), judge=judge,
        at_goal=np.array([at_goal]), rewards=np.array(task.rewards), goal_steps=task.goal_steps,
        episode_steps=task.episode_steps or NEVER,
    )  # fmt: skip


@cache
def kernels_of(move: Callable[..., Any], sense: Callable[..., Any]) -> tuple[Any, Any]:
    """What `make_run` asks for, begin and outcome, of a robot with these kernels."""

    @compiled
    def begin(world, rng):
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

    return begin, outcome
