"""A task and its kinematic robot as kernels, for the compiled loop of learning: binning, reward and goal.

A task's functions are compiled as they are written, from Python's bytecode, as far as they do only what has the same
bits in every language: arithmetic without powers, comparisons, and calls of what stands in EXACT and of others like
themselves. The `hypot` and the `sin` of C differ from Python's in the last bit; a square root is exact everywhere.
"""

import builtins
import dis
import math
import sys
from collections.abc import Callable, Mapping
from functools import cache
from types import FunctionType
from typing import Any, NamedTuple

import numpy as np

from rlrobot_edu.learning.compiled_loop import NEVER
from rlrobot_edu.learning.fingerprint import code_of
from rlrobot_edu.learning.jit import IS_PLAIN, compiled, numba
from rlrobot_edu.task.task import Task

EXACT = (abs, bool, float, max, min, math, math.fabs, math.sqrt)
OF_MATH = ("fabs", "inf", "pi", "sqrt")
# What else the compiler knows and does in its own way, in the words of Python's disassembler
REFUSED = ("**", "**=", "<<", "<<=", "STORE_SUBSCR", "STORE_GLOBAL", "IMPORT_NAME", "IS_OP", "MAKE_FUNCTION")
INPUT = np.dtype([("sensor", int), ("low", float), ("high", float), ("sectors", int), ("bins", int)])


class Kinematics(NamedTuple):
    """What a robot without an engine is to a kernel.

    begin: (parts, rng), puts it at its start
    move: (parts, command), for one control step; sense: (parts, readings), fills in what is on its card
    parts: its arrays and numbers, of which ``parts.place`` alone says where it is
    commands: array (n_actions, n), each a command
    """

    begin: Callable[..., Any]
    move: Callable[..., Any]
    sense: Callable[..., Any]
    parts: Any
    commands: np.ndarray


class World(NamedTuple):
    """A task and its robot, as the loop is given them.

    robot, commands: parts and commands of `Kinematics`
    place: array (n,), where the robot was before the step
    numbers: array (2, n), readings before and after a step, which are those before the next; records: the same memory,
        in which readings have names
    inputs: array (n_inputs,) of INPUT; cuts: array (n_inputs, n), the cuts of each, then infinity
    reward, goal: (record before, record after) -> number; NaN where the task's function fails
    at_goal: array (1,), steps at the goal without a break
    rewards, goal_steps, episode_steps: the task's
    """

    robot: Any
    commands: np.ndarray
    place: np.ndarray
    numbers: np.ndarray
    records: np.ndarray
    inputs: np.ndarray
    cuts: np.ndarray
    reward: Any
    goal: Any
    at_goal: np.ndarray
    rewards: np.ndarray
    goal_steps: int
    episode_steps: int


def world_of(task: Task, robot: Kinematics, readings: Mapping[str, float], at_goal: int) -> World | None:
    """The world of a task's robot that senses `readings` now; None where the loop cannot be compiled."""
    if IS_PLAIN or any(v.values is not None for v in task.inputs):
        return None
    names = tuple(readings)
    reward, goal = _asked(task, "reward", task.reward, names), _asked(task, "goal", task.goal or _nowhere, names)
    if reward is None or goal is None:
        return None
    numbers = np.array([list(readings.values())] * 2, dtype=float)
    cuts = np.full((len(task.inputs), 1 + max(v.n_bins for v in task.inputs)), math.inf)
    for row, v in zip(cuts, task.inputs, strict=True):
        row[: len(v.cuts or ())] = v.cuts or ()
    inputs = [(names.index(v.name), v.low, v.high, v.sectors or 0, v.n_bins) for v in task.inputs]
    return World(
        robot.parts, robot.commands, robot.parts.place.copy(),
        numbers, numbers.view([(name, float) for name in names])[:, 0], np.array(inputs, INPUT), cuts,
        reward, goal, np.array([at_goal]), np.array(task.rewards), task.goal_steps, task.episode_steps or NEVER,
    )  # fmt: skip


@compiled
def state_of(inputs, cuts, readings):
    """Number of the state that is seen in `readings`, array (n,), as `StateSpace.encode`; −1 if one is out of range."""
    s = 0
    for i in range(inputs.shape[0]):
        one, reading, bin = inputs[i], readings[inputs[i].sensor], 0
        if not (one.low <= reading <= one.high and abs(reading) < math.inf):
            return -1
        if one.sectors > 0:
            bin = math.ceil(reading * one.sectors / (2 * math.pi) - 0.5) % one.sectors
        else:
            while cuts[i, bin] < reading:
                bin += 1
        s = s * one.bins + bin
    return s


