"""A task as kernels, for the compiled loop of learning: the state that readings show, the reward and the goal.

A task's reward and goal are compiled as they are. They are tried first, on a walk at random: only if they say there
what Python says does the loop use them. A reward is one of few numbers, so the last bit of a `hypot` is of no account.
"""

import math
import sys
from collections.abc import Mapping, Sequence
from contextlib import suppress
from types import FunctionType
from typing import Any

import numpy as np

from rlrobot_edu.jit.dispatcher import compiled, numba
from rlrobot_edu.jit.fingerprint import code_of
from rlrobot_edu.task.task import Task

INPUT = np.dtype(
    [("sensor", int), ("low", float), ("high", float), ("sectors", int), ("bins", int)]
)
TRIED = 300  # steps of the walk at random


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


_judges: dict[Any, Any] = {}  # by the code of a task's reward and goal


def judge_of(task: Task, robot: Any, commands: Sequence[Mapping[str, float]]) -> Any:
    """A task's reward and goal as the loop asks for them; None, and once a word on stderr, where there is no such."""
    names = tuple(robot.readings)
    key = code_of((task.reward, task.goal)), names
    if key not in _judges:
        _judges[key] = _tried(
            task, np.dtype([(name, float) for name in names]), _walk(robot, commands)
        )
    return _judges[key]


def _tried(task: Task, kind: np.dtype[Any], walk: list[dict[str, float]]) -> Any:
    """Reward and goal, compiled for readings of this `kind`, if they say on this walk what Python says; or None."""
    record, records = (
        numba.from_dtype(kind),
        np.array([tuple(readings.values()) for readings in walk], kind),
    )
    plain = _judging(task.reward, task.goal)
    with suppress(Exception):  # a compiler may find anything odd in somebody's function
        kernel = compiled(
            _judging(_kernel_of(task.reward), task.goal and _kernel_of(task.goal))
        )
        kernel.compile((record, record))
        if repr([*map(kernel, records, records[1:])]) == repr(
            [*map(plain, walk, walk[1:])]
        ):
            return numba.types.function_type.CompileResultWAP(
                kernel.overloads[record, record]
            )
    print(
        f"{task.path}: learning is slower, since numba cannot compile reward or goal",
        file=sys.stderr,
    )
    return None


def _walk(
    robot: Any, commands: Sequence[Mapping[str, float]]
) -> list[dict[str, float]]:
    """Readings on a walk at random; afterwards the robot stands where it stood."""
    place, draws = (
        robot.parts.place.copy(),
        np.random.default_rng(0).integers(len(commands), size=TRIED),
    )
    walk = [robot.act(commands[a]) for a in draws]
    robot.parts.place[:] = place
    robot.look()
    return walk


def _kernel_of(function: Any) -> Any:
    """The kernel of a function, and of those that it calls."""
    used = {
        name: v
        for name, v in function.__globals__.items()
        if name in function.__code__.co_names
    }
    around = {
        name: _kernel_of(v) if isinstance(v, FunctionType) else v
        for name, v in used.items()
    }
    around["__name__"] = (
        __name__  # kept on disk, a kernel is read again only under a module that can be imported
    )
    name, defaults = function.__name__, function.__defaults__
    copy = FunctionType(function.__code__, around, name, defaults, function.__closure__)
    copy.__kwdefaults__ = function.__kwdefaults__
    return numba.njit(error_model="python")(copy)


def _judging(reward: Any, goal: Any) -> Any:
    def judge(before, after):
        try:
            return 1.0 * reward(before, after) + 0.0, goal is not None and bool(
                goal(after)
            )
        except Exception:
            return math.nan, False

    return judge
