"""A robot of geometry alone and its task as kernels, for the compiled loop of learning.

A task's reward and goal are compiled as they are, from Python's bytecode, as long as their results have the same bits
in every language: arithmetic without powers, comparisons, what stands in EXACT, and functions made of these. The
`hypot` and the `sin` of C differ from Python's in the last bit; a square root is exact everywhere.
"""

import builtins
import dis
import math
import sys
from abc import abstractmethod
from collections import namedtuple
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from types import FunctionType, ModuleType
from typing import Any

import numpy as np

from rlrobot_edu.learning.compiled_loop import NEVER
from rlrobot_edu.learning.fingerprint import code_of
from rlrobot_edu.learning.jit import IS_PLAIN, compiled, numba
from rlrobot_edu.robots.robot import SimulatedRobot
from rlrobot_edu.task.robot_cards import RobotCard
from rlrobot_edu.task.task import Task

# What the compiler would do in a way of its own, in the words of Python's disassembler
REFUSED = {"**", "**=", "<<", "<<=", ">>", ">>=", "UNARY_INVERT", "IS_OP", "STORE_SUBSCR", "STORE_GLOBAL"}
REFUSED |= {"IMPORT_NAME", "LOAD_DEREF", "MAKE_FUNCTION"}
INPUT = np.dtype([("sensor", int), ("low", float), ("high", float), ("sectors", int), ("bins", int)])

# What the loop is given.
# parts, start: the robot's; place: array, where it was before the step; commands: array (actions, n), see `in_numbers`
# numbers: array (2, n), readings before and after a step; records: the same memory, in which readings have names
# inputs: array (n_inputs,) of INPUT; cuts: array (n_inputs, n), the cuts of each, then infinity
# reward, goal: (record before, record after) -> number; NaN where the task's function fails
# at_goal: array (1,), steps at the goal without a break; rewards, goal_steps, episode_steps: the task's
World = namedtuple(
    "World",
    "parts start place commands numbers records inputs cuts reward goal at_goal rewards goal_steps episode_steps",
)


@compiled
def _round(x):
    if not abs(x) < 2**20:  # whole numbers of Python have no end
        raise OverflowError
    return round(x)


@compiled
def _sqrt(x):
    if x < 0:
        raise ValueError
    return math.sqrt(x)


_MATH = ModuleType("math")
vars(_MATH).update(fabs=math.fabs, inf=math.inf, pi=math.pi, sqrt=_sqrt)
# What a task's function may call, and what is called in its place
EXACT: Any = {**{f: f for f in (abs, bool, float, max, min, math.fabs)}, round: _round, math.sqrt: _sqrt, math: _MATH}


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
        return sensed(self.kernels[1], self.parts, self._card)


def sensed(sense: Callable[..., None], parts: Any, card: RobotCard) -> dict[str, float]:
    """What the kernel `sense` tells of `parts`, by the names on the card."""
    readings = np.empty(len(card.sensors))
    sense(parts, readings)
    return dict(zip(card.sensors, readings.tolist(), strict=True))


def world_of(task: Task, robot: Any, commands: Sequence[Mapping[str, float]], at_goal: int) -> World | None:
    """What the compiled loop is given of a task and its robot, as it stands there; None where there is no such loop."""
    start = robot.start() if "kernels" in vars(type(robot)) else None
    if IS_PLAIN or start is None or any(v.values is not None for v in task.inputs):
        return None
    names = tuple(robot.readings)
    reward, goal = (_asked(task, what, names) for what in ("reward", "goal"))
    if reward is None or goal is None:
        return None
    numbers = np.array([[*robot.readings.values()]] * 2)
    width = max(v.n_bins for v in task.inputs)
    cuts = [[*(v.cuts or ()), *[math.inf] * (width - len(v.cuts or ()))] for v in task.inputs]
    inputs = [(names.index(v.name), v.low, v.high, v.sectors or 0, v.n_bins) for v in task.inputs]
    return World(
        robot.parts, start, start.copy(), np.array([*map(robot.in_numbers, commands)]),
        numbers, numbers.view([(name, float) for name in names])[:, 0], np.array(inputs, INPUT), np.array(cuts),
        reward, goal, np.array([at_goal]), np.array(task.rewards), task.goal_steps, task.episode_steps or NEVER,
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
        r = world.reward(world.records[0], world.records[1])
        is_there = world.goal(world.records[0], world.records[1])
        if s_next < 0 or r not in world.rewards or math.isnan(is_there):
            world.parts.place[:] = world.place
            return -1, r, False
        before[:] = after
        world.at_goal[0] = world.at_goal[0] + 1 if is_there else 0
        return s_next, r, world.at_goal[0] >= world.goal_steps

    return begin, outcome


_known: dict[Any, Any] = {}  # what the loop asks, by the code of a task's function


def _asked(task: Task, what: str, names: tuple[str, ...]) -> Any:
    """The pointer that stands for a task's reward or goal in the loop; None, and once a word on stderr, without one."""
    function = getattr(task, what) or (lambda readings: False)
    key = what, code_of(function), names
    if key not in _known:
        try:
            record = numba.from_dtype(np.dtype([(name, float) for name in names]))
            kernel = compiled(_guarded(_exact(function), is_reward=what == "reward"))
            kernel.compile((record, record))
            _known[key] = numba.types.function_type.CompileResultWAP(kernel.overloads[record, record])
        except Exception as error:
            _known[key] = None
            why = str(error).splitlines()[0]
            print(f"{task.path}: learning is slower, since {what} cannot be compiled: {why}", file=sys.stderr)
    return _known[key]


def _guarded(function: Any, is_reward: bool) -> Any:
    def asked(before, after):
        try:
            return 1.0 * function(before, after) + 0.0 if is_reward else 1.0 * bool(function(after))
        except Exception:
            return math.nan

    return asked


def _exact(function: Any) -> Any:
    """The kernel of a function, and of those that it calls. Raises ValueError if its results could be others."""
    if not isinstance(function, FunctionType):
        raise ValueError(f"it calls {getattr(function, '__name__', function)}")
    around: dict[str, Any] = {}
    for step in dis.get_instructions(function):
        name = str(step.argval)
        if REFUSED.intersection((step.opname, step.argrepr)):
            raise ValueError(f"{step.opname} {step.argrepr} in {function.__name__}")
        if step.opname in ("LOAD_ATTR", "LOAD_METHOD") and name not in vars(_MATH):
            raise ValueError(f"it uses .{name}")
        if step.opname == "LOAD_GLOBAL":
            value = function.__globals__.get(name, getattr(builtins, name, None))
            parts = value if type(value) is tuple else (value,)
            is_number = all(isinstance(part, int | float) for part in parts)
            around[name] = value if is_number else EXACT[value] if value in EXACT else _exact(value)
    copy = FunctionType(function.__code__, around, function.__name__, function.__defaults__)
    copy.__kwdefaults__ = function.__kwdefaults__
    return numba.njit(error_model="python")(copy)
