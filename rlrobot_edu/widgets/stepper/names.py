"""What the numbers of states and actions mean, in the words of the task."""

from __future__ import annotations

from functools import lru_cache

import gymnasium
import numpy as np

from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.robots.chassis import CHASSIS
from rlrobot_edu.task.robot_cards import WHEELS
from rlrobot_edu.task.task import Task
from rlrobot_edu.widgets.motions import (
    AHEAD,
    SPIN_LEFT,
    SPIN_RIGHT,
    STILL,
    motion_of,
    name_of,
)
from rlrobot_edu.widgets.stepper.numerals import given

CELL_COMMAND = {"advance", "spin"}  # of the robot in four cells


class Names:
    """Names of the states and actions of an agent's environment.

    task: the environment's own, which has the names; None if it has no task
    outputs: what an action sets, for example ``left_wheel, right_wheel``; empty without a task
    inputs: name of each input
    """

    def __init__(self, agent: Agent, env: gymnasium.Env) -> None:
        own = getattr(env.unwrapped, "task", None)
        task = own if isinstance(own, Task) else None
        n_actions = agent.q.shape[1]
        self.task = task
        self.shape = agent.shape
        self.outputs = ""
        self._most_letters = 12 if n_actions <= 4 else 8  # of the name of a column
        self._icons: list[str] = []
        self._motions: list[str] = []
        if task is not None:
            self.inputs = tuple(variable.name for variable in task.states.inputs)
            outputs = tuple(variable.name for variable in task.actions.outputs)
            self.outputs = ", ".join(outputs)
            if outputs == WHEELS:
                # of the wheels' commands, which some tasks compute from the outputs
                for a in range(n_actions):
                    left, right = task.command_for(a).values()
                    self._icons.append(motion_of(left, right).icon)
                    self._motions.append(_motion(task, left, right))
        elif len(self.shape) == 1:
            self.inputs = ("state",)
        else:
            self.inputs = tuple(f"input {i}" for i in range(len(self.shape)))
        self._all_differ = len(set(self._icons)) == n_actions
        self.state = lru_cache(4096)(self._state)
        self.action = lru_cache(4096)(self._action)

    def bins(self, s: int) -> tuple[int, ...]:
        """Bin of each input in state `s`."""
        return tuple(int(i) for i in np.unravel_index(s, self.shape))

    def readings(self, s: int) -> list[str]:
        """What each input reads in state `s`: its interval, or the number of its bin."""
        if self.task is None:
            return [str(i) for i in self.bins(s)]
        bins = self.task.states.decode(s)
        return [str(value).replace("-", "−") for value in bins.values()]

    def column(self, a: int) -> str:
        """Heading of the column of action `a`: its icon or its name, or its number if the name is too long."""
        if self._icons:
            icon = self._icons[a]
            return icon if self._all_differ else f"{icon} {a}"
        name = self.action(a)
        return name if len(name) <= self._most_letters else str(a)

    def row(self, a: int) -> str:
        """Name of action `a`, and its number if that is the heading of its column."""
        if self._motions:
            return f"{self.column(a)} {self._motions[a]}"
        name = self.action(a)
        return name if name.startswith(self.column(a)) else f"{a}: {name}"

    def told(self, a: int) -> str:
        """What a robot did that took action `a`: "The robot stood still"."""
        if self.task is None:
            return f"The agent took action {a}"
        command = self.task.command_for(a)
        did = f"did “{self.action(a)}”"
        if self._icons:
            did = motion_of(*command.values()).told
        elif set(command) == CELL_COMMAND:
            spin = SPIN_LEFT if command["spin"] > 0 else SPIN_RIGHT
            did = AHEAD.told if command["advance"] else spin.told
        elif not any(command.values()):
            did = STILL.told
        return f"The robot {did}"

    def quoted(self, a: int) -> str:
        """Action `a` in a sentence: “spin left”, or action 2 if it has no name."""
        name = self.action(a)
        return f"action {a}" if name == str(a) else f"“{name}”"

    def _state(self, s: int) -> str:
        """State `s` in words: ``X = 0, Y = 1, theta = 90 deg, d = 0``."""
        pairs = zip(self.inputs, self.readings(s), strict=True)
        return ", ".join(f"{name} = {reading}" for name, reading in pairs)

    def _action(self, a: int) -> str:
        """Action `a` in a few words: the motion, or the value of each output, or the task's word for it.

        Where several actions are the same motion, the values of the outputs follow.
        """
        if self.task is None:
            return str(a)
        values = self.task.actions.decode(a)
        words = []
        for variable in self.task.outputs:
            value = values[variable.name]
            if variable.words:
                words.append(variable.words[variable.values.index(value)])
            else:
                words.append(given(value))
        text = ", ".join(words)
        if not self._motions:
            stands = not any(self.task.command_for(a).values())
            return STILL.name if stands else text
        name = self._motions[a]
        return name if self._motions.count(name) == 1 else f"{name} ({text})"


def _motion(task: Task, left: float, right: float) -> str:
    """The name of what wheels with these speeds [rad/s] make the task's robot do."""
    if task.robot not in CHASSIS:
        return motion_of(left, right).name
    chassis = CHASSIS[task.robot]
    return name_of(*chassis.twist({"left_wheel": left, "right_wheel": right}))
