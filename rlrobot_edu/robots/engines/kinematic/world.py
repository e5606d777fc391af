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
from types import FunctionType
from typing import Any

import numpy as np

from rlrobot_edu.learning.compiled_loop import NEVER
from rlrobot_edu.learning.fingerprint import code_of
from rlrobot_edu.learning.jit import IS_PLAIN, compiled, numba
from rlrobot_edu.robots.robot import SimulatedRobot
from rlrobot_edu.task.task import Task

EXACT = (abs, bool, float, max, min, math, math.fabs, math.sqrt)
OF_MATH = ("fabs", "inf", "pi", "sqrt")
# What the compiler would do in a way of its own, in the words of Python's disassembler
REFUSED = ("**", "**=", "<<", "<<=", "STORE_SUBSCR", "STORE_GLOBAL", "IMPORT_NAME", "IS_OP", "MAKE_FUNCTION")
INPUT = np.dtype([("sensor", int), ("low", float), ("high", float), ("sectors", int), ("bins", int)])

# What the loop is given.
# parts, start: the robot's; place: array, where it was before the step; commands: array (n_actions, n), see `in_numbers`
# numbers: array (2, n), readings before and after a step; records: the same memory, in which readings have names
# inputs: array (n_inputs,) of INPUT; cuts: array (n_inputs, n), the cuts of each, then infinity
# reward, goal: (record before, record after) -> number; NaN where the task's function fails
# at_goal: array (1,), steps at the goal without a break; rewards, goal_steps, episode_steps: the task's
_TASK = "inputs cuts reward goal at_goal rewards goal_steps episode_steps"
World = namedtuple("World", f"parts start place commands numbers records {_TASK}")


class KinematicRobot(SimulatedRobot):
    """A robot that kernels move and that they let sense.

    kernels: move (parts, command as `in_numbers` makes it), for one control step; and sense (parts, readings), which
        fills in what is on the card, array (n,). Whoever inherits has its own, or is not compiled into the loop
    parts: its arrays and numbers; ``parts.place`` alone says where it is
    start: array, the place at which an episode begins; None if that differs from one to the next
    """

    kernels: tuple[Callable[..., None], Callable[..., None]]
    parts: Any
    start: np.ndarray | None

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
    has_kernels = "kernels" in vars(type(robot)) and robot.start is not None
    if IS_PLAIN or not has_kernels or any(v.values is not None for v in task.inputs):
        return None
    names = tuple(robot.readings)
    asked = [_asked(task, what, names) for what in ("reward", "goal")]
    if None in asked:
        return None
    numbers = np.array([[*robot.readings.values()]] * 2)
    cuts = np.full((len(task.inputs), 1 + max(v.n_bins for v in task.inputs)), math.inf)
    for row, v in zip(cuts, task.inputs, strict=True):
        row[: len(v.cuts or ())] = v.cuts or ()
    inputs = [(names.index(v.name), v.low, v.high, v.sectors or 0, v.n_bins) for v in task.inputs]
    return World(
        robot.parts, robot.start, robot.start.copy(), np.array([*map(robot.in_numbers, commands)]),
        numbers, numbers.view([(name, float) for name in names])[:, 0], np.array(inputs, INPUT), cuts,
        *asked, np.array([at_goal]), np.array(task.rewards), task.goal_steps, task.episode_steps or NEVER,
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


@compiled
def is_among(x, numbers):
    """Whether `x` is one of `numbers`, array (n,)."""
    for i in range(numbers.shape[0]):
        if x == numbers[i]:
            return True
    return False


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
        r, is_there = world.reward(world.records[0], world.records[1]), world.goal(world.records[0], world.records[1])
        if s_next < 0 or not is_among(r, world.rewards) or math.isnan(is_there):
            world.parts.place[:] = world.place
            return -1, r, False
        before[:] = after
        world.at_goal[0] = world.at_goal[0] + 1 if is_there else 0
        return s_next, r, world.at_goal[0] >= world.goal_steps

    return begin, outcome


_known: dict[Any, Any] = {}  # what the loop asks, by the code of a task's function


def _asked(task: Task, what: str, names: tuple[str, ...]) -> Any:
    """What the loop asks in place of a task's reward or goal, a pointer; None, and once a word on stderr, if it cannot."""
    function = getattr(task, what)
    key = what, code_of(function), names
    if key not in _known:
        try:
            record = numba.from_dtype(np.dtype([(name, float) for name in names]))
            kernel = compiled(_guarded(function and _exact(function), what))
            kernel.compile((record, record))
            _known[key] = numba.types.function_type.CompileResultWAP(kernel.overloads[record, record])
        except Exception as error:
            _known[key] = None
            why = str(error).splitlines()[0]
            print(f"{task.path}: learning is slower, since {what} cannot be compiled: {why}", file=sys.stderr)
    return _known[key]


def _guarded(function: Any, what: str) -> Any:
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

    def nowhere(before, after):
        return 0.0

    return nowhere if function is None else {"reward": reward, "goal": goal}[what]


def _exact(function: Any) -> Any:
    """The kernel of a function, and of those that it calls. Raises ValueError if its results could be others."""
    if not isinstance(function, FunctionType):
        raise ValueError(f"it calls {getattr(function, '__name__', function)}")
    around: dict[str, Any] = {}
    for step in dis.get_instructions(function):
        name = str(step.argval)
        if {step.opname, step.argrepr}.intersection(REFUSED):
            raise ValueError(f"it has {step.argrepr or step.opname} in {function.__name__}")
        if step.opname in ("LOAD_ATTR", "LOAD_METHOD") and name not in OF_MATH:
            raise ValueError(f"it uses .{name}")
        if step.opname == "LOAD_GLOBAL":
            value = function.__globals__.get(name, getattr(builtins, name, None))
            parts = value if type(value) is tuple else (value,)
            if not all(isinstance(part, int | float) for part in parts) and value not in EXACT:
                value = _round if value is round else _exact(value)
            around[name] = value
    copy = FunctionType(function.__code__, around, function.__name__, function.__defaults__)
    copy.__kwdefaults__ = function.__kwdefaults__
    return numba.njit(error_model="python")(copy)


@compiled
def _round(x):
    if not abs(x) < 2.0**53:
        raise OverflowError
    return round(x)