@cache
def kernels_of(begin: Callable[..., Any], move: Callable[..., Any], sense: Callable[..., Any]) -> tuple[Any, Any]:
    """The kernels `begin` and `outcome` of the loop, see `make_run`, compiled for this kind of robot."""

    @compiled
    def begin_at(world, rng):
        begin(world.robot, rng)
        sense(world.robot, world.numbers[0])
        world.at_goal[0] = 0
        return state_of(world.inputs, world.cuts, world.numbers[0])

    @compiled
    def outcome(world, s, a, rng):
        """What happens after (s, a): (s', r, terminated). If the task's functions fail, nothing has moved and s' < 0.

        Then the plain loop makes this step, and says what is wrong.
        """
        world.place[:] = world.robot.place
        move(world.robot, world.commands[a])
        sense(world.robot, world.numbers[1])
        s_next = state_of(world.inputs, world.cuts, world.numbers[1])
        r = world.reward(world.records[0], world.records[1])
        is_there = world.goal(world.records[0], world.records[1])
        is_listed = False
        for i in range(world.rewards.shape[0]):
            is_listed |= r == world.rewards[i]
        if s_next < 0 or not is_listed or is_there != is_there:
            world.robot.place[:] = world.place
            return -1, r, False
        world.numbers[0] = world.numbers[1]
        world.at_goal[0] = world.at_goal[0] + 1 if is_there else 0
        return s_next, r, world.at_goal[0] >= world.goal_steps

    return begin_at, outcome


_known: dict[Any, Any] = {}  # what stands for a task's function in the loop, by its code


def _nowhere(readings):
    """The goal of a task without one."""
    return False


def _asked(task: Task, what: str, function: Any, names: tuple[str, ...]) -> Any:
    """What stands for a task's reward or goal in the loop, a pointer; None, and a word on stderr, if there is none."""
    key = code_of(function), names
    if key not in _known:
        try:
            record = numba.from_dtype(np.dtype([(name, float) for name in names]))
            kernel = compiled(_that_never_fails(_exact(function), is_goal=what == "goal"))
            kernel.compile((record, record))
            _known[key] = numba.types.function_type.CompileResultWAP(kernel.overloads[record, record])
        except Exception as error:
            _known[key] = None
            why = str(error).splitlines()[0]
            print(f"{task.path}: its {what} is not compiled, and learning is slower: {why}", file=sys.stderr)
    return _known[key]


def _that_never_fails(function: Any, is_goal: bool) -> Any:
    def reward(before, after):
        try:
            return 1.0 * function(before, after)
        except Exception:
            return math.nan

    def goal(before, after):
        try:
            return 1.0 if function(after) else 0.0
        except Exception:
            return math.nan

    return goal if is_goal else reward


def _exact(function: Any) -> Any:
    """The kernel of a function, and of all that it calls. Raises ValueError unless its results are those of Python."""
    if not isinstance(function, FunctionType):
        raise ValueError(f"{function!r:.100} is no function of Python")
    around: dict[str, Any] = {}
    for step in dis.get_instructions(function):
        name = step.argval
        if step.opname in REFUSED or step.argrepr in REFUSED:
            raise ValueError(f"{function.__name__} has {step.argrepr or step.opname} in it")
        if step.opname in ("LOAD_ATTR", "LOAD_METHOD") and name not in OF_MATH:
            raise ValueError(f"{function.__name__} uses .{name}")
        if step.opname == "LOAD_GLOBAL":
            value = function.__globals__.get(name, getattr(builtins, name, None))
            is_number = all(isinstance(part, int | float) for part in (value if type(value) is tuple else (value,)))
            if not is_number and value not in EXACT:
                value = _round if value is round else _exact(value)
            around[name] = value
    code = FunctionType(function.__code__, around, function.__name__, function.__defaults__)
    code.__kwdefaults__ = function.__kwdefaults__
    return numba.njit(error_model="python")(code)


@compiled
def _round(x):
    if not abs(x) < 2.0**53:
        raise OverflowError
    return round(x)
