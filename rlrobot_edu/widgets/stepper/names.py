"""What the numbers of states and actions mean, in the words of the task."""

from __future__ import annotations

from functools import lru_cache

import gymnasium
import numpy as np

from rlrobot_edu.learning.agent import Agent
from rlrobot_edu.task.task import Task
from rlrobot_edu.widgets.stepper.numerals import given
from rlrobot_edu.widgets.wheel_icons import wheel_icon


class Names:
    """Names of the states and actions of an agent's environment.

    task: where the names come from, the environment's own; None if it has none
    outputs: what an action sets, for example ``left_wheel, right_wheel``; empty where nobody says
    inputs: name of each input
    """

    def __init__(self, agent: Agent, env: gymnasium.Env) -> None:
        own = getattr(env.unwrapped, "task", None)
        task = own if isinstance(own, Task) else None
        n_actions = agent.q.shape[1]
        self.task, self.shape, self._few = task, agent.shape, n_actions <= 4
        if task is not None:
            self.inputs = tuple(variable.name for variable in task.states.inputs)
        else:
            self.inputs = (
                ("state",)
                if len(self.shape) == 1
                else tuple(f"input {i}" for i in range(len(self.shape)))
            )
        self.outputs = (
            ", ".join(variable.name for variable in task.actions.outputs)
            if task is not None
            else ""
        )
        drives = task is not None and [v.name for v in task.actions.outputs] == [
            "left_wheel",
            "right_wheel",
        ]
        # by the wheels' commands, which some tasks make of other outputs
        self._icons = (
            [wheel_icon(*task.command_for(a).values()) for a in range(n_actions)]
            if drives
            else []
        )
        self._all_differ = len(set(self._icons)) == n_actions
        self.state, self.action = (
            lru_cache(4096)(self._state),
            lru_cache(4096)(self._action),
        )

    def bins(self, s: int) -> tuple[int, ...]:
        """Bin of each input in state `s`."""
        return tuple(int(i) for i in np.unravel_index(s, self.shape))

    def readings(self, s: int) -> list[str]:
        """What each input reads in state `s`: its interval, or the number of its bin."""
        if self.task is None:
            return [str(i) for i in self.bins(s)]
        return [
            str(value).replace("-", "−")
            for value in self.task.states.decode(s).values()
        ]

    def column(self, a: int) -> str:
        """Heading of the column of action `a`: its icon or its name, or its number where that is too long."""
        if self._icons:
            return self._icons[a] if self._all_differ else f"{self._icons[a]} {a}"
        name = self.action(a)
        return name if len(name) <= (12 if self._few else 8) else str(a)

    def row(self, a: int) -> str:
        """Name of action `a`, and its number where that heads its column."""
        name, column = self.action(a), self.column(a)
        return name if name.startswith(column) else f"{a}: {name}"

    def _state(self, s: int) -> str:
        """State `s` in words: ``X = 0, Y = 1, theta = 90 deg, d = 0``."""
        return ", ".join(
            f"{name} = {value}"
            for name, value in zip(self.inputs, self.readings(s), strict=True)
        )

    def _action(self, a: int) -> str:
        """Action `a` in as few signs as possible: the value of each output, or the task's word for it."""
        if self.task is None:
            return str(a)
        values = self.task.actions.decode(a)
        text = ", ".join(
            v.words[v.values.index(values[v.name])]
            if v.words
            else given(values[v.name])
            for v in self.task.outputs
        )
        return f"{self._icons[a]} {text}" if self._icons else text
