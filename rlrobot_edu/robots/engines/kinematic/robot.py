"""A robot of geometry alone as kernels, and its world for the compiled loop of learning."""

import math
from abc import abstractmethod
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from rlrobot_edu.jit.building import build, for_python
from rlrobot_edu.jit.dispatcher import IS_PLAIN
from rlrobot_edu.learning.kernel_world import NEVER, KernelWorld
from rlrobot_edu.robots.engines.kinematic import kernels
from rlrobot_edu.robots.engines.kinematic.compiled_task import INPUT, judge_of
from rlrobot_edu.robots.robot import SimulatedRobot
from rlrobot_edu.task.task import Task
from rlrobot_edu.task.variables import InputVariable


class World(NamedTuple):
    """What the compiled loop is given of a robot and its task."""

    parts: Any  # of the robot
    start: np.ndarray  # where each episode begins
    place: np.ndarray  # where the robot was before the step
    commands: np.ndarray  # (actions, n), see `command_array`
    numbers: np.ndarray  # (2, n), the readings before and after a step
    records: np.ndarray  # (2,), the same memory, in which readings have names
    inputs: np.ndarray  # (n_inputs,) of INPUT
    cuts: np.ndarray  # (n_inputs, n), the cuts of each, then infinity
    judge: Any  # (record before, record after) -> reward, whether it is at the goal; see `judge_of`
    at_goal: np.ndarray  # (1,), steps at the goal without a break
    rewards: np.ndarray  # all that the task can give
    goal_steps: int  # at the goal, which end an episode
    episode_steps: int  # after which an episode is cut off


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
        for_python(self.kernels[0])(self.parts, self.command_array(command))

    def _sense(self) -> dict[str, float]:
        readings = np.empty(len(self._card.sensors))
        for_python(self.kernels[1])(self.parts, readings)
        return dict(zip(self._card.sensors, readings.tolist(), strict=True))

    def kernel_world(
        self, task: Task, commands: Sequence[Mapping[str, float]], at_goal: int
    ) -> KernelWorld | None:
        """What the compiled loop is given of a task and this robot, see `KernelRobot`."""
        has_kernels = "kernels" in vars(type(self)) and not IS_PLAIN
        start = self.start() if has_kernels else None
        if start is None or any(v.values is not None for v in task.inputs):
            return None
        names = tuple(self.readings)
        judge = judge_of(task, names)
        if judge is None:
            return None
        numbers = np.array([list(self.readings.values())] * 2)
        records = numbers.view([(name, float) for name in names])[:, 0]
        move, sense = self.kernels
        built = build(kernels, move=move, sense=sense)
        arrays = World(
            parts=self.parts,
            start=start,
            place=start.copy(),
            commands=np.array([self.command_array(command) for command in commands]),
            numbers=numbers,
            records=records,
            inputs=np.array([_input(v, names) for v in task.inputs], INPUT),
            cuts=_cuts(task),
            judge=judge,
            at_goal=np.array([at_goal]),
            rewards=np.array(task.rewards),
            goal_steps=task.goal_steps,
            episode_steps=task.episode_steps or NEVER,
        )
        state = (self.parts.place, numbers, arrays.at_goal)
        return KernelWorld(built.begin, built.outcome, arrays, state)


def _input(v: InputVariable, readings: Sequence[str]) -> tuple[Any, ...]:
    """A row of INPUT."""
    return readings.index(v.name), v.low, v.high, v.sectors or 0, v.n_bins


def _cuts(task: Task) -> np.ndarray:
    """The cuts of each input, then infinity up to the width of the widest, array (n_inputs, n)."""
    width = max(v.n_bins for v in task.inputs)
    cuts = np.full((len(task.inputs), width), math.inf)
    for row, variable in zip(cuts, task.inputs, strict=True):
        own = variable.cuts or ()
        row[: len(own)] = own
    return cuts
