"""A robot of geometry alone and its task as kernels, for the compiled loop of learning.

A task's reward and goal are compiled as they are. They are tried first, on a walk at random: only if they say there
what Python says does the loop use them. A reward is one of few numbers, so the last bit of a `hypot` is of no account.
"""

import math
import sys
from abc import abstractmethod
from collections import namedtuple
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from functools import cache
from types import FunctionType
from typing import Any

import numpy as np

from rlrobot_edu.learning.compiled_loop import NEVER
from rlrobot_edu.learning.fingerprint import code_of
from rlrobot_edu.learning.jit import IS_PLAIN, compiled, numba
from rlrobot_edu.robots.robot import SimulatedRobot
from rlrobot_edu.task.task import Task

INPUT = np.dtype([("sensor", int), ("low", float), ("high", float), ("sectors", int), ("bins", int)])
TRIED = 300  # steps of the walk at random

# What the loop is given.
# parts, start: the robot's; place: array, where it was before the step; commands: array (actions, n), see `in_numbers`
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

    kernels: move (parts, command as `in_numbers` makes it), for one control step; and sense (parts, readings), which
        fills in what is on the card, array (n,). Whoever inherits has its own, or is not compiled into the loop
    parts: its arrays and numbers; ``parts.place`` alone says where it is
    """

    kernels: tuple[Callable[..., None], Callable[..., None]]
    parts: Any

    @abstractmethod
    def start(self) -> np.ndarray | None:
        """The place at which each episode begins, from now on; None if they differ, or are not known yet."""

    @abstractmethod
    def in_numbers(self, command: Mapping[str, float]) -> np.ndarray:
        """A command as the kernels know it, array (n,)."""

    def _move(self, command: Mapping[str, float]) -> None:
        self.kernels[0](self.parts, self.in_numbers(command))

    def _sense(self) -> dict[str, float]:
        readings = np.empty(len(self._card.sensors))
        self.kernels[1](self.parts, readings)
        return dict(zip(self._card.sensors, readings.tolist(), strict=True))


def world_of(task: Task, robot: Any, commands: Sequence[Mapping[str, float]], at_goal: int) -> World | None:
    """What the compiled loop is given of a task and its robot, as it stands there; None where there is no such loop."""
    start = robot.start() if "kernels" in vars(type(robot)) else None
    if IS_PLAIN or start is None or any(v.values is not None for v in task.inputs):
        return None
    names, judge = tuple(robot.readings), judge_of(task, robot, commands)
    if judge is None:
        return None
    numbers = np.array([[*robot.readings.values()]] * 2)
    width = max(v.n_bins for v in task.inputs)
    cuts = [[*(v.cuts or ()), *[math.inf] * (width - len(v.cuts or ()))] for v in task.inputs]
    inputs = [(names.index(v.name), v.low, v.high, v.sectors or 0, v.n_bins) for v in task.inputs]
    return World(
        robot.parts, start, start.copy(), np.array([*map(robot.in_numbers, commands)]),
        numbers, numbers.view([(name, float) for name in names])[:, 0], np.array(inputs, INPUT), np.array(cuts),
        judge, np.array([at_goal]), np.array(task.rewards), task.goal_steps, task.episode_steps or NEVER,
    )  # fmt: skip


@compiled
def state_of(inputs, cuts, readings):
    """Number of the state that shows in `readings`, array (n,), as `StateSpace.encode`; −1 if one is out of range."""
    s = 0
    for i in range(inputs.shape[0]):
        one, reading, bin = inputs[i], readings[inputs[i].sensor], 0
        if not (one.low <= reading <= one.high and abs(reading) < math.inf):
            return -1
        if one.sectors > 0:
            bin = math.ceil(reading * one.sectors / (2 * math.pi) - 0.5) % one.sectors
        while cuts[i, bin] < reading and one.sectors == 0:
            bin += 1
        s = s * one.bins + bin
    return s


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


_judges: dict[Any, Any] = {}  # by the code of a task's reward and goal


def judge_of(task: Task, robot: KinematicRobot, commands: Sequence[Mapping[str, float]]) -> Any:
    """A task's reward and goal as the loop asks for them; None, and once a word on stderr, where there is no such."""
    kind = np.dtype([(name, float) for name in robot.readings])
    key = code_of((task.reward, task.goal)), kind
    if key not in _judges:
        _judges[key], walk, record = None, _walk(robot, commands), numba.from_dtype(kind)
        records = np.array([tuple(readings.values()) for readings in walk], kind)
        with suppress(Exception):  # a compiler may find anything odd in somebody's function
            kernel = compiled(_judging(_kernel_of(task.reward), task.goal and _kernel_of(task.goal)))
            kernel.compile((record, record))
            if repr([*map(kernel, records, records[1:])]) == repr(
                [*map(_judging(task.reward, task.goal), walk, walk[1:])]
            ):
                _judges[key] = numba.types.function_type.CompileResultWAP(kernel.overloads[record, record])
        if _judges[key] is None:
            print(f"{task.path}: learning is slower, since numba cannot compile reward or goal", file=sys.stderr)
    return _judges[key]


def _walk(robot: KinematicRobot, commands: Sequence[Mapping[str, float]]) -> list[dict[str, float]]:
    """Readings on a walk at random; afterwards the robot stands where it stood."""
    place, draws = robot.parts.place.copy(), np.random.default_rng(0).integers(len(commands), size=TRIED)
    walk = [robot.act(commands[a]) for a in draws]
    robot.parts.place[:] = place
    robot.look()
    return walk


def _kernel_of(function: Any) -> Any:
    """The kernel of a function, and of those that it calls."""
    used = {name: v for name, v in function.__globals__.items() if name in function.__code__.co_names}
    around = {name: _kernel_of(v) if isinstance(v, FunctionType) else v for name, v in used.items()}
    around["__name__"] = __name__  # kept on disk, a kernel is read again only under a module that can be imported
    copy = FunctionType(function.__code__, around, function.__name__, function.__defaults__, function.__closure__)
    copy.__kwdefaults__ = function.__kwdefaults__
    return numba.njit(error_model="python")(copy)


def _judging(reward: Any, goal: Any) -> Any:
    def judge(before, after):
        try:
            return 1.0 * reward(before, after) + 0.0, goal is not None and bool(goal(after))
        except Exception:
            return math.nan, False

    return judge
